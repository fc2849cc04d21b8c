/* The poster's backward heuristic: from the point back along the shortest way
 * to the lamp as far as one can see, to the node n_e; the rest of the way is
 * taken for a straight line: B = I / d^2 with d = |lamp - n_e| + |n_e - point|.
 * The search ends at the first node that is hidden (A6). */
#include "skeleton/heuristic.h"
#include "skeleton/stream.h"

/* Visibility hardly changes within a ball of void: steps of half its radius,
 * then node by node where the first was hidden. */
static uint32_t backward_farthest(const struct skeleton *skeleton,
                                  const struct paths *paths,
                                  const struct skeleton_point *point)
{
    const struct graph_node *nodes = skeleton->graph->nodes;
    uint32_t seen = point->node;
    bool visible = true;
    while (visible && paths->parent[seen] != GRAPH_NONE) {
        double step = nodes[seen].radius / 2;
        uint32_t next = paths->parent[seen], ahead = next;
        while (paths->parent[ahead] != GRAPH_NONE &&
               (double)(paths->distance[seen] - paths->distance[ahead]) < step)
            ahead = paths->parent[ahead];
        visible = stream_sees(skeleton, point->position, nodes[ahead].position);
        while (!visible && next != ahead &&
               stream_sees(skeleton, point->position, nodes[next].position)) {
            seen = next;
            next = paths->parent[next];
        }
        if (visible)
            seen = ahead;
    }
    return seen;
}

static struct stream_way backward_follow(const struct skeleton *skeleton,
                                         const struct skeleton_lamp *lamp,
                                         const struct skeleton_point *point)
{
    uint32_t farthest = backward_farthest(skeleton, lamp->paths, point);
    uint32_t source = stream_source(lamp->paths, farthest);
    vec3 start = stream_start(skeleton, lamp, source);
    vec3 from = skeleton->graph->nodes[farthest].position;
    vec3 way = vec3_sub(from, point->position);
    return (struct stream_way){
        .length = vec3_length(way) + vec3_length(vec3_sub(start, from)),
        .share = 1,
        .source = source,
        .direction = vec3_normalise(way),
    };
}

static struct skeleton_light backward_answer(const struct skeleton *skeleton,
                                             struct worker *worker,
                                             const struct skeleton_point *point)
{
    return stream_gather(skeleton, worker, point, backward_follow);
}

const struct heuristic backward_heuristic = {
    .name = "backward",
    .help = "by the way to the lamp, straightened as far as one can see",
    .answer = backward_answer,
};
