/* generate SCENE [TRIANGLES [LAMPS]]: writes a bench scene to standard output,
 * the same bytes on every machine.
 *   triangles [1000000]     one mesh2: a hilly landscape
 *   forest [23542 [100]]    65 trees after section 3 of "Light meshes": the
 *                           paper's count of triangles and of lamps
 * The forest looks alike at every size: more triangles are more and smaller
 * leaves that cover as much, more lamps are fainter ones. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TREES = 65, TRUNK_SIDES = 6, GROUND = 12 };
enum { FOREST_LEAST = TREES * (2 * TRUNK_SIDES + 1) + GROUND };

static const double pi = 3.14159265358979323846;

/* In [0,1): a linear congruential sequence, for its portability. */
static double random_next(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static double random_between(unsigned *state, double low, double high)
{
    return low + (high - low) * random_next(state);
}

static double hill(double x, double z)
{
    return 0.9 * sin(1.1 * x) * cos(0.8 * z + 0.5 * x) +
           0.25 * sin(3.7 * x + 1.3 * z) + 0.06 * sin(17 * x) * cos(15 * z);
}

static void write_head(const char *camera)
{
    printf("#version 3.7;\nglobal_settings { assumed_gamma 1 }\n%s\n", camera);
}

/* Vertices of a grid of columns x rows cells over [-8,8] x [0,16]. */
static void write_grid(int columns, int rows)
{
    printf("vertex_vectors { %d", (columns + 1) * (rows + 1));
    for (int row = 0; row <= rows; row++)
        for (int column = 0; column <= columns; column++) {
            double x = 16.0 * column / columns - 8;
            double z = 16.0 * row / rows;
            printf(",\n<%.5f,%.5f,%.5f>", x, hill(x, z), z);
        }
    printf("\n}\n");
}

static void write_triangles(int count)
{
    int columns = (int)fmax(1, sqrt(count / 2.0));
    int rows = count / (2 * columns);
    int left = count - 2 * rows * columns; /* so that the count is exact */
    write_head("camera { location <0,4,-5> look_at <0,0,5>"
               " right x*image_width/image_height angle 60 }\n"
               "light_source { <-20,18,-10> rgb <1.3,1.2,1.0> }\n"
               "background { rgb <0.55,0.7,0.9> }");
    printf("mesh2 {\n");
    write_grid(columns, rows + 1);
    printf("face_indices { %d", count);
    for (int row = 0; row <= rows; row++)
        for (int column = 0; column < columns; column++) {
            int a = row * (columns + 1) + column, b = a + columns + 1;
            if (row < rows || left-- > 0)
                printf(",\n<%d,%d,%d>", a, b, a + 1);
            if (row < rows || left-- > 0)
                printf(",\n<%d,%d,%d>", a + 1, b, b + 1);
        }
    printf("\n}\npigment { rgb <0.35,0.45,0.2> } }\n");
}

/* A cone of six sides: 12 triangles, the upper radius a third. */
static void write_trunk(double x, double z, double radius, double height)
{
    for (int i = 0; i < TRUNK_SIDES; i++) {
        double a = 2 * pi * i / TRUNK_SIDES, b = a + 2 * pi / TRUNK_SIDES;
        double ax = radius * cos(a), az = radius * sin(a);
        double bx = radius * cos(b), bz = radius * sin(b);
        printf("triangle { <%.4f,0,%.4f>, <%.4f,0,%.4f>, <%.4f,%.4f,%.4f>"
               " texture { Bark } }\n",
               x + ax, z + az, x + bx, z + bz, x + ax / 3, height, z + az / 3);
        printf("triangle { <%.4f,0,%.4f>, <%.4f,%.4f,%.4f>, <%.4f,%.4f,%.4f>"
               " texture { Bark } }\n",
               x + bx, z + bz, x + ax / 3, height, z + az / 3, x + bx / 3,
               height, z + bz / 3);
    }
}

static void write_leaf(unsigned *state, double x, double y, double z,
                       double size)
{
    printf("triangle {");
    for (int corner = 0; corner < 3; corner++) {
        double dx = random_between(state, -size, size);
        double dy = random_between(state, -size, size);
        double dz = random_between(state, -size, size);
        printf("%s <%.4f,%.4f,%.4f>", corner ? "," : "", x + dx, y + dy,
               z + dz);
    }
    printf(" texture { Leaf%d } }\n", (int)(3 * random_next(state)));
}

/* Leaves fill an egg around the upper half of the trunk. 350 of them are 0.14
 * large. */
static void write_tree(unsigned *state, double x, double z, int leaves)
{
    double size = 0.14 * sqrt(350.0 / leaves);
    double height = random_between(state, 2.0, 3.2);
    double width = random_between(state, 0.6, 0.9);
    printf("mesh {\n");
    write_trunk(x, z, 0.05 * height, height);
    for (int i = 0; i < leaves; i++) {
        double turn = 2 * pi * random_next(state);
        double up = random_between(state, -1, 1);
        double reach = width * pow(random_next(state), 0.4);
        double flat = reach * sqrt(1 - up * up);
        write_leaf(state, x + flat * cos(turn), height * 0.8 + 1.3 * reach * up,
                   z + flat * sin(turn), size);
    }
    printf("}\n");
}

/* 3 x 2 rectangles of two triangles. */
static void write_ground(void)
{
    printf("mesh {\n");
    for (int i = 0; i < 6; i++) {
        double x = -15 + 10.0 * (i % 3), z = -6 + 15.0 * (i / 3);
        printf("triangle { <%g,0,%g>, <%g,0,%g>, <%g,0,%g> texture { Soil } }\n"
               "triangle { <%g,0,%g>, <%g,0,%g>, <%g,0,%g> texture { Soil } "
               "}\n",
               x, z, x + 10, z, x, z + 15, x + 10, z, x, z + 15, x + 10,
               z + 15);
    }
    printf("}\n");
}

/* Lamps have their own dice: the first hundred of a thousand hang where the
 * hundred hang. */
static void write_lamps(int count)
{
    unsigned state = 9;
    for (int i = 0; i < count; i++) {
        double x = random_between(&state, -10, 10);
        double y = random_between(&state, 4, 8);
        double z = random_between(&state, -5, 12);
        double warm = random_between(&state, 0.6, 1.0);
        printf("light_source { <%.3f,%.3f,%.3f> rgb %.6g*<1,%.3f,%.3f> }\n", x,
               y, z, 2.8 / count, 0.5 + 0.5 * warm, warm);
    }
}

static void write_forest(int triangles, int lamps)
{
    unsigned state = 1;
    int leaves = triangles - GROUND - TREES * 2 * TRUNK_SIDES;
    write_head("camera { location <0,5.5,-9.5> look_at <0,0.9,1> right x angle "
               "52 }\nbackground { rgb <0.10,0.13,0.22> }\n"
               "#default { finish { ambient 0 diffuse 0.6 } }\n"
               "#declare Bark = texture { pigment { rgb <0.24,0.15,0.09> } }\n"
               "#declare Soil = texture { pigment { rgb <0.42,0.34,0.22> } }\n"
               "#declare Leaf0 = texture { pigment { rgb <0.16,0.42,0.08> } }\n"
               "#declare Leaf1 = texture { pigment { rgb <0.30,0.50,0.10> } }\n"
               "#declare Leaf2 = texture { pigment { rgb <0.55,0.42,0.08> } }");
    printf("// %d trees, %d triangles, %d lamps\n", TREES, triangles, lamps);
    write_lamps(lamps);
    write_ground();
    for (int i = 0; i < TREES; i++) {
        double x = random_between(&state, -6.5, 6.5);
        double z = random_between(&state, -3.5, 9);
        unsigned tree = (unsigned)i;
        write_tree(&tree, x, z, leaves / TREES + (i < leaves % TREES));
    }
}

static int usage(void)
{
    fprintf(stderr,
            "usage: generate triangles [TRIANGLES, 1 to 50000000]\n"
            "       generate forest [TRIANGLES, %d to 50000000 "
            "[LAMPS, 1 to 1000000]]\n",
            FOREST_LEAST);
    return 2;
}

/* Argument I as a number, or `missing`; 0 if it is none from `low` to `high`.
 */
static int number(char **argv, int count, int i, int missing, int low, int high)
{
    if (i >= count)
        return missing;
    char *end;
    long value = strtol(argv[i], &end, 10);
    return *end || value < low || value > high ? 0 : (int)value;
}

int main(int argc, char **argv)
{
    bool forest = argc > 1 && strcmp(argv[1], "forest") == 0;
    if (argc < 2 || argc > (forest ? 4 : 3) ||
        (!forest && strcmp(argv[1], "triangles") != 0))
        return usage();
    int triangles = number(argv, argc, 2, forest ? 23542 : 1000000,
                           forest ? FOREST_LEAST : 1, 50000000);
    int lamps = number(argv, argc, 3, 100, 1, 1000000);
    if (!triangles || !lamps)
        return usage();
    if (forest)
        write_forest(triangles, lamps);
    else
        write_triangles(triangles);
    return 0;
}
