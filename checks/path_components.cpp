#include "checks/path_components.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

namespace gabarit {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The lower number stays, so that the result does not depend on the order.
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct End {
  Point2 at;
  std::size_t piece;
  bool joined = false;
};

// Ends nearer than this are one point. Two disks that leave a gap of d between them (d < 0: they overlap)
// part by 2 sqrt(R |d|), so only gaps within some 1e-14 mm of the diameter are taken for the diameter.
constexpr double same_point = 1e-6;
// Ends that rounding has moved along nearly parallel curves: only those that found no partner, and still
// nearer than the ends at a mouth that is 4e-8 mm too narrow.
constexpr double moved_point = 5e-3;

void join_near_ends(std::vector<End>& ends, double reach, UnionFind& groups, bool lonely_only) {
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size() && ends[j].at.x - ends[i].at.x <= reach; ++j) {
      if (lonely_only && ends[i].joined && ends[j].joined) continue;
      if (ends[i].piece == ends[j].piece || length(ends[j].at - ends[i].at) > reach) continue;
      groups.join(ends[i].piece, ends[j].piece);
      if (!lonely_only) ends[i].joined = ends[j].joined = true;
    }
  }
}

void join_ends(const std::vector<PathPiece>& pieces, UnionFind& groups) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ends.push_back({pieces[i].from, i});
    ends.push_back({pieces[i].to, i});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y != b.at.y ? a.at.y < b.at.y : a.piece < b.piece;
  });
  join_near_ends(ends, same_point, groups, false);
  join_near_ends(ends, moved_point, groups, true);
}

// The place of a piece furthest to +x, and how far to the right of its feature that is (negative: left).
struct Rightmost {
  Point2 at;
  double right_of_feature;
};

Rightmost rightmost(const PathPiece& piece) {
  // Angles run from 0 to 2 pi, so only an arc that begins or ends at 0 points straight to +x.
  const bool end = piece.to.x > piece.from.x;
  const Point2 at = end ? piece.to : piece.from;
  if (piece.arc) return {at, at.x - piece.centre.x};
  const Point2 along = piece.to - piece.from;
  const Point2 across = piece.from - piece.foot;
  return {at, across.x != 0 ? across.x : -along.x};
}

// x of the first meeting with the ray from `at` to +x; infinity when there is none.
double meeting(const PathPiece& piece, Point2 at, double radius) {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr double slack = 1e-9;
  const double beyond = at.x + slack;
  if (!piece.arc) {
    const double low = std::min(piece.from.y, piece.to.y);
    const double high = std::max(piece.from.y, piece.to.y);
    if (at.y < low - slack || at.y > high + slack) return none;
    const double dy = piece.to.y - piece.from.y;
    const double t = dy != 0 ? std::clamp((at.y - piece.from.y) / dy, 0.0, 1.0) : 0;
    double x = piece.from.x + (piece.to.x - piece.from.x) * t;
    if (dy == 0)
      x = std::min(piece.from.x, piece.to.x) > beyond ? std::min(piece.from.x, piece.to.x)
                                                      : std::max(piece.from.x, piece.to.x);
    return x > beyond ? x : none;
  }
  const double y = at.y - piece.centre.y;
  if (std::abs(y) > radius + slack) return none;
  const double half = std::sqrt(std::max(0.0, radius * radius - y * y));
  double first = none;
  for (const double x : {-half, half}) {
    double angle = std::atan2(y, x);
    if (angle < 0) angle += 2 * std::numbers::pi;
    const bool inside = angle >= piece.from_angle - slack && angle <= piece.to_angle + slack;
    const bool seam = angle < slack && piece.to_angle > 2 * std::numbers::pi - slack;
    if ((inside || seam) && piece.centre.x + x > beyond) first = std::min(first, piece.centre.x + x);
  }
  return first;
}

}  // namespace

std::vector<bool> number_components(std::vector<PathPiece>& pieces, double radius) {
  UnionFind groups(pieces.size());
  join_ends(pieces, groups);
  std::vector<Rightmost> best(pieces.size(), {{-std::numeric_limits<double>::infinity(), 0}, 0});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Rightmost& b = best[groups.root(i)];
    if (const Rightmost mine = rightmost(pieces[i]); mine.at.x > b.at.x) b = mine;
  }
  // Around an obstacle the rightmost place lies to the right of every feature that is touched there; a pocket
  // ends in front of a wall or between two features.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Rightmost& b = best[groups.root(i)];
    const Rightmost mine = rightmost(pieces[i]);
    if (mine.at.x >= b.at.x - same_point)
      b.right_of_feature = std::min(b.right_of_feature, mine.right_of_feature);
  }
  // What goes on out of reach is out of reach itself.
  std::vector<bool> cut(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].cut) cut[groups.root(i)] = true;
  }
  const std::size_t infinity = pieces.size();
  UnionFind spaces(pieces.size() + 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) spaces.join(i, groups.root(i));
  for (std::size_t root = 0; root < pieces.size(); ++root) {
    const Rightmost& start = best[root];
    if (groups.root(root) != root || cut[root] || start.right_of_feature <= 0)
      continue;  // the free space lies inside
    std::size_t hit = infinity;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (groups.root(i) == root) continue;
      if (const double x = meeting(pieces[i], start.at, radius); x < nearest) {
        nearest = x;
        hit = i;
      }
    }
    spaces.join(root, hit);
  }
  std::vector<std::uint32_t> number(pieces.size(), 0);
  std::vector<bool> reached;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::uint32_t& n = number[groups.root(i)];
    if (n == 0) {
      reached.push_back(!cut[groups.root(i)] && spaces.root(i) == spaces.root(infinity));
      n = static_cast<std::uint32_t>(reached.size());
    }
    pieces[i].component = n - 1;
  }
  return reached;
}

}  // namespace gabarit
