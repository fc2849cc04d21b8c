/* Image files around the codec module: loading it, and replacing a file in
 * one step so that a picture is either whole or not there. See file.h. */
#include "image/file.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "image/codec.h"
#include "image/png.h"

#define MODULE "glim-image.so"

/* Where it may be, seen from the program's directory: beside it in a build,
 * where `make install` puts it, and above the unit tests. */
static const char *const places[] = { "/", "/../lib/glim/", "/../../" };

/* The module, loaded, or NULL. It stays loaded; dlopen counts, and is quick
 * the second time. */
static void *file_module(void)
{
    char name[PATH_MAX + 64];
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
            break;
    }
    return dlopen(name, RTLD_LAZY | RTLD_LOCAL);
}

/* A function of the module, or NULL with the reason. */
static void *file_codec(const char *name, char *error, size_t size)
{
    void *module = file_module();
    void *function = module ? dlsym(module, name) : NULL;
    if (!function)
        snprintf(error, size,
                 "can't load glim's module for image files, which belongs in "
                 "../lib/glim seen from the program (%s)",
                 dlerror());
    return function;
}

static bool file_is_png(const struct image_format *format)
{
    return strcmp(format->type, "png") == 0;
}

void image_prepare(void *format)
{
    if (!file_is_png(format))
        file_module();
}

static float *file_allocate(void *context, int width, int height, char *error,
                            size_t size)
{
    struct image **image = context;
    if (width < 1 || height < 1 ||
        (long long)width * height > IMAGE_PIXEL_LIMIT) {
        snprintf(error, size,
                 "it has %d x %d pixels; glim's limit is %d in all", width,
                 height, IMAGE_PIXEL_LIMIT);
        return NULL;
    }
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

struct image *image_read(const char *path, char *error, size_t size)
{
    if (!file_readable(path, error, size))
        return NULL;
    codec_decode_function *decode;
    *(void **)&decode = file_codec("codec_decode", error, size);
    if (!decode)
        return NULL;
    struct image *image = NULL;
    struct codec_target target = { .allocate = file_allocate,
                                   .context = &image };
    *error = '\0';
    if (!decode(path, &target, error, size)) {
        file_tidy(error, size);
        image_free(image);
        return NULL;
    }
    image->has_alpha = target.has_alpha;
    image->linear = target.linear;
    image->gamma = target.gamma;
    image->plain = target.plain;
    return image;
}

/* Whether it begins as a PNG and does not end as one. Asked first because
 * libpng would tell the world about it on standard error. */
static bool file_is_cut_png(const char *path)
{
    static const char head[8] = "\x89PNG\r\n\x1a\n";
    static const char tail[8] = "IEND\xae\x42\x60\x82";
    char first[8] = "", last[8] = "";
    FILE *file = fopen(path, "rb");
    if (!file)
        return false;
    bool cut = fread(first, 1, 8, file) == 8 && memcmp(first, head, 8) == 0 &&
               (fseek(file, -8, SEEK_END) != 0 ||
                fread(last, 1, 8, file) != 8 || memcmp(last, tail, 8) != 0);
    fclose(file);
    return cut;
}

bool image_probe(const char *path, int *width, int *height, char *error,
                 size_t size)
{
    if (file_is_cut_png(path)) {
        snprintf(error, size, "it is cut short");
        return false;
    }
    struct image *image = image_read(path, error, size);
    if (!image)
        return false;
    *width = image->width;
    *height = image->height;
    image_free(image);
    return true;
}

/* What a name stands for once symbolic links are followed, so that a link
 * keeps its place and the file it names is the one replaced. */
static bool file_resolve(const char *path, char target[PATH_MAX], char *error,
                         size_t size)
{
    if (realpath(path, target))
        return true;
    if (strlen(path) >= PATH_MAX) {
        snprintf(error, size, "%s", strerror(ENAMETOOLONG));
        return false;
    }
    strcpy(target, path);
    return true;
}

/* Devices and pipes (/dev/null, /dev/stdout) are written to, not replaced. */
static bool file_is_special(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

bool image_writable(const char *path, char *error, size_t size)
{
    if (strcmp(path, "-") == 0)
        return true;
    struct stat status;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
        snprintf(error, size, "it is a directory");
        return false;
    }
    char target[PATH_MAX];
    if (!file_resolve(path, target, error, size))
        return false;
    /* Renaming could replace a file that is write-protected, but shouldn't. */
    if (access(target, W_OK) != 0 && errno != ENOENT && errno != ENOTDIR) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    if (!file_is_special(target)) {
        char *slash = strrchr(target, '/');
        if (slash)
            slash[slash == target] = '\0';
        else
            strcpy(target, ".");
    }
    if (access(target, W_OK) == 0)
        return true;
    if (errno == ENOENT)
        snprintf(error, size, "there is no directory '%s'", target);
    else
        snprintf(error, size, "%s: %s", target, strerror(errno));
    return false;
}

static bool file_put_all(int file, const void *bytes, size_t count)
{
    const char *next = bytes;
    while (count > 0) {
        ssize_t written = write(file, next, count);
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0) {
            next += written;
            count -= (size_t)written;
        }
    }
    return true;
}

/* codec_sink.put for standard output and for devices. */
static bool file_put_stream(void *context, const void *bytes, size_t count,
                            char *error, size_t size)
{
    const int *file = context;
    if (file_put_all(*file, bytes, count))
        return true;
    snprintf(error, size, "%s", strerror(errno));
    return false;
}

/* A new file called `name` with the permissions of `target`, if that exists.
 * A file of that name can only be left over from a process that was killed. */
static int file_create(const char *name, const char *target)
{
    unlink(name);
    int file = open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    struct stat status;
    if (file >= 0 && stat(target, &status) == 0)
        fchmod(file, status.st_mode & 07777);
    return file;
}

/* codec_sink.put for a file: a new one beside it, then renamed. */
static bool file_put_new(void *context, const void *bytes, size_t count,
                         char *error, size_t size)
{
    const char *target = context;
    size_t length = strlen(target) + 40;
    char *name = memory_new(length);
    snprintf(name, length, "%s.%ld.tmp", target, (long)getpid());
    int file = file_create(name, target);
    bool done = file >= 0 && file_put_all(file, bytes, count);
    int reason = errno;
    if (file >= 0 && close(file) != 0 && done) {
        done = false;
        reason = errno;
    }
    if (done && rename(name, target) != 0) {
        done = false;
        reason = errno;
    }
    if (!done) {
        snprintf(error, size, "%s", strerror(reason));
        if (file >= 0)
            unlink(name);
    }
    memory_free(name);
    return done;
}

static codec_encode_function *file_encoder(const struct image_format *format,
                                           char *error, size_t size)
{
    codec_encode_function *encode = png_encode;
    if (!file_is_png(format))
        *(void **)&encode = file_codec("codec_encode", error, size);
    return encode;
}

bool image_write(const struct image *image, const char *path,
                 const struct image_format *format, char *error, size_t size)
{
    codec_encode_function *encode = file_encoder(format, error, size);
    if (!encode)
        return false;
    char target[PATH_MAX];
    int stream = STDOUT_FILENO;
    struct codec_sink sink = { file_put_stream, &stream };
    if (strcmp(path, "-") == 0)
        return encode(image, format, &sink, error, size);
    if (!file_resolve(path, target, error, size))
        return false;
    if (!file_is_special(target)) {
        sink = (struct codec_sink){ file_put_new, target };
        return encode(image, format, &sink, error, size);
    }
    FILE *device = fopen(target, "wb");
    if (!device) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    stream = fileno(device);
    bool done = encode(image, format, &sink, error, size);
    if (fclose(device) != 0 && done) {
        snprintf(error, size, "%s", strerror(errno));
        done = false;
    }
    return done;
}
