#include "tests/dense_boundary.h"

#include <random>

#include "model/brep_curvature.h"
#include "model/brep_trim.h"

namespace gabarit {

std::vector<BoundaryPoint> dense_boundary(const Brep& brep, std::size_t tries) {
  const BrepView arrays = view(brep);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<BoundaryPoint> points;
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    const Face& face = brep.faces[f];
    for (std::size_t i = 0; i < tries; ++i) {
      const Parameters at{face.range.u0 + share(random) * (face.range.u1 - face.range.u0),
                          face.range.v0 + share(random) * (face.range.v1 - face.range.v0)};
      if (trim_side(arrays, f, at) != TrimSide::inside) continue;
      const SurfacePoint s = face_point(arrays, face, at);
      points.push_back({s.p, outward_normal(s, face.sign)});
    }
  }
  return points;
}

}  // namespace gabarit
