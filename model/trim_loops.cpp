#include "model/trim_loops.h"

#include <algorithm>
#include <cmath>

#include "model/brep_surface.h"
#include "model/brep_trim.h"
#include "model/monotone_cuts.h"
#include "model/trim_bins.h"
#include "model/trim_chain.h"
#include "model/trim_seams.h"

namespace gabarit {
namespace {

constexpr double many_turns = 4096;
constexpr double covered_gap = 1e-3;  // mm: what exporters leave open whatever tolerance they claim

bool finite(const TrimStretch& s) {
  return std::isfinite(s.start.u + s.start.v + s.end.u + s.end.v + s.first + s.last);
}

class Trimming {
 public:
  explicit Trimming(Brep& brep)
      : brep_(&brep),
        face_(&brep.faces[brep.trims.size()]),
        surface_(&brep.surfaces[face_->surface]),
        turn_{u_period(*surface_), v_period(*surface_)} {
    trim_.first_piece = static_cast<std::uint32_t>(brep.trim_pieces.size());
  }

  // False when the wires make no sense.
  bool make(const std::vector<TrimWire>& wires) {
    for (const TrimWire& wire : wires) {
      if (!std::all_of(wire.begin(), wire.end(), finite)) return false;
      if (!wire.empty()) loops_.push_back(chained(wire, *face_, turn_, *brep_));
    }
    trim_.all = loops_.empty();
    join_seams(*face_, *surface_, loops_);
    for (const TrimLoop& loop : loops_) add(loop);
    if (!join_windings() || !sensible_box()) return false;
    trim_.piece_count = static_cast<std::uint32_t>(brep_->trim_pieces.size()) - trim_.first_piece;
    sort_into_bins(trim_, *brep_);
    return true;
  }

  FaceTrim trim() const { return trim_; }
  bool leaky() const { return leaky_; }

  // On closed surfaces every loop bounds two faces; of them it has the one on its left.
  bool is_the_other_one(FaceId face) const {
    if (!two_sided_) return false;
    const auto size = [this](const TrimStretch& s) {
      const Parameters middle = point(s, 0.5);
      return std::abs(middle.u - s.start.u) + std::abs(middle.v - s.start.v) + std::abs(s.end.u - middle.u) +
             std::abs(s.end.v - middle.v);
    };
    const TrimStretch* longest = nullptr;
    for (const TrimLoop& loop : loops_) {
      for (const TrimStretch& s : loop.stretches) {
        if (s.role == TrimRole::border && (longest == nullptr || size(s) > size(*longest))) longest = &s;
      }
    }
    return longest != nullptr && trim_side(view(*brep_), face, beside(*longest)) == TrimSide::outside;
  }

 private:
  Parameters point(const TrimStretch& s, double part) const {
    if (s.curve != no_number)
      return trim_point(view(*brep_), brep_->curves[s.curve], s.first + (s.last - s.first) * part);
    return {s.start.u + (s.end.u - s.start.u) * part, s.start.v + (s.end.v - s.start.v) * part};
  }

  // A point on its left.
  Parameters beside(const TrimStretch& s) const {
    const Parameters a = point(s, 0.499), middle = point(s, 0.5), b = point(s, 0.501);
    return {middle.u - 0.05 * (b.v - a.v), middle.v + 0.05 * (b.u - a.u)};
  }

  // From start to end.
  std::vector<double> cuts(const TrimStretch& s) const {
    if (s.curve == no_number) return {};
    const auto [low, high] = std::minmax(s.first, s.last);
    std::vector<double> t = monotone_cuts(*brep_, brep_->curves[s.curve], low, high);
    if (s.first > s.last) std::reverse(t.begin(), t.end());
    return t;
  }

  void add(const TrimLoop& loop) {
    const std::size_t n = loop.stretches.size();
    for (std::size_t i = 0; i < n; ++i) {
      const TrimStretch& s = loop.stretches[i];
      add(s);
      Parameters next = loop.stretches[(i + 1) % n].start;
      if (i + 1 == n) next.u += loop.u_turns * turn_.u, next.v += loop.v_turns * turn_.v;
      close_gap(s, next);
      seams_ = seams_ || s.role != TrimRole::border;
    }
  }

  void close_gap(const TrimStretch& s, Parameters next) {
    const BrepView arrays = view(*brep_);
    const double gap = length(face_point(arrays, *face_, s.end).p - face_point(arrays, *face_, next).p);
    leaky_ = leaky_ || gap > std::max(covered_gap, 2 * s.tolerance);
    add({.a = s.end, .b = next});
  }

  void add(const TrimStretch& s) {
    TrimPiece rest{.a = s.start,
                   .b = s.end,
                   .first = s.first,
                   .last = s.last,
                   .curve = s.curve,
                   .seam = s.role == TrimRole::seam};
    if (s.role == TrimRole::silent) return add_to_box(s.start), add_to_box(s.end);
    for (const double t : cuts(s)) {
      TrimPiece piece = rest;
      piece.b = rest.a = trim_point(view(*brep_), brep_->curves[s.curve], t);
      piece.last = rest.first = t;
      add(piece);
    }
    add(rest);
  }

  void add(TrimPiece piece) {
    add_to_box(piece.a), add_to_box(piece.b);
    if (piece.a.v > piece.b.v) std::swap(piece.a, piece.b), std::swap(piece.first, piece.last);
    if (piece.a.v < piece.b.v) brep_->trim_pieces.push_back(piece);
  }

  void add_to_box(Parameters p) {
    ParameterBox& b = trim_.box;
    if (!has_box_) b = {p.u, p.u, p.v, p.v};
    has_box_ = true;
    b = {std::min(b.u0, p.u), std::max(b.u1, p.u), std::min(b.v0, p.v), std::max(b.v1, p.v)};
  }

  // Loops that wind around in u, in the order of v: between each two of them a cut, like a seam. One that is
  // alone has the face up or down to the end of the surface.
  bool join_windings() {
    std::vector<double> ends;
    double last_turns = 0, around_v = 0;
    for (const TrimLoop& loop : loops_) {
      around_v += std::abs(loop.v_turns);
      if (std::fmod(loop.u_turns, 2) == 0) continue;
      ends.push_back(loop.stretches[0].start.v), last_turns = loop.u_turns;
    }
    const bool odd = ends.size() % 2 != 0,
               closed = turn_.u > 0 && (turn_.v > 0 || surface_->kind == SurfaceKind::sphere);
    if (std::fmod(around_v, 2) != 0 || (odd && turn_.v > 0)) return false;
    if (odd) ends.push_back(last_turns > 0 ? surface_->domain.v1 : surface_->domain.v0);
    two_sided_ = closed && !seams_ && (turn_.v > 0 || ends.empty());
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (!std::isfinite(ends[i]) || !std::isfinite(ends[i + 1])) return false;
      add({.a = {trim_.box.u0, ends[i]}, .b = {trim_.box.u0, ends[i + 1]}, .seam = true});
    }
    return true;
  }

  bool sensible_box() const {
    const double u = trim_.box.u1 - trim_.box.u0, v = trim_.box.v1 - trim_.box.v0;
    return std::isfinite(u + v) && (turn_.u == 0 || u <= many_turns * turn_.u) &&
           (turn_.v == 0 || v <= many_turns * turn_.v);
  }

  Brep* brep_;
  const Face* face_;
  const Surface* surface_;
  Parameters turn_;
  FaceTrim trim_;
  std::vector<TrimLoop> loops_;
  bool has_box_ = false, leaky_ = false, seams_ = false, two_sided_ = false;
};

}  // namespace

void add_trim(const std::vector<TrimWire>& wires, Brep& brep) {
  const auto pieces = brep.trim_pieces.size();
  const auto face = static_cast<FaceId>(brep.trims.size());
  Trimming trimming(brep);
  if (trimming.make(wires)) {
    brep.leaky += trimming.leaky() ? 1 : 0;
    brep.trims.push_back(trimming.trim());
    brep.trims.back().all = trimming.trim().all != trimming.is_the_other_one(face);
    return;
  }
  brep.trim_pieces.resize(pieces);
  add_unknown_trim(brep);
}

void add_unknown_trim(Brep& brep) {
  ++brep.untrimmed;
  brep.trims.push_back({.box = {}, .all = true});
}

}  // namespace gabarit
