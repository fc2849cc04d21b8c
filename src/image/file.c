/* Image files around the codec module, which is loaded when the first picture
 * is read or written. See file.h. */
#include "image/file.h"

#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/library.h"
#include "base/memory.h"
#include "base/save.h"
#include "image/codec.h"
#include "image/exr.h"
#include "image/gif.h"
#include "image/jpeg.h"
#include "image/kind.h"
#include "image/png.h"
#include "image/pnm.h"

#define MODULE "glim-image.so"

/* Where it may be, seen from the program's directory: beside it in a build,
 * where `make install` puts it, and above the unit tests. */
static const char *const places[] = { "/", "/../lib/glim/", "/../../" };

#define NO_MODULE                                                              \
    "files of this kind need glim's module glim-image.so, which 'make' "       \
    "builds with OpenImageIO and which belongs in ../lib/glim seen from the "  \
    "program (it is not there)"

/* Whether it is there; its name, of PATH_MAX + 64 characters at most. */
static bool file_find_module(char *name)
{
    ssize_t length = readlink("/proc/self/exe", name, PATH_MAX);
    if (length < 0)
        length = 0;
    name[length] = '\0';
    char *end = strrchr(name, '/');
    if (!end)
        end = name;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        sprintf(end, "%s" MODULE, places[i]);
        if (access(name, R_OK) == 0)
            return true;
    }
    return false;
}

enum { MODULE_TAKES = 480 }; /* MB, most of them for libraries of OIIO's */

/* The module, loaded, or NULL with the reason. */
static void *file_module(char *error, size_t size)
{
    char name[PATH_MAX + 64], why[200];
    if (!file_find_module(name)) {
        snprintf(error, size, NO_MODULE);
        return NULL;
    }
    void *module = library_open(name, MODULE_TAKES, why, sizeof why);
    if (!module)
        snprintf(error, size, "glim's module " MODULE " can't be loaded: %s",
                 why);
    return module;
}

static const char build[] =
#include "codec.inc"
    ;

/* A function of the module, or NULL with the reason. */
static void *file_codec(const char *name, char *error, size_t size)
{
    void *module = file_module(error, size);
    void *function = module ? dlsym(module, name) : NULL;
    if (!module)
        return NULL;
    const char *of = dlsym(module, "codec_build");
    if (function && of && strcmp(of, build) == 0)
        return function;
    snprintf(error, size,
             MODULE " belongs to another glim: type make, or make install, "
                    "which write both");
    return NULL;
}

/* What writes such files, if it isn't the module. */
static codec_stream_function *
file_own_encoder(const struct image_format *format)
{
    return strcmp(format->type, "png") == 0       ? png_encode
           : strcmp(format->type, "pnm") == 0     ? pnm_encode
           : strcmp(format->type, "openexr") == 0 ? exr_encode
                                                  : NULL;
}

void image_prepare(void *format)
{
    char error[256];
    if (!file_own_encoder(format))
        file_module(error, sizeof error);
}

bool image_can_write(const struct image_format *format, char *error,
                     size_t size)
{
    char name[PATH_MAX + 64];
    if (file_own_encoder(format) || file_find_module(name))
        return true;
    snprintf(error, size, NO_MODULE);
    return false;
}

static bool file_size_allowed(int width, int height, bool any, char *error,
                              size_t size)
{
    long long limit = any ? (long long)IMAGE_SIDE_LIMIT * IMAGE_SIDE_LIMIT
                          : IMAGE_PIXEL_LIMIT;
    bool allowed =
        width >= 1 && height >= 1 && (long long)width * height <= limit;
    if (!allowed)
        snprintf(error, size,
                 "it has %d x %d pixels; glim's limit is %d in all", width,
                 height, IMAGE_PIXEL_LIMIT);
    return allowed;
}

static float *file_allocate(void *context, int width, int height, char *error,
                            size_t size)
{
    struct image **image = context;
    if (!file_size_allowed(width, height, false, error, size))
        return NULL;
    *image = image_new(width, height);
    return (*image)->pixels;
}

/* Whether `path` is a file that can be opened: the system's words are clearer
 * than OIIO's, and no module need be loaded. */
static bool file_readable(const char *path, char *error, size_t size)
{
    struct stat status;
    if (stat(path, &status) != 0 || access(path, R_OK) != 0) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    if (!S_ISREG(status.st_mode)) {
        snprintf(error, size, "it is not a regular file");
        return false;
    }
    if (status.st_size == 0) {
        snprintf(error, size, "it is empty");
        return false;
    }
    return true;
}

/* Libraries may say nothing, or several lines. */
static void file_tidy(char *error, size_t size)
{
    if (!*error)
        snprintf(error, size, "it is cut short or broken");
    for (char *end = strchr(error, '\n'); end; end = strchr(end, '\n'))
        *end = end[1] ? ';' : '\0';
}

/* OIIO's name of what it holds, or NULL with the reason. */
static const char *file_kind(const char *path, char *error, size_t size)
{
    static const unsigned char tail[8] = { 'I',  'E',  'N',  'D',
                                           0xae, 0x42, 0x60, 0x82 };
    unsigned char first[KIND_BYTES];
    char last[8] = "";
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(error, size, "%s", strerror(errno));
        return NULL;
    }
    const char *kind = kind_of_bytes(first, fread(first, 1, KIND_BYTES, file));
    bool whole = fseek(file, -8, SEEK_END) == 0 &&
                 fread(last, 1, 8, file) == 8 && memcmp(last, tail, 8) == 0;
    fclose(file);
    if (kind && strcmp(kind, "png") == 0 && !whole) {
        snprintf(error, size, "it is cut short");
        return NULL;
    }
    if (!kind)
        snprintf(error, size, "it is no picture that glim reads: " KIND_NAMES);
    return kind;
}

/* What reads it, if it isn't the module. */
static codec_decode_function *
file_own_decoder(const char *path, const struct codec_target *target)
{
    if (strcmp(target->type, "gif") == 0)
        return gif_decode;
    if (strcmp(target->type, "jpeg") == 0 && jpeg_is_ours(path))
        return jpeg_decode;
    if (strcmp(target->type, "pnm") == 0 && pnm_is_ours(path))
        return pnm_decode;
    return strcmp(target->type, "png") == 0 ? png_decode : NULL;
}

static bool file_decode(const char *path, struct codec_target *target,
                        char *error, size_t size)
{
    if (!file_readable(path, error, size))
        return false;
    target->type = file_kind(path, error, size);
    if (!target->type)
        return false;
    *error = '\0';
    codec_decode_function *decode = file_own_decoder(path, target);
    if (!decode && strcmp(target->type, "jpeg") == 0 &&
        !jpeg_passes_few(path, error, size))
        return false;
    if (!decode)
        *(void **)&decode = file_codec("codec_decode", error, size);
    return decode && decode(path, target, error, size);
}

static void file_describe(struct image *image,
                          const struct codec_target *target)
{
    image->has_alpha = target->has_alpha;
    image->multiplied = target->multiplied;
    image->linear = target->linear;
    image->gamma = target->gamma;
    image->srgb = target->srgb;
    image->plain = target->plain;
    image->indexed = target->indexed;
    image->palette = target->palette;
    image->png = strcmp(target->type, "png") == 0;
    image->channels = target->channels;
    image->bits = target->bits;
}

struct image *image_read_raw(const char *path, bool numbers, char *error,
                             size_t size)
{
    struct image *image = NULL;
    struct codec_target target = { .allocate = file_allocate,
                                   .context = &image,
                                   .numbers = numbers };
    if (!file_decode(path, &target, error, size)) {
        file_tidy(error, size);
        image_free(image);
        return NULL;
    }
    file_describe(image, &target);
    return image;
}

struct image *image_read(const char *path, char *error, size_t size)
{
    struct image *image = image_read_raw(path, false, error, size);
    if (!image || !image->has_alpha || image->multiplied)
        return image;
    size_t count = (size_t)image->width * (size_t)image->height;
    for (float *p = image->pixels; count-- > 0; p += 4)
        for (int c = 0; c < 3; c++)
            p[c] *= p[3];
    return image;
}

/* A picture on its way through, of which one row is there. */
struct file_stream {
    struct codec_target target;
    struct image image; /* without pixels */
    const struct image_rows *rows;
    float *row;
    bool refused;
};

static float *stream_allocate(void *context, int width, int height, char *error,
                              size_t size)
{
    struct file_stream *stream = context;
    if (!file_size_allowed(width, height, stream->rows->any_size, error, size))
        return NULL;
    stream->image.width = width;
    stream->image.height = height;
    file_describe(&stream->image, &stream->target);
    stream->refused =
        !stream->rows->begin(stream->rows->context, &stream->image);
    if (!stream->refused)
        stream->row = memory_new((size_t)width * 4 * sizeof *stream->row);
    return stream->row;
}

static void stream_take(void *context, int y)
{
    struct file_stream *stream = context;
    stream->rows->take(stream->rows->context, &stream->image, y, stream->row);
}

bool image_read_rows(const char *path, const struct image_rows *rows,
                     char *error, size_t size)
{
    struct file_stream stream = { .rows = rows };
    stream.target = (struct codec_target){ .allocate = stream_allocate,
                                           .take = stream_take,
                                           .context = &stream,
                                           .numbers = true };
    bool done = file_decode(path, &stream.target, error, size);
    if (!done && stream.refused)
        *error = '\0';
    else if (!done)
        file_tidy(error, size);
    memory_free(stream.row);
    return done;
}

/* image_rows.begin and .take of who only wants to know whether all is there. */
static bool probe_begin(void *context, const struct image *image)
{
    struct image *found = context;
    found->width = image->width;
    found->height = image->height;
    return true;
}

static void probe_take(void *context, const struct image *image, int y,
                       const float *pixels)
{
    (void)context;
    (void)image;
    (void)y;
    (void)pixels;
}

bool image_probe(const char *path, int *width, int *height, char *error,
                 size_t size)
{
    struct image found = { 0 };
    const struct image_rows rows = { probe_begin, probe_take, &found, true };
    if (!image_read_rows(path, &rows, error, size))
        return false;
    *width = found.width;
    *height = found.height;
    return true;
}

/* codec_sink.put and .patch */
static bool file_put(void *context, const void *bytes, size_t count,
                     char *error, size_t size)
{
    return save_put(context, bytes, count, error, size);
}

static bool file_patch(void *context, size_t at, const void *bytes,
                       size_t count, char *error, size_t size)
{
    return save_patch(context, at, bytes, count, error, size);
}

bool image_has_bands(const struct image_format *format)
{
    return file_own_encoder(format) != NULL;
}

/* What writes it, on its way to the place. */
static bool file_encode(const struct image_bands *bands,
                        const struct image *whole,
                        const struct image_format *format,
                        const struct codec_sink *sink, char *error, size_t size)
{
    codec_stream_function *own = file_own_encoder(format);
    codec_encode_function *encode = NULL;
    if (own)
        return own(bands, format, sink, error, size);
    *(void **)&encode = file_codec("codec_encode", error, size);
    return encode && encode(whole, format, sink, error, size);
}

static bool file_write(const struct image_bands *bands,
                       const struct image *whole, const char *path,
                       const struct image_format *format, char *error,
                       size_t size)
{
    char unheard[1];
    struct save *save = save_start(path, error, size);
    const struct codec_sink sink = { file_put, file_patch, save };
    if (!save)
        return false;
    bool done = file_encode(bands, whole, format, &sink, error, size);
    return save_finish(save, done, done ? error : unheard, done ? size : 1) &&
           done;
}

bool image_write_bands(const struct image_bands *bands, const char *path,
                       const struct image_format *format, char *error,
                       size_t size)
{
    return file_write(bands, NULL, path, format, error, size);
}

/* image_bands.at of one band. */
static const struct image *file_whole(void *context, int y, int *top)
{
    (void)y;
    *top = 0;
    return *(const struct image **)context;
}

bool image_write(const struct image *image, const char *path,
                 const struct image_format *format, char *error, size_t size)
{
    const struct image_bands bands = { image->width, image->height, file_whole,
                                       &image };
    return file_write(&bands, image, path, format, error, size);
}
