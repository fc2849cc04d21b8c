/* Array jobs: see array.h. */
#include "cli/array.h"

#include <stdio.h>
#include <stdlib.h>

/* The names of an engine's variables; NULL: it has none. */
struct engine {
    const char *name, *index, *first, *last, *step, *count;
    int base; /* the first index, where nothing else is said */
};

static const struct engine engines[] = {
    { "Slurm", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN",
      "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP", "SLURM_ARRAY_TASK_COUNT",
      1 },
    { "Grid Engine", "SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST",
      "SGE_TASK_STEPSIZE", NULL, 1 },
    { "PBS", "PBS_ARRAY_INDEX", NULL, NULL, NULL, NULL, 1 },
    { "Torque", "PBS_ARRAYID", NULL, NULL, NULL, NULL, 1 },
    { "LSF", "LSB_JOBINDEX", NULL, "LSB_JOBINDEX_END", "LSB_JOBINDEX_STEP",
      NULL, 1 },
    { "AWS Batch", "AWS_BATCH_JOB_ARRAY_INDEX", NULL, NULL, NULL,
      "AWS_BATCH_JOB_ARRAY_SIZE", 0 },
    { "Kubernetes", "JOB_COMPLETION_INDEX", NULL, NULL, NULL, NULL, 0 },
};

/* A whole number that is not below 0. */
static bool array_variable(const char *name, long *number)
{
    const char *text = name ? getenv(name) : NULL;
    char *end;
    if (!text || *text < '0' || *text > '9')
        return false;
    *number = strtol(text, &end, 10);
    return *end == '\0' && *number <= 1000000000;
}

/* LSF says 0 where there is no array, Grid Engine "undefined". */
static const struct engine *array_engine(long *index)
{
    for (size_t i = 0; i < sizeof engines / sizeof *engines; i++)
        if (array_variable(engines[i].index, index) &&
            *index >= engines[i].base - (engines[i].first != NULL))
            return &engines[i];
    return NULL;
}

/* How many tasks there are, or 0. */
static long array_count(const struct engine *engine, long first, long step)
{
    long count, last;
    if (array_variable(engine->count, &count))
        return count;
    if (array_variable(engine->last, &last) && last >= first)
        return (last - first) / step + 1;
    return 0;
}

bool array_task(int count, struct share *task, char *problem, size_t size)
{
    long index, first, step = 1;
    const struct engine *engine = array_engine(&index);
    if (!engine) {
        snprintf(problem, size,
                 "this is no task of an array job: SLURM_ARRAY_TASK_ID and "
                 "its kin are not set");
        return false;
    }
    first = engine->base;
    if (!count) {
        array_variable(engine->first, &first);
        if (!array_variable(engine->step, &step) || step < 1)
            step = 1;
        index = (index - first) / step;
        long all = array_count(engine, first, step);
        count = all > SHARE_LIMIT ? SHARE_LIMIT : (int)all;
    } else {
        index -= first;
    }
    if (!count) {
        snprintf(problem, size,
                 "%s does not say how many tasks there are: type array/16",
                 engine->name);
        return false;
    }
    if (index < 0 || index >= count) {
        snprintf(problem, size, "%s is %ld, which is none of %d tasks",
                 engine->index, index + first, count);
        return false;
    }
    *task = (struct share){ (int)index + 1, count };
    return true;
}
