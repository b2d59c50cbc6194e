#include "report/triad.h"

#include <algorithm>

namespace gabarit {

std::array<TriadAxis, 3> triad(const Camera& camera) {
  std::array<TriadAxis, 3> axes;
  const Vec3d toward = camera.toward();
  for (int i = 0; i < 3; ++i) {
    axes[static_cast<std::size_t>(i)] = {"xyz" [i], { camera.right[i], camera.up[i] }, toward[i]};
  }
  std::stable_sort(axes.begin(), axes.end(),
                   [](const TriadAxis& a, const TriadAxis& b) { return a.toward < b.toward; });
  return axes;
}

}  // namespace gabarit
