/* Answers that the rays of a pixel share: see pixel_answers.h. */
#include "lightmesh/pixel_answers.h"

#include "base/memory.h"
#include "lightmesh/pixel_slots.h"
#include "lightmesh/tuning.h"

struct pixel_answer {
    vec3 point, side, normal;
    double reach2; /* square of its reach */
    int coarser;   /* as of a corner_cell */
    struct indirect_share share;
};

/* Those of one pixel. */
struct told {
    unsigned count;
    struct pixel_answer at[ANSWERS_MOST];
};

struct pixel_answers {
    struct pixel_slots *told;
};

struct pixel_answers *pixel_answers_new(unsigned threads)
{
    struct pixel_answers *answers = memory_new(sizeof *answers);
    answers->told = pixel_slots_new(threads, sizeof(struct told));
    return answers;
}

void pixel_answers_free(struct pixel_answers *answers)
{
    if (!answers)
        return;
    pixel_slots_free(answers->told);
    memory_free(answers);
}

/* NULL: the only ray of its pixel. */
static struct told *told_of(const struct pixel_answers *answers,
                            const struct worker *worker,
                            const struct receiver *receiver)
{
    bool fresh;
    struct told *told = pixel_slots_at(answers->told, worker, receiver, &fresh);
    if (told && fresh)
        told->count = 0;
    return told;
}

static bool answer_serves(const struct pixel_answer *answer,
                          const struct receiver *receiver)
{
    vec3 between = vec3_sub(answer->point, receiver->point);
    double apart2 = vec3_dot(between, between);
    double rise = vec3_dot(between, receiver->side);
    return apart2 <= answer->reach2 &&
           rise * rise <= answer_rise * answer_rise * apart2 &&
           vec3_dot(answer->side, receiver->side) >= answer_bend &&
           vec3_dot(answer->normal, receiver->normal) >= answer_bend &&
           answer->coarser == point_mesh_worth(receiver->weight);
}

bool pixel_answers_find(const struct pixel_answers *answers,
                        const struct worker *worker,
                        const struct receiver *receiver,
                        struct indirect_share *share)
{
    const struct told *told = told_of(answers, worker, receiver);
    for (unsigned i = 0; told && i < told->count && i < ANSWERS_MOST; i++)
        if (answer_serves(&told->at[i], receiver)) {
            *share = told->at[i].share;
            return true;
        }
    return false;
}

void pixel_answers_keep(const struct pixel_answers *answers,
                        const struct worker *worker,
                        const struct receiver *receiver, double reach,
                        const struct indirect_share *share)
{
    struct told *told = told_of(answers, worker, receiver);
    if (!told)
        return;
    told->at[told->count++ % ANSWERS_MOST] = (struct pixel_answer){
        .point = receiver->point,
        .side = receiver->side,
        .normal = receiver->normal,
        .reach2 = reach * reach,
        .coarser = point_mesh_worth(receiver->weight),
        .share = *share,
    };
}
