/* Options that say what light_mesh {} and skeleton {} of a scene say, by the
 * same table of fields; see scene/light_settings.h. */
#include "cli/option.h"

#include <math.h>

#include "base/text.h"

static bool light_number(struct option_reader *reader,
                         const struct option *option,
                         const struct setting *setting,
                         const struct field *field, void *at)
{
    double number;
    if (!option_read_number(reader, option, setting, &number))
        return false;
    if (field->kind == FIELD_INTEGER)
        number = trunc(number);
    if (!(number >= field->minimum && number <= field->maximum))
        return option_fail(reader, setting, "%s must be from %s to %s",
                           option->key, NUMBER_TEXT(field->minimum),
                           NUMBER_TEXT(field->maximum));
    if (field->kind == FIELD_INTEGER)
        *(int *)at = (int)number;
    else
        *(double *)at = number;
    return true;
}

static bool light_choice(struct option_reader *reader,
                         const struct option *option,
                         const struct setting *setting,
                         const struct field *field, int *at)
{
    char choices[128];
    if (!option_wants(reader, option, setting, field->choices[0]))
        return false;
    int choice = field_choice(field, setting->value);
    field_choices(field, choices, sizeof choices);
    if (choice < 0)
        return option_fail(reader, setting, "%s is %s, not '%s'", option->key,
                           choices, setting->value);
    *at = choice;
    return true;
}

static bool light_state(struct option_reader *reader,
                        const struct option *option,
                        const struct setting *setting, bool *at)
{
    if (!option_wants(reader, option, setting, "on"))
        return false;
    return option_truth(setting->value, at) ||
           option_fail(reader, setting, "%s is on or off, not '%s'",
                       option->key, setting->value);
}

static bool light_read(struct option_reader *reader,
                       const struct option *option,
                       const struct setting *setting, const struct field *field)
{
    void *at = (char *)&reader->options->light + field->offset;
    switch (field->kind) {
    case FIELD_CHOICE:
        return light_choice(reader, option, setting, field, at);
    case FIELD_NAME:
        if (!option_wants(reader, option, setting, option->argument))
            return false;
        *(const char **)at = setting->value;
        return true;
    case FIELD_BOOL:
        return light_state(reader, option, setting, at);
    case FIELD_FLAG:
        *(bool *)at = true;
        return true;
    default:
        return light_number(reader, option, setting, field, at);
    }
}

bool set_light(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    const struct field *field = field_find(option->fields, option->field);
    if (!light_read(reader, option, setting, field))
        return false;
    light_said_add(&reader->options->light_said, field, setting->value_span);
    return true;
}
