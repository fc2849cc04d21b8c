// Image formats through OpenImageIO, 2.2 to 3: the only C++ and the only user
// of that library. Built as a module of its own, see codec.h. PNG, most of what
// is read as GIF, JPEG and PPM, and what is written as OpenEXR and PPM never
// come here.
#include "image/codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <new>
#include <vector>

using namespace OIIO;

static bool codec_fail(char *error, size_t size, const std::string &why)
{
    std::snprintf(error, size, "%s", why.c_str());
    for (size_t end = std::strlen(error); end && error[end - 1] == '\n';)
        error[--end] = '\0'; // OIIO ends some reasons with a newline
    return false;
}

static void codec_start()
{
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    OIIO::attribute("plugin_searchpath", "");
}

// ---------------------------------------------------------------- writing

// v in 0..1 as one of 256 numbers.
static float codec_level(float value)
{
    if (!(value > 0))
        value = 0;
    else if (value > 1)
        value = 1;
    return std::floor(value * 255.0f + 0.5f);
}

struct row_writer {
    const struct image *image;
    int channels; // 1 Y, 2 YA, 3 RGB, 4 RGBA
    bool whole;   // numbers are kept, not rounded to bytes
    std::vector<float> floats;
    std::vector<unsigned char> bytes;

    // Where channel c of the file is in an RGBA pixel.
    int source(int c) const
    {
        return channels < 3 && c == 1 ? 3 : c;
    }

    float number(int x, int y, int c) const
    {
        return image_pixel(image, x, y)[source(c)];
    }

    // Fills `floats` with row y, as levels of the file unless it is a float
    // file.
    void fetch(int y)
    {
        floats.resize(size_t(image->width) * size_t(channels));
        for (size_t i = 0; i < floats.size(); i++) {
            float value = number(int(i) / channels, y, int(i) % channels);
            floats[i] = whole ? value : codec_level(value);
        }
    }

    bool write(ImageOutput &output, int y)
    {
        fetch(y);
        if (whole)
            return output.write_scanline(y, 0, TypeFloat, floats.data());
        bytes.assign(floats.begin(), floats.end());
        return output.write_scanline(y, 0, TypeUInt8, bytes.data());
    }
};

static bool codec_is(const struct image_format *format, const char *type)
{
    return std::strcmp(format->type, type) == 0;
}

static ImageSpec codec_spec(const struct image *image, int channels,
                            const struct image_format *format)
{
    ImageSpec spec(image->width, image->height, channels,
                   codec_is(format, "hdr") ? TypeFloat : TypeUInt8);
    if (channels == 2) {
        spec.channelnames = { "Y", "A" };
        spec.alpha_channel = 1;
    }
    spec.attribute("Software", "glim " GLIM_VERSION);
    if (codec_is(format, "jpeg")) {
        spec.attribute("Compression",
                       "jpeg:" + std::to_string(format->quality));
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (codec_is(format, "targa"))
        spec.attribute("compression", format->packed ? "rle" : "none");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format->gamma == 0)
        spec.attribute("oiio:ColorSpace", "sRGB");
    else if (format->gamma == 1)
        spec.attribute("oiio:ColorSpace", "linear");
    else {
        spec.attribute("oiio:ColorSpace",
                       Strutil::sprintf("Gamma%g", format->gamma));
        spec.attribute("oiio:Gamma", float(format->gamma));
    }
    return spec;
}

// A file for what OIIO 2.2 can't write to memory; removed in the end.
struct scratch_file {
    std::string name;

    bool make()
    {
        char made[] = "/tmp/glim-XXXXXX";
        int file = mkstemp(made);
        if (file >= 0) {
            close(file);
            name = made;
        }
        return file >= 0;
    }

    std::vector<unsigned char> bytes() const
    {
        std::ifstream file(name, std::ios::binary);
        return std::vector<unsigned char>(std::istreambuf_iterator<char>(file),
                                          std::istreambuf_iterator<char>());
    }

    ~scratch_file()
    {
        if (!name.empty())
            unlink(name.c_str());
    }
};

static bool codec_encode_checked(const struct image *image,
                                 const struct image_format *format,
                                 const struct codec_sink *sink, char *error,
                                 size_t size)
{
    codec_start();
    auto output = ImageOutput::create(format->type);
    if (!output)
        return codec_fail(error, size, OIIO::geterror());
    bool alpha = format->alpha && output->supports("alpha");
    // Radiance files have three channels; so have OIIO's 8-bit BMPs but for a
    // palette.
    bool grey =
        format->grey && !codec_is(format, "hdr") && !codec_is(format, "bmp");
    row_writer rows;
    rows.image = image;
    rows.channels = (grey ? 1 : 3) + (alpha ? 1 : 0);
    rows.whole = codec_is(format, "hdr");
    Filesystem::IOVecOutput memory;
    scratch_file scratch;
    if (!output->set_ioproxy(&memory) && !scratch.make())
        return codec_fail(error, size, std::strerror(errno));
    // To memory the name only tells the format.
    ImageSpec spec = codec_spec(image, rows.channels, format);
    std::string name = std::string("glim.") + format->type;
    if (!output->open(scratch.name.empty() ? name : scratch.name, spec))
        return codec_fail(error, size, output->geterror());
    for (int y = 0; y < image->height; y++)
        if (!rows.write(*output, y))
            return codec_fail(error, size, output->geterror());
    if (!output->close())
        return codec_fail(error, size, output->geterror());
    const std::vector<unsigned char> &bytes =
        scratch.name.empty() ? memory.buffer() : scratch.bytes();
    return sink->put(sink->context, bytes.data(), bytes.size(), error, size);
}

// ---------------------------------------------------------------- reading

// Spreads `channels` numbers a pixel over RGBA, in place from the last.
static void codec_spread(float *pixels, size_t count, int channels, int alpha)
{
    for (size_t i = count; i-- > 0;) {
        float in[4] = { 0, 0, 0, 0 };
        std::memcpy(in, pixels + i * size_t(channels),
                    size_t(channels) * sizeof(float));
        float *out = pixels + i * 4;
        bool grey = channels < 3;
        out[0] = in[0];
        out[1] = grey ? in[0] : in[1];
        out[2] = grey ? in[0] : in[2];
        out[3] = alpha >= 0 && alpha < 4 ? in[alpha] : 1;
    }
}

// Radiance's bytes stand for the middle of what they were rounded down from
// (Ward, "Real Pixels"); OpenImageIO takes its lower end. The largest of three
// has its first bit set, and tells the exponent of all.
static void codec_centre(float *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++, pixels += 4) {
        int exponent;
        float most = std::max(pixels[0], std::max(pixels[1], pixels[2]));
        std::frexp(most, &exponent);
        for (int c = 0; c < 3 && most > 0; c++)
            pixels[c] += std::ldexp(0.5F, exponent - 8);
    }
}

// What is done to pixels as they are read.
struct codec_finish {
    int channels, alpha;
    bool centre;

    void apply(float *pixels, size_t count) const
    {
        codec_spread(pixels, count, channels, alpha);
        if (centre)
            codec_centre(pixels, count);
    }
};

// Row by row; of files in tiles all must be read before the first.
static bool codec_stream(ImageInput &input, const struct codec_target *target,
                         const codec_finish &finish, float *row, char *error,
                         size_t size)
{
    const ImageSpec &spec = input.spec();
    size_t count = size_t(spec.width) * size_t(finish.channels);
    std::vector<float> all;
    if (spec.tile_width)
        all.resize(count * size_t(spec.height));
    if (spec.tile_width &&
        !input.read_image(0, 0, 0, finish.channels, TypeFloat, all.data()))
        return codec_fail(error, size, input.geterror());
    for (int y = 0; y < spec.height; y++) {
        if (spec.tile_width)
            std::memcpy(row, all.data() + count * size_t(y),
                        count * sizeof *row);
        else if (!input.read_scanlines(0, 0, spec.y + y, spec.y + y + 1, 0, 0,
                                       finish.channels, TypeFloat, row))
            return codec_fail(error, size, input.geterror());
        finish.apply(row, size_t(spec.width));
        target->take(target->context, y);
    }
    return true;
}

static bool codec_decode_checked(const char *path, struct codec_target *target,
                                 char *error, size_t size)
{
    codec_start();
    ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    wish.attribute("oiio:missingcolor", "");
    auto input = ImageInput::create(target->type);
    if (!input)
        return codec_fail(error, size, OIIO::geterror());
    ImageSpec spec;
    if (!input->open(path, spec, wish))
        return codec_fail(error, size, input->geterror());
    if (spec.depth > 1 || spec.deep)
        return codec_fail(error, size, "it is not a flat picture");
    int channels = spec.nchannels < 4 ? spec.nchannels : 4;
    int alpha = spec.alpha_channel < channels ? spec.alpha_channel : -1;
    if (channels == 2 && alpha < 0)
        channels = 1;
    // OIIO 2.4 doesn't say so of BMP files, but they are not premultiplied.
    bool straight = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0 ||
                    std::strcmp(input->format_name(), "bmp") == 0;
    target->linear = spec.format.is_floating_point();
    target->gamma = double(spec.get_float_attribute("oiio:Gamma", 0));
    target->plain =
        !target->linear && (std::strcmp(input->format_name(), "pnm") == 0 ||
                            std::strcmp(input->format_name(), "tiff") == 0);
    target->has_alpha = alpha >= 0;
    target->multiplied = target->has_alpha && !straight;
    target->channels = channels;
    target->bits = int(spec.format.size()) * 8;
    float *pixels =
        target->allocate(target->context, spec.width, spec.height, error, size);
    if (!pixels)
        return false;
    codec_finish finish = { channels, alpha,
                            std::strcmp(input->format_name(), "hdr") == 0 };
    if (target->take)
        return codec_stream(*input, target, finish, pixels, error, size);
    if (!input->read_image(0, 0, 0, channels, TypeFloat, pixels))
        return codec_fail(error, size, input->geterror());
    finish.apply(pixels, size_t(spec.width) * size_t(spec.height));
    return true;
}

extern "C" {
const char codec_build[] =
#include "codec.inc"
    ;
}

// ------------------------------------------- nothing is thrown at C callers

extern "C" bool codec_encode(const struct image *image,
                             const struct image_format *format,
                             const struct codec_sink *sink, char *error,
                             size_t size)
{
    try {
        return codec_encode_checked(image, format, sink, error, size);
    } catch (const std::bad_alloc &) {
        return codec_fail(error, size, "out of memory");
    } catch (const std::exception &e) {
        return codec_fail(error, size, e.what());
    } catch (...) {
        return codec_fail(error, size, "");
    }
}

extern "C" bool codec_decode(const char *path, struct codec_target *target,
                             char *error, size_t size)
{
    try {
        return codec_decode_checked(path, target, error, size);
    } catch (const std::bad_alloc &) {
        return codec_fail(error, size, "out of memory");
    } catch (const std::exception &e) {
        return codec_fail(error, size, e.what());
    } catch (...) {
        return codec_fail(error, size, "");
    }
}
