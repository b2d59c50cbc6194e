#include "model/trim_seams.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gabarit {
namespace {

constexpr double same_place = 1e-6;  // of the face's range: both sides of one seam

// Along one parameter.
struct Direction {
  double low, high;  // of the domain
  bool periodic;
  double tolerance;

  // Whole turns in a shift, or whole widths of a domain that may close without being periodic.
  double turns(double shift) const {
    const double width = high - low;
    return std::isfinite(width) && width > 0 ? std::round(shift / width) : 0;
  }
  double shift(double turns) const { return turns == 0 ? 0 : turns * (high - low); }
  bool same(double a, double b) const { return std::abs(a - b) <= tolerance; }
  bool at_end(double t) const { return same(t, low) || same(t, high); }
};

class SeamJoiner {
 public:
  SeamJoiner(const Face& face, const Surface& s)
      : u_{s.domain.u0, s.domain.u1, s.u_periodic, same_place * (face.range.u1 - face.range.u0)},
        v_{s.domain.v0, s.domain.v1, s.v_periodic, same_place * (face.range.v1 - face.range.v0)} {}

  void join(TrimStretch& a, TrimStretch& b) const {
    const double u_turns = u_.turns(b.end.u - a.start.u), v_turns = v_.turns(b.end.v - a.start.v);
    const Parameters shift{u_.shift(u_turns), v_.shift(v_turns)};
    if (!same(a.start, b.end, shift) || !same(a.end, b.start, shift)) return;
    const bool straight = a.curve == no_number && b.curve == no_number;
    // Without a period only the ends of the domain can be the two sides of a seam.
    if (u_turns != 0 && !u_.periodic && !(straight && u_.at_end(a.start.u) && u_.at_end(a.end.u))) return;
    if (v_turns != 0 && straight) a.end.v = a.start.v;
    b.start = {a.end.u + shift.u, a.end.v + shift.v};
    b.end = {a.start.u + shift.u, a.start.v + shift.v};
    a.role = std::fmod(u_turns, 2) != 0 ? TrimRole::seam : TrimRole::silent;
    b.role = TrimRole::silent;
  }

 private:
  bool same(Parameters a, Parameters b, Parameters shift) const {
    return u_.same(a.u + shift.u, b.u) && v_.same(a.v + shift.v, b.v);
  }

  Direction u_, v_;
};

}  // namespace

void join_seams(const Face& face, const Surface& surface, std::vector<TrimLoop>& loops) {
  std::map<EdgeId, std::vector<TrimStretch*>> sides;
  for (TrimLoop& loop : loops) {
    for (TrimStretch& s : loop.stretches) {
      if (s.edge != no_number) sides[s.edge].push_back(&s);
    }
  }
  const SeamJoiner joiner(face, surface);
  for (const auto& [edge, pair] : sides) {
    if (pair.size() == 2) joiner.join(*pair[0], *pair[1]);
  }
}

}  // namespace gabarit
