/* Places and texts in JSON. */
#include "base/writer.h"
#include "language/server.h"

static json_t *json_place(struct place place)
{
    return json_pack("{s:I,s:I}", "line", (json_int_t)place.line, "character",
                     (json_int_t)place.unit);
}

json_t *json_range(struct stretch range)
{
    return json_pack("{s:o,s:o}", "start", json_place(range.start), "end",
                     json_place(range.end));
}

static unsigned json_unsigned(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    double number = json_number_value(value);
    return number >= 1e9 ? 1000000000u : number > 0 ? (unsigned)number : 0;
}

struct place json_to_place(const json_t *json)
{
    return (struct place){ json_unsigned(json, "line"),
                           json_unsigned(json, "character") };
}

struct stretch json_to_range(const json_t *json)
{
    return (struct stretch){ json_to_place(json_object_get(json, "start")),
                             json_to_place(json_object_get(json, "end")) };
}

const char *json_text(const json_t *object, const char *key)
{
    return json_string_value(json_object_get(object, key));
}

json_t *json_words(const char *text, size_t length)
{
    json_t *string = json_stringn(text, length);
    if (string)
        return string;
    struct writer clean = writer_new();
    for (size_t i = 0; i < length;) {
        size_t size = 1;
        while (size < 4 && i + size < length &&
               ((unsigned char)text[i + size] & 0xc0) == 0x80)
            size++;
        json_t *piece = json_stringn(text + i, size);
        writer_add(&clean, piece ? text + i : "?", piece ? size : 1);
        i += piece ? size : 1;
        json_decref(piece);
    }
    string = json_stringn(clean.items, clean.count);
    writer_free(&clean);
    return string;
}

json_t *json_markdown(const char *text)
{
    return json_pack("{s:s,s:o}", "kind", "markdown", "value",
                     json_words(text, strlen(text)));
}
