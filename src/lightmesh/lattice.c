/* Lattices of mesh points: see lattice.h. */
#include "lightmesh/lattice.h"

#include "base/affine.h"
#include "base/random.h"
#include "base/smooth.h"
#include "lightmesh/tuning.h"

/* Where the origin lies in its cell of the usual level, less 1/3: irrational
 * looking, so that no cell boundary lies in a wall for long. */
static const vec3 lattice_shift = { 0.0386, 0.0809, -0.0516 };

static const double lattice_rim = (1 << 18) - 64;

/* Halving 1/3 gives 2/3 if the origin's cell is the second half of the coarser
 * one, and halving 2/3 gives 1/3 if it is the first: so, by turns, the levels
 * nest, and on none does the origin come near a mesh point. */
static int lattice_half(const struct lattice *lattice, int level)
{
    return (level - lattice->usual) & 1 ? 0 : 1;
}

/* 2 to the power of n, where that fits a double and not only just. */
static double power_of_two(int n)
{
    return n >= 0 ? (double)(1ull << n) : 1 / (double)(1ull << -n);
}

static vec3 lattice_origin(const struct lattice *lattice, int level)
{
    double third = (2 - lattice_half(lattice, level)) / 3.0;
    double finer = power_of_two(lattice->usual - level);
    return vec3_make(third + lattice_shift.x * finer,
                     third + lattice_shift.y * finer,
                     third + lattice_shift.z * finer);
}

static double region_levels(const struct mesh_region *region)
{
    return round(log2(region->factor));
}

void lattice_set_regions(struct lattice *lattice,
                         const struct mesh_region *regions, size_t count)
{
    lattice->regions = regions;
    lattice->region_count = count;
    for (size_t i = 0; i < count; i++)
        lattice->usual = (int)fmax(lattice->usual, region_levels(&regions[i]));
    lattice->spacing /= (double)(1ull << lattice->usual);
}

void lattice_make_finer(struct lattice *lattice, int levels)
{
    lattice->usual += levels;
    lattice->spacing /= (double)(1ull << levels);
}

/* Distance to the region from outside; from inside, to the nearest side, and
 * negative. */
static double region_distance(const struct mesh_region *region, vec3 place)
{
    const struct box3 box = { region->low, region->high };
    double apart = box3_distance2(box, place);
    if (apart > 0)
        return sqrt(apart);
    vec3 below = vec3_sub(box.low, place), above = vec3_sub(place, box.high);
    return fmax(fmax(fmax(below.x, above.x), fmax(below.y, above.y)),
                fmax(below.z, above.z));
}

/* How many levels finer the regions make the mesh: finer ones fade out around
 * them and coarser ones (factor < 1) fade in inside. */
static double lattice_finer(const struct lattice *lattice, vec3 place)
{
    double finer = 0, coarser = 0;
    double width = lattice_spacing(lattice, lattice->usual);
    for (size_t i = 0; i < lattice->region_count; i++) {
        const struct mesh_region *region = &lattice->regions[i];
        double levels = region_levels(region);
        double cells = region_distance(region, place) / width;
        if (levels > 0)
            finer = fmax(finer, levels - fmax(cells, 0));
        else
            coarser = fmin(coarser, fmax(levels, cells));
    }
    return finer + coarser;
}

int lattice_level(const struct lattice *lattice,
                  const struct lattice_view *view, vec3 place, double *blend)
{
    double exact = view->finest;
    *blend = 0;
    if (lattice->near > 0) {
        double distance = vec3_length(vec3_sub(place, view->eye));
        exact = fmax(log2(distance / lattice->near) + 1, exact);
    }
    exact += lattice->usual + view->coarser - lattice_finer(lattice, place);
    if (!(exact > level_blend))
        return 0;
    if (exact >= LATTICE_LEVELS - 1)
        return LATTICE_LEVELS - 1;
    double level = floor(exact);
    *blend = smooth_step((exact - level - level_blend) / (1 - level_blend));
    return (int)level;
}

double lattice_spacing_at(const struct lattice *lattice,
                          const struct lattice_view *view, vec3 place)
{
    double coarse;
    int level = lattice_level(lattice, view, place, &coarse);
    return lattice_spacing(lattice, level) * (1 + coarse);
}

static double rim(double x)
{
    return x > -lattice_rim ? x < lattice_rim ? x : lattice_rim : -lattice_rim;
}

vec3 lattice_units(const struct lattice *lattice, int level, vec3 place)
{
    vec3 at = vec3_scale(place, 1 / lattice_spacing(lattice, level));
    at = vec3_add(at, lattice_origin(lattice, level));
    return vec3_make(rim(at.x), rim(at.y), rim(at.z));
}

vec3 lattice_place(const struct lattice *lattice,
                   const struct lattice_point *point)
{
    vec3 at = vec3_make(point->at[0], point->at[1], point->at[2]);
    return vec3_scale(vec3_sub(at, lattice_origin(lattice, point->level)),
                      lattice_spacing(lattice, point->level));
}

struct lattice_point lattice_coarsest(const struct lattice *lattice,
                                      const struct lattice_point *point)
{
    struct lattice_point coarsest = *point;
    for (; coarsest.level < LATTICE_LEVELS - 1; coarsest.level++) {
        int half = lattice_half(lattice, coarsest.level), *at = coarsest.at;
        if ((at[0] + half) & 1 || (at[1] + half) & 1 || (at[2] + half) & 1)
            break;
        for (int axis = 0; axis < 3; axis++)
            at[axis] = (at[axis] + half) / 2;
    }
    return coarsest;
}

/* 1 bit that says it is a key, 5 of level, 3 times 19, biased. */
uint64_t lattice_key(const struct lattice_point *point)
{
    uint64_t key = 1;
    key = key << 5 | (uint64_t)point->level;
    for (int axis = 0; axis < 3; axis++)
        key = key << 19 |
              (uint64_t)((point->at[axis] + (1 << 18)) & ((1 << 19) - 1));
    return key;
}

struct lattice_point lattice_named(uint64_t key)
{
    struct lattice_point point = { .level = (int)(key >> 57 & 31) };
    for (int axis = 0; axis < 3; axis++)
        point.at[axis] =
            (int)(key >> (38 - 19 * axis) & ((1 << 19) - 1)) - (1 << 18);
    return point;
}

/* Blocks of 4 x 4 x 4 points stay together. */
uint64_t lattice_hash(uint64_t key)
{
    const uint64_t low = 3ull | 3ull << 19 | 3ull << 38;
    uint64_t inside = (key & 3) | (key >> 19 & 3) << 2 | (key >> 38 & 3) << 4;
    return random_mix(key & ~low) << 6 | inside;
}
