// Balls and rays between every kind of exact surface: all that an answer holds, the same bits on every
// device.
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gtest/gtest.h>

#include "checks/exact_ray_probe.h"
#include "gpu/device_error.h"
#include "tests/gpu/other_devices.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
void add(Bits& bits, const Vec3d& p) { add(bits, p.x), add(bits, p.y), add(bits, p.z); }

Bits bits_of(const std::vector<ExactWall>& walls) {
  Bits bits;
  for (const ExactWall& w : walls) {
    const ExactBall& b = w.ball;
    add(bits, w.value), add(bits, w.off), add(bits, w.at), add(bits, b.contact);
    add(bits, b.radius), add(bits, b.at.u), add(bits, b.at.v), add(bits, b.t), add(bits, b.residual);
    for (const auto number :
         {static_cast<std::uint32_t>(b.kind), b.face, b.edge, b.piece, static_cast<std::uint32_t>(b.steps),
          static_cast<std::uint32_t>(b.starts), b.verified ? 1U : 0U})
      bits.push_back(number);
  }
  return bits;
}

// A ring about z whose section is a smooth closed curve through points on an ellipse.
TopoDS_Shape ring_of_revolution() {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 8);
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi / 4 * i;
    points->SetValue(i + 1, gp_Pnt(12 + 3 * std::cos(angle), 0, 2 * std::sin(angle)));
  }
  GeomAPI_Interpolate section(points, Standard_True, 1e-7);
  section.Perform();
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section.Curve())).Wire();
  const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire).Face(), axis).Shape();
}

std::vector<step_shapes::NamedShape> every_kind() {
  using namespace step_shapes;
  const TopoDS_Shape plate = minus(box(30, 30, 4), moved(cylinder(6, 20), 15, 13, -5));
  return {{"plate with a hole", plate},
          {"drilled block", minus(box(12, 12, 20), moved(turned(cone(3, 5), 180), 6, 6, 20))},
          {"shell", minus(sphere(10), sphere(8))},
          {"torus", torus(20, 5)},
          {"elliptic cylinder", elliptic_cylinder(8, 5, 12)},
          {"lobed cylinder", lobed_cylinder({8, 9, 7.5, 9, 8, 9.5}, 10)},
          {"ring of revolution", ring_of_revolution()},
          {"rounded box of splines", as_splines(rounded_box(20, 15, 10, 3))},
          {"turned rounded box", turned(rounded_box(20, 15, 10, 3), 33)}};
}

class ExactDevices : public step_shapes::StepFiles {
 protected:
  static Model model_of(const std::filesystem::path& file) {
    LoadOptions options;
    options.sag = 0.3;
    return step_shapes::loaded(file, options);
  }
};

std::vector<FacetPlace> places_on(const Model& model, std::size_t count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> weight(0, 1);
  std::vector<FacetPlace> places;
  for (std::size_t i = 0; i < count; ++i) {
    double v = weight(random), w = weight(random);
    if (v + w > 1) v = 1 - v, w = 1 - w;
    places.push_back({static_cast<FacetId>(i * model.mesh.facet_count() / count), {v, w}});
  }
  return places;
}

// From both sides, without a separation angle and with two; and by cones of rays.
Bits everything(const Model& model, const Device& device, std::span<const FacetPlace> places) {
  const Scene scene(model, device);
  Bits bits;
  for (const Side side : {Side::inside, Side::outside}) {
    const ContactSurface& surface = scene.surface({.side = side, .sag = *model.sag});
    std::vector<std::vector<ExactWall>> found;
    for (const double degrees : {0, 20, 120}) {
      const ExactWallOptions options{.side = side, .separation = degrees * std::numbers::pi / 180};
      found.push_back(ExactWalls(scene, surface, options).measure(places));
    }
    const RayOptions cone{.side = side, .cone = 0.4, .rays = 5};
    found.push_back(ExactRayWalls(scene, surface, cone).measure(places));
    for (const std::vector<ExactWall>& walls : found) {
      const Bits more = bits_of(walls);
      bits.insert(bits.end(), more.begin(), more.end());
    }
  }
  return bits;
}

TEST_F(ExactDevices, balls_and_rays_on_every_kind_of_surface_have_the_same_bits) {
  std::set<SurfaceKind> kinds;
  for (const auto& [name, shape] : every_kind()) {
    const Model model = model_of(step(shape));
    for (const Face& face : model.brep->faces) kinds.insert(model.brep->surfaces[face.surface].kind);
    const std::vector<FacetPlace> places = places_on(model, 60);
    const Bits expected = everything(model, plain_cpu, places);
    for (const auto& [where, device] : other_devices())
      EXPECT_TRUE(everything(model, device, places) == expected) << name << " on " << where;
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(surface_kinds));
}

// As much is left as some dozens of queries take.
void leave_little(MemoryLimit& limit) {
  constexpr std::size_t little = 20'000;
  for (std::size_t part = std::size_t{1} << 29; part > 64; part /= 2)
    if (limit.take(part + little)) limit.give_back(little);
}

TEST_F(ExactDevices, queries_that_do_not_fit_at_once_are_answered_in_batches_with_the_same_bits) {
  const Model model = model_of(step(step_shapes::rounded_box(20, 15, 10, 3)));
  const std::vector<FacetPlace> places = places_on(model, 1000);
  const auto measured = [&](const Scene& scene, bool by_rays) {
    const ContactSurface& surface = scene.surface({.side = Side::inside, .sag = *model.sag});
    return bits_of(by_rays ? ExactRayWalls(scene, surface, {}).measure(places)
                           : ExactWalls(scene, surface, {}).measure(places));
  };
  const Scene here(model, plain_cpu);
  MemoryLimit limit(std::size_t{1} << 30);
  const Scene scene(model, Device::simulated(1, &limit));
  for (const bool by_rays : {false, true}) measured(scene, by_rays);  // now all that is shared is there
  leave_little(limit);
  for (const bool by_rays : {false, true})
    EXPECT_TRUE(measured(scene, by_rays) == measured(here, by_rays)) << by_rays;
  while (limit.take(1)) {
  }
  EXPECT_THROW(measured(scene, false), OutOfDeviceMemory);
}

TEST_F(ExactDevices, what_lies_on_the_device_lies_there_and_has_to_fit) {
  const Model model = model_of(step(step_shapes::torus(20, 5)));
  const Scene scene(model, Device::simulated(1));
  EXPECT_TRUE(scene.exact_surface(Side::inside).tree.device().has_own_memory());
  EXPECT_NE(scene.exact_model().view().brep.faces.data, model.brep->faces.data());
  EXPECT_EQ(&scene.exact_model(), scene.exact_surface(Side::outside).exact);
  MemoryLimit limit(1000);
  const Scene small(model, Device::simulated(1, &limit));
  EXPECT_THROW(small.exact_surface(Side::inside), OutOfDeviceMemory);
}

// The same places in another order of their faces: each face's own follow each other as before.
TEST_F(ExactDevices, answers_come_back_in_the_order_of_the_caller_whatever_the_order_of_faces) {
  const Model model = model_of(step(step_shapes::rounded_box(20, 15, 10, 3)));
  const std::vector<FacetPlace> places = places_on(model, 500);
  std::vector<std::size_t> order(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return model.brep->facets[places[a].facet].face > model.brep->facets[places[b].facet].face;
  });
  std::vector<FacetPlace> shuffled;
  shuffled.reserve(order.size());
  for (const std::size_t i : order) shuffled.push_back(places[i]);
  const Scene scene(model, Device::cpu(1));
  const ContactSurface& surface = scene.surface({.side = Side::inside, .sag = *model.sag});
  const ExactWalls walls(scene, surface, {});
  const std::vector<ExactWall> expected = walls.measure(places), found = walls.measure(shuffled);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(found[i].value, expected[order[i]].value);
    EXPECT_EQ(found[i].at, expected[order[i]].at);
  }
}

}  // namespace
}  // namespace gabarit
