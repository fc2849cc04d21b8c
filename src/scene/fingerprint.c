/* A walk through everything that the scene holds: see fingerprint.h. Structs
 * are hashed member by member, as they have padding and pointers. */
#include "scene/fingerprint.h"

#include "base/hash.h"
#include "base/memory.h"
#include "base/random.h"
#include "image/image.h"
#include "scene/fields.h"
#include "scene/light.h"
#include "scene/medium.h"
#include "scene/mesh.h"
#include "scene/primitive.h"
#include "scene/warp.h"

/* Hashes of what is shared by many objects, by its address. */
struct known {
    const void *at; /* NULL: free */
    uint64_t hash;
};

struct walk {
    struct fingerprint found;
    bool colours;
    struct known
        *known; /* open addressing; a power of two, at most half full */
    size_t count, capacity;
};

static struct known *known_place(const struct walk *walk, const void *at)
{
    size_t mask = walk->capacity - 1;
    size_t i = random_mix((uint64_t)(uintptr_t)at) & mask;
    while (walk->known[i].at && walk->known[i].at != at)
        i = (i + 1) & mask;
    return &walk->known[i];
}

static const uint64_t *known_find(const struct walk *walk, const void *at)
{
    const struct known *place = known_place(walk, at);
    return place->at ? &place->hash : NULL;
}

static uint64_t known_add(struct walk *walk, const void *at, uint64_t hash)
{
    if (2 * (walk->count + 1) > walk->capacity) {
        struct walk larger = *walk;
        larger.capacity *= 2;
        larger.known = memory_new(larger.capacity * sizeof *larger.known);
        for (size_t i = 0; i < walk->capacity; i++)
            if (walk->known[i].at)
                *known_place(&larger, walk->known[i].at) = walk->known[i];
        memory_free(walk->known);
        *walk = larger;
    }
    struct known *place = known_place(walk, at);
    walk->count += !place->at;
    *place = (struct known){ at, hash };
    return hash;
}

static uint64_t hash_affine(uint64_t hash, const affine *map)
{
    return hash_numbers(hash, &map->m[0][0], 12);
}

static uint64_t hash_vector(uint64_t hash, vec3 v)
{
    return hash_numbers(hash, (const double[]){ v.x, v.y, v.z }, 3);
}

static uint64_t hash_rgb(uint64_t hash, rgb c)
{
    return hash_numbers(hash, (const double[]){ c.r, c.g, c.b }, 3);
}

static uint64_t hash_colour(uint64_t hash, colour c)
{
    const double numbers[] = { c.r, c.g, c.b, c.filter, c.transmit };
    return hash_numbers(hash, numbers, 5);
}

/* Of a struct that one table describes. */
static uint64_t hash_one(uint64_t hash, const struct field *table,
                         const void *values)
{
    const struct field *const tables[] = { table, NULL };
    return hash_tables(hash, tables, values);
}

/* Whose row has one number more. */
static uint64_t warp_hash(uint64_t hash, const struct warp *warp)
{
    double row[HASH_ROW];
    size_t count = field_numbers(warp_said, warp, FIELDS_BOTH, row);
    row[count++] = 0;
    return hash_affine(hash_numbers(hash, row, count), &warp->inverse);
}

/* The row of its numbers ends with what takes more than a look at a field. */
static uint64_t pattern_hash(uint64_t hash, const struct pattern *pattern)
{
    const struct pattern_kind *kind = pattern->kind;
    double row[HASH_ROW];
    size_t count = field_numbers(pattern_said, pattern, FIELDS_BOTH, row);
    row[count++] = pattern_generator(pattern);
    row[count++] = pattern->noise->waves;
    row[count++] = pattern->uv;
    hash = hash_affine(hash, &pattern->inverse);
    for (const struct warp *warp = pattern->warps; warp; warp = warp->inner)
        hash = warp_hash(hash, warp);
    hash = hash_numbers(hash, row, count);
    if (!kind)
        return hash;
    hash = hash_text(hash, kind->name);
    hash = hash_fields(hash, kind->arguments, pattern->parameters);
    return hash_fields(hash, kind->items, pattern->parameters);
}

static uint64_t image_hash(struct walk *walk, const struct image *image)
{
    const uint64_t *known = known_find(walk, image);
    if (known)
        return *known;
    uint64_t hash =
        hash_numbers(0, (const double[]){ image->width, image->height }, 2);
    size_t pixels = (size_t)image->width * (size_t)image->height;
    hash = hash_bytes(hash, image->pixels, pixels * 4 * sizeof(float));
    return known_add(walk, image, hash);
}

static uint64_t image_map_hash(struct walk *walk, uint64_t hash,
                               const struct image_map *image)
{
    hash = hash_one(hash, image_map_said, image);
    return random_key(hash, image_hash(walk, image->image));
}

static uint64_t pigment_hash(struct walk *walk, uint64_t hash,
                             const struct pigment *pigment)
{
    const struct image_map *image = pigment->image;
    hash = pattern_hash(random_key(hash, pigment->kind), &pigment->pattern);
    hash = hash_colour(hash, pigment->colour);
    if (pigment->has_quick_colour)
        hash = hash_colour(hash, pigment->quick_colour);
    if (image)
        hash = image_map_hash(walk, hash, image);
    if (!pigment->map)
        return hash;
    for (size_t i = 0; i < pigment->map->count; i++) {
        const struct blend_entry *entry = &pigment->map->entries[i];
        hash = hash_colour(hash_numbers(hash, &entry->value, 1), entry->colour);
        if (entry->pigment)
            hash = pigment_hash(walk, hash, entry->pigment);
    }
    return random_key(hash, pigment->map->count);
}

/* What the item keeps of its own, if it was said. */
static uint64_t finish_own_hash(uint64_t hash, const struct finish *finish,
                                size_t place)
{
    const struct finish_item *item = finish_item_at(place);
    if (!finish->own[place])
        return hash;
    return hash_one(hash_text(hash, item->name), item->fields,
                    finish->own[place]);
}

/* Vectors first, then all other numbers in one row, of the items in their
 * order. */
static uint64_t finish_hash(uint64_t hash, const struct finish *finish)
{
    const struct field *tables[2 * FINISH_ITEMS + 1] = { NULL };
    size_t count = 0;
    const struct finish_item *item;
    for (size_t i = 0; (item = finish_item_at(i)) != NULL; i++) {
        if (!item->size && item->fields)
            hash = hash_wide(hash, tables[count++] = item->fields, finish);
        if (!item->size && item->inner)
            tables[count++] = item->inner;
    }
    for (size_t i = 0; (item = finish_item_at(i)) != NULL; i++)
        if (!item->size && item->inner)
            hash = hash_wide(hash, item->inner, finish);
    hash = hash_narrow(hash, tables, finish);
    for (size_t i = 0; i < FINISH_ITEMS; i++)
        hash = finish_own_hash(hash, finish, i);
    return hash;
}

static uint64_t normal_hash(struct walk *walk, uint64_t hash,
                            const struct normal *normal)
{
    hash = pattern_hash(hash, &normal->pattern);
    hash = hash_one(hash, normal_fields, normal);
    for (size_t i = 0; normal->map && i < normal->map->count; i++) {
        const struct normal_entry *entry = &normal->map->entries[i];
        hash = hash_numbers(hash, &entry->value, 1);
        hash = entry->normal ? normal_hash(walk, hash, entry->normal) : hash;
    }
    if (normal->bumps)
        hash = image_map_hash(walk, hash, normal->bumps);
    const struct slope_map *slopes = normal->slopes;
    return slopes
               ? hash_numbers(hash, &slopes->entries->value, 3 * slopes->count)
               : hash;
}

static uint64_t texture_hash(struct walk *walk, const struct texture *texture)
{
    const uint64_t *known = known_find(walk, texture);
    if (known)
        return *known;
    uint64_t hash = random_mix(texture->count);
    const struct texture_choice *choice = texture->choice;
    if (!walk->colours && texture_is_opaque(texture))
        return known_add(walk, texture, 0);
    if (choice)
        hash = pattern_hash(hash, &choice->pattern);
    for (size_t i = 0; choice && i < choice->count; i++) {
        hash = hash_numbers(hash, &choice->entries[i].value, 1);
        hash = random_key(hash, texture_hash(walk, choice->entries[i].texture));
    }
    for (size_t i = 0; !choice && i < texture->count; i++) {
        const struct layer *layer = &texture->layers[i];
        hash = pigment_hash(walk, hash, layer->pigment);
        hash = finish_hash(hash, layer->finish);
        if (layer->normal)
            hash = normal_hash(walk, hash, layer->normal);
    }
    return known_add(walk, texture, hash);
}

static uint64_t pigment_paint(uint64_t hash, const struct pigment *pigment)
{
    const struct blend_map *map = pigment->map;
    hash = hash_colour(random_key(hash, pigment->kind), pigment->colour);
    for (size_t i = 0; map && i < map->count; i++) {
        hash = hash_colour(hash, map->entries[i].colour);
        if (map->entries[i].pigment)
            hash = pigment_paint(hash, map->entries[i].pigment);
    }
    return hash;
}

/* What its colours and finishes are, without its patterns. Known by an address
 * within the texture, since that itself is for all of it. */
static uint64_t texture_paint(struct walk *walk, const struct texture *texture)
{
    const struct texture_choice *choice = texture->choice;
    const void *at = &texture->count;
    const uint64_t *known = known_find(walk, at);
    if (known)
        return *known;
    uint64_t hash = 1;
    for (size_t i = 0; choice && i < choice->count; i++)
        hash =
            random_key(hash, texture_paint(walk, choice->entries[i].texture));
    for (size_t i = 0; !choice && i < texture->count; i++)
        hash = finish_hash(pigment_paint(hash, texture->layers[i].pigment),
                           texture->layers[i].finish);
    return known_add(walk, at, hash);
}

/* Of textures that don't count not even the places do. */
static void walk_texture(struct walk *walk, const struct texture *texture,
                         const affine *place)
{
    walk->found.kinds =
        random_key(walk->found.kinds, texture_paint(walk, texture));
    uint64_t *textures = &walk->found.textures;
    uint64_t hash = texture_hash(walk, texture);
    *textures = random_key(*textures, hash);
    if (hash)
        *textures = hash_affine(*textures, place);
}

static uint64_t mesh_hash(struct walk *walk, const struct mesh *mesh)
{
    const uint64_t *known = known_find(walk, mesh);
    if (known)
        return *known;
    walk->found.size += mesh->triangle_count;
    uint64_t hash = hash_vector(random_mix(mesh->solid), mesh->inside_vector);
    hash = hash_bytes(hash, mesh->vertices,
                      mesh->vertex_count * sizeof *mesh->vertices);
    hash = hash_bytes(hash, mesh->normals,
                      mesh->normal_count * sizeof *mesh->normals);
    hash = hash_bytes(hash, mesh->triangles,
                      mesh->triangle_count * sizeof *mesh->triangles);
    for (size_t i = 0; mesh->uv_faces && i < mesh->triangle_count; i++)
        for (int k = 0; k < 3 && mesh->uv_faces[i][0] != MESH_NONE; k++)
            hash = hash_numbers(hash, mesh->uvs[mesh->uv_faces[i][k]], 2);
    return known_add(walk, mesh, hash);
}

static const struct field *const medium_tables[] = { scattering_fields,
                                                     medium_fields, NULL };

static uint64_t media_hash(struct walk *walk, uint64_t hash,
                           const struct media *media)
{
    for (size_t i = 0; i < media->count; i++) {
        const struct medium *m = media->items[i];
        hash = hash_tables(hash, medium_tables, m);
        for (size_t k = 0; k < m->density_count; k++)
            hash = pigment_hash(walk, hash, m->densities[k]);
    }
    return hash;
}

static void walk_material(struct walk *walk, const struct object *object,
                          affine outer)
{
    affine place = affine_compose(outer, *object->maps->texture);
    const struct interior *interior = object->more->interior;
    const struct mesh *mesh = object->kind == OBJECT_MESH ? object->mesh : NULL;
    if (object->texture)
        walk_texture(walk, object->texture, &place);
    affine inner = affine_compose(outer, *object->maps->inner);
    if (object->more->inner)
        walk_texture(walk, object->more->inner, &inner);
    for (size_t i = 0; mesh && i < mesh->texture_count; i++)
        walk_texture(walk, mesh->textures[i], &place);
    if (!interior)
        return;
    uint64_t *textures = &walk->found.textures;
    *textures = hash_one(*textures, interior_fields, interior);
    if (interior->media.count == 0)
        return;
    affine media = affine_compose(outer, *object->maps->interior);
    *textures =
        media_hash(walk, hash_affine(*textures, &media), &interior->media);
}

/* Whatever its numbers are. */
static uint64_t kind_hash(const struct object *object)
{
    uint64_t hash = random_key(object->kind, object->more->child_count);
    return object->kind == OBJECT_SHAPE
               ? hash_text(hash, object->primitive->name)
               : hash;
}

static uint64_t shape_hash(struct walk *walk, const struct object *object)
{
    const unsigned flags =
        (unsigned)object->uv_mapping << 11 | (unsigned)object->kind << 7 |
        (unsigned)object->inverse << 6 | (unsigned)object->hollow << 5 |
        (unsigned)object->has_hollow << 4 | (unsigned)object->no_shadow << 3 |
        (unsigned)object->no_image << 2 | (unsigned)object->no_reflection << 1 |
        (unsigned)object->double_illuminate;
    const struct photon_flags *photons = object->more->photons;
    const double counts[] = { flags,
                              photons ? photons->target + 2.0 : 0,
                              photons ? photons->refraction : 0,
                              (double)object->more->child_count,
                              (double)object->more->clip_count,
                              (double)object->more->bound_count };
    uint64_t hash = hash_numbers(0, counts, 6);
    if (object->kind == OBJECT_MESH)
        return random_key(hash, mesh_hash(walk, object->mesh));
    if (object->kind != OBJECT_SHAPE)
        return hash;
    hash = hash_text(hash, object->primitive->name);
    hash = hash_fields(hash, object->primitive->arguments, object->shape);
    return hash_fields(hash, object->primitive->items, object->shape);
}

static void walk_object(struct walk *walk, const struct object *object,
                        affine outer);

static void walk_clips(struct walk *walk, const struct clip *clips,
                       size_t count, affine outer)
{
    for (size_t i = 0; i < count; i++)
        walk_object(walk, clips[i].object,
                    affine_compose(outer, clips[i].transform));
}

/* `outer` takes the space around the object to the world's. */
static void walk_object(struct walk *walk, const struct object *object,
                        affine outer)
{
    affine place = affine_compose(outer, *object->maps->own);
    struct fingerprint *found = &walk->found;
    if (object->kind == OBJECT_LIGHT) {
        struct light light = light_moved(object->light, &place);
        found->lights = hash_tables(found->lights, light_tables, &light);
        if (light.looks_like)
            walk_object(walk, light.looks_like, place);
        if (light.window)
            walk_object(walk, light.window, place);
        return;
    }
    found->size++;
    found->kinds = random_key(found->kinds, kind_hash(object));
    found->objects = random_key(found->objects, shape_hash(walk, object));
    found->objects = hash_affine(found->objects, &place);
    walk_material(walk, object, outer);
    for (size_t i = 0; i < object->more->child_count; i++)
        walk_object(walk, object->more->children[i], place);
    walk_clips(walk, object->more->clips, object->more->clip_count, outer);
    walk_clips(walk, object->more->bounds, object->more->bound_count, outer);
}

static const struct field *const fog_tables[] = { fog_fields,
                                                  fog_turbulence_fields, NULL };

/* Fog weakens lamps, too. */
static uint64_t fogs_hash(const struct scene *scene)
{
    uint64_t hash = random_mix(scene->fogs.count);
    for (size_t i = 0; i < scene->fogs.count; i++) {
        hash = hash_tables(hash, fog_tables, &scene->fogs.items[i]);
    }
    return hash;
}

static uint64_t sky_hash(struct walk *walk, const struct scene *scene)
{
    uint64_t hash = hash_colour(0, scene->background);
    const struct sky_sphere *sky = scene->sky;
    for (size_t i = 0; sky && i < sky->count; i++)
        hash =
            hash_rgb(pigment_hash(walk, hash, sky->pigments[i]), sky->emission);
    return sky && scene->settings.old_filter ? ~hash : hash;
}

struct fingerprint scene_fingerprint(const struct scene *scene, bool colours)
{
    struct walk walk = { .colours = colours, .capacity = 256 };
    walk.known = memory_new(walk.capacity * sizeof *walk.known);
    for (size_t i = 0; i < scene->objects.count; i++)
        walk_object(&walk, scene->objects.items[i], affine_identity());
    walk.found.surroundings =
        media_hash(&walk, fogs_hash(scene), &scene->media);
    if (colours)
        walk.found.surroundings =
            random_key(walk.found.surroundings, sky_hash(&walk, scene));
    memory_free(walk.known);
    return walk.found;
}
