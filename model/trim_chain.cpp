#include "model/trim_chain.h"

#include <cmath>
#include <limits>

namespace gabarit {
namespace {

constexpr double meets = 1e-4;  // of the face's range: ends of consecutive curves
constexpr double whole = 1e-3;  // of a turn: nearly a whole one

double turns_in(double distance, double period) { return period > 0 ? std::round(distance / period) : 0; }

// Whole turns by which `to` lies beyond `from`; 0 when they are apart by anything else.
double whole_turns(double from, double to, double period) {
  const double turns = turns_in(to - from, period);
  return std::abs(to - from - turns * period) <= whole * period ? turns : 0;
}

class Chain {
 public:
  Chain(const TrimWire& wire, const Face& face, Parameters turn, Brep& brep)
      : wire_(wire), turn_(turn), brep_(&brep), used_(wire.size()) {
    size_ = {face.range.u1 - face.range.u0, face.range.v1 - face.range.v0};
  }

  TrimLoop run() {
    TrimLoop loop;
    loop.stretches.reserve(wire_.size());
    for (std::size_t next = 0; loop.stretches.size() < wire_.size();) {
      used_[next] = true;
      loop.stretches.push_back(wire_[next]);
      if (loop.stretches.size() > 1)
        lift(loop.stretches[loop.stretches.size() - 2].end, loop.stretches.back());
      next = following(next);
    }
    const Parameters start = loop.stretches.front().start, end = loop.stretches.back().end;
    loop.u_turns = whole_turns(start.u, end.u, turn_.u);
    loop.v_turns = whole_turns(start.v, end.v, turn_.v);
    return loop;
  }

 private:
  // From the end of one stretch to the start of another, in parts of the face's range: as the file has them,
  // or whatever the turns.
  double distance(std::size_t a, std::size_t b, Parameters turn) const {
    const Parameters p = wire_[a].end, q = wire_[b].start;
    const double u = p.u - q.u - turn.u * turns_in(p.u - q.u, turn.u);
    const double v = p.v - q.v - turn.v * turns_in(p.v - q.v, turn.v);
    return (size_.u > 0 ? std::abs(u) / size_.u : 0) + (size_.v > 0 ? std::abs(v) / size_.v : 0);
  }

  // The next in the order given where it fits, else the nearest. All sides of a torus begin at one point when
  // turns do not count: they do as long as something fits.
  std::size_t following(std::size_t last) const {
    const std::size_t next = (last + 1) % wire_.size();
    if (!used_[next] && distance(last, next, {}) <= meets) return next;
    const std::size_t best = nearest(last, {});
    return distance(last, best, {}) <= meets ? best : nearest(last, turn_);
  }

  std::size_t nearest(std::size_t last, Parameters turn) const {
    std::size_t best = last;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < wire_.size(); ++i) {
      if (used_[i]) continue;
      const double d = distance(last, i, turn);
      if (d < least) best = i, least = d;
    }
    return best;
  }

  void lift(Parameters from, TrimStretch& s) {
    const Parameters shift{-turn_.u * whole_turns(from.u, s.start.u, turn_.u),
                           -turn_.v * whole_turns(from.v, s.start.v, turn_.v)};
    if (shift.u == 0 && shift.v == 0) return;
    for (Parameters* p : {&s.start, &s.end}) p->u += shift.u, p->v += shift.v;
    if (s.curve != no_number) move(brep_->curves[s.curve], shift);
  }

  void move(Curve& c, Parameters by) {
    c.axes.origin += Vec3d{by.u, by.v, 0};
    for (std::int32_t i = 0; i < c.pole_count; ++i) {
      Pole& p = brep_->poles[c.first_pole + static_cast<std::uint32_t>(i)];
      p.x += by.u * p.w, p.y += by.v * p.w;
    }
  }

  const TrimWire& wire_;
  Parameters turn_, size_;
  Brep* brep_;
  std::vector<bool> used_;
};

}  // namespace

TrimLoop chained(const TrimWire& wire, const Face& face, Parameters turn, Brep& brep) {
  return Chain(wire, face, turn, brep).run();
}

}  // namespace gabarit
