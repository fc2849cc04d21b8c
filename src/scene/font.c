/* Reads TrueType fonts: see font.h. Numbers in them are big-endian. */
#include "scene/font.h"

#include "base/array.h"

/* A letter has some hundred points, of ornate fonts some thousand: a broken one
 * could have millions, part within part. */
enum { COMPOSITE_DEPTH = 8, POINTS_LIMIT = 30000 };

struct table {
    size_t offset, length;
};

struct font {
    const uint8_t *bytes;
    size_t size;
    struct table places, outlines, widths, pairs;
    size_t map;   /* where the characters' subtable begins; 0: none */
    bool symbols; /* whose characters are 0xf000 and on */
    bool wide;    /* places are of 4 bytes */
    double units; /* of the font's size */
    int letters, metrics;
};

/* Beyond the end there are zeroes. */
static unsigned font_byte(const struct font *font, size_t at)
{
    return at < font->size ? font->bytes[at] : 0;
}

static unsigned font_u16(const struct font *font, size_t at)
{
    return font_byte(font, at) << 8 | font_byte(font, at + 1);
}

static int font_i16(const struct font *font, size_t at)
{
    return (int16_t)font_u16(font, at);
}

static uint32_t font_u32(const struct font *font, size_t at)
{
    return (uint32_t)font_u16(font, at) << 16 | font_u16(font, at + 2);
}

static struct table font_table(const struct font *font, const char *name)
{
    unsigned count = font_u16(font, 4);
    for (unsigned i = 0; i < count; i++) {
        size_t row = 12 + 16 * (size_t)i;
        if (row + 16 > font->size)
            break;
        if (memcmp(font->bytes + row, name, 4) == 0)
            return (struct table){ font_u32(font, row + 8),
                                   font_u32(font, row + 12) };
    }
    return (struct table){ 0, 0 };
}

/* Unicode where there is, then symbols, then the characters of old Macs, of
 * which the first 128 are those of ASCII. */
static void font_find_map(struct font *font)
{
    size_t map = font_table(font, "cmap").offset;
    unsigned count = map ? font_u16(font, map + 2) : 0;
    int best = 0;
    for (unsigned i = 0; i < count; i++) {
        size_t row = map + 4 + 8 * (size_t)i;
        unsigned platform = font_u16(font, row);
        unsigned encoding = font_u16(font, row + 2);
        int rank = platform == 3 && (encoding == 1 || encoding == 10) ? 4
                   : platform == 0                                    ? 3
                   : platform == 3 && encoding == 0                   ? 2
                   : platform == 1                                    ? 1
                                                                      : 0;
        if (rank <= best)
            continue;
        best = rank;
        font->map = map + font_u32(font, row + 4);
        font->symbols = rank == 2;
    }
}

/* The first table of pairs of the old kind. */
static void font_find_pairs(struct font *font)
{
    struct table kern = font_table(font, "kern");
    if (kern.offset && font_u16(font, kern.offset) == 0 &&
        font_u16(font, kern.offset + 2) > 0 &&
        (font_u16(font, kern.offset + 8) & 0xff07) == 1)
        font->pairs = (struct table){ kern.offset + 18,
                                      font_u16(font, kern.offset + 10) };
}

const struct font *font_new(struct arena *arena, const char *bytes, size_t size,
                            const char **problem)
{
    struct font *font = ARENA_NEW(arena, struct font);
    font->bytes = (const uint8_t *)bytes;
    font->size = size;
    uint32_t kind = font_u32(font, 0);
    size_t head = font_table(font, "head").offset;
    size_t most = font_table(font, "maxp").offset;
    size_t across = font_table(font, "hhea").offset;
    font->places = font_table(font, "loca");
    font->outlines = font_table(font, "glyf");
    font->widths = font_table(font, "hmtx");
    *problem = "it is no TrueType font";
    if (kind != 0x00010000 && kind != 0x74727565)
        return NULL;
    *problem = "it has no outlines of the TrueType kind";
    if (!head || !most || !across || !font->places.offset ||
        !font->outlines.offset || !font->widths.offset)
        return NULL;
    font->units = font_u16(font, head + 18);
    font->wide = font_u16(font, head + 50) != 0;
    font->letters = (int)font_u16(font, most + 4);
    font->metrics = (int)font_u16(font, across + 34);
    *problem = "its numbers are wrong";
    if (!(font->units > 0) || font->letters == 0 || font->metrics == 0)
        return NULL;
    font_find_map(font);
    font_find_pairs(font);
    return font;
}

/* Format 4: ranges of characters, each with what to add, or with a list. */
static unsigned map_ranges(const struct font *font, unsigned character)
{
    unsigned twice = font_u16(font, font->map + 6);
    for (unsigned i = 0; i + 1 < twice; i += 2) {
        size_t ends = font->map + 14 + i, starts = ends + twice + 2;
        size_t deltas = starts + twice, lists = deltas + twice;
        unsigned first = font_u16(font, starts);
        if (character > font_u16(font, ends))
            continue;
        if (character < first)
            return 0;
        unsigned delta = font_u16(font, deltas), list = font_u16(font, lists);
        if (list == 0)
            return (character + delta) & 0xffff;
        unsigned letter =
            font_u16(font, lists + list + 2 * (size_t)(character - first));
        return letter ? (letter + delta) & 0xffff : 0;
    }
    return 0;
}

/* Format 12: groups of characters that follow each other. */
static unsigned map_groups(const struct font *font, uint32_t character)
{
    uint32_t count = font_u32(font, font->map + 12);
    for (uint32_t i = 0; i < count; i++) {
        size_t row = font->map + 16 + 12 * (size_t)i;
        if (row >= font->size)
            break;
        uint32_t first = font_u32(font, row);
        if (character >= first && character <= font_u32(font, row + 4))
            return font_u32(font, row + 8) + (character - first);
    }
    return 0;
}

static unsigned map_letter(const struct font *font, uint32_t character)
{
    unsigned first;
    switch (font->map ? font_u16(font, font->map) : 0xffff) {
    case 0:
        return character < 256 ? font_byte(font, font->map + 6 + character) : 0;
    case 4:
        return character < 0x10000 ? map_ranges(font, character) : 0;
    case 6:
        first = font_u16(font, font->map + 6);
        return character >= first &&
                       character - first < font_u16(font, font->map + 8)
                   ? font_u16(font, font->map + 10 + 2 * (character - first))
                   : 0;
    case 12:
        return map_groups(font, character);
    default:
        return 0;
    }
}

int font_letter(const struct font *font, uint32_t character)
{
    unsigned letter = map_letter(font, character);
    if (!letter && font->symbols && character < 256)
        letter = map_letter(font, 0xf000 + character);
    return letter < (unsigned)font->letters ? (int)letter : 0;
}

double font_advance(const struct font *font, int letter)
{
    int row = letter < font->metrics ? letter : font->metrics - 1;
    return font_u16(font, font->widths.offset + 4 * (size_t)row) / font->units;
}

/* Letters beyond the last that has both share its width. */
double font_bearing(const struct font *font, int letter)
{
    int more = letter - font->metrics;
    size_t at = 4 * (size_t)(more < 0 ? letter : font->metrics) +
                (more < 0 ? 2 : 2 * (size_t)more);
    return font_i16(font, font->widths.offset + at) / font->units;
}

/* Not every font has its pairs in order. */
double font_kerning(const struct font *font, int left, int right)
{
    uint32_t key = (uint32_t)left << 16 | (uint32_t)right;
    for (size_t i = 0; i < font->pairs.length; i++) {
        size_t row = font->pairs.offset + 6 * i;
        if (font_u32(font, row) == key)
            return font_i16(font, row + 4) / font->units;
    }
    return 0;
}

/* ---- Outlines ---- */

struct point {
    double at[2];
    bool on;   /* the curve; else it pulls the curve */
    bool last; /* of its contour */
};

struct drawing {
    const struct font *font;
    struct arena *arena;
    struct segment_list {
        struct segment *items;
        size_t count, capacity;
    } segments;
    struct affine2 {
        double xx, xy, yx, yy, x, y;
    } map; /* of the letter's points */
    int parts, points;
};

static void drawing_place(const struct drawing *drawing, const double from[2],
                          double to[2])
{
    const struct affine2 *m = &drawing->map;
    double units = drawing->font->units;
    to[0] = (m->xx * from[0] + m->xy * from[1] + m->x) / units;
    to[1] = (m->yx * from[0] + m->yy * from[1] + m->y) / units;
}

static void drawing_add(struct drawing *drawing, const double a[2],
                        const double *b, const double c[2])
{
    double p[3][2];
    drawing_place(drawing, a, p[0]);
    drawing_place(drawing, c, p[2]);
    if (b)
        drawing_place(drawing, b, p[1]);
    *ARRAY_PUSH(drawing->arena, &drawing->segments) =
        b ? segment_quadratic(p[0], p[1], p[2]) : segment_line(p[0], p[2]);
}

static void point_between(const struct point *a, const struct point *b,
                          double middle[2])
{
    middle[0] = 0.5 * (a->at[0] + b->at[0]);
    middle[1] = 0.5 * (a->at[1] + b->at[1]);
}

/* Between two points off the curve there is one on it that is not written. */
static void draw_contour(struct drawing *drawing, const struct point *points,
                         size_t count)
{
    double start[2], from[2], to[2];
    const double *pull = NULL;
    if (count < 2)
        return;
    size_t first = 0;
    while (first < count && !points[first].on)
        first++;
    if (first < count)
        memcpy(start, points[first].at, sizeof start);
    else
        point_between(&points[0], &points[count - 1], start);
    /* All are off it: the contour begins before its first point. */
    size_t rest = first < count ? 1 : 0;
    first %= count;
    memcpy(from, start, sizeof from);
    for (size_t i = rest; i < count; i++) {
        const struct point *point = &points[(first + i) % count];
        const struct point *before = &points[(first + i + count - 1) % count];
        if (point->on)
            memcpy(to, point->at, sizeof to);
        else if (pull)
            point_between(before, point, to);
        if (point->on || pull) {
            drawing_add(drawing, from, pull, to);
            memcpy(from, to, sizeof from);
        }
        pull = point->on ? NULL : point->at;
    }
    drawing_add(drawing, from, pull, start);
}

static void draw_letter(struct drawing *drawing, int letter, int depth);

/* Bits of a part of a composite letter. */
enum {
    PART_WORDS = 1,
    PART_OFFSETS = 2,
    PART_SCALE = 8,
    PART_MORE = 32,
    PART_SCALES = 64,
    PART_MATRIX = 128,
};

static double font_f2dot14(const struct font *font, size_t at)
{
    return font_i16(font, at) / 16384.0;
}

/* One part at `at`, which moves behind it; whether there are more. */
static bool draw_part(struct drawing *drawing, size_t *at, int depth)
{
    const struct font *font = drawing->font;
    unsigned bits = font_u16(font, *at);
    int letter = (int)font_u16(font, *at + 2);
    struct affine2 outer = drawing->map, own = { 1, 0, 0, 1, 0, 0 };
    *at += 4;
    bool words = bits & PART_WORDS;
    if (bits & PART_OFFSETS) {
        own.x = words ? font_i16(font, *at) : (int8_t)font_byte(font, *at);
        own.y =
            words ? font_i16(font, *at + 2) : (int8_t)font_byte(font, *at + 1);
    }
    *at += words ? 4 : 2;
    if (bits & PART_SCALE) {
        own.xx = own.yy = font_f2dot14(font, *at);
        *at += 2;
    } else if (bits & PART_SCALES) {
        own.xx = font_f2dot14(font, *at);
        own.yy = font_f2dot14(font, *at + 2);
        *at += 4;
    } else if (bits & PART_MATRIX) {
        own.xx = font_f2dot14(font, *at);
        own.yx = font_f2dot14(font, *at + 2);
        own.xy = font_f2dot14(font, *at + 4);
        own.yy = font_f2dot14(font, *at + 6);
        *at += 8;
    }
    drawing->map = (struct affine2){
        outer.xx * own.xx + outer.xy * own.yx,
        outer.xx * own.xy + outer.xy * own.yy,
        outer.yx * own.xx + outer.yy * own.yx,
        outer.yx * own.xy + outer.yy * own.yy,
        outer.xx * own.x + outer.xy * own.y + outer.x,
        outer.yx * own.x + outer.yy * own.y + outer.y,
    };
    draw_letter(drawing, letter, depth + 1);
    drawing->map = outer;
    return (bits & PART_MORE) && *at < font->size && drawing->parts++ < 1000;
}

/* The x, then the y of all points: as much as is said in the points' bits. */
static size_t read_coordinates(const struct font *font, size_t at, int k,
                               const uint8_t *bits, struct point *points,
                               int count)
{
    unsigned is_short = k ? 4 : 2, same = k ? 32 : 16;
    int value = 0;
    for (int i = 0; i < count; i++) {
        if (bits[i] & is_short) {
            int step = (int)font_byte(font, at++);
            value += bits[i] & same ? step : -step;
        } else if (!(bits[i] & same)) {
            value += font_i16(font, at);
            at += 2;
        }
        points[i].at[k] = value;
    }
    return at;
}

static void draw_simple(struct drawing *drawing, size_t at, int contours)
{
    const struct font *font = drawing->font;
    size_t ends = at + 10;
    size_t next = ends + 2 * (size_t)contours;
    int count = (int)font_u16(font, next - 2) + 1;
    next += 2 + font_u16(font, next);
    drawing->points += count;
    if (next >= font->size || drawing->points > POINTS_LIMIT)
        return;
    uint8_t *bits = ARENA_ARRAY(drawing->arena, uint8_t, (size_t)count);
    struct point *points =
        ARENA_ARRAY(drawing->arena, struct point, (size_t)count);
    for (int i = 0; i < count;) {
        unsigned bit = font_byte(font, next++);
        unsigned repeat = bit & 8 ? font_byte(font, next++) : 0;
        for (unsigned k = 0; k <= repeat && i < count; k++)
            bits[i++] = (uint8_t)bit;
    }
    next = read_coordinates(font, next, 0, bits, points, count);
    read_coordinates(font, next, 1, bits, points, count);
    for (int i = 0; i < count; i++)
        points[i].on = bits[i] & 1;
    int first = 0;
    for (int i = 0; i < contours; i++) {
        int last = (int)font_u16(font, ends + 2 * (size_t)i);
        if (last < first || last >= count)
            return;
        draw_contour(drawing, points + first, (size_t)(last - first + 1));
        first = last + 1;
    }
}

static void draw_letter(struct drawing *drawing, int letter, int depth)
{
    const struct font *font = drawing->font;
    size_t place = font->places.offset, row = (size_t)letter;
    if (letter >= font->letters || depth > COMPOSITE_DEPTH)
        return;
    size_t begin = font->wide ? font_u32(font, place + 4 * row)
                              : 2 * (size_t)font_u16(font, place + 2 * row);
    size_t end = font->wide ? font_u32(font, place + 4 * row + 4)
                            : 2 * (size_t)font_u16(font, place + 2 * row + 2);
    size_t at = font->outlines.offset + begin;
    if (end <= begin || at + 12 > font->size)
        return;
    int contours = font_i16(font, at);
    if (contours > 0) {
        draw_simple(drawing, at, contours);
    } else if (contours < 0) {
        at += 10;
        while (draw_part(drawing, &at, depth))
            continue;
    }
}

struct letter font_outline(const struct font *font, int letter,
                           struct arena *arena)
{
    struct drawing drawing = { .font = font,
                               .arena = arena,
                               .map = { 1, 0, 0, 1, 0, 0 } };
    draw_letter(&drawing, letter, 0);
    return (struct letter){ drawing.segments.items, drawing.segments.count };
}
