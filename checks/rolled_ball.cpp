#include "checks/rolled_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "checks/span_cuts.h"
#include "gpu/parallel_for.h"
#include "model/brep_curvature.h"
#include "model/brep_view.h"

namespace gabarit {
namespace {

constexpr double same = 1e-12;              // of the size of the face
constexpr double same_curvature = 1e-6;     // of the curvature, at single places: what is worth a closer look
constexpr std::size_t most_places = 20000;  // of one face

// A ball of this radius rolled along a circle, or standing still (no ring), or along a line (an axis only).
struct RolledBall {
  enum class Along { point, line, circle } along = Along::point;
  Vec3d centre, axis;
  double radius = 0, ring = 0;

  // Of a point from the surface.
  double distance(const Vec3d& p) const {
    const Vec3d q = p - centre;
    if (along == Along::point) return std::fabs(length(q) - radius);
    const double high = dot(q, axis), wide = length(q - axis * high);
    if (along == Along::line) return std::fabs(wide - radius);
    return std::fabs(std::hypot(wide - ring, high) - radius);
  }
};

struct Sample {
  Vec3d p, centre;  // of the ball that touches there from inside
};

class FaceOnBall {
 public:
  FaceOnBall(const BrepView& brep, const Face& face)
      : brep_(brep), face_(face), surface_(brep.surfaces[face.surface]), r_(face.range) {}

  double curvature() {
    const std::optional<RolledBall> ball = candidate();
    return ball && lies_on(*ball) ? 1 / ball->radius : 0;
  }

 private:
  // Nothing where the curvature is not the wanted one; the first place says which that is.
  std::optional<Sample> sample(double u, double v) {
    const SurfacePoint s =
        face_point(brep_, face_, {r_.u0 + u * (r_.u1 - r_.u0), r_.v0 + v * (r_.v1 - r_.v0)});
    const Vec3d n = outward_normal(s, face_.sign);
    const double k = principal_curvatures(s, face_.sign).greatest;
    if (n == Vec3d{} || !(k > 1e-9)) return std::nullopt;
    if (curvature_ == 0) curvature_ = k;
    if (!(std::fabs(k - curvature_) <= same_curvature * curvature_)) return std::nullopt;
    return Sample{s.p, s.p - n / curvature_};
  }

  std::optional<RolledBall> candidate() {
    std::array<Sample, 9> samples;
    double size = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::size_t row = i / 3, column = i % 3;
      const auto s =
          sample(0.11 + 0.37 * static_cast<double>(column), 0.13 + 0.36 * static_cast<double>(row));
      if (!s) return std::nullopt;
      samples[i] = *s;
      size = std::max(size, length(s->p - samples[0].p));
    }
    size_ = size + 1 / curvature_;
    RolledBall ball;
    ball.centre = samples[0].centre, ball.radius = 1 / curvature_;
    const auto farther = [&](const Sample& a, const Sample& b) {
      return length(a.centre - ball.centre) < length(b.centre - ball.centre);
    };
    const Vec3d far = std::max_element(samples.begin(), samples.end(), farther)->centre - ball.centre;
    const double reach = length(far);
    if (reach <= 1e-7 * size_) return ball;
    ball.axis = far / reach;
    // The one farthest from the line through these two.
    Vec3d third;
    double bow = 0;
    for (const Sample& s : samples) {
      const Vec3d q = s.centre - ball.centre, beside = q - ball.axis * dot(q, ball.axis);
      if (length(beside) > bow) bow = length(beside), third = q;
    }
    if (bow <= 1e-7 * size_) return ball.along = RolledBall::Along::line, ball;
    // The circle through the three.
    const Vec3d normal = cross(far, third);
    const double area = squared_length(normal);
    const Vec3d to_centre = cross(normal, far) * (squared_length(third) / (2 * area)) +
                            cross(third, normal) * (reach * reach / (2 * area));
    ball.along = RolledBall::Along::circle;
    ball.centre += to_centre, ball.ring = length(to_centre), ball.axis = normal / std::sqrt(area);
    return ball;
  }

  bool lies_on(const RolledBall& ball) const {
    if (!turns_with(ball)) return false;
    const std::vector<double> u = places(0), v = places(1);
    if (u.empty() || v.empty() || u.size() > most_places / v.size()) return false;
    for (const double a : u) {
      for (const double b : v) {
        if (!(ball.distance(face_point(brep_, face_, {a, b}).p) <= same * size_)) return false;
      }
    }
    return true;
  }

  // A revolution keeps to the shape when both have the same axis and its curve keeps to it.
  bool turns_with(const RolledBall& ball) const {
    if (surface_.kind != SurfaceKind::revolution) return true;
    const Vec3d z = surface_.axes.z, q = ball.centre - surface_.axes.origin;
    const bool parallel = ball.along == RolledBall::Along::point || length(cross(ball.axis, z)) <= same;
    return parallel && length(cross(q, z)) <= same * size_;
  }

  // Chebyshev points of every span.
  std::vector<double> places(int along) const {
    const std::vector<double> cuts = along == 0 ? span_cuts(brep_, surface_, 0, r_.u0, r_.u1)
                                                : span_cuts(brep_, surface_, 1, r_.v0, r_.v1);
    const int n = 4 * degree(along);
    std::vector<double> t;
    if (cuts.size() * static_cast<std::size_t>(n + 1) > most_places) return t;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      for (int k = 0; k <= n; ++k) {
        const double x = std::cos((k + 0.5) / (n + 1) * std::numbers::pi);
        t.push_back(cuts[i] + (cuts[i + 1] - cuts[i]) * (1 + x) / 2);
      }
    }
    return t;
  }

  int degree(int along) const {
    if (surface_.kind == SurfaceKind::spline) return along == 0 ? surface_.u_degree : surface_.v_degree;
    const Curve& c = brep_.curves[surface_.curve];
    return along == (surface_.kind == SurfaceKind::extrusion ? 1 : 0) ? 1 : c.degree;
  }

  const BrepView& brep_;
  const Face& face_;
  const Surface& surface_;
  const ParameterBox& r_;
  double curvature_ = 0, size_ = 0;
};

bool of_splines(const Brep& brep, const Surface& s) {
  const bool swept = s.kind == SurfaceKind::extrusion || s.kind == SurfaceKind::revolution;
  return s.kind == SurfaceKind::spline || (swept && brep.curves[s.curve].kind == CurveKind::spline);
}

}  // namespace

std::vector<double> rolled_balls(const Brep& brep, const Device& device) {
  std::vector<double> found(brep.faces.size(), 0);
  const BrepView arrays = view(brep);
  const auto kernel = [&](std::int64_t i) {
    const Face& face = brep.faces[static_cast<std::size_t>(i)];
    if (of_splines(brep, brep.surfaces[face.surface]))
      found[static_cast<std::size_t>(i)] = FaceOnBall(arrays, face).curvature();
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(found.size()), kernel, 4);
  return found;
}

}  // namespace gabarit
