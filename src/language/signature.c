/* Signature help: what the arguments of a macro, a function or a shape are. */
#include "language/context.h"
#include "language/describe.h"
#include "language/manual.h"

#include "base/array.h"
#include "scene/primitive.h"

/* A call as it is written, and where each argument is in it. */
struct signature {
    const char *label, *help;
    struct parameter {
        const char *name, *help;
    } * items;
    size_t count, capacity;
};

static const char *field_help(struct arena *arena, const struct field *field)
{
    if (field->minimum == field->maximum)
        return field->help;
    return arena_printf(arena, "%s, %g to %g", field->help, field->minimum,
                        field->maximum);
}

static bool signature_shape(struct arena *arena, const char *name,
                            struct signature *signature)
{
    const struct primitive *primitive = primitive_find(name);
    const struct field *field = primitive ? primitive->arguments : NULL;
    if (!field || !field->name)
        return false;
    const char *label = arena_printf(arena, "%s { ", name);
    for (; field->name; field++) {
        bool first = signature->count == 0;
        const char *shown = field->optional
                                ? arena_printf(arena, "[%s]", field->name)
                                : field->name;
        label = arena_printf(arena, "%s%s%s", label, first ? "" : ", ", shown);
        *ARRAY_PUSH(arena, signature) =
            (struct parameter){ shown, field_help(arena, field) };
    }
    signature->label = arena_printf(arena, "%s ... }", label);
    signature->help = primitive->help;
    return true;
}

/* The names between the parentheses of "pow(a, b)". */
static void signature_split(struct arena *arena, struct signature *signature)
{
    const char *at = strchr(signature->label, '(');
    while (at && *at && *at != ')') {
        at += 1 + strspn(at + 1, " ");
        size_t length = strcspn(at, ",)");
        if (length > 0)
            *ARRAY_PUSH(arena, signature) =
                (struct parameter){ arena_copy_text(arena, at, length), "" };
        at += length;
    }
}

static bool signature_find(struct request *request, const struct call *call,
                           size_t token, struct signature *signature)
{
    struct arena *arena = request->arena;
    struct page *where;
    if (call->block)
        return signature_shape(arena, call->name->text, signature);
    if (call->name->reserved) {
        signature->label =
            manual_function(arena, call->name->text, &signature->help);
    } else {
        const struct name *name = describe_find(
            request->server, arena, request->page, call->name, token, &where);
        if (!name || name->kind != NAME_MACRO)
            return false;
        signature->label = describe_macro(arena, name);
        signature->help = describe_comment(arena, where, name);
    }
    if (signature->label)
        signature_split(arena, signature);
    return signature->label != NULL;
}

json_t *signature_answer(struct request *request)
{
    struct context context =
        context_at(&request->server->library, request->page, request->offset);
    struct signature signature = { 0 };
    if (!context.call.name || context.kind == CONTEXT_NOTHING ||
        !signature_find(request, &context.call, context.token, &signature))
        return NULL;
    json_t *parameters = json_array();
    for (size_t i = 0; i < signature.count; i++)
        json_array_append_new(
            parameters, json_pack("{s:s,s:s}", "label", signature.items[i].name,
                                  "documentation", signature.items[i].help));
    json_t *json = json_pack("{s:s,s:o}", "label", signature.label,
                             "parameters", parameters);
    if (signature.help)
        json_object_set_new(json, "documentation",
                            json_markdown(signature.help));
    return json_pack("{s:[o],s:i,s:i}", "signatures", json, "activeSignature",
                     0, "activeParameter", (int)context.call.argument);
}
