/* Which task of an array job this process is, as the engine's variables say. */
#ifndef CLI_ARRAY_H
#define CLI_ARRAY_H

#include <stddef.h>

#include "render/share.h"

/* By SLURM_ARRAY_TASK_ID, SGE_TASK_ID, PBS_ARRAY_INDEX (or PBS_ARRAYID),
 * LSB_JOBINDEX, AWS_BATCH_JOB_ARRAY_INDEX or JOB_COMPLETION_INDEX, and what
 * goes with them. `count`: of how many, or 0 if the engine is to say; then the
 * first task is number 1 whatever its index, else indices count from 1, AWS's
 * and Kubernetes's from 0. False with what is wrong in problem[size]. */
bool array_task(int count, struct share *task, char *problem, size_t size);

#endif
