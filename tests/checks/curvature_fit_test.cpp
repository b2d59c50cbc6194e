#include "checks/curvature_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

// A piece of z = -(xx x² + 2 xy x y + yy y²) / 2 over irregular triangles; so shallow that angles are slopes.
shapes::Triangles quadric(double xx, double xy, double yy, unsigned seed) {
  std::mt19937 random(seed);
  const auto off = [&] { return 0.3 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  std::vector<std::vector<Vec3d>> p(8, std::vector<Vec3d>(8));
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const double x = i + off() - 3.5, y = j + off() - 3.5;
      p[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {
          x, y, -(xx * x * x + 2 * xy * x * y + yy * y * y) / 2};
    }
  }
  shapes::Triangles out;
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = 0; j < 7; ++j) {
      const Vec3d &a = p[i][j], &b = p[i + 1][j], &c = p[i + 1][j + 1], &d = p[i][j + 1];
      const bool other = random() % 2 == 0;
      out.push_back({a, b, other ? d : c});
      out.push_back({other ? b : a, c, d});
    }
  }
  return out;
}

TEST(CurvatureFit, is_exact_on_shallow_quadrics_of_any_kind_and_any_triangles) {
  struct Case {
    double xx, xy, yy, largest;
  };
  const double s = 1e-3;
  for (const Case& c : {Case{s, 0, 0, s},
                        {s, 0, s, s},
                        {s, 0, 0.5 * s, s},
                        {s, 0, -0.4 * s, s},
                        {0.5 * s, 0.5 * s, 0.5 * s, s}}) {
    for (unsigned seed = 1; seed < 5; ++seed) {
      const Model model = shapes::model(quadric(c.xx, c.xy, c.yy, seed));
      std::vector<FacetId> all;
      for (FacetId f = 0; f < model.mesh.facet_count(); ++f) all.push_back(f);
      const Folds folds(Scene(model, Device::cpu(1)), all, 0, 0.1);
      for (const FacetId f : all) {
        const Vec3d m = model.mesh.centroid(f);
        if (std::fabs(m.x) > 1.5 || std::fabs(m.y) > 1.5) continue;  // away from the free rims
        const CurvatureFit fit = fit_curvature(model.mesh, folds, f);
        EXPECT_NEAR(fit.curvature, c.largest, 2e-3 * c.largest);
        EXPECT_LT(fit.doubt, 0.05 * c.largest);
        EXPECT_TRUE(fit.resolved);
      }
    }
  }
}

}  // namespace
}  // namespace gabarit
