// Whether a point of a surface belongs to the face that is cut out of it.
#pragma once

#include "model/brep_curve.h"

namespace gabarit {

enum class TrimSide : std::uint8_t { outside, inside };

// The width of a turn; 0 where the parameter does not come round.
GABARIT_HD inline double u_period(const Surface& s) { return s.u_periodic ? s.domain.u1 - s.domain.u0 : 0; }
GABARIT_HD inline double v_period(const Surface& s) { return s.v_periodic ? s.domain.v1 - s.domain.v0 : 0; }

// t in the turn that begins with `first`: never below it, and below first + period.
GABARIT_HD inline double in_turn(double t, double first, double period) {
  if (!(period > 0)) return t;
  t -= period * std::floor((t - first) / period);
  return t >= first && t < first + period ? t : first;
}

// A point on a curve that lies in a plane of parameters.
GABARIT_HD inline Parameters trim_point(const BrepView& brep, const Curve& c, double t) {
  if (c.kind != CurveKind::spline) {
    const Vec3d p = curve_point(brep, c, t).p;
    return {p.x, p.y};
  }
  if (c.periodic) t = wrapped(t, c.first, c.last);
  const double* const knots = brep.knots.data + c.first_knot;
  const int span = knot_span(knots, c.degree, c.pole_count, t);
  double basis[highest_degree + 1] = {1};
  for (int q = 1; q <= c.degree; ++q) raise_basis(knots, span, q, t, basis);
  Pole sum{0, 0, 0, 0};
  for (int j = 0; j <= c.degree; ++j)
    add_scaled(sum, brep.poles[c.first_pole + span - c.degree + j], basis[j]);
  return {sum.x / sum.w, sum.y / sum.w};
}

// How many turns of the ray from u meet a boundary at `edge`.
GABARIT_HD inline double turns_met(double edge, double u, double period) {
  if (!(edge > u)) return 0;
  return period > 0 ? std::ceil((edge - u) / period) : 1;
}

// The next place to look at between two on either side of v: in turns that of a straight line and the middle,
// so that both ends of what is left close in.
GABARIT_HD inline double next_place(Parameters a, Parameters b, double first, double last, double v,
                                    int step) {
  const double middle = first + (last - first) / 2;
  const double straight = first + (last - first) * ((v - a.v) / (b.v - a.v));
  const bool between = (straight - first) * (last - straight) > 0;
  return between && step % 3 != 2 ? straight : middle;
}

// How many turns of a ray from (u, v) towards greater u meet the piece. Its ends decide nearly always; else
// the place where it crosses v is closed in until both ends of what is left agree, at the latest when no
// number lies between them.
GABARIT_HD inline double crossings(const BrepView& brep, const TrimPiece& piece, Parameters at,
                                   double period) {
  if (!(piece.a.v <= at.v && at.v < piece.b.v)) return 0;
  if (piece.seam) return 1;
  double low = turns_met(piece.a.u, at.u, period);
  if (low == turns_met(piece.b.u, at.u, period)) return low;
  Parameters a = piece.a, b = piece.b;
  if (piece.curve == no_number)
    return turns_met(a.u + (b.u - a.u) * ((at.v - a.v) / (b.v - a.v)), at.u, period);
  double first = piece.first, last = piece.last;
  const Curve& curve = brep.curves[piece.curve];
  for (int step = 0; low != turns_met(b.u, at.u, period); ++step) {
    const double t = next_place(a, b, first, last, at.v, step);
    if (t == first || t == last) break;
    const Parameters p = trim_point(brep, curve, t);
    if (p.v <= at.v)
      a = p, first = t, low = turns_met(a.u, at.u, period);
    else
      b = p, last = t;
  }
  return low;
}

// Bins divide the box of a face into layers; never less for a greater v.
GABARIT_HD inline std::uint32_t trim_bin(const FaceTrim& trim, double v) {
  const double place = (v - trim.box.v0) / (trim.box.v1 - trim.box.v0) * trim.bin_count;
  return place < trim.bin_count ? static_cast<std::uint32_t>(place) : trim.bin_count - 1;
}

// Of all pieces of the face; only whether the number is odd means something.
GABARIT_HD inline double all_crossings(const BrepView& brep, const FaceTrim& trim, Parameters at,
                                       double period) {
  double sum = 0;
  if (trim.bin_count == 0) {
    for (std::uint32_t i = 0; i < trim.piece_count; ++i)
      sum += crossings(brep, brep.trim_pieces[trim.first_piece + i], at, period);
    return sum;
  }
  if (!(at.v >= trim.box.v0 && at.v <= trim.box.v1)) return 0;
  const std::int64_t bin = trim.first_bin + trim_bin(trim, at.v);
  for (std::uint32_t i = brep.trim_bins[bin]; i < brep.trim_bins[bin + 1]; ++i)
    sum += crossings(brep, brep.trim_pieces[brep.trim_listing[i]], at, period);
  return sum;
}

// On which side of the trimming curves of the face the point is, to the last digits of the curves: no chord
// stands for them. `at` may lie in any turn of a periodic parameter. On a curve either answer may come.
GABARIT_SEPARATE GABARIT_HD inline TrimSide trim_side(const BrepView& brep, FaceId face, Parameters at) {
  const FaceTrim& trim = brep.trims[face];
  const Surface& surface = brep.surfaces[brep.faces[face].surface];
  const double u_turn = u_period(surface), v_turn = v_period(surface);
  at.u = in_turn(at.u, trim.box.u0, u_turn);
  at.v = in_turn(at.v, trim.box.v0, v_turn);
  // The upper end of the surface itself, such as a pole, is no edge of the face.
  if (v_turn == 0 && at.v == trim.box.v1) at.v = std::nextafter(at.v, trim.box.v0);
  double sum = trim.all ? 1 : 0;
  do sum += all_crossings(brep, trim, at, u_turn);
  while (v_turn > 0 && (at.v += v_turn) < trim.box.v1);
  return std::fmod(sum, 2) != 0 ? TrimSide::inside : TrimSide::outside;
}

// t in the turn in which it lies in the range or nearest to it.
GABARIT_HD inline double near_range(double t, double low, double high, double period) {
  t = in_turn(t, low, period);
  return t > high && low - (t - period) < t - high ? t - period : t;
}

// The same point with periodic parameters in the turns in which they lie in the face's range, or nearest to
// it.
GABARIT_HD inline Parameters into_range(const BrepView& brep, FaceId face, Parameters at) {
  const Face& f = brep.faces[face];
  const Surface& surface = brep.surfaces[f.surface];
  return {near_range(at.u, f.range.u0, f.range.u1, u_period(surface)),
          near_range(at.v, f.range.v0, f.range.v1, v_period(surface))};
}

}  // namespace gabarit
