// Roundings of known radius, meshed regularly, in long strips and irregularly: the bounds hold the truth,
// R3.6 fails R4, R4.4 never does, R5 passes.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "checks/turning.h"
#include "tests/checks/fillets.h"

namespace gabarit {
namespace {

using fillets::Fillet;
using fillets::Meshed;
using fillets::Meshing;
using fillets::Part;

constexpr double degree = std::numbers::pi / 180;
constexpr double limit = 4;

Field measured(const Meshed& meshed) {
  const Model model = shapes::model(meshed.triangles, meshed.sag);
  Setup setup;
  setup.sag = meshed.sag;
  return measure_turning(Scene(model, Device::cpu(1)), setup, whole_model(model.mesh));
}

struct Count {
  int facets = 0, failed = 0, passed = 0, false_fails = 0, false_passes = 0;
};

// A facet of the rounding has its radius, one of the planes has none.
Count judged(const Meshed& meshed, const Field& field, Part part, double radius) {
  Count n;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (meshed.part[i] != part) continue;
    ++n.facets;
    n.failed += field.upper[i] < limit;
    n.passed += field.lower[i] >= limit;
    n.false_fails += field.upper[i] < radius * (1 - 1e-6);
    n.false_passes += part != Part::plane && field.lower[i] > radius * (1 + 1e-6);
  }
  return n;
}

std::string text(const Fillet& f) {
  return fmt::format("R{} over {} deg, step {}, meshing {}", f.radius, f.angle / degree, f.step,
                     static_cast<int>(f.meshing));
}

template <class Check>
void for_each_fillet(std::initializer_list<Meshing> meshings, std::initializer_list<double> radii,
                     std::initializer_list<double> angles, Check&& check) {
  for (const Meshing meshing : meshings) {
    for (const double radius : radii) {
      for (const double angle : angles) {
        for (const double step : {0.5, 1.5, 3.0}) {
          const Fillet fillet{.radius = radius, .angle = angle * degree, .step = step, .meshing = meshing};
          const int strips = static_cast<int>(std::ceil(radius * fillet.angle / step - 1e-9));
          if (fillet.angle / strips > 50 * degree) continue;  // no rounding is left
          SCOPED_TRACE(text(fillet));
          const Meshed meshed = fillets::mesh(fillet);
          check(fillet, strips, meshed, measured(meshed));
        }
      }
    }
  }
}

constexpr auto marked = {Meshing::grid, Meshing::long_strips, Meshing::jittered, Meshing::jittered_flips};

TEST(RadiusOfFillets, the_bounds_hold_the_truth_where_edges_mark_the_tangent_lines) {
  for_each_fillet(marked, {1, 2, 3, 5, 8, 12}, {30, 45, 90, 180},
                  [](const Fillet& f, int, const Meshed& meshed, const Field& field) {
                    for (const Part part : {Part::rounding, Part::plane}) {
                      const Count n = judged(meshed, field, part, f.radius);
                      EXPECT_EQ(n.false_fails, 0);
                      EXPECT_EQ(n.false_passes, 0);
                    }
                  });
}

TEST(RadiusOfFillets, the_bounds_hold_the_truth_within_roundings_whose_rims_no_edges_mark) {
  for_each_fillet({Meshing::unmarked}, {3, 5, 12}, {60, 90, 180},
                  [](const Fillet& f, int strips, const Meshed& meshed, const Field& field) {
                    if (strips < 4) return;
                    EXPECT_EQ(judged(meshed, field, Part::rounding, f.radius).false_passes, 0);
                    EXPECT_EQ(judged(meshed, field, Part::across, f.radius).false_passes, 0);
                    EXPECT_EQ(judged(meshed, field, Part::plane, 1).false_fails, 0);
                    if (f.radius >= 4.4) {
                      EXPECT_EQ(judged(meshed, field, Part::rounding, 1).failed, 0);
                    }
                  });
}

TEST(RadiusOfFillets, those_of_3_6_mm_and_less_fail_r4_when_two_strips_show_them) {
  for_each_fillet(marked, {1, 2, 3, 3.6}, {30, 45, 60, 90, 180},
                  [](const Fillet& f, int strips, const Meshed& meshed, const Field& field) {
                    const Count n = judged(meshed, field, Part::rounding, f.radius);
                    EXPECT_EQ(n.passed, 0);
                    if (strips >= 2) {
                      EXPECT_GT(n.failed, 0.9 * n.facets);
                    }
                  });
}

TEST(RadiusOfFillets, those_of_4_4_mm_and_more_never_fail_r4) {
  for_each_fillet(marked, {4.4, 5, 6, 8, 12}, {30, 45, 60, 90, 180},
                  [](const Fillet& f, int, const Meshed& meshed, const Field& field) {
                    EXPECT_EQ(judged(meshed, field, Part::rounding, f.radius).failed, 0);
                    EXPECT_EQ(judged(meshed, field, Part::plane, f.radius).failed, 0);
                  });
}

TEST(RadiusOfFillets, those_of_4_4_mm_and_more_pass_r4_with_their_planes) {
  int facets = 0;
  int passed = 0;
  for_each_fillet(marked, {4.4, 5, 6}, {45, 90},
                  [&](const Fillet& f, int strips, const Meshed& meshed, const Field& field) {
                    if (strips < 2) return;
                    for (const Part part : {Part::rounding, Part::plane}) {
                      const Count n = judged(meshed, field, part, f.radius);
                      facets += n.facets;
                      passed += n.passed;
                      if (f.meshing <= Meshing::long_strips) {
                        EXPECT_EQ(n.passed, n.facets);
                      }
                    }
                  });
  EXPECT_GT(passed, 0.995 * facets);
}

TEST(RadiusOfFillets, what_lies_between_3_6_and_4_4_mm_is_never_wrong) {
  for_each_fillet(marked, {3.8, 3.9, 4.1, 4.2}, {90},
                  [](const Fillet& f, int, const Meshed& meshed, const Field& field) {
                    const Count n = judged(meshed, field, Part::rounding, f.radius);
                    EXPECT_EQ(f.radius < limit ? n.passed : n.failed, 0);
                  });
}

TEST(RadiusOfFillets, a_single_strip_is_undecided_as_a_chamfer_would_be) {
  const Meshed meshed = fillets::mesh({.radius = 5, .angle = 20 * degree, .step = 3});
  const Field field = measured(meshed);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (meshed.part[i] != Part::rounding) continue;
    EXPECT_TRUE(std::isnan(field.value[i]));
    EXPECT_EQ(field.absence[i], Absence::too_little);
    EXPECT_EQ(field.lower[i], 0);
    EXPECT_GT(field.upper[i], 5);
  }
}

TEST(RadiusOfFillets, planes_stay_flat_up_to_the_rim) {
  const Meshed meshed = fillets::mesh({.radius = 2, .angle = 90 * degree, .step = 1});
  const Field field = measured(meshed);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (meshed.part[i] == Part::plane) {
      EXPECT_GT(field.lower[i], 1000);
    }
  }
}

}  // namespace
}  // namespace gabarit
