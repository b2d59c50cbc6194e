// Walls between exact surfaces: time a query, what stops the balls, residuals, memory by part, how many
// places are read too thick, and the mesh method on tessellations of several sags beside it.
// bench_brep_thickness [FILE.step ...]; without files it makes parts of its own.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <numbers>
#include <random>

#include <BRepAlgoAPI_Fuse.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <fmt/format.h>

#include "checks/exact_probe.h"
#include "gpu/maximal_sphere.h"
#include "gpu/tangent_ball.h"
#include "model/brep_foot.h"
#include "model/load.h"
#include "tests/dense_boundary.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

constexpr double separation = 120 * std::numbers::pi / 180;

// Of the processor: all runs on one thread.
double seconds_of(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Spread over the area, in the order of the tree, so that neighbours follow each other.
std::vector<FacetPlace> places_on(const TriangleMesh& mesh, const ContactSurface& surface,
                                  std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> weight(0, 1);
  double whole = 0;
  const auto area = [&](FacetId f) {
    const auto [a, b, c] = mesh.corners(f);
    return length(cross(b - a, c - a)) / 2;
  };
  for (FacetId f = 0; f < mesh.facet_count(); ++f) whole += area(f);
  std::vector<FacetPlace> places;
  double owed = 0;
  for (const std::uint32_t id : surface.tree.order()) {
    if (id >= mesh.facet_count()) continue;
    owed += area(id) / whole * static_cast<double>(count);
    for (; owed >= 1; owed -= 1) {
      double v = weight(random), w = weight(random);
      if (v + w > 1) v = 1 - v, w = 1 - w;
      places.push_back({id, {v, w}});
    }
  }
  return places;
}

// How many of every `step`-th place are beaten by a point of the boundary by more than 1e-4.
std::pair<std::size_t, std::size_t> beaten(const Model& model, const std::vector<FacetPlace>& places,
                                           const std::vector<ExactWall>& walls, double floor,
                                           std::size_t step) {
  const Brep& brep = *model.brep;
  const BrepView arrays = view(brep);
  const std::vector<BoundaryPoint> boundary =
      dense_boundary(brep, std::max<std::size_t>(200, 200'000 / brep.faces.size()));
  std::size_t count = 0, looked_at = 0;
  for (std::size_t i = 0; i < places.size(); i += step) {
    if (!walls[i].measured) continue;
    ++looked_at;
    const FacetOrigin& origin = brep.facets[places[i].facet];
    const auto [v, w] = places[i].weights;
    const Face& face = brep.faces[origin.face];
    const SurfacePoint s = face_point(arrays, face, parameters_at(origin, 1 - v - w, v, w));
    const Vec3d d = -outward_normal(s, face.sign);
    count += std::any_of(boundary.begin(), boundary.end(), [&](const BoundaryPoint& b) {
      return dot(b.normal, d) >= -std::cos(separation) && length(b.p - s.p) > floor &&
             2 * ball_through_point(d, b.p - s.p).radius < walls[i].value * (1 - 1e-4);
    });
  }
  return {count, looked_at};
}

// How many of all lie in each power of ten.
std::string spread(const std::vector<double>& of) {
  std::string text;
  for (int power = -16; power <= -6; power += 2) {
    const double low = power == -16 ? 0 : std::pow(10, power),
                 high = power == -6 ? 1e300 : std::pow(10, power + 2);
    const auto count = std::count_if(of.begin(), of.end(), [&](double x) { return x >= low && x < high; });
    const std::string range = power == -6 ? "from 1e-6" : fmt::format("under 1e{}", power + 2);
    text += fmt::format(" {} {:.2f} %,", range,
                        100 * static_cast<double>(count) / static_cast<double>(of.size()));
  }
  return text;
}

double quantile(std::vector<double> of, double share) {
  if (of.empty()) return 0;
  std::sort(of.begin(), of.end());
  return of[std::min(of.size() - 1, static_cast<std::size_t>(share * static_cast<double>(of.size())))];
}

template <class T>
std::size_t bytes(const std::vector<T>& of) {
  return of.size() * sizeof(T);
}

// Whatever the number of queries.
struct BytesByPart {
  std::size_t tree, pieces, patches, trimming;

  BytesByPart(const ExactSurface& exact, const Brep& brep)
      : tree(exact.tree.bytes()),
        pieces(exact.bytes() - exact.tree.bytes()),
        patches(bytes(brep.surfaces) + bytes(brep.curves) + bytes(brep.poles) + bytes(brep.knots)),
        trimming(bytes(brep.trims) + bytes(brep.trim_pieces) + bytes(brep.trim_bins) +
                 bytes(brep.trim_listing)) {}
};

void print_memory(const ExactSurface& exact, const Brep& brep) {
  const BytesByPart b(exact, brep);
  const auto row = [](const std::string& part, std::size_t patches, std::size_t curves, double tree,
                      double surfaces, double trimming) {
    fmt::print("  | {:28} | {:7} | {:6} | {:6.2f} | {:8.2f} | {:8.2f} |\n", part, patches, curves, tree,
               surfaces, trimming);
  };
  constexpr double mega = 1024 * 1024;
  fmt::print("  | memory, MB                   | patches | curves |   tree | surfaces | trimming |\n");
  row("here", brep.surfaces.size(), brep.trim_pieces.size(), static_cast<double>(b.tree + b.pieces) / mega,
      static_cast<double>(b.patches) / mega, static_cast<double>(b.trimming) / mega);
  row("Lemasson et al., Lens", 88581, 27793, 12.94, 23.50, 1.45);
  row("Lemasson et al., Mask", 27188, 12793, 5.38, 9.69, 0.69);
  row("Lemasson et al., Mask1", 12793, 4586, 0.43, 0.82, 0.25);
}

void report(const std::string& name, const Model& model) {
  const Scene scene(model, Device::cpu(1));
  const ContactSurface& surface = scene.surface({.side = Side::inside, .crease = 0.7, .sag = *model.sag});
  const ExactWalls walls(scene, surface, {.side = Side::inside, .separation = separation});
  const Brep& brep = *model.brep;
  fmt::print("\n{}: {} faces, {} facets at a sag of {:.3g} mm\n", name, brep.faces.size(),
             model.mesh.facet_count(), *model.sag);
  std::vector<ExactWall> found;
  std::vector<FacetPlace> places;
  for (const std::size_t count : {1000, 10'000, 100'000, 1'000'000}) {
    places = places_on(model.mesh, surface, count);
    const double time = seconds_of([&] { found = walls.measure(places); });
    fmt::print("  {:7} places: {:5.1f} us a query, {:.0f} queries/s\n", places.size(),
               1e6 * time / static_cast<double>(places.size()), static_cast<double>(places.size()) / time);
  }
  std::array<std::size_t, 6> kinds{};
  std::size_t measured = 0, unverified = 0;
  double steps = 0, starts = 0;
  std::vector<double> on_faces, on_edges;
  for (const ExactWall& w : found) {
    if (!w.measured) continue;
    ++measured, ++kinds[static_cast<std::size_t>(w.ball.kind)];
    unverified += w.ball.verified ? 0 : 1;
    steps += w.ball.steps, starts += w.ball.starts;
    if (w.ball.kind == BallContact::face) on_faces.push_back(w.ball.residual);
    if (w.ball.kind == BallContact::edge) on_edges.push_back(w.ball.residual);
  }
  const auto n = static_cast<double>(measured);
  fmt::print("  contacts:");
  for (std::size_t k = 0; k < kinds.size(); ++k)
    fmt::print(" {} {:.2f} %,", gabarit::name(static_cast<BallContact>(k)),
               100 * static_cast<double>(kinds[k]) / n);
  fmt::print(" {:.1f} starts and {:.1f} steps a query, {:.3f} % not verified\n", starts / n, steps / n,
             100 * static_cast<double>(unverified) / n);
  fmt::print("  residual, mm: faces median {:.1e}, 99 % {:.1e}:{}\n", quantile(on_faces, 0.5),
             quantile(on_faces, 0.99), spread(on_faces));
  fmt::print("                edges median {:.1e}, 99 % {:.1e}:{}\n", quantile(on_edges, 0.5),
             quantile(on_edges, 0.99), spread(on_edges));
  const ExactSurface& exact = scene.exact_surface(Side::inside);
  const auto [lost, looked_at] = beaten(model, places, found, 1e-6 * surface.size, places.size() / 1000);
  fmt::print("  beaten by a point of the boundary by more than 1e-4: {} of {}\n", lost, looked_at);
  print_memory(exact, brep);
}

// The mesh method at the middle of each facet, against the exact surfaces there.
void compare(const std::filesystem::path& file, double sag) {
  const Result<Model> loaded = load(file, {.sag = sag});
  if (!loaded) return;
  const Model& model = *loaded;
  const Scene scene(model, Device::cpu(1));
  const ContactSurface& surface = scene.surface({.side = Side::inside, .crease = 0.7, .sag = *model.sag});
  const ExactWalls walls(scene, surface, {.side = Side::inside, .separation = separation});
  std::vector<FacetPlace> places;
  std::vector<SphereQuery> queries;
  for (const std::uint32_t id : surface.tree.order()) {
    if (id >= model.mesh.facet_count()) continue;
    places.push_back({id, {1.0 / 3, 1.0 / 3}});
    const auto& n = surface.normals[id];
    Vec3d mean;
    for (const Vec3f& corner : n)
      mean +=
          Vec3d{static_cast<double>(corner.x), static_cast<double>(corner.y), static_cast<double>(corner.z)};
    queries.push_back({model.mesh.centroid(id), -normalized(mean), id, 0, 0, 0});
  }
  std::vector<ExactWall> exact;
  std::vector<SphereContact> mesh(queries.size());
  const double exact_time = seconds_of([&] { exact = walls.measure(places); });
  const double mesh_time = seconds_of([&] {
    maximal_spheres(surface.tree,
                    {.cos_separation = std::cos(separation), .contact_floor = 1e-6 * surface.size}, queries,
                    mesh);
  });
  std::vector<double> errors;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (exact[i].measured && std::isfinite(exact[i].value) && std::isfinite(mesh[i].radius))
      errors.push_back(std::abs(2 * mesh[i].radius - exact[i].value));
  }
  const auto n = static_cast<double>(places.size());
  fmt::print("  | {:5} | {:7} | {:6.2f} | {:6.2f} | {:.1e} | {:.1e} | {:.1e} |\n", sag, places.size(),
             1e6 * exact_time / n, 1e6 * mesh_time / n, quantile(errors, 0.5), quantile(errors, 0.95),
             quantile(errors, 1));
}

void run(const std::string& name, const std::filesystem::path& file) {
  const Result<Model> model = load(file);
  if (!model || !model->brep) return fmt::print("{}: not read\n", name);
  report(name, *model);
  fmt::print("  | sag asked for | facets | exact, us | mesh, us | mesh off: median, mm | 95 % | most |\n");
  for (const double sag : {0.1, 0.01, 0.001}) compare(file, sag);
}

TopoDS_Shape housing() {
  using namespace step_shapes;
  const TopoDS_Shape shell = minus(rounded_box(80, 60, 40, 6), moved(rounded_box(76, 56, 36, 4), 2, 2, 2));
  const TopoDS_Shape boss = moved(cylinder(5, 36), 20, 20, 2);
  return minus(BRepAlgoAPI_Fuse(shell, boss).Shape(), moved(cylinder(2.5, 60), 20, 20, -5));
}

void own_parts() {
  using namespace step_shapes;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "gabarit_bench_part.step";
  const std::vector<std::pair<std::string, TopoDS_Shape>> parts{
      {"shell 10/8", minus(sphere(10), sphere(8))},
      {"rounded box", rounded_box(40, 30, 20, 3)},
      {"tube with an offset bore", minus(cylinder(10, 60), moved(cylinder(6, 60), 2, 0, 0))},
      {"torus", torus(20, 5)},
      {"housing with a boss", housing()}};
  for (const auto& [name, shape] : parts) {
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(file.c_str());
    run(name, file);
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gabarit

int main(int count, char** files) {
  if (count < 2) gabarit::own_parts();
  for (int i = 1; i < count; ++i) gabarit::run(std::filesystem::path(files[i]).filename(), files[i]);
  return 0;
}
