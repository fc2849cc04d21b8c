/* #version and #default. */
#include "base/text.h"
#include "parse/directive.h"
#include "parse/rules.h"

#define VERSION_NEWEST 3.75 /* beyond it are POV-Ray's versions to come */

/* version_directive = "#version" ["unofficial"] float [";"] . */
static bool version_run(struct parser *p, struct span at)
{
    struct cursor *outer = stream_directive_begin(p);
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_WORD &&
        strcmp(token->word->text, "unofficial") == 0)
        stream_next(p);
    double version;
    bool ok = parse_float(p, &version);
    if (!ok && stream_peek_infix(p)->kind == TOKEN_STRING)
        stream_next(p);
    if (stream_peek_infix(p)->kind == TOKEN_SEMICOLON)
        stream_next(p);
    stream_directive_end(p, outer);
    if (!ok)
        return false;
    if (version >= 4 || version < 1)
        return error_at(p, span_join(at, p->last_span), "#version 3.7;",
                        "the scene asks for POV-Ray %s; glim speaks the "
                        "language of 3.7",
                        NUMBER_TEXT(version));
    if (version > VERSION_NEWEST) {
        warning_at(p, span_join(at, p->last_span), "#version 3.7;",
                   "the scene is of POV-Ray %s; it is read as one of 3.7",
                   NUMBER_TEXT(version));
        version = 3.7;
    }
    p->version = version;
    p->version_said = true;
    settings_follow_version(p);
    return true;
}

/* default_directive = "#default" "{" {default_item} "}" . */
static bool default_run(struct parser *p, struct span at)
{
    (void)at;
    struct cursor *outer = stream_directive_begin(p);
    struct span open;
    bool ok = block_begin(p, &open);
    if (ok)
        ok = block_end(p, open, parse_defaults(p, open));
    stream_directive_end(p, outer);
    return ok;
}

const struct directive version_directive = {
    version_run, "which version of the language follows"
};
const struct directive default_directive = {
    default_run, "what textures, pigments, normals and finishes start from"
};
