/* Points and lines over a picture: see overlay.h. Lines are cut into strokes
 * of about two pixels; a ray tells of each whether it is hidden. */
#include "render/overlay.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "image/tone.h"

/* A straight piece of a line, or a dot: one colour, all of it hidden or not.
 * Pixels from the top left. */
struct stroke {
    double x0, y0, x1, y1;
    double radius;
    vec3 at;      /* world, its middle */
    double depth; /* from the camera, in directions */
    double number;
    bool hidden;
};

struct overlay {
    const struct tracer *tracer;
    const struct camera *camera;
    const struct render_options *options;
    const struct show *show;
    struct image *image;
    double line; /* half the width of lines, pixels */
    struct arena *arena;
    struct {
        struct stroke *items;
        size_t count, capacity;
    } strokes;
};

static const double stroke_length = 2; /* pixels */
static const double hidden_opacity = 0.3;
enum {
    STROKES_CHUNK = 256, /* a thread takes at a time */
    SEEN_THROUGH = 16,   /* clear surfaces before a stroke, at most */
};

/* ---- from space to strokes ---- */

/* Pixels of a place before the camera. */
static void overlay_place(const struct overlay *overlay, vec3 view, double *x,
                          double *y)
{
    camera_place(overlay->camera, view, x, y);
    *x *= overlay->options->width;
    *y *= overlay->options->height;
}

static void overlay_dot(struct overlay *overlay, const struct show_point *point)
{
    const struct render_options *options = overlay->options;
    vec3 view = camera_view(overlay->camera, point->at);
    struct stroke stroke = { .radius = 2 * overlay->line,
                             .at = point->at,
                             .depth = view.z,
                             .number = point->number };
    if (!(view.z > 0))
        return;
    overlay_place(overlay, view, &stroke.x0, &stroke.y0);
    double margin = stroke.radius + 1;
    if (!(stroke.x0 > -margin && stroke.x0 < options->width + margin &&
          stroke.y0 > -margin && stroke.y0 < options->height + margin))
        return;
    stroke.x1 = stroke.x0;
    stroke.y1 = stroke.y0;
    *ARRAY_PUSH(overlay->arena, &overlay->strokes) = stroke;
}

/* A line in space and in the picture. */
struct path {
    const struct show_line *line;
    vec3 view[2];   /* ends, cut to what is before the camera */
    double part[2]; /* of the line, where these are */
    double x[2], y[2];
};

/* What is before the camera: a hair before it at least. */
static bool path_cut(struct path *path)
{
    double front = fmax(path->view[0].z, path->view[1].z), near = 1e-4 * front;
    for (int end = 0; end < 2; end++) {
        vec3 this = path->view[end], other = path->view[1 - end];
        if (this.z >= near)
            continue;
        double share = (near - this.z) / (other.z - this.z);
        path->view[end] = vec3_along(this, vec3_sub(other, this), share);
        path->part[end] += (path->part[1 - end] - path->part[end]) * share;
    }
    return front > 0;
}

/* Narrows t[0]..t[1] to where from + t * step is within low..high. */
static void range_clip(double from, double step, double low, double high,
                       double t[2])
{
    if (step == 0) {
        if (from < low || from > high)
            t[1] = -1;
        return;
    }
    double a = (low - from) / step, b = (high - from) / step;
    t[0] = fmax(t[0], fmin(a, b));
    t[1] = fmin(t[1], fmax(a, b));
}

/* How far along the line of the scene the share t of its picture is. */
static double path_part(const struct overlay *overlay, const struct path *path,
                        double t)
{
    double from = path->view[0].z, to = path->view[1].z;
    if (overlay->camera->kind->lines == CAMERA_CENTRAL)
        t = t * from / (to + t * (from - to));
    return path->part[0] + (path->part[1] - path->part[0]) * t;
}

static struct stroke path_stroke(const struct overlay *overlay,
                                 const struct path *path, double start,
                                 double end)
{
    const struct show_line *line = path->line;
    double width = path->x[1] - path->x[0], height = path->y[1] - path->y[0];
    double part = path_part(overlay, path, (start + end) / 2);
    vec3 at = vec3_along(line->from, vec3_sub(line->to, line->from), part);
    return (struct stroke){
        .x0 = path->x[0] + start * width,
        .y0 = path->y[0] + start * height,
        .x1 = path->x[0] + end * width,
        .y1 = path->y[0] + end * height,
        .radius = overlay->line,
        .at = at,
        .depth = camera_view(overlay->camera, at).z,
        .number =
            line->from_number + part * (line->to_number - line->from_number),
    };
}

/* Two short strokes back from the end. */
static void path_head(struct overlay *overlay, const struct path *path)
{
    struct stroke stroke = path_stroke(overlay, path, 1, 1);
    double x = path->x[0] - path->x[1], y = path->y[0] - path->y[1];
    double length = sqrt(x * x + y * y);
    double head = fmin(6 * overlay->line, length / 2) / fmax(length, 1e-9);
    for (int side = -1; side <= 1; side += 2) {
        stroke.x1 = stroke.x0 + head * (x - 0.6 * side * y);
        stroke.y1 = stroke.y0 + head * (y + 0.6 * side * x);
        *ARRAY_PUSH(overlay->arena, &overlay->strokes) = stroke;
    }
}

static void overlay_line(struct overlay *overlay, const struct show_line *line)
{
    const struct render_options *options = overlay->options;
    struct path path = { .line = line, .part = { 0, 1 } };
    double t[2] = { 0, 1 }, margin = overlay->line + 1;
    path.view[0] = camera_view(overlay->camera, line->from);
    path.view[1] = camera_view(overlay->camera, line->to);
    if (!path_cut(&path))
        return;
    for (int end = 0; end < 2; end++)
        overlay_place(overlay, path.view[end], &path.x[end], &path.y[end]);
    double width = path.x[1] - path.x[0], height = path.y[1] - path.y[0];
    if (!isfinite(width) || !isfinite(height))
        return;
    range_clip(path.x[0], width, -margin, options->width + margin, t);
    range_clip(path.y[0], height, -margin, options->height + margin, t);
    if (!(t[0] <= t[1]))
        return;
    double length = (t[1] - t[0]) * sqrt(width * width + height * height);
    int count = (int)ceil(length / stroke_length) + 1;
    double step = (t[1] - t[0]) / count;
    for (int i = 0; i < count; i++)
        *ARRAY_PUSH(overlay->arena, &overlay->strokes) =
            path_stroke(overlay, &path, t[0] + i * step, t[0] + (i + 1) * step);
    if (line->arrow && t[1] == 1)
        path_head(overlay, &path);
}

/* ---- what hides them ---- */

static bool overlay_hides(const struct overlay *overlay,
                          const struct stroke *stroke)
{
    const struct camera *camera = overlay->camera;
    struct ray ray = { camera->location, camera->direction };
    if (camera->kind->lines == CAMERA_CENTRAL)
        ray.direction = vec3_sub(stroke->at, camera->location);
    else
        ray.origin = vec3_along(stroke->at, camera->direction, -stroke->depth);
    double distance = vec3_length(vec3_sub(stroke->at, ray.origin)), tmin = 0;
    ray.direction = vec3_normalise(ray.direction);
    for (int i = 0; i < SEEN_THROUGH; i++) {
        struct intersection at;
        if (!world_within(overlay->tracer->world, &ray, tmin,
                          distance * (1 - 1e-6), RAY_CAMERA, &at))
            return false;
        if (at.leaf->look->opaque)
            return true;
        tmin = at.t * (1 + 1e-9);
    }
    return true;
}

static void overlay_look(void *context, size_t item, unsigned thread)
{
    struct overlay *overlay = context;
    size_t end = (item + 1) * STROKES_CHUNK;
    (void)thread;
    for (size_t i = item * STROKES_CHUNK; i < end && i < overlay->strokes.count;
         i++)
        overlay->strokes.items[i].hidden =
            overlay_hides(overlay, &overlay->strokes.items[i]);
}

/* ---- from strokes to pixels ---- */

/* What is hidden first, then from far to near; the rest of the order is only
 * that there is one. */
static int stroke_compare(const void *one, const void *other)
{
    const struct stroke *a = one, *b = other;
    const double keys[][2] = {
        { b->hidden, a->hidden }, { b->depth, a->depth },   { a->x0, b->x0 },
        { a->y0, b->y0 },         { a->number, b->number }, { a->x1, b->x1 },
        { a->y1, b->y1 },
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] != keys[i][1])
            return keys[i][0] < keys[i][1] ? -1 : 1;
    return 0;
}

/* How far a pixel's centre is from the stroke. */
static double stroke_distance(const struct stroke *stroke, double x, double y)
{
    double width = stroke->x1 - stroke->x0, height = stroke->y1 - stroke->y0;
    double squared = width * width + height * height, t = 0;
    if (squared > 0)
        t = ((x - stroke->x0) * width + (y - stroke->y0) * height) / squared;
    t = fmin(fmax(t, 0), 1);
    return hypot(x - stroke->x0 - t * width, y - stroke->y0 - t * height);
}

static int limited(double value, int low, int high)
{
    return value > low ? value < high ? (int)value : high : low;
}

/* Lays the stroke over `layer`, colours that are not multiplied by their
 * opacity. Where strokes meet the more opaque one wins, so that ends that
 * touch leave no knots. */
static void overlay_paint(const struct overlay *overlay,
                          const struct stroke *stroke, const float tint[3],
                          struct image *layer)
{
    const struct render_options *options = overlay->options;
    double reach = stroke->radius + 1;
    double opacity = stroke->hidden ? hidden_opacity : 1;
    int left = options->column_start, right = options->column_end;
    int top = options->row_start, bottom = options->row_end;
    left = limited(fmin(stroke->x0, stroke->x1) - reach, left, right);
    right = limited(fmax(stroke->x0, stroke->x1) + reach + 1, left, right);
    top = limited(fmin(stroke->y0, stroke->y1) - reach, top, bottom);
    bottom = limited(fmax(stroke->y0, stroke->y1) + reach + 1, top, bottom);
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            float *pixel = image_pixel(layer, x, y);
            double away = stroke_distance(stroke, x + 0.5, y + 0.5);
            double cover = fmin(stroke->radius + 0.5 - away, 1) * opacity;
            if (!(cover > 0) || cover < (double)pixel[3])
                continue;
            memcpy(pixel, tint, 3 * sizeof *tint);
            pixel[3] = (float)cover;
        }
}

/* Puts the layer over the picture, whose colours are premultiplied and, where
 * something is drawn, no brighter than white. */
static void overlay_blend(const struct overlay *overlay, double working_gamma,
                          const struct image *layer)
{
    size_t pixels = (size_t)layer->width * (size_t)layer->height;
    for (size_t i = 0; i < pixels; i++) {
        const float *over = layer->pixels + 4 * i;
        float *under = overlay->image->pixels + 4 * i;
        if (!(over[3] > 0))
            continue;
        for (int c = 0; c < 3; c++) {
            double light = tone_srgb_decode((double)over[c]);
            float value = (float)tone_encode(light, working_gamma);
            under[c] = over[3] * value + (1 - over[3]) * fminf(under[c], 1);
        }
        under[3] = over[3] + (1 - over[3]) * under[3];
    }
}

static void overlay_strokes(struct overlay *overlay, struct ramp_range *range)
{
    const struct show *show = overlay->show;
    *range = (struct ramp_range){ .logarithmic = show->logarithmic };
    for (size_t i = 0; i < show->points.count; i++) {
        ramp_range_add(range, show->points.items[i].number);
        overlay_dot(overlay, &show->points.items[i]);
    }
    for (size_t i = 0; i < show->lines.count; i++) {
        ramp_range_add(range, show->lines.items[i].from_number);
        ramp_range_add(range, show->lines.items[i].to_number);
        overlay_line(overlay, &show->lines.items[i]);
    }
}

bool overlay_draw(const struct tracer *tracer,
                  const struct render_options *options, const struct show *show,
                  double working_gamma, struct image *image,
                  struct ramp_range *range)
{
    struct overlay overlay = {
        .tracer = tracer,
        .camera = &tracer->scene->camera,
        .options = options,
        .show = show,
        .image = image,
        .line = fmax(0.6, options->height / 450.0),
        .arena = arena_new(0),
    };
    overlay_strokes(&overlay, range);
    size_t count = overlay.strokes.count;
    bool done = parallel_run(options->threads ? options->threads : 1,
                             (count + STROKES_CHUNK - 1) / STROKES_CHUNK,
                             options->stop, overlay_look, &overlay);
    if (done && count > 0) {
        struct image *layer = image_new(image->width, image->height);
        qsort(overlay.strokes.items, count, sizeof *overlay.strokes.items,
              stroke_compare);
        for (size_t i = 0; i < count; i++) {
            const struct stroke *stroke = &overlay.strokes.items[i];
            float tint[3];
            ramp_colour(RAMP_SPECTRUM, ramp_range_place(range, stroke->number),
                        tint);
            overlay_paint(&overlay, stroke, tint, layer);
        }
        overlay_blend(&overlay, working_gamma, layer);
        image_free(layer);
    }
    arena_free(overlay.arena);
    return done;
}
