#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "examples/motorcycle/placement.h"

namespace gabarit::motorcycle {

namespace {

// A bend takes `trim` of the straights on both sides and turns by `angle`.
struct Turn {
  double trim = 0, angle = 0;
  Vec3d inward;  // at the arc's start
};

Turn turn_at(const Vec3d& before, const Bend& bend, const Vec3d& after) {
  const Vec3d in = normalized(bend.at - before), out = normalized(after - bend.at);
  const double angle = std::atan2(length(cross(in, out)), dot(in, out));
  return {.trim = bend.radius * std::tan(angle / 2),
          .angle = angle,
          .inward = normalized(out - dot(out, in) * in)};
}

}  // namespace

Path::Path(const std::vector<Bend>& bends, const Vec3d& x) : starts_{0} {
  const Vec3d z = normalized(bends[1].at - bends[0].at);
  const Vec3d across = normalized(x - dot(x, z) * z);
  end_ = {bends[0].at, across, cross(z, across), z};
  double trimmed = 0;
  for (std::size_t i = 1; i < bends.size(); ++i) {
    Turn turn;
    if (i + 1 < bends.size()) turn = turn_at(bends[i - 1].at, bends[i], bends[i + 1].at);
    const double straight = gabarit::length(bends[i].at - bends[i - 1].at) - trimmed - turn.trim;
    if (straight < -1e-7) throw std::invalid_argument("the bends of a path do not fit its straights");
    if (straight > 1e-7) add(straight, 0, {});
    if (turn.trim > 0) add(bends[i].radius * turn.angle, bends[i].radius, turn.inward);
    trimmed = turn.trim;
  }
}

void Path::add(double length, double radius, const Vec3d& inward) {
  pieces_.push_back({end_, radius, inward});
  starts_.push_back(starts_.back() + length);
  end_ = advanced(pieces_.back(), length);
}

Path::Frame Path::advanced(const Piece& piece, double s) {
  Frame frame = piece.start;
  if (piece.radius == 0) {
    frame.origin += s * frame.z;
    return frame;
  }
  const double angle = s / piece.radius, c = std::cos(angle), sine = std::sin(angle);
  const Vec3d along = piece.start.z, inward = piece.inward;
  // What lies in the bend's plane turns, the rest stays.
  const auto turned = [&](const Vec3d& d) {
    const double a = dot(d, along), b = dot(d, inward);
    return d + (a * (c - 1) - b * sine) * along + (a * sine + b * (c - 1)) * inward;
  };
  frame.origin += piece.radius * (sine * along + (1 - c) * inward);
  frame.x = turned(frame.x), frame.y = turned(frame.y), frame.z = turned(frame.z);
  return frame;
}

Vec3d Path::at(const Vec3d& local) const {
  const double inside = std::clamp(local.z, 0.0, length());
  const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, inside);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - starts_.begin() - 1));
  const std::size_t k = std::min(i, pieces_.size() - 1);
  const Frame f = advanced(pieces_[k], inside - starts_[k]);
  return f.origin + local.x * f.x + local.y * f.y + (local.z - inside) * f.z;
}

}  // namespace gabarit::motorcycle
