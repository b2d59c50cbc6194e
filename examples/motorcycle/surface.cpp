#include "examples/motorcycle/surface.h"

namespace gabarit::motorcycle {

Surface mirrored(const Surface& surface) {
  Surface other = surface;
  other.at = [at = surface.at](double u, double v) {
    const Vec3d p = at(u, v);
    return Vec3d{p.x, -p.y, p.z};
  };
  other.flipped = !surface.flipped;
  return other;
}

}  // namespace gabarit::motorcycle
