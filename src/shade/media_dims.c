/* What media let pass of several ways' light: see media_dims.h. */
#include "shade/media_dims.h"

#include <string.h>

#include "base/lesser.h"
#include "shade/media_march.h"
#include "shade/media_places.h"

void media_dims_begin(struct media_dims *dims, struct worker *worker, int ways)
{
    dims->worker = worker;
    dims->media.count = 0;
    dims->at.count = 0;
    for (int i = 0; i < ways; i++)
        dims->depth[i] = rgb_grey(0);
}

void media_dims_look(struct media_dims *dims)
{
    rgb depths[SPOTS_MAX];
    if (dims->at.count == 0)
        return;
    media_depths(&dims->media, dims->worker, &dims->at, depths);
    for (int i = 0; i < dims->at.count;) {
        int way = dims->way[i];
        rgb sum = dims->depth[way];
        for (; i < dims->at.count && dims->way[i] == way; i++)
            sum = rgb_add_scaled(sum, depths[i], dims->weight[i]);
        dims->depth[way] = sum;
    }
    dims->at.count = 0;
}

/* The way that is being added. */
struct dimming {
    struct media_dims *dims;
    struct march *march;
    int number;
};

static void dimming_place(const struct dimming *dimming, double share,
                          double weight)
{
    struct media_dims *dims = dimming->dims;
    if (dims->at.count == SPOTS_MAX)
        media_dims_look(dims);
    dims->weight[dims->at.count] = weight;
    dims->way[dims->at.count] = dimming->number;
    march_place(dimming->march, &dims->at, share);
}

/* An interval of method 3: pieces' means are sums of their ends and middles. */
static void dimming_refining(const struct dimming *dimming)
{
    struct march *march = dimming->march;
    int count = march_pieces(march);
    double moved = march_moved(march), from = greater(moved, 0) / count;
    double weight = march->length / (3 * (count - 1));
    dimming_place(dimming, from, weight);
    for (int i = 1; i < count; i++) {
        double to = lesser((i + moved) / count, 1);
        dimming_place(dimming, (from + to) / 2, weight);
        dimming_place(dimming, to, i < count - 1 ? 2 * weight : weight);
        from = to;
    }
}

static void dimming_averaging(const struct dimming *dimming)
{
    struct march *march = dimming->march;
    int count = march->how->samples;
    for (int i = 0; i < count; i++)
        dimming_place(dimming, march_share(march, i), march->length / count);
}

static void dimming_march(const struct dimming *dimming, double length)
{
    struct march *march = dimming->march;
    const rgb *depth = &dimming->dims->depth[dimming->number];
    int intervals = march_intervals(march);
    march->length = length / intervals;
    for (int i = 0; i < intervals; i++) {
        march->from = i * march->length;
        if (lesser(lesser(depth->r, depth->g), depth->b) > MEDIA_DEEP)
            return;
        if (march->how->method == 3)
            dimming_refining(dimming);
        else
            dimming_averaging(dimming);
    }
}

static rgb media_extinction(const struct media_list *media)
{
    rgb depth = rgb_grey(0);
    for (int i = 0; i < media->count; i++)
        depth = rgb_add(depth, medium_extinction(media->at[i]));
    return depth;
}

/* Places that follow are in these. */
static void dims_enter(struct media_dims *dims, const struct media_list *media)
{
    size_t size = (size_t)media->count * sizeof media->at[0];
    if (dims->media.count == media->count &&
        memcmp(dims->media.at, media->at, size) == 0)
        return;
    media_dims_look(dims);
    dims->media.count = media->count;
    memcpy(dims->media.at, media->at, size);
}

bool media_dims_add(struct media_dims *dims, const struct media_way *way,
                    int number)
{
    double length = lesser(way->length, media_horizon);
    if (way->media->count == 0 || !(length > 0))
        return true;
    struct march march = march_begin(way);
    if (!march_dims(&march))
        return false;
    if (march.even) {
        rgb *sum = &dims->depth[number];
        *sum = rgb_add_scaled(*sum, media_extinction(way->media), length);
        return true;
    }
    const struct dimming dimming = { dims, &march, number };
    dims_enter(dims, way->media);
    dimming_march(&dimming, length);
    return true;
}

rgb media_dims_through(const struct media_dims *dims, int number)
{
    return depth_through(dims->depth[number], 1);
}
