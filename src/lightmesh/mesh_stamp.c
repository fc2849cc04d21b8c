/* See mesh_stamp.h. Settings are kept as text, so that a message can name the
 * one that has changed. */
#include "lightmesh/mesh_stamp.h"
#include "lightmesh/virtual_lights.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/text.h"

static void settings_add(char *settings, const char *name, const char *value)
{
    size_t length = strlen(settings);
    snprintf(settings + length, MESH_SETTINGS_SIZE - length, "%s %s\n", name,
             value);
}

static void settings_number(char *settings, const char *name, double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.17g", value);
    settings_add(settings, name, text);
}

static void settings_fields(char *settings, const struct field *table,
                            const struct settings *said)
{
    for (; table->name; table++) {
        const void *at = (const char *)said + table->offset;
        const char *word = "";
        if (table->kind == FIELD_FLOAT)
            settings_number(settings, table->name, *(const double *)at);
        else if (table->kind == FIELD_INTEGER)
            settings_number(settings, table->name, *(const int *)at);
        else if (table->kind == FIELD_BOOL)
            settings_add(settings, table->name,
                         *(const bool *)at ? "on" : "off");
        else if (table->kind == FIELD_CHOICE)
            settings_add(settings, table->name,
                         table->choices[*(const int *)at]);
        else if (table->kind == FIELD_NAME && *(const char *const *)at)
            word = *(const char *const *)at;
        if (table->kind == FIELD_NAME)
            settings_add(settings, table->name, word);
    }
}

static uint64_t regions_hash(const struct light_mesh_settings *mesh)
{
    uint64_t hash = 0;
    for (size_t i = 0; i < mesh->regions.count; i++) {
        const struct mesh_region *region = &mesh->regions.items[i];
        const double numbers[] = { region->low.x,  region->low.y,
                                   region->low.z,  region->high.x,
                                   region->high.y, region->high.z,
                                   region->factor };
        hash = hash_numbers(hash, numbers, 7);
    }
    return hash;
}

struct mesh_stamp mesh_stamp_new(const struct scene *scene,
                                 enum mesh_shadows shadows, bool indirect,
                                 int quality, unsigned long long seed)
{
    struct mesh_stamp stamp = { .scene = scene_fingerprint(scene, indirect) };
    struct settings said = scene->settings;
    char regions[24];
    said.light_mesh.shadows = shadows;
    settings_fields(stamp.settings, light_mesh_fields, &said);
    snprintf(regions, sizeof regions, "%016llx",
             (unsigned long long)regions_hash(&said.light_mesh));
    settings_add(stamp.settings, "region", regions);
    settings_add(stamp.settings, "indirect", indirect ? "on" : "off");
    if (indirect)
        settings_fields(stamp.settings, indirect_fields, &said);
    if (indirect && said.light_mesh.indirect.skeleton)
        settings_fields(stamp.settings, skeleton_fields, &said);
    settings_number(stamp.settings, "+Q", quality);
    settings_number(stamp.settings, "seed", (double)seed);
    return stamp;
}

/* Whether the value is what stands for one that was not said. */
static bool value_unsaid(const char *value)
{
    return *value == '\0' || strcmp(value, "0") == 0;
}

/* A number without the digits that only keep it exact. */
static const char *value_words(const char *value, char text[TEXT_NUMBER_SIZE])
{
    char *end;
    double number = strtod(value, &end);
    return *value && !*end ? text_number(text, number) : value;
}

static void settings_differ(const char *name, const char *made, const char *now,
                            char *text, size_t size)
{
    bool unsaid = value_unsaid(made);
    char number[2][TEXT_NUMBER_SIZE];
    snprintf(text, size, "it was made with %s%s%s%s, not with %s",
             unsaid ? "the default " : "", name, unsaid ? "" : " ",
             unsaid ? "" : value_words(made, number[0]),
             value_unsaid(now) ? "the default" : value_words(now, number[1]));
}

static bool settings_same(const char *name, const char *made, const char *now,
                          char *text, size_t size)
{
    if (strcmp(made, now) == 0)
        return true;
    /* What the mesh has is good enough for who wants none in particular. */
    if (strcmp(name, "density") == 0 && strcmp(now, "0") == 0)
        return true;
    if (strcmp(name, "region") == 0)
        snprintf(text, size, "the regions have changed");
    else
        settings_differ(name, made, now, text, size);
    return false;
}

/* The next line "name value" of *from, cut in two; false after the last. */
static bool settings_line(const char **from, char line[MESH_SETTINGS_SIZE],
                          const char **value)
{
    size_t length = strcspn(*from, "\n");
    memcpy(line, *from, length);
    line[length] = '\0';
    *from += length;
    *from += **from != '\0';
    size_t name = strcspn(line, " ");
    *value = line + name;
    if (line[name])
        (*value)++;
    line[name] = '\0';
    return length > 0;
}

static bool stamp_settings_same(const struct mesh_stamp *made,
                                const struct mesh_stamp *now, char *text,
                                size_t size)
{
    char name[2][MESH_SETTINGS_SIZE];
    const char *at[2] = { made->settings, now->settings }, *value[2];
    for (;;) {
        bool more = settings_line(&at[0], name[0], &value[0]);
        bool wanted = settings_line(&at[1], name[1], &value[1]);
        if (!more && !wanted)
            return true;
        if (strcmp(name[0], name[1]) != 0) {
            snprintf(text, size, "it was made with other settings");
            return false;
        }
        if (!settings_same(name[0], value[0], value[1], text, size))
            return false;
    }
}

bool mesh_stamp_alike(const struct mesh_stamp *a, const struct mesh_stamp *b)
{
    return strcmp(a->settings, b->settings) == 0;
}

bool mesh_stamp_same(const struct mesh_stamp *made,
                     const struct mesh_stamp *now, char *text, size_t size)
{
    const char *changed = NULL;
    if (made->scene.surroundings != now->scene.surroundings)
        changed = "the background, the sky or the fog has changed";
    if (made->scene.textures != now->scene.textures)
        changed = "the textures have changed";
    if (made->scene.lights != now->scene.lights)
        changed = "the lights have changed";
    if (made->scene.objects != now->scene.objects)
        changed = "the objects have changed";
    if (!stamp_settings_same(made, now, text, size))
        return false;
    if (changed)
        snprintf(text, size, "%s", changed);
    return !changed;
}

/* Returns what comes after. */
static double *discs_put(const struct bright *bright, double *to)
{
    for (int i = 0; i < bright->count; i++, to += FRAME_DISC_NUMBERS) {
        const struct bright_disc *disc = &bright->at[i];
        const double numbers[FRAME_DISC_NUMBERS] = {
            disc->centre.x, disc->centre.y, disc->centre.z, disc->normal.x,
            disc->normal.y, disc->normal.z, disc->worth,    disc->brought
        };
        memcpy(to, numbers, sizeof numbers);
    }
    return to;
}

static const double *discs_take(struct bright *bright, double count,
                                double radius, const double *from)
{
    bright->count = (int)fmin(fmax(count, 0), BRIGHT_MOST);
    bright->radius = radius;
    for (int i = 0; i < bright->count; i++, from += FRAME_DISC_NUMBERS)
        bright->at[i] = (struct bright_disc){ { from[0], from[1], from[2] },
                                              { from[3], from[4], from[5] },
                                              from[6],
                                              from[7] };
    return from;
}

static bool disc_possible(const struct bright_disc *disc)
{
    return disc->worth > 0 && disc->brought >= 0 && disc->brought <= 1;
}

static bool discs_possible(const struct bright *bright)
{
    for (int i = 0; i < bright->count; i++)
        if (!disc_possible(&bright->at[i]))
            return false;
    return bright->count == 0 || bright->radius > 0;
}

void mesh_frame_put(const struct mesh_frame *frame,
                    double numbers[MESH_FRAME_NUMBERS])
{
    const struct mesh_frame *f = frame;
    const double first[FRAME_OWN_NUMBERS] = {
        f->spacing,        f->wanted,      f->near,           f->eye.x,
        f->eye.y,          f->eye.z,       f->centre.x,       f->centre.y,
        f->centre.z,       f->size,        f->gather,         f->samples,
        f->asked,          f->closed,      f->around.light.r, f->around.light.g,
        f->around.light.b, f->around.open, f->bright.count,   f->bright.radius,
        f->edged,          f->lit.count,   f->lit.radius,     f->picks,
        f->glow_picks,
    };
    double *to = numbers + FRAME_OWN_NUMBERS;
    memset(numbers, 0, MESH_FRAME_NUMBERS * sizeof *numbers);
    memcpy(numbers, first, sizeof first);
    to = discs_put(&f->bright, to);
    discs_put(&f->lit, to);
}

void mesh_frame_take(struct mesh_frame *frame,
                     const double numbers[MESH_FRAME_NUMBERS])
{
    const double *n = numbers, *from = numbers + FRAME_OWN_NUMBERS;
    *frame = (struct mesh_frame){
        .spacing = n[0],
        .wanted = n[1],
        .near = n[2],
        .eye = { n[3], n[4], n[5] },
        .centre = { n[6], n[7], n[8] },
        .size = n[9],
        .gather = n[10],
        .samples = (int)fmin(fmax(n[11], 0), 1e6),
        .asked = (int)fmin(fmax(n[12], 0), 1e6),
        .edged = (int)fmin(fmax(n[20], 0), 1e6),
        .picks = (int)fmin(fmax(n[23], 0), VIRTUAL_PICKS_USUAL),
        .glow_picks = (int)fmin(fmax(n[24], 0), VIRTUAL_PICKS_USUAL),
        .closed = n[13] > 0,
        .around = { { n[14], n[15], n[16] }, n[17] },
    };
    from = discs_take(&frame->bright, n[18], n[19], from);
    discs_take(&frame->lit, n[21], n[22], from);
}

bool mesh_frame_possible(const struct mesh_frame *frame)
{
    double numbers[MESH_FRAME_NUMBERS];
    mesh_frame_put(frame, numbers);
    for (int i = 0; i < MESH_FRAME_NUMBERS; i++)
        if (!isfinite(numbers[i]))
            return false;
    return discs_possible(&frame->bright) && discs_possible(&frame->lit) &&
           frame->spacing > 0 && frame->wanted > 0 && frame->near >= 0 &&
           frame->size >= 0 && frame->gather > 0;
}

uint64_t mesh_stamp_family(const struct mesh_stamp *stamp)
{
    double frame[MESH_FRAME_NUMBERS];
    mesh_frame_put(&stamp->frame, frame);
    const uint64_t scene[] = { stamp->scene.objects, stamp->scene.textures,
                               stamp->scene.lights, stamp->scene.surroundings };
    uint64_t hash = hash_numbers(1, frame, MESH_FRAME_NUMBERS);
    hash = hash_bytes(hash, scene, sizeof scene);
    return hash_text(hash, stamp->settings);
}
