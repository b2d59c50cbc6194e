// Needs nothing but a compiler: the tree against brute force, every set of vector instructions and every CUDA
// device against the portable code, bit for bit, and a table of times, each the median of RUNS. Ends with 1
// and a sentence for each thing that is wrong. Usage: gpu_self_test [FACETS [RUNS]]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "gpu/bumpy_ball.h"
#include "gpu/closest_point.h"
#include "gpu/maximal_sphere.h"
#include "gpu/maximal_sphere_kernel.h"
#include "gpu/query_trials.h"
#include "gpu/ray_cast.h"
#include "gpu/triangle.h"

namespace gabarit {
namespace {

int failures = 0;

void expect(bool good, const std::string& sentence) {
  if (good) return;
  ++failures;
  std::printf("FAILED: %s\n", sentence.c_str());
}

// Field by field: padding may hold anything.
bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(const SphereContact& a, const SphereContact& b) {
  return same_bits(a.radius, b.radius) && same_bits(a.lower, b.lower) && same_bits(a.upper, b.upper) &&
         a.contact == b.contact && a.primitive == b.primitive;
}
bool same(const RayHit& a, const RayHit& b) {
  return same_bits(a.distance, b.distance) && a.facet == b.facet && same_bits(a.facing, b.facing);
}
bool same(const ClosestPoint& a, const ClosestPoint& b) {
  return same_bits(a.distance, b.distance) && a.point == b.point && a.facet == b.facet;
}

struct Answers {
  std::vector<SphereContact> spheres;
  std::vector<RayHit> hits;
  std::vector<ClosestPoint> closest;
};

bool same(const Answers& a, const Answers& b) {
  const auto all = [](const auto& x, const auto& y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!same(x[i], y[i])) return false;
    }
    return x.size() == y.size();
  };
  return all(a.spheres, b.spheres) && all(a.hits, b.hits) && all(a.closest, b.closest);
}

const SphereOptions opposite_walls{.cos_separation = std::cos(2 * std::numbers::pi / 3),
                                   .contact_floor = 1e-6};

Vec3d centroid(const FacetSurface& s, const Primitive& p) {
  return (s.points[p.corner[0]] + s.points[p.corner[1]] + s.points[p.corner[2]]) / 3.0;
}
Vec3d inwards(const Primitive& p) {
  return normalized(Vec3d{-static_cast<double>(p.normal.x), -static_cast<double>(p.normal.y),
                          -static_cast<double>(p.normal.z)});
}

std::vector<SphereQuery> queries_of(const FacetSurface& s) {
  std::vector<SphereQuery> queries;
  for (const Primitive& p : s.primitives) queries.push_back({centroid(s, p), inwards(p), p.id, 0, 0, 0});
  return queries;
}

Answers ask(const Device& device, const FacetSurface& surface) {
  const Bvh tree(device, surface);
  const std::vector<SphereQuery> queries = queries_of(surface);
  std::vector<Ray> rays;
  std::vector<Vec3d> points;
  for (const SphereQuery& q : queries) {
    rays.push_back({q.point, q.direction, q.own, 1e-6});
    points.push_back(q.point + 0.37 * q.direction);
  }
  Answers answers{std::vector<SphereContact>(queries.size()), std::vector<RayHit>(queries.size()),
                  std::vector<ClosestPoint>(queries.size())};
  maximal_spheres(tree, opposite_walls, queries, answers.spheres);
  cast_rays(tree, rays, answers.hits);
  closest_points(tree, points, answers.closest);
  return answers;
}

double brute_force_radius(const FacetSurface& s, const SphereQuery& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const Primitive& p : s.primitives) {
    const Vec3d n{static_cast<double>(p.normal.x), static_cast<double>(p.normal.y),
                  static_cast<double>(p.normal.z)};
    if (p.id == q.own || dot(n, q.direction) < -opposite_walls.cos_separation - 1e-6) continue;
    const TangentBall ball =
        ball_through_triangle(q.direction, s.points[p.corner[0]] - q.point, s.points[p.corner[1]] - q.point,
                              s.points[p.corner[2]] - q.point, std::numeric_limits<double>::infinity());
    least = std::min(least, ball.radius);
  }
  return least;
}

double brute_force_distance(const FacetSurface& s, const Vec3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Primitive& p : s.primitives)
    least = std::min(least, length(point - closest_point(point, s.points[p.corner[0]], s.points[p.corner[1]],
                                                         s.points[p.corner[2]])));
  return least;
}

void the_tree_finds_what_brute_force_finds(const FacetSurface& surface) {
  const Answers answers = ask(Device::cpu(1), surface);
  const std::vector<SphereQuery> queries = queries_of(surface);
  for (std::size_t i = 0; i < queries.size(); i += 7) {
    const double truth = brute_force_radius(surface, queries[i]);
    const SphereContact& found = answers.spheres[i];
    expect(found.radius >= truth && found.lower <= truth && truth <= found.upper &&
               found.radius <= truth * 1.011,
           "ball " + std::to_string(i) + " has radius " + std::to_string(found.radius) + ", not " +
               std::to_string(truth));
    const double distance = brute_force_distance(surface, queries[i].point + 0.37 * queries[i].direction);
    expect(std::fabs(answers.closest[i].distance - distance) <= 1e-12, "closest point " + std::to_string(i));
  }
}

void every_device_gives_the_same_bits(const FacetSurface& surface) {
  Device portable = Device::cpu(1);
  portable.vectors = VectorSet::portable;
  const Answers reference = ask(portable, surface);
  for (const VectorSet set : {VectorSet::avx2, VectorSet::avx512}) {
    Device device = Device::cpu(3);
    device.vectors = set;
    expect(same(ask(device, surface), reference), "vector set " + std::to_string(static_cast<int>(set)));
  }
  const auto devices = cuda_devices();
  for (std::size_t i = 0; i < devices.size(); ++i) {
    expect(same(ask(Device::cuda(static_cast<int>(i)), surface), reference), "CUDA device " + devices[i]);
  }
  expect(same(ask(Device::simulated(2), surface), reference), "the simulated device");
}

// Each kind of work of the table below; a bare machine with a GPU has no other tests.
void every_kind_of_work_gives_the_same_bits(const FacetSurface& surface) {
  std::vector<Device> others{Device::cpu(2), Device::simulated(2)};
  for (std::size_t i = 0; i < cuda_devices().size(); ++i) others.push_back(Device::cuda(static_cast<int>(i)));
  for (const QueryTrial& trial : query_trials()) {
    const auto bits_on = [&](const Device& device) {
      const PreparedTrial prepared = trial.prepare(device, surface);
      prepared.run();
      return prepared.bits();
    };
    const std::vector<std::uint64_t> expected = bits_on({.threads = 1, .vectors = VectorSet::portable});
    for (const Device& device : others)
      expect(bits_on(device) == expected,
             std::string(trial.name) + " on device of kind " + std::to_string(static_cast<int>(device.kind)));
  }
}

// The median of so many runs after one that warms up, in milliseconds.
double milliseconds(const PreparedTrial& trial, int runs) {
  trial.run();
  std::vector<double> all;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    trial.run();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    all.push_back(took.count());
  }
  std::nth_element(all.begin(), all.begin() + runs / 2, all.end());
  return all[static_cast<std::size_t>(runs / 2)];
}

void print_row(const QueryTrial& trial, const FacetSurface& surface, int runs, bool with_cuda) {
  const PreparedTrial here = trial.prepare(Device::cpu(), surface);
  const double on_cpu = milliseconds(here, runs);
  std::printf("%-20s %9zu %10.2f", trial.name, surface.primitives.size(), on_cpu);
  if (!with_cuda) {
    std::printf(" %10s %8s %s\n", "-", "-", "-");
    return;
  }
  const PreparedTrial there = trial.prepare(Device::cuda(), surface);
  const double on_cuda = milliseconds(there, runs);
  const bool equal = here.bits() == there.bits();
  std::printf(" %10.2f %8.1f %s\n", on_cuda, on_cpu / on_cuda, equal ? "yes" : "NO");
  expect(equal, std::string(trial.name) + " on CUDA and on the CPU");
}

void print_table(const FacetSurface& surface, int runs) {
  const auto devices = cuda_devices();
  if (devices.empty())
    std::printf("No CUDA device can be used here: its columns are empty.\n");
  else
    std::printf("CUDA: %s. Times with the copies to and from the device.\n", devices.front().c_str());
  std::printf("%-20s %9s %10s %10s %8s %s\n", "query", "facets", "CPU ms", "CUDA ms", "ratio", "bits equal");
  for (const QueryTrial& trial : query_trials()) print_row(trial, surface, runs, !devices.empty());
}

void an_empty_surface_has_no_contacts() {
  const Bvh tree(Device::cpu(1), FacetSurface{});
  const SphereQuery query{{0, 0, 0}, {0, 0, 1}, no_child, 0, 0, 0};
  SphereContact contact;
  maximal_spheres(tree, opposite_walls, {&query, 1}, {&contact, 1});
  expect(contact.primitive == SphereContact::none, "an empty surface has a contact");
}

void test_all(double facets, int runs) {
  for (const FacetSurface& surface : {bumpy_ball(30, 40, 10, 0.2), bumpy_ball(24, 40, 10, 0),
                                      bumpy_ball(12, 16, 0.5, 0.1, {9000, -4000, 250})}) {
    the_tree_finds_what_brute_force_finds(surface);
    every_device_gives_the_same_bits(surface);
    every_kind_of_work_gives_the_same_bits(surface);
  }
  an_empty_surface_has_no_contacts();
  const int side = static_cast<int>(std::sqrt(facets / 2));
  print_table(bumpy_ball(side, side, 10, 0.2), runs);
}

}  // namespace
}  // namespace gabarit

int main(int argc, char** argv) {
  using namespace gabarit;
  const double facets = argc > 1 ? std::atof(argv[1]) : 20'000;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
  if (!(facets >= 32 && facets <= 1e8 && runs >= 1 && runs <= 100'000))
    return std::printf("usage: gpu_self_test [FACETS [RUNS]]\n"), 2;
  try {
    test_all(facets, runs);
  } catch (const std::exception& error) {
    expect(false, error.what());
  }
  std::printf(failures == 0 ? "all good\n" : "%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
