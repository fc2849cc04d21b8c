/* A packet's rays meet a solid that is a tree: a CSG object, or a shape that is
 * clipped. */
#ifndef WORLD_PACKET_TREE_H
#define WORLD_PACKET_TREE_H

#include "world/packet.h"

/* Takes what the rays of `lanes` meet first; or returns, of rays to a lamp,
 * those that meet it. Each as query_tree has it, to the bit. */
unsigned packet_tree(struct packet *packet, const struct solid *solid,
                     unsigned lanes);

/* The same of a simple shape. */
unsigned packet_shape(struct packet *packet, const struct solid *solid,
                      unsigned lanes);

#endif
