// The cones and half-spaces of a tree's nodes, where kernels run.
#pragma once

#include "gpu/contact_cap.h"
#include "gpu/wide_tree.h"

namespace gabarit {

// Those of bvh_cones.cpp: every primitive tells all the nodes above it. `primitives` in the order of the
// tree.
void add_cones_there(const Device& device, View<const Primitive> primitives, View<const ContactCap> caps,
                     View<const Vec3d> points, const Vec3d& origin, WideTree& tree);

}  // namespace gabarit
