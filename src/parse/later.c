/* Words of POV-Ray 3.8, which scenes for it use: each is told from a slip of
 * the pen, with what does the same here. */
#include <string.h>

#include "base/text.h"
#include "parse/expression.h"
#include "parse/symbol.h"

/* What stands in a certain block comes first, what may in any (NULL) last; ""
 * is where a value is wanted. */
struct later {
    const char *words, *block, *hint, *instead;
};

static const struct later later[] = {
    { "dictionary", NULL, "array[3]", "an array keeps values by number" },
    { "mixed", "array", NULL, "all elements of an array are of one kind" },
    { "lemon", NULL, "lathe { cubic_spline ... }",
      "a lathe turns its outline round y" },
    { "user_defined", "camera", "mesh_camera { ... }",
      "a mesh_camera has a ray for each face of a mesh" },
    { "user_defined", NULL, "pigment { function { ... } color_map { ... } }",
      "'average' adds pigments of a function each" },
    { "potential", "isosurface", NULL,
      "a pigment of the same function shows its values" },
    { "potential", NULL, "function { F(x, y, z) } color_map { ... }",
      "a function of the isosurface has the same values" },
    { "polarity", NULL, "inverse",
      "the inside is where the function is below the threshold" },
    { "blend_mode blend_gamma", NULL, NULL,
      "colours of a map blend linearly; entries between two make a curve" },
    { "fresnel", "finish", "reflection { 1 fresnel }",
      "only a reflection depends on the ior" },
    { "distance radius precision", "ovus", "scale <1, 1.2, 1>",
      "its two radii alone make an ovus" },
    { "tau", "", "2*pi", "a whole turn is two pi" },
    { "akima_spline tcb_spline basic_x_spline extended_x_spline "
      "general_x_spline sor_spline",
      NULL, "cubic_spline", "a cubic_spline is as smooth" },
};

static const struct later *later_find(const char *word, const char *block)
{
    for (size_t i = 0; i < sizeof later / sizeof *later; i++)
        if (text_among(word, later[i].words) &&
            (!later[i].block || strcmp(block, later[i].block) == 0))
            return &later[i];
    return NULL;
}

bool error_later(struct parser *p, const char *hint, const char *what,
                 const char *instead)
{
    error_at(p, p->token_span, hint,
             "%s needs POV-Ray 3.8, and glim reads 3.7; %s", what, instead);
    stream_next(p);
    if (stream_peek(p)->kind == TOKEN_LBRACE)
        skip_brackets(p);
    return false;
}

bool error_later_word(struct parser *p, const struct word *word,
                      const char *block)
{
    const struct later *found = later_find(word->text, block);
    if (!found || symbol_find(p, word))
        return false;
    error_later(p, found->hint, arena_printf(p->arena, "'%s'", word->text),
                found->instead);
    return true;
}
