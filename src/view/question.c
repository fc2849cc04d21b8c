/* Asking the scene: see question.h. */
#include "view/question.h"

#include <stdlib.h>

#include "base/telling.h"
#include "image/tone.h"
#include "render/probe.h"
#include "render/workers.h"
#include "tracer/integrator.h"

enum { PATH_SAMPLES = 256 }; /* of --lighting path, for an irradiance */

struct question_hit question_meet(const struct model *model,
                                  const struct camera *camera, double x,
                                  double y)
{
    struct question_hit hit = { .met = false };
    if (!camera_sees(camera, x, y))
        return hit;
    hit.ray = camera_ray(camera, x, y);
    hit.met = world_closest(model->world, &hit.ray, 0, RAY_CAMERA, &hit.at);
    return hit;
}

void question_place(struct span span, char *text, size_t size)
{
    if (!span.source) {
        snprintf(text, size, "nowhere");
        return;
    }
    struct source_place place = source_locate(span.source, span.offset);
    snprintf(text, size, "%s:%u:%u", span.source->name, place.line,
             place.column);
}

struct span question_span(const struct question_hit *hit, bool texture)
{
    /* The texture that objects have by default was written nowhere. */
    return texture && hit->at.texture->span.source ? hit->at.texture->span
                                                   : hit->at.leaf->object->span;
}

void question_tell(const struct question_hit *hit, FILE *out)
{
    char object[FILENAME_MAX], texture[FILENAME_MAX];
    if (!hit->met) {
        fputs("nothing: the background\n", out);
        return;
    }
    const struct intersection *at = &hit->at;
    struct span span = question_span(hit, false);
    question_place(span, object, sizeof object);
    question_place(question_span(hit, true), texture, sizeof texture);
    fprintf(out,
            "%s: %.*s, texture %s, point <%.4g, %.4g, %.4g>, normal <%.3g, "
            "%.3g, %.3g>, distance %.4g\n",
            object, span.source ? (int)span.length : 0,
            span.source ? span.source->text + span.offset : "", texture,
            at->point.x, at->point.y, at->point.z, at->normal.x, at->normal.y,
            at->normal.z, at->t);
}

/* The irradiance of the side that is seen. */
static rgb question_light(const struct drawing *drawing,
                          const struct question_hit *hit)
{
    vec3 normal = hit->at.normal;
    if (vec3_dot(normal, hit->ray.direction) > 0)
        normal = vec3_negate(normal);
    const struct probe_point point = { hit->at.point, normal, true };
    struct render_options render = drawing->options.render;
    render.threads = 1;
    render.stop = NULL;
    render.progress = NULL;
    render.samples = PATH_SAMPLES;
    struct probe_light light;
    struct render_stats stats = { 0 };
    probe_run(&drawing->tracer, &render, &point, 1, &light, &stats);
    return light.colour;
}

/* What --debug-pixel says of the pixel; returns who answered first, or NULL. */
static const char *question_pixel(const struct drawing *drawing, int x, int y,
                                  FILE *out)
{
    const struct options *options = &drawing->options;
    struct telling telling = { .out = out };
    struct worker worker;
    struct tracer tracer = drawing->tracer;
    const struct picture_place place = { { (x + 0.5) / options->render.width,
                                           (y + 0.5) / options->render.height },
                                         { x, y } };
    worker_start(&worker, 0, NULL);
    worker.telling = &telling;
    tracer_ready(&tracer);
    tracer_camera(&tracer, &worker, &place);
    worker_end(&worker, NULL);
    return telling.answer;
}

/* Of `count` places the one at x, 0..1. */
static int question_index(double x, int count)
{
    int index = (int)(x * count);
    return index < 0 ? 0 : index < count ? index : count - 1;
}

/* Who told the light: of a lighting with several stores, the one that did. */
static void question_lit(const struct drawing *drawing,
                         const struct question_hit *hit, const int pixel[2],
                         FILE *out, char *notice, size_t size)
{
    char place[FILENAME_MAX], *lines = NULL;
    size_t length;
    const struct lighting *lighting = drawing->tracer.lighting;
    FILE *told = open_memstream(&lines, &length);
    const char *answer =
        integrator_for(lighting)->sample
            ? NULL
            : question_pixel(drawing, pixel[0], pixel[1], told);
    rgb light = question_light(drawing, hit);
    fclose(told);
    fprintf(out, "irradiance <%.4g, %.4g, %.4g> by %s%s%s\n%s", light.r,
            light.g, light.b, lighting->name, answer ? ", told by " : "",
            answer ? answer : "", lines);
    free(lines);
    question_place(question_span(hit, false), place, sizeof place);
    snprintf(notice, size,
             "%s  <%.4g, %.4g, %.4g>  at %.4g  light <%.3g, %.3g, %.3g> by "
             "%s%s%s",
             place, hit->at.point.x, hit->at.point.y, hit->at.point.z,
             hit->at.t, light.r, light.g, light.b, lighting->name,
             answer ? ", " : "", answer ? answer : "");
}

void question_answer(const struct drawing *drawing, double x, double y,
                     FILE *out, char *notice, size_t size)
{
    const struct image *image = drawing->image;
    struct question_hit hit =
        question_meet(drawing->model, &drawing->camera, x, y);
    const int pixel[2] = { question_index(x, image->width),
                           question_index(y, image->height) };
    const float *seen = image_pixel(image, pixel[0], pixel[1]);
    question_tell(&hit, out);
    fprintf(out, "pixel %d,%d: colour <%.4g, %.4g, %.4g>\n", pixel[0] + 1,
            pixel[1] + 1, (double)seen[0], (double)seen[1], (double)seen[2]);
    if (hit.met && drawing->options.quality >= QUALITY_LIT)
        question_lit(drawing, &hit, pixel, out, notice, size);
}
