/* All choices and thresholds of light meshes in one place, each written once:
 * what it is of, its unit, and in brackets the row of tests/bench/rows.txt (or
 * the scene of examples/) where it was measured: to change one is to run that
 * row. Lengths "in spacings" are of the lattice there, shares are of 1. What
 * only describes a layout (bits of a key, sizes of an array) stays where it is
 * used. plan.h makes of these, of the settings and of the scene the figures of
 * one picture. */
#ifndef LIGHTMESH_TUNING_H
#define LIGHTMESH_TUNING_H

/* Who is asked. */
enum {
    EACH_LAMPS = 96,    /* lamps that shadow rays ask one by one, at most, as
                         * under rays; of more the light is summed at mesh points
                         * [lights-100; firs of cones, 30 lamps: FLIP .21 -> 0] */
    FEW_LAMPS = 24,     /* the same where it is said what the mesh is to be; and
                         * known one by one there [hall] */
    SPOTS_MOST = 256,   /* spotlights count by what they light, of so many */
    SHARP_LAMPS = 1000, /* the same where `shadows sharp` is said [hall] */
    GATHER_LAMPS = 96,  /* of which gather rays ask one, if not a sum [room] */
    GATHER_EACH = 3,    /* of so few each */
    DRAWN_LAMPS = 8,    /* of which it is drawn */
};

/* What is looked at before a picture is planned [price]. */
enum {
    OUTLOOK_EDGE = 24, /* rays along the edge of the picture that tell how large
                        * and how far what it shows is */
    SURVEY_EDGE = 16,  /* the same that tell what indirect light is worth, */
    SURVEY_RAYS = 4,   /* gather rays of each, */
    CHAMBER_RAYS = 32, /* or, where little light leaves the scene, so many, */
    BRIGHT_RAYS = 64,  /* or, where most of it comes from few places; */
    SURVEY_PANES = 16, /* and how many panes and mirrors both pass: */
};
static const double pane_least = 0.5; /* of light they let pass, or mirror */
static const double pane_shows = 0.1; /* of it, itself, before nothing else */
/* Pixels, where it isn't said. */
static const double usual_width = 640, usual_height = 480;
static const double outlook_beside = 0.1; /* share of what is seen, at either
                                           * end, that tells nothing of it */
/* Of the usual distance: cameras that bend lines look all around, at what is
 * near as well [camera-cylinder]. */
static const double outlook_bent = 3;
static const double survey_dark = 0.03; /* what the picture shows is not
                                         * darker than that, to an eye */

/* Light cuts: which cluster of lamps is opened next [lights-1000]. */
static const double cut_near = 0.25; /* its sizes: nearer counts as so near */
static const double cut_even = 1e-6; /* of its light, where all are far away */

/* How near mesh points are to each other. */
static const double quality_usual = 5;   /* if none is said */
static const double quality_step = 1.3;  /* finer for each step [quality] */
static const double spacing_pixels = 20; /* pixels [density, forest] */
static const double spacing_cells_least = 24; /* across what is seen [room] */
static const double spacing_cells_most = 256; /* likewise [pixels-1200] */
/* Half as many on a surface. */
static const double spacing_coarser = 1.4142135623730951;
static const double interpolation_usual = 1.6; /* radius, spacings [room], */
static const double interpolation_least = 0.9; /* and at least: some point is
                                                * always in it */
static const double indirect_cells = 40; /* of the indirect mesh, across what
                                          * is seen, are enough [room] */
static const double adaptive_threshold = 0.2; /* relative difference
                                               * [paper/surfaces] */
enum {
    ADAPTIVE_LEVELS = 2,   /* finer, where a threshold is said */
    SPACINGS_MOST = 20,    /* that are counted until the points have room */
    CENSUS_EDGE = 16,      /* rays along the edge of the first count, */
    CENSUS_SEEN_EDGE = 48, /* where only what is seen is counted */
    CENSUS_FINE_EDGE = 64, /* and if that can't tell */
    CENSUS_PANES = 16,     /* looked through, one behind the other */
};
static const double census_far = 150;   /* times as many: too far to tell */
static const double census_sure = 0.25; /* less of the room taken: sure */

/* Memory, bytes: issue 4 allows 64 MB more than rays [memory]. */
enum {
    MESH_BYTES = 120 * 1000 * 1000,
    INDIRECT_BYTES = 30 * 1000 * 1000, /* of them, with indirect light */
    SURFACE_PART = 3, /* one in so many is for points on surfaces */
};
static const double kept_full = 0.5; /* of a table, by the picture before */
static const double kept_levels = 1; /* by which points are nearer to each
                                      * other than wanted, or farther off,
                                      * before others are asked, ... */
static const double follow_levels =
    0.5; /* the same of another picture of an animation in
          * which something moves: as these can be afforded
          * [flicker] */
static const double moments_alike = 0.05, /* light that differs by less, */
    moments_apart = 0.15; /* by more: smoothed in full, not at all [flicker] */
enum { KEPT_LEVELS = 6 }; /* which are up to so many levels finer or coarser */
static const double kept_rays = 4; /* times as many that are wanted of a point:
                                    * others are made */

/* Mesh points in space [forest, thinwall, room]. */
static const double seek_lift = 0.3;   /* above the surface, spacings */
static const double seek_rise = 0.2;   /* points lower than that count less,
                                        * spacings */
static const double seek_clear = 0.1;  /* of light: panes that let it pass */
static const double seek_few = 0.5;    /* of its points see a place in a gap */
static const double seek_least = 0.03; /* of a place's points that gather: what
                                        * counts less isn't asked [pillars] */
static const double seek_worth = 0.17; /* and the more of them the less it is
                                        * worth, down to that [price] */
static const double seek_behind_least = 0.06; /* likewise, behind panes */
static const double nearest_rise = 0.1;       /* likewise, of the nearest */
static const double worth_fine = 0.15;        /* what is worth less is a level
                                               * coarser, share of the picture */
static const double worth_step = 3; /* and one more for each such factor */
static const double obstacle_reach = 2.5;  /* spacings */
static const double obstacle_plane = 0.03; /* flat within that share */
static const double obstacle_hides = 1.25; /* of the way to what stands on all
                                            * sides of it: a ray nearly always
                                            * meets it as well */
/* Of the 26 directions of a point: what stands in so many may be what the point
 * is in [a cylinder on a floor]. */
enum { OBSTACLES_ENCLOSE = 22 };
static const double asking_reach = 2.1; /* nothing farther asks, spacings */
static const double alike_amounts = 3;  /* of light, a factor: no matter which
                                         * points see the place */
static const double level_blend = 0.5;  /* of a level, then the next begins */

/* Few lamps under `shadows soft` and `sharp` [hall]. */
enum { AGREEING_POINTS = 3 };           /* fewer don't decide what is sharp */
static const double faint_error = 0.13; /* of faint lamps together, relative */

/* Many lamps, asked by points in space and on surfaces [lights-1000,
 * lamps-10000]. */
enum {
    LAMP_BUDGET = 24,     /* that a point asks, of 100 at quality 5 */
    BUDGET_LAMPS = 100,   /* of more the budget grows as they do, ... */
    BUDGET_MOST = 4,      /* up to so many times */
    SURFACE_LAMPS = 1024, /* points on surfaces look at each; of more at
                           * clusters */
    CERTAIN_ROUNDS = 4,   /* of counting lamps that are asked for certain */
};

/* Mesh points on surfaces [forest, triangles-50000]. Sizes are square roots of
 * areas, in spacings. */
static const double facet_least = 0.05;     /* of triangles that stand alone */
static const double facet_least_shared = 2; /* of others */
static const double facet_least_square = 1; /* of parallelograms */
static const double facet_most = 4096;      /* longest edge */
static const double facet_narrow = 0.2;     /* width over length */
static const double chain_long = 2, chain_thin = 0.1, chain_wide = 1.5;
static const double apart_alone = 0.7, apart_shared = 1.4, apart_chain = 3;
static const double spread_cell = 0.5;    /* rays begin on so much of a cell */
static const double spread_single = 0.94; /* and of a triangle */
static const double asked_cell = 0.6, asked_shared = 4; /* of the budget */
static const double asked_fully = 0.3; /* smaller triangles ask fewer lamps */
static const double facet_lift = 0.05; /* from where points are looked for */
enum { FACETS_MOST = 250000 }; /* more: none alone [triangles-1000000] */

/* Pixels as mesh points [lights-10 to lights-1000, forest]. Times in seconds,
 * as measured; only their ratios count. */
static const double pixels_most = 2.5e6;      /* places, 100 MB */
static const double pixel_pairs_most = 3.2e8; /* bits, 40 MB */
static const double pixel_points = 1.5;       /* with those of small surfaces */
static const double pixel_lamps_apart = 14;   /* of lamps / 14 pixels one */
static const double pixel_lamps_more = 100, pixel_more_most = 4;
static const double time_lamp_triangle = 26e-9, time_lamp_point = 15e-9;
static const double time_ray = 0.3e-6, time_space_pixel = 0.8e-6;
static const double time_pixel_point = 0.25e-6; /* however many lamps there are
                                                 */
static const double time_ray_together = 0.1e-6; /* of those of many pixels */
static const double pixel_worth = 3;        /* so much longer: a third of the
                                             * error of points in space */
static const double pixel_rays_share = 0.6; /* of few lamps' rays it may take
                                             */
static const double pixel_rays_most = 0.3;  /* of pairs that a ray may decide */
static const double pixel_detail_least = 1e-3; /* units: rays begin there */
static const double pixel_detail = 0.1; /* of a pixel: no shadow is seen */
static const double pixel_alike = 0.5;  /* cosine of normals that share light */

/* Area lights at pixels [arealight]. */
static const double penumbra_bytes_most = 64e6;
static const double penumbra_wide = 2;     /* at least, in blocks */
static const float penumbra_even = 0.2f;   /* corners differ by less */
static const double penumbra_bend = 0.3;   /* of normals, in a block */
static const double penumbra_swell = 0.25; /* of a block, in its side */

/* Gathering [room, blocks, maze, room-error]. */
enum {
    BOUNCES = 6,
    ONWARD_MOST = 24,    /* surfaces on the way of one that goes on, at most */
    CLOSED_BOUNCES = 1,  /* when the skeleton knows the rest */
    OPEN_BOUNCES = 1,    /* when further rays do: much light leaves the scene */
    GATHER_LEAST = 16,   /* rays of a mesh point where they are dear, */
    GATHER_FEW = 32,     /* and else; twice that where single rays bring more
                          * than all of them change [truth] */
    CHAMBER_LEAST = 32,  /* the same where little light leaves the scene, */
    CHAMBER_BLIND = 128, /* and where the skeleton doesn't know more than one in
                          * so many of the places they meet [plates_glow], */
    CHAMBER_KNOWN = 32,
    CHAMBER_WAYS = 128,   /* and at most: others are sent where these differ
                           * [blocks, courtyard], and more where that is said */
    CHAMBER_ANIMATED = 4, /* times as many, and as many picks and CLOSE_RAYS,
                           * in an animation [flicker]; */
    CHAMBER_SMOOTHED = 2, /* rays where its frames smooth each other */
    GATHER_MOST = 512,    /* more gain little [maze, pillars] */
    UNSEEN_SAMPLES = 256, /* where nobody looks how many it takes */
    LONE_SAMPLES = 16,    /* of places that are their own mesh point */
    LONE_PART = 8,        /* of later bounces one in so many */
    LATER_SAMPLES = 16,   /* of kept points of later bounces, at most */
    HIT_LEVELS = 1,       /* direct light on what they meet is coarser */
    WALL_PART = 4,        /* of ways into the only wall one in so many */
    BRIGHT_PART = 2,      /* one ray in so many goes to bright places */
    PICK_PART = 2,        /* for so many rays one to what glows: others do not
                           * differ as much [an emissive Cornell box, a room
                           * with a lamp: 0.75 of the time] */
    WAYS_MOST = 65536,    /* directions that are kept */
    GATHER_PANES = 64,    /* that a ray passes */
    GATHER_MIRRORS = 3,   /* on one way */
    CLOSE_VOXELS = 48,    /* of the closing skeleton, along the longest side */
    CLOSE_RAYS = 40000,   /* between its walls */
    NEAR_RAYS = 10,       /* to what is close to a corner, */
    NEAR_LONE_RAYS = 5,   /* and to a place that only a pixel shares [truth], */
    NEAR_LONE_FEW = 3,    /* where surfaces give little light: near_worth, */
    NEAR_MORE_RAYS = 3,   /* or that is another of a pixel's [a meadow] */
    NEAR_GLOW_RAYS = 48, /* around, and to what glows close to a place, each, of
                          * which a packet tells whether that matters; */
    NEAR_GLOW_FEW = 4,   /* to what glows, of what is worth little */
    NEAR_BESIDE = 32,    /* to what is close where something glows [furnace] */
    NEAR_OWN_RAYS = 32,  /* of a place in a crevice [contact], */
    NEAR_OWN_LEAST = 4,  /* of which so few tell nothing [light-point] */
    LONE_PLACES = 4,     /* of a pixel, that its rays share */
    ANSWERS_MOST = 4,    /* likewise, of what they were told */
    PIXEL_SLOTS = 16,    /* both are kept for so many that were last refined */
    SCALAR_SAMPLES = 100, /* of the paper's indirect mesh */
};

/* Indirect light at corners on surfaces [price, look]. */
enum { INDIRECT_PIXELS_BYTES = 24 * 1000 * 1000 };
static const double indirect_pixels_most = 15200;  /* corners, but for these: */
static const double indirect_pixels_near = 4.5;    /* apart at least, pixels */
static const double indirect_pixels_far = 18;      /* and at most */
static const double indirect_pixels_flat = 0.9999; /* cosine: no bump */
static const double indirect_pixels_bend = 0.8;    /* cosine: normals share */
static const double indirect_pixels_rise = 0.3;  /* of a corner over the plane,
                                                  * share of its distance */
static const double indirect_pixels_lift = 0.05; /* of a corner's distance */
static const double indirect_pixels_even = 0.3; /* share of their light by which
                                                 * corners may differ, */
static const double indirect_pixels_same = 0.2; /* where those do between
                                                 * which another would be, that
                                                 * one is spared */
static const double indirect_pixels_fade = 0.5; /* of that more, by which those
                                                 * still are in part */
static const double indirect_pixels_dim = 0.004;  /* and irradiance, */
static const double indirect_pixels_open = 0.2;   /* openness 1 counting as much
                                                   */
static const double indirect_pixels_least = 0.01; /* weight of a corner asked */
static const double indirect_pixels_enough = 0.4; /* and of all that serve */

static const double clip_before = 0.1; /* of a cell's edge: what stands for a
                                        * corner is that far before a wall, */
static const double clip_least = 0.05; /* and from the next one, at least */

static const double grid_facing_least = 0.0625; /* cosine of a surface to the
                                                 * way to it: what is seen more
                                                 * from its edge counts as that
                                                 */
static const double grid_between = 0.70710678118654752; /* of the step that is
                                                         * wanted: finer ones
                                                         * are too fine */
static const double grid_blend = 0.84;  /* of a step the one that is a level
                                         * finer, from where on this one is
                                         * blended in */
static const double grid_margin = 0.25; /* of a cell, by which a corner is
                                         * looked for above and below it */

static const double block_places = 0.25; /* of the grid's step, from one place
                                          * of a block to the next */
static const double block_bend = 0.95;   /* cosine of normals that share one */
static const double block_deep = 0.7; /* of short rays: more meet something */
static const double block_around = 1; /* spacings: places no farther from the
                                       * middle ask the same mesh points, */
static const double block_around_bend = 0; /* if their normals are so near */
static const double block_beside = 1.5;    /* of that: what is no farther is one
                                            * surface, or shows no difference */

static const double answer_reach = 0.5;  /* of the grid's step: rays of a pixel
                                          * that are no farther apart have one
                                          * answer, if their normals are so */
static const double answer_bend = 0.985; /* near to each other, cosine, */
static const double answer_rise = 0.3;   /* and on one surface, as corners */

static const double beyond_straight =
    0.98;                                /* cosine: what panes bend no more
                                          * is seen as if they weren't there */
static const double mended_worth = 0.02; /* what is worth less beyond mirrors
                                          * and glass has no rays of its own [a
                                          * third of the time of a watch] */

static const double near_field_reach = 0.85; /* spacings: what stands farther
                                              * off mesh points see [truth], */
static const double near_field_whole = 0.75; /* of it: all of that is missed */
static const double near_glow_reach = 5, near_glow_whole = 0.5; /* of glow */
static const double near_glow_wide = 2;     /* larger, in reaches: not near */
static const double near_glow_little = 0.1; /* of other light: few rays do */
static const double near_glow_worth = 0.5;  /* what is worth less has few */
/* Of short rays so many meet something in a corner, and in a crevice; where
 * there are many of these, in the deepest; in chambers more than in an edge. */
static const double near_shallow = 0.25, near_deep = 0.5, near_full = 0.4,
                    near_edge = 0.55;
static const double own_usual = 0.045; /* of places in one: more have less */
static const double own_little = 0.5;  /* of one: a packet of rays tells that */
/* Surfaces give less of the picture: fewer short rays, and of these [price]. */
static const double near_worth = 0.2, own_worth = 0.12;

static const double bright_times = 4; /* as bright as the mean is bright; */
static const double bright_least =
    1e-3;                              /* of all light, which comes from it; */
static const double bright_fade = 2;   /* what has so much more is worth most */
static const double bright_gain = 0.8; /* of the variance there is without is
                                        * worth aiming at them */
/* Of the variance there is with those that are found: by those of another
 * picture of an animation there may be so much [flicker]. */
static const double bright_known = 2;
static const double lit_taken = 0.9; /* of lamps' light, of which lit cells are
                                      * to have so much, */
enum { LIT_SIDES = 3 }; /* if not, cells of up to so many sizes are tried */
static const double bright_cells = 10;  /* along the chamber, at least */
static const double bright_round = 0.7; /* radius of what is in a cell, sides */
static const double bright_wall = 1e-3; /* of that its walls are off */

/* Virtual lights [room, thinwall]. */
enum {
    VIRTUAL_EDGE_LEAST = 4, /* rays along the edge of a cell that look at it, at
                             * least, */
    VIRTUAL_RAYS = 4096,    /* and about so many in all, where there is light */
};
enum {
    SURVEY_PICKS = 16,   /* that tell how many a point needs: */
    PICKS_LEAST = 32,    /* at least, */
    VIRTUAL_PICKS = 128, /* and at most, for one picture; */
    GLOW_PICKS = 64,     /* to what glows so many */
};
static const double virtual_worth = 0.05; /* share of all light, to be worth any
                                           */
static const double virtual_unseen = 1e-3; /* a cell of which a survey saw
                                            * nothing is about that share of
                                            * all that is brought */
static const double virtual_near = 1.2;    /* of their distance from each other:
                                            * what is nearer gather rays bring */

static const double gather_noise = 0.009; /* of the picture, */
/* And in chambers, where neighbours send other rays [room, kitchen]; of each
 * picture of an animation, were it alone [flicker]. */
static const double chamber_noise = 0.012, chamber_noise_animated = 0.0095;
static const double gather_edge = 3; /* in chambers: see way_cells.h [blocks,
                                      * cornell, flicker] */
/* The noise of ways falls by the power 1/1.43 of its size [room to pillars]. */
static const double gather_net = 1.43;
static const double gather_worth_none = 0.003; /* change of the picture that is
                                                * not seen */
static const double gather_across = 1.5; /* pictures: what must be smooth */
/* Of a picture of so many pixels, as of smaller ones; of larger ones they grow
 * as edges do. */
static const double gather_pixels = 76800;
/* Gather rays for each pixel, more for each unit of worth, and in all: */
static const double gather_pixel = 0.2, gather_pixel_worth = 2.2,
                    gather_pixel_most = 2.4;
/* Worth beyond which most of the picture is what is gathered: more for each
 * unit of that, of which there may be 1; and beyond which none is spared. How
 * rough it may be to need none of both, and how much rougher to need all. */
static const double gather_mostly = 0.4, gather_pixel_mostly = 8,
                    gather_most = 0.5, mostly_smooth = 0.4, mostly_rough = 0.1;
static const double gather_rough = 0.2; /* what is usual, likewise; rougher
                                         * light gets more, a factor: */
static const double gather_rough_least = 0.5, gather_rough_most = 1.75;
static const double gather_few_rough = 1.2; /* times worth: twice GATHER_FEW */
static const double gather_shaded = 1.5; /* rays: one more, and a shaded hit */
static const double gather_chamber = 31; /* times as many where light stays */
static const double gather_coarser_most = 3; /* factor of the spacing */
static const double open_enough = 0.1; /* share of gather rays that leave the
                                        * scene: it is no chamber, */
static const double half_open = 0.35;  /* but like one if fewer leave it and
                                        * indirect light is worth so much and so
                                        * rough [stairs, courtyards: .5 to .9 of
                                        * the time, and less error] */
static const double half_open_worth = 0.5, half_open_rough = 0.3;
static const double half_open_stays = 1.4; /* factor of these for what follows
                                            * another picture */
static const double gather_worth_least = 0.02;  /* then the skeleton answers */
static const double gather_worth_around = 0.01; /* or, in the open, what is
                                                 * usual */
static const double gather_worth_whole = 0.5;   /* less gathers fewer rays */
static const double gather_least = 0.02;        /* share that is followed */
static const double gather_spread = 0.02;       /* radius of the cone that a
                                                 * ray is, and one from what it
                                                 * meets to a lamp */
static const double often_mirrored = 2, often_lit = 4; /* roulette, factors, */
static const double onward_often = 1; /* of where it goes on [truth]; */
static const double onward_often_blind =
    2; /* of the first step where no survey says what is usual [plates] */

#endif
