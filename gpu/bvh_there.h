// Building a tree where kernels run.
#pragma once

#include <optional>

#include "gpu/contact_cap.h"

namespace gabarit {

struct TreeThere {
  Buffer<BvhNode> nodes;
  Buffer<BvhLeaf> leaves;
  Buffer<Primitive> primitives;
  Buffer<Vec3d> points;
};

// The tree that the CPU builds, but for the numbers of its nodes and leaves; so queries give the same bits.
// Kernels of any device: the CPU itself runs them for tests. Nothing when some facets can only be halved by
// count, as where dozens have the same middle: such surfaces are for the CPU. `origin`: of the tree.
std::optional<TreeThere> build_there(const Device& device, const FacetSurface& surface,
                                     const std::vector<ContactCap>& caps, const Vec3d& origin);

}  // namespace gabarit
