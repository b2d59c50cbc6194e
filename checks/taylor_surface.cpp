#include "checks/taylor_surface.h"

#include <algorithm>

#include "model/brep_surface.h"

namespace gabarit {
namespace {

constexpr auto at(int k) { return static_cast<std::size_t>(k); }
constexpr int most_terms = highest_degree + 1;

double power_of(double base, int exponent) {
  double product = 1;
  for (int i = 0; i < exponent; ++i) product *= base;
  return product;
}

// The turn of a periodic parameter that a range lies in does not matter to the curve.
struct Range {
  double centre, half;
};
Range range(double low, double high, bool periodic, double first, double last) {
  const double centre = low + (high - low) / 2;
  // A hair wider, so that the ends stay inside whatever is rounded.
  const double half =
      std::max(high - centre, centre - low) * (1 + 1e-12) + 4 * unit_roundoff * std::fabs(centre);
  return {periodic ? wrapped(centre, first, last) : centre, half};
}

// The basis functions of one span as polynomials in x: value[i][k] x^k. The sizes of the coefficients of x^k
// of all functions together are at most binomial(degree, k) shrink^k grow, and so are those of what the
// recurrence adds up.
struct BasisPolynomials {
  int degree = 0, first = 0;    // the number of the pole that value[0] belongs to
  double shrink = 0, grow = 1;  // the box against the span; more than 1 beyond the ends of the knots
  std::array<std::array<double, most_terms>, most_terms> value;
};

// Cox and de Boor's recurrence on polynomials.
void set(BasisPolynomials& b, const double* knots, int degree, int poles, const Range& over) {
  const int span = knot_span(knots, degree, poles, over.centre);
  b.degree = degree, b.first = span - degree;
  const double width = knots[span + 1] - knots[span],
               outside = std::max({0.0, knots[span] - over.centre, over.centre - knots[span + 1]});
  b.shrink = 2 * over.half / width;
  b.grow = power_of(1 + 2 * outside / width, degree);
  for (int i = 0; i <= degree; ++i) std::fill_n(b.value[at(i)].begin(), degree + 1, 0.0);
  b.value[0][0] = 1;
  for (int q = 1; q <= degree; ++q) {
    std::array<double, most_terms> saved{};
    for (int r = 0; r < q; ++r) {
      const double high = knots[span + r + 1], low = knots[span + 1 - q + r];
      const double right = (high - over.centre) / (high - low), left = (over.centre - low) / (high - low),
                   half = over.half / (high - low);
      std::array<double, most_terms> next{};
      std::array<double, most_terms>& term = b.value[at(r)];
      for (int k = 0; k <= q; ++k) {
        const double same = k < q ? term[at(k)] : 0, before = k > 0 ? term[at(k - 1)] : 0;
        next[at(k)] = saved[at(k)] + right * same - half * before;
        saved[at(k)] = left * same + half * before;
      }
      std::copy_n(next.begin(), q + 1, term.begin());
    }
    b.value[at(q)] = saved;
  }
}

void set_constant(BasisPolynomials& b) {
  b.degree = b.first = 0;
  b.shrink = 0, b.grow = 1;
  b.value[0][0] = 1;
}

// k (k - 1) … down to n factors.
double falling(int k, int n) {
  double product = 1;
  for (int i = 0; i < n; ++i) product *= k - i;
  return product;
}

// The polynomials of the numerators and the denominator of a spline over a box, relative to a point.
class SplinePolynomials {
 public:
  // The poles of one u lie `stride` apart.
  SplinePolynomials(const Pole* poles, std::int64_t stride, const Vec3d& origin, const BasisPolynomials& u,
                    const BasisPolynomials& v)
      : u_degree_(u.degree),
        v_degree_(v.degree),
        u_shrink_(u.shrink),
        v_shrink_(v.shrink),
        grow_(u.grow * v.grow) {
    gather(poles + u.first * stride + v.first, stride, origin);
    for (int k = 0; k <= u_degree_; ++k) std::fill_n(sum_[at(k)].begin(), v_degree_ + 1, Homogeneous{});
    for (int i = 0; i <= u_degree_; ++i) {
      std::array<Homogeneous, most_terms> row;
      std::fill_n(row.begin(), v_degree_ + 1, Homogeneous{});
      for (int j = 0; j <= v_degree_; ++j) {
        for (int l = 0; l <= v_degree_; ++l) add(row[at(l)], pole_[at(i)][at(j)], v.value[at(j)][at(l)]);
      }
      for (int k = 0; k <= u_degree_; ++k) {
        for (int l = 0; l <= v_degree_; ++l) add(sum_[at(k)][at(l)], row[at(l)], u.value[at(i)][at(k)]);
      }
    }
  }

  bool rational() const { return rational_; }
  TaylorVector numerator(int by_u, int by_v) const {
    return {derivative(0, size_, by_u, by_v), derivative(1, size_, by_u, by_v),
            derivative(2, size_, by_u, by_v)};
  }
  TaylorModel denominator(int by_u, int by_v) const { return derivative(3, weight_, by_u, by_v); }

 private:
  using Homogeneous = std::array<double, 4>;  // w·x, w·y, w·z, w
  static void add(Homogeneous& sum, const Homogeneous& term, double by) {
    for (std::size_t i = 0; i < 4; ++i) sum[i] += by * term[i];
  }

  void gather(const Pole* poles, std::int64_t stride, const Vec3d& origin) {
    const double w = poles[0].w;
    for (int i = 0; i <= u_degree_; ++i) {
      for (int j = 0; j <= v_degree_; ++j) rational_ = rational_ || poles[i * stride + j].w != w;
    }
    for (int i = 0; i <= u_degree_; ++i) {
      for (int j = 0; j <= v_degree_; ++j) {
        Pole p = poles[i * stride + j];
        if (!rational_) p = {p.x / w, p.y / w, p.z / w, 1};
        const Vec3d a = gabarit::numerator(p) - origin * p.w;
        size_ = std::max({size_, std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
        weight_ = std::max(weight_, std::fabs(p.w));
        pole_[at(i)][at(j)] = {a.x, a.y, a.z, p.w};
      }
    }
    // Moving to the origin rounds by the origin's size.
    const double far = std::max({std::fabs(origin.x), std::fabs(origin.y), std::fabs(origin.z)});
    size_ += far * weight_ / (2 * (u_degree_ + v_degree_ + 4));
  }

  TaylorModel derivative(std::size_t part, double size, int by_u, int by_v) const {
    TaylorModel m;
    for (int k = by_u; k <= u_degree_; ++k) {
      for (int l = by_v; l <= v_degree_; ++l) {
        const double c = sum_[at(k)][at(l)][part] * falling(k, by_u) * falling(l, by_v);
        if (k - by_u + l - by_v <= taylor_order)
          m.c[at(taylor_term(k - by_u, l - by_v))] = c;
        else
          m.r += std::fabs(c);
      }
    }
    // Rounding of the recurrences and the sums.
    m.r = outward(m.r + 8 * (u_degree_ + v_degree_ + 4) * unit_roundoff * size * grow_ *
                            together(u_degree_, u_shrink_, by_u) * together(v_degree_, v_shrink_, by_v));
    return m;
  }

  // The sum over k of falling(k, by) binomial(degree, k) shrink^k.
  static double together(int degree, double shrink, int by) {
    return falling(degree, by) * power_of(shrink, by) * power_of(1 + shrink, degree - by);
  }

  int u_degree_, v_degree_;
  double u_shrink_, v_shrink_, grow_;
  bool rational_ = false;
  double size_ = 0, weight_ = 0;
  std::array<std::array<Homogeneous, most_terms>, most_terms> pole_, sum_;
};

TaylorModel cut(const TaylorModel& a_d, const TaylorModel& w, const TaylorModel& a, const TaylorModel& w_d) {
  return a_d * w - a * w_d;
}
// The derivative of A / w but for w² and a tangential part.
TaylorVector cut(const TaylorVector& a_d, const TaylorModel& w, const TaylorVector& a,
                 const TaylorModel& w_d) {
  return {cut(a_d.x, w, a.x, w_d), cut(a_d.y, w, a.y, w_d), cut(a_d.z, w, a.z, w_d)};
}

TaylorVector fixed(const Vec3d& a) { return {constant(a.x), constant(a.y), constant(a.z)}; }

TaylorSurface of_spline(const BrepView& brep, const Surface& s, const ParameterBox& box) {
  const Range u = range(box.u0, box.u1, s.u_periodic, s.domain.u0, s.domain.u1),
              v = range(box.v0, box.v1, s.v_periodic, s.domain.v0, s.domain.v1);
  BasisPolynomials in_u, in_v;
  set(in_u, brep.knots.data + s.first_u_knot, s.u_degree, s.u_poles, u);
  set(in_v, brep.knots.data + s.first_v_knot, s.v_degree, s.v_poles, v);
  const Vec3d origin = spline_surface_point(brep, s, u.centre, v.centre).p;
  const SplinePolynomials p(brep.poles.data + s.first_pole, s.v_poles, origin, in_u, in_v);
  const TaylorVector a_u = p.numerator(1, 0), a_v = p.numerator(0, 1), a_uu = p.numerator(2, 0),
                     a_uv = p.numerator(1, 1), a_vv = p.numerator(0, 2);
  if (!p.rational()) return {a_u, a_v, a_uu, a_uv, a_vv, constant(1)};
  const TaylorVector a = p.numerator(0, 0);
  const TaylorModel w = p.denominator(0, 0);
  return {cut(a_u, w, a, p.denominator(1, 0)),  cut(a_v, w, a, p.denominator(0, 1)),
          cut(a_uu, w, a, p.denominator(2, 0)), cut(a_uv, w, a, p.denominator(1, 1)),
          cut(a_vv, w, a, p.denominator(0, 2)), w * w};
}

// C = a / w by the curve's own parameter, relative to a point: d and dd as in TaylorSurface.
struct TaylorCurve {
  TaylorVector a, d, dd;
  TaylorModel w;
};

// factor · f over the range, for f with f'' = ±f: `values` are f and its next three derivatives at the
// centre, `most` bounds all of them.
TaylorModel wave(const std::array<double, 4>& values, int derivative, double half, double factor,
                 double most) {
  TaylorModel m;
  double h = power_of(half, derivative) * factor;
  for (int k = 0; k <= taylor_order; ++k) {
    m.c[at(taylor_term(k, 0))] = values[at((derivative + k) % 4)] * h;
    h *= half / (k + 1);
  }
  m.r = outward(std::fabs(h) * most + 16 * unit_roundoff * (norm(m) + std::fabs(h)));
  return m;
}

// The coordinates along the axes of a conic, or their derivatives.
struct ConicModels {
  TaylorModel x, y;
};
ConicModels conic(const Curve& c, const Range& t, int derivative) {
  const double h = t.half, at_centre = t.centre;
  if (c.kind == CurveKind::circle || c.kind == CurveKind::ellipse) {
    const double co = std::cos(at_centre), si = std::sin(at_centre);
    return {wave({co, -si, -co, si}, derivative, h, c.radius, 1),
            wave({si, co, -si, -co}, derivative, h, c.kind == CurveKind::circle ? c.radius : c.minor, 1)};
  }
  if (c.kind == CurveKind::hyperbola) {
    const double ch = std::cosh(at_centre), sh = std::sinh(at_centre),
                 most = std::cosh(std::fabs(at_centre) + h);
    return {wave({ch, sh, ch, sh}, derivative, h, c.radius, most),
            wave({sh, ch, sh, ch}, derivative, h, c.minor, most)};
  }
  // t along one axis, and a square along the other of a parabola: the polynomial (p + q x)(p + q x)·s.
  TaylorModel line;
  line.c[0] = derivative == 0 ? at_centre : derivative == 1 ? h : 0;
  if (derivative == 0) line.c[at(taylor_term(1, 0))] = h;
  if (c.kind != CurveKind::parabola) return {line, constant(0)};
  TaylorModel square;
  const double s = 1 / (4 * c.radius);
  const std::array<double, 3> of{at_centre * at_centre * s, 2 * at_centre * h * s, h * h * s};
  for (int k = derivative; k <= 2; ++k)
    square.c[at(taylor_term(k - derivative, 0))] = of[at(k)] * falling(k, derivative);
  square.r = 16 * unit_roundoff * norm(square);
  return {square, line};
}

TaylorCurve of_curve(const BrepView& brep, const Curve& c, double low, double high, const Vec3d& origin) {
  const Range t = range(low, high, c.periodic, c.first, c.last);
  if (c.kind == CurveKind::spline) {
    BasisPolynomials along, across;
    set(along, brep.knots.data + c.first_knot, c.degree, c.pole_count, t);
    set_constant(across);
    const SplinePolynomials p(brep.poles.data + c.first_pole, 1, origin, along, across);
    const TaylorVector a = p.numerator(0, 0), d = p.numerator(1, 0), dd = p.numerator(2, 0);
    if (!p.rational()) return {a, d, dd, constant(1)};
    const TaylorModel w = p.denominator(0, 0);
    return {a, cut(d, w, a, p.denominator(1, 0)), cut(dd, w, a, p.denominator(2, 0)), w};
  }
  const auto derivative = [&](int n) {
    const ConicModels m = conic(c, t, n);
    return fixed(c.axes.x) * m.x + fixed(c.axes.y) * m.y;
  };
  TaylorVector a = derivative(0) + fixed(c.axes.origin - origin);
  for (TaylorModel* const part : {&a.x, &a.y, &a.z})
    part->r += 4 * unit_roundoff * (length(origin) + length(c.axes.origin));
  return {a, derivative(1), derivative(2), constant(1)};
}

// C(u) + v z.
TaylorSurface of_extrusion(const BrepView& brep, const Surface& s, const ParameterBox& box) {
  const Curve& c = brep.curves[s.curve];
  const TaylorCurve t = of_curve(brep, c, box.u0, box.u1, curve_point(brep, c, (box.u0 + box.u1) / 2).p);
  const TaylorModel scale = t.w * t.w;
  return {t.d, fixed(s.axes.z) * scale, t.dd, {}, {}, scale};
}

// C(v) turned about z: where it stands at u = 0, as all turns of it are alike.
TaylorSurface of_revolution(const BrepView& brep, const Surface& s, const ParameterBox& box) {
  const Curve& c = brep.curves[s.curve];
  const Vec3d near = curve_point(brep, c, (box.v0 + box.v1) / 2).p - s.axes.origin;
  const TaylorCurve t = of_curve(brep, c, box.v0, box.v1, s.axes.origin + s.axes.z * dot(near, s.axes.z));
  const TaylorVector z = fixed(s.axes.z), arm = t.a * t.w, around = cross(z, arm);
  const TaylorVector inwards = cross(z, around);  // z is a unit vector
  return {around, t.d, inwards, cross(z, t.d), t.dd, t.w * t.w};
}

}  // namespace

TaylorSurface taylor_surface(const BrepView& brep, const Surface& surface, const ParameterBox& box) {
  switch (surface.kind) {
    case SurfaceKind::extrusion: return of_extrusion(brep, surface, box);
    case SurfaceKind::revolution: return of_revolution(brep, surface, box);
    default: return of_spline(brep, surface, box);
  }
}

}  // namespace gabarit
