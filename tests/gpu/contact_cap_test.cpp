#include "gpu/contact_cap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Of a vertex, or of an edge along `along`.
ContactCap cap(const std::vector<Vec3d>& fan, const Vec3d& along = {}) {
  FacetSurface surface;
  surface.points = {{1, 2, 3}, Vec3d{1, 2, 3} + along};
  const std::uint32_t end = along == Vec3d{} ? 0 : 1;
  surface.primitives.push_back({{0, end, 0}, 7, {}, 0});
  for (const Vec3d& w : fan) surface.fan_directions.push_back(to_float(w));
  surface.fan_first.push_back(static_cast<std::uint32_t>(fan.size()));
  return contact_caps(Device::cpu(1), surface).front();
}

// The directions in which two walls leave an edge along z that bends by `bend` about +x.
std::vector<Vec3d> walls(double bend) {
  const double x = std::sin(bend / 2), y = std::cos(bend / 2);
  return {{x, y, 0}, {x, -y, 0}};
}
double angle_of(const ContactCap& cap) { return std::acos(static_cast<double>(cap.cosine)) / degree; }

TEST(ContactCap, of_an_edge_is_as_wide_as_its_bend_and_twice_that_where_it_is_fine) {
  for (const double bend : {90.0, 150.0}) {
    const ContactCap found = cap(walls(bend * degree), {0, 0, 2});
    EXPECT_NEAR(angle_of(found), bend / 2, 0.1) << bend;
    EXPECT_GE(angle_of(found), bend / 2);
    EXPECT_NEAR(static_cast<double>(found.axis.x), 1, 1e-6);
  }
  for (const double bend : {10.0, 40.0})
    EXPECT_NEAR(angle_of(cap(walls(bend * degree), {0, 0, 2})), bend, 0.1);
}

TEST(ContactCap, of_the_corner_of_a_room_is_an_octant) {
  const ContactCap found = cap({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_NEAR(static_cast<double>(found.cosine), std::sqrt(1.0 / 3), 2e-3);
  EXPECT_LE(static_cast<double>(found.cosine), std::sqrt(1.0 / 3));
  EXPECT_NEAR(static_cast<double>(found.axis.x), std::sqrt(1.0 / 3), 1e-4);
}

TEST(ContactCap, of_a_saddle_of_a_flat_vertex_and_of_nothing_is_unknown) {
  const auto unknown = [](const std::vector<Vec3d>& fan) { return cap(fan).cosine == -1; };
  const double up = std::sin(0.3), along = std::cos(0.3);
  EXPECT_TRUE(unknown({{along, 0, up}, {-along, 0, up}, {0, along, -up}, {0, -along, -up}}));
  EXPECT_TRUE(unknown({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}));
  EXPECT_TRUE(unknown(walls(0.5)));  // two directions leave a vertex free along the edge
  FacetSurface none;
  none.points = {{0, 0, 0}};
  none.primitives.push_back({{0, 0, 0}, 0, {}, 0});
  none.fan_first.push_back(0);
  EXPECT_TRUE(contact_caps(Device::cpu(1), none).empty());
}

TEST(ContactCap, of_a_fan_that_two_edges_share_is_unknown) {
  FacetSurface surface;
  surface.points = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  surface.primitives = {{{0, 1, 0}, 0, {}, 0}, {{0, 2, 0}, 1, {}, 0}};
  for (const Vec3d& w : walls(1)) surface.fan_directions.push_back(to_float(w));
  surface.fan_first.push_back(2);
  EXPECT_EQ(contact_caps(Device::cpu(1), surface).front().cosine, -1);
  surface.primitives.pop_back();
  EXPECT_GT(contact_caps(Device::cpu(1), surface).front().cosine, 0);
}

// Directions from the tip of a cone into its mantle, each turned by up to half its bend.
std::vector<Vec3d> dented_tip(std::mt19937& random, double bend) {
  std::uniform_real_distribution<double> any(0, 1);
  const int count = 3 + static_cast<int>(any(random) * 9);
  std::vector<Vec3d> fan;
  for (int i = 0; i < count; ++i) {
    const double at = 2 * std::numbers::pi * (i + 0.4 * any(random)) / count, rise = bend * any(random);
    fan.push_back({std::cos(at) * std::cos(rise), std::sin(at) * std::cos(rise), std::sin(rise)});
  }
  return fan;
}

TEST(ContactCap, holds_every_direction_on_the_positive_side_of_a_fan) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  int known = 0, tried = 0, held = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<Vec3d> fan = dented_tip(random, 0.05 + 0.004 * round);
    const ContactCap found = cap(fan);
    known += found.cosine > 0 ? 1 : 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3d u = normalized(Vec3d{0.5 * any(random), 0.5 * any(random), 0.2 + std::fabs(any(random))});
      bool positive = true;
      for (const Vec3d& w : fan) positive = positive && dot(w, u) >= -fan_tolerance;
      if (!positive) continue;
      ++tried;
      held += dot(u, to_double(found.axis)) >= static_cast<double>(found.cosine) ? 1 : 0;
    }
  }
  EXPECT_EQ(held, tried);
  EXPECT_GT(tried, 10000);
  EXPECT_GT(known, 100);
}

Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle) {
  return shapes::rotated({{v, v, v}}, axis, angle)[0][0];
}

TEST(ContactCap, turns_with_the_fan_and_does_not_depend_on_its_order) {
  std::mt19937 random(9);
  const Vec3d axis = normalized(Vec3d{1, 2, -3});
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3d> fan = dented_tip(random, 0.6);
    const ContactCap before = cap(fan);
    const Vec3d mean = turned(to_double(before.axis), axis, 1.1);
    for (Vec3d& w : fan) w = turned(w, axis, 1.1);
    std::shuffle(fan.begin(), fan.end(), random);
    const ContactCap after = cap(fan);
    EXPECT_NEAR(static_cast<double>(before.cosine), static_cast<double>(after.cosine), 1e-3);
    EXPECT_GT(before.cosine, 0);
    EXPECT_GT(dot(mean, to_double(after.axis)), 1 - 1e-5);
  }
}

}  // namespace
}  // namespace gabarit
