#include "tests/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <tuple>

namespace gabarit::shapes {

static void add_quad(Triangles& out, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

Triangles box(const Vec3d& min, const Vec3d& max) {
  return gridded_box(min, max, std::max({max.x - min.x, max.y - min.y, max.z - min.z}));
}

Triangles gridded_box(const Vec3d& min, const Vec3d& max, double step) {
  Triangles out;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto steps = [&](int a) {
      return std::max(1, static_cast<int>(std::ceil((max[a] - min[a]) / step - 1e-9)));
    };
    const int nu = steps(u);
    const int nv = steps(v);
    const auto at = [&](double side, int i, int j) {
      Vec3d p;
      p[axis] = side;
      p[u] = i == nu ? max[u] : min[u] + (max[u] - min[u]) * i / nu;
      p[v] = j == nv ? max[v] : min[v] + (max[v] - min[v]) * j / nv;
      return p;
    };
    for (int i = 0; i < nu; ++i) {
      for (int j = 0; j < nv; ++j) {
        add_quad(out, at(max[axis], i, j), at(max[axis], i + 1, j), at(max[axis], i + 1, j + 1),
                 at(max[axis], i, j + 1));
        add_quad(out, at(min[axis], i, j), at(min[axis], i, j + 1), at(min[axis], i + 1, j + 1),
                 at(min[axis], i + 1, j));
      }
    }
  }
  return out;
}

Triangles extrude(const std::vector<Point2>& polygon, double bottom, double top, int layers) {
  Triangles out;
  const std::size_t n = polygon.size();
  const auto at = [&](std::size_t i, double z) { return Vec3d{polygon[i % n].x, polygon[i % n].y, z}; };
  const auto height = [&](int k) { return k == layers ? top : bottom + (top - bottom) * k / layers; };
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < layers; ++k) {
      add_quad(out, at(i, height(k)), at(i + 1, height(k)), at(i + 1, height(k + 1)), at(i, height(k + 1)));
    }
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    out.push_back({at(0, top), at(i, top), at(i + 1, top)});
    out.push_back({at(0, bottom), at(i + 1, bottom), at(i, bottom)});
  }
  return out;
}

Triangles revolve(const std::vector<Point2>& profile, int segments) {
  Triangles out;
  const auto at = [&](std::size_t i, int k) {
    const double angle = 2.0 * std::numbers::pi * (k % segments) / segments;
    const double r = profile[i].x;
    return r == 0.0 ? Vec3d{0, 0, profile[i].y}
                    : Vec3d{r * std::cos(angle), r * std::sin(angle), profile[i].y};
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    for (int k = 0; k < segments; ++k) {
      const Vec3d a = at(i, k);
      const Vec3d b = at(i, k + 1);
      const Vec3d c = at(i + 1, k + 1);
      const Vec3d d = at(i + 1, k);
      if (profile[i].x != 0.0) out.push_back({a, b, c});
      if (profile[i + 1].x != 0.0) out.push_back({a, c, d});
    }
  }
  return out;
}

std::vector<Point2> arc(Point2 centre, double radius, double from, double to, int steps) {
  std::vector<Point2> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

Triangles sphere(double radius, int rings, int segments) {
  auto profile = arc({0, 0}, radius, -std::numbers::pi / 2, std::numbers::pi / 2, rings);
  profile.front().x = profile.back().x = 0.0;
  return revolve(profile, segments);
}

Triangles torus(double ring_radius, double tube_radius, int ring_segments, int tube_segments) {
  auto profile = arc({ring_radius, 0}, tube_radius, -std::numbers::pi, std::numbers::pi, tube_segments);
  profile.back() = profile.front();
  return revolve(profile, ring_segments);
}

Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <class F>
static Triangles mapped(Triangles triangles, F&& f) {
  for (Triangle& t : triangles) {
    for (Vec3d& p : t) p = f(p);
  }
  return triangles;
}

Triangles moved(Triangles triangles, const Vec3d& by) {
  return mapped(std::move(triangles), [&](const Vec3d& p) { return p + by; });
}

Triangles rotated(Triangles triangles, const Vec3d& axis, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return mapped(std::move(triangles),
                [&](const Vec3d& p) { return p * c + cross(axis, p) * s + axis * (dot(axis, p) * (1 - c)); });
}

Triangles flipped(Triangles triangles) {
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

Triangles permuted(const Triangles& triangles, std::uint32_t seed, std::vector<std::uint32_t>* order) {
  std::vector<std::uint32_t> places(triangles.size());
  std::iota(places.begin(), places.end(), 0U);
  std::mt19937 random(seed);
  std::shuffle(places.begin(), places.end(), random);
  Triangles out;
  for (const std::uint32_t i : places) {
    Triangle t = triangles[i];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    out.push_back(t);
  }
  if (order != nullptr) *order = places;
  return out;
}

Triangles rounded_to_float(Triangles triangles) {
  return mapped(std::move(triangles), [](const Vec3d& p) {
    return Vec3d{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  });
}

TriangleMesh mesh(const Triangles& triangles) {
  TriangleMesh mesh;
  std::map<std::tuple<double, double, double>, VertexId> known;
  for (const Triangle& t : triangles) {
    std::array<VertexId, 3> facet{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_finite(t[i])) {  // never equal to another
        facet[i] = static_cast<VertexId>(mesh.vertices.size());
        mesh.vertices.push_back(t[i]);
        continue;
      }
      const auto [place, fresh] = known.try_emplace({t[i].x + 0.0, t[i].y + 0.0, t[i].z + 0.0},
                                                    static_cast<VertexId>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back(t[i]);
      facet[i] = place->second;
    }
    mesh.facets.push_back(facet);
  }
  return mesh;
}

Model model(const Triangles& triangles, double sag) {
  Model model;
  model.file = "shape";
  model.format = "test shape";
  model.sha256 = std::string(64, '0');
  model.unit_declared = true;
  model.sag = sag;
  model.bodies = {"shape"};
  model.mesh = mesh(triangles);
  model.box = bounding_box(model.mesh);
  return model;
}

}  // namespace gabarit::shapes
