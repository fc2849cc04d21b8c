/* The frames of an animation, as POV-Ray 3.7 counts them (measured). */
#include "cli/frames.h"

#include <stdio.h>

#include "cli/output_name.h"

struct frames frames_new(void)
{
    return (struct frames){
        .initial = FRAMES_UNSAID,
        .final = FRAMES_UNSAID,
        .step = 1,
        .subset_start = FRAMES_UNSAID,
        .subset_end = FRAMES_UNSAID,
        .initial_clock = 0,
        .final_clock = 1,
    };
}

/* A share of all frames is counted from 0 whatever the first is, as POV-Ray
 * does; what isn't said is `otherwise`. */
static int frames_bound(const struct frames *frames, double said, int otherwise)
{
    int bound = otherwise;
    if (said > 0 && said < 1)
        bound = (int)floor(said * (frames->last - frames->first + 1));
    else if (!isnan(said))
        bound = (int)said;
    return bound < frames->first ? frames->first : bound;
}

/* POV-Ray draws a single picture then: frame 0, its clock from +K, its name
 * without a number. What +KFF1 or +KFI1 alone asks for is an animation. */
static bool frames_say_one(const struct frames *frames)
{
    return frames->initial == 1 && frames->final == 1;
}

const char *frames_resolve(struct frames *frames, struct arena *arena)
{
    double final = isnan(frames->final) ? frames->initial : frames->final;
    if (isnan(final) || final == 0 || frames_say_one(frames))
        return NULL;
    double initial = isnan(frames->initial) ? 1 : frames->initial;
    if (final < initial)
        return arena_printf(arena,
                            "Final_Frame %.0f is before Initial_Frame %.0f",
                            final, initial);
    frames->animated = true;
    frames->first = (int)initial;
    frames->last = (int) final;
    frames->pace = (int)frames->step;
    frames->begin = frames_bound(frames, frames->subset_start, frames->first);
    int last = frames->begin > frames->last ? frames->begin : frames->last;
    frames->end = frames_bound(frames, frames->subset_end, last);
    if (frames->end < frames->begin)
        return arena_printf(
            arena, "Subset_End_Frame %d is before Subset_Start_Frame %d",
            frames->end, frames->begin);
    if (frames->pace < 0) {
        int begin = frames->end;
        frames->end = frames->begin;
        frames->begin = begin;
    }
    frames->digits =
        snprintf(NULL, 0, "%d", frames->last + (frames->cyclic ? 1 : 0));
    return NULL;
}

void frames_deal(struct frames *frames, int number, int count)
{
    const int all = frames_count(frames), longer = all % count,
              before = number - 1;
    const int first =
        before * (all / count) + (before < longer ? before : longer);
    const int row = all / count + (before < longer);
    frames->none = row == 0;
    if (frames->none)
        return;
    frames->begin += first * frames->pace;
    frames->end = frames->begin + (row - 1) * frames->pace;
}

int frames_count(const struct frames *frames)
{
    if (frames->none)
        return 0;
    if (!frames->animated)
        return 1;
    return (frames->end - frames->begin) / frames->pace + 1;
}

int frames_number(const struct frames *frames, int index)
{
    return frames->animated ? frames->begin + index * frames->pace : 0;
}

void frames_tell(const struct frames *frames, int number,
                 struct parse_options *parse)
{
    if (!frames->animated)
        return;
    /* A cyclic animation lacks its last frame, which would be the first
     * again; the scene is told of it as POV-Ray does. */
    int last = frames->last + (frames->cyclic ? 1 : 0);
    double range = frames->final_clock - frames->initial_clock;
    /* POV-Ray divides by zero for a lone frame. */
    parse->clock_delta =
        last > frames->first ? range / (last - frames->first) : 0;
    parse->clock = frames->initial_clock;
    if (number != frames->first)
        parse->clock +=
            range * (number - frames->first) / fmax(last - frames->first, 1);
    parse->clock_on = true;
    parse->initial_clock = frames->initial_clock;
    parse->final_clock = frames->final_clock;
    parse->initial_frame = frames->first;
    parse->final_frame = last;
    parse->frame_number = number;
}

const char *frames_name(const struct frames *frames, int number,
                        const char *output, struct arena *arena)
{
    if (!frames->animated || !output || output_is_fixed(output))
        return output;
    size_t stem = output_stem(output);
    return arena_printf(arena, "%.*s%0*d%s", (int)stem, output, frames->digits,
                        number, output + stem);
}
