/* Functions of strings. Strings are UTF-8; positions and lengths count
 * characters, as POV-Ray's do. */
#include <stdlib.h>
#include <time.h>

#include "base/text.h"
#include "parse/expression.h"
#include "parse/function.h"

enum {
    TEXT_LIMIT = 1 << 24, /* bytes: concat(S, S) in a loop */
    TEXT_WIDTH_LIMIT = 1000,
};

static const char *argument(const struct call *call, int i)
{
    return call->arguments[i].text;
}

static int argument_integer(const struct call *call, int i)
{
    return float_to_int(call->arguments[i].number[0]);
}

static bool is_continuation(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* The start of character number `count` after `text`, or the end. */
static const char *text_skip(const char *text, int count)
{
    while (*text && count > 0) {
        text++;
        while (is_continuation(*text))
            text++;
        count--;
    }
    return text;
}

static int text_length(const char *text)
{
    int count = 0;
    for (; *text; text++)
        count += !is_continuation(*text);
    return count;
}

/* The code point of the first character; 0 of the empty string. */
void text_asc(struct parser *p, const struct call *call, struct value *result)
{
    (void)p;
    const unsigned char *s = (const unsigned char *)argument(call, 0);
    unsigned code = s[0];
    if ((code & 0xe0) == 0xc0 && s[1])
        code = (code & 31u) << 6 | (s[1] & 63u);
    else if ((code & 0xf0) == 0xe0 && s[1] && s[2])
        code = (code & 15u) << 12 | (s[1] & 63u) << 6 | (s[2] & 63u);
    *result = value_float(code);
}

void text_chr(struct parser *p, const struct call *call, struct value *result)
{
    int code = argument_integer(call, 0);
    unsigned c = (unsigned)code;
    if (code < 0 || code > 65535) {
        call_error(p, call, result, NULL,
                   "chr() wants a number from 0 to 65535, found %d", code);
        return;
    }
    char *text = arena_alloc(p->arena, 4);
    if (c < 0x80) {
        text[0] = (char)c;
    } else if (c < 0x800) {
        text[0] = (char)(0xc0 | c >> 6);
        text[1] = (char)(0x80 | (c & 63));
    } else {
        text[0] = (char)(0xe0 | c >> 12);
        text[1] = (char)(0x80 | (c >> 6 & 63));
        text[2] = (char)(0x80 | (c & 63));
    }
    *result = value_text(text);
}

void text_concat(struct parser *p, const struct call *call,
                 struct value *result)
{
    const char *a = argument(call, 0), *b = argument(call, 1);
    size_t length = strlen(a);
    if (length + strlen(b) > TEXT_LIMIT) {
        call_error(p, call, result, NULL,
                   "a string can't be longer than %d bytes, glim's limit",
                   TEXT_LIMIT);
        return;
    }
    char *text = arena_alloc(p->arena, length + strlen(b) + 1);
    memcpy(text, a, length);
    strcpy(text + length, b);
    *result = value_text(text);
}

void text_file_exists(struct parser *p, const struct call *call,
                      struct value *result)
{
    *result = value_float(file_find(p, argument(call, 0), NULL) != NULL);
}

/* A negative length fills with zeros, a negative precision is 6 digits.
 * Returns NULL after an error. */
static const char *text_format(struct parser *p, const struct call *call,
                               double number, int length, int precision)
{
    struct value ignored;
    if (length > TEXT_WIDTH_LIMIT || length < -TEXT_WIDTH_LIMIT ||
        precision > TEXT_WIDTH_LIMIT) {
        call_error(p, call, &ignored, NULL,
                   "length and precision can be %d at most", TEXT_WIDTH_LIMIT);
        return NULL;
    }
    if (length < 0)
        return arena_printf(p->arena, "%0*.*f", -length, precision, number);
    return arena_printf(p->arena, "%*.*f", length, precision, number);
}

/* str(number, length, precision) */
void text_str(struct parser *p, const struct call *call, struct value *result)
{
    const char *text =
        text_format(p, call, call->arguments[0].number[0],
                    argument_integer(call, 1), argument_integer(call, 2));
    *result = text ? value_text(text) : value_poison();
}

/* The difference of the first bytes that differ. */
void text_strcmp(struct parser *p, const struct call *call,
                 struct value *result)
{
    (void)p;
    const char *a = argument(call, 0), *b = argument(call, 1);
    while (*a && *a == *b)
        a++, b++;
    *result = value_float((unsigned char)*a - (unsigned char)*b);
}

void text_strlen(struct parser *p, const struct call *call,
                 struct value *result)
{
    (void)p;
    *result = value_float(text_length(argument(call, 0)));
}

enum { SECONDS_A_DAY = 86400, SECONDS_TO_2000 = 946684800, TIME_LENGTH = 200 };

double text_days_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return ((double)(now.tv_sec - SECONDS_TO_2000) + now.tv_nsec * 1e-9) /
           SECONDS_A_DAY;
}

/* datetime(days [, format]): days since the year 2000 as strftime() writes
 * them, in universal time. */
void text_datetime(struct parser *p, const struct call *call,
                   struct value *result)
{
    char text[TIME_LENGTH];
    struct tm parts;
    const char *format =
        call->count > 1 ? argument(call, 1) : "%Y-%m-%d %H:%M:%SZ";
    double days = call->arguments[0].number[0];
    time_t seconds =
        (time_t)floor(days * SECONDS_A_DAY + 0.5) + SECONDS_TO_2000;
    if (!(fabs(days) < 1e8) || !gmtime_r(&seconds, &parts))
        call_error(p, call, result, "now", "there is no date %s days from 2000",
                   NUMBER_TEXT(days));
    else if (!*format)
        call_error(p, call, result, "\"%Y-%m-%d\"", "the format is empty");
    else if (!strftime(text, sizeof text, format, &parts))
        call_error(p, call, result, "\"%Y-%m-%d\"",
                   "the date has more than %d characters", TIME_LENGTH - 1);
    else
        *result = value_text(arena_printf(p->arena, "%s", text));
}

/* Letters of ASCII between `first` and `last` moved by `shift`. */
static struct value text_shifted(struct parser *p, const char *text, char first,
                                 char last, int shift)
{
    char *copy = arena_copy_text(p->arena, text, strlen(text));
    for (char *c = copy; *c; c++)
        if (*c >= first && *c <= last)
            *c = (char)(*c + shift);
    return value_text(copy);
}

void text_strlwr(struct parser *p, const struct call *call,
                 struct value *result)
{
    *result = text_shifted(p, argument(call, 0), 'A', 'Z', 'a' - 'A');
}

void text_strupr(struct parser *p, const struct call *call,
                 struct value *result)
{
    *result = text_shifted(p, argument(call, 0), 'a', 'z', 'A' - 'a');
}

/* substr(text, first, length), characters numbered from 1. Position 0 gives
 * nothing, as in POV-Ray; past the end is an error. */
void text_substr(struct parser *p, const struct call *call,
                 struct value *result)
{
    const char *text = argument(call, 0);
    int first = argument_integer(call, 1), count = argument_integer(call, 2);
    int length = text_length(text);
    if (first < 0 || count < 0 || first > length ||
        count > length - (first > 0 ? first - 1 : 0)) {
        call_error(p, call, result, NULL,
                   "the string has %d characters; %d of them from number %d "
                   "on are too many",
                   length, count, first);
        return;
    }
    const char *start = text_skip(text, first - 1);
    const char *end = text_skip(start, first == 0 ? 0 : count);
    *result =
        value_text(arena_copy_text(p->arena, start, (size_t)(end - start)));
}

/* The number at the start of a string; 0 if there is none. */
void text_val(struct parser *p, const struct call *call, struct value *result)
{
    (void)p;
    *result = value_float(strtod(argument(call, 0), NULL));
}

/* vstr(components, vector, separator, length, precision): 2 to 5 components,
 * those that the vector does not have are 0. */
void text_vstr(struct parser *p, const struct call *call, struct value *result)
{
    struct value vector = call->arguments[1];
    int count = argument_integer(call, 0);
    char *text = arena_printf(p->arena, "%s", "");
    int size = value_size(&vector);
    count = count < 2 ? 2 : count > 5 ? 5 : count;
    for (int i = 0; i < count; i++) {
        const char *number =
            text_format(p, call, i < size ? vector.number[i] : 0,
                        argument_integer(call, 3), argument_integer(call, 4));
        if (!number) {
            *result = value_poison();
            return;
        }
        text = arena_printf(p->arena, "%s%s%s", text,
                            i > 0 ? argument(call, 2) : "", number);
    }
    *result = value_text(text);
}
