#include "checks/path_components.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

#include "checks/disjoint_sets.h"
#include "checks/path_joins.h"
#include "gpu/segment_grid.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Box2 box_of(const PathPiece& piece, double radius) {
  Box2 box;
  box.add(piece.from);
  box.add(piece.to);
  if (!piece.arc) return box;
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const double angle = quarter * std::numbers::pi / 2;
    if (piece.from_angle <= angle && angle <= piece.to_angle)
      box.add(piece.centre + Point2{std::cos(angle), std::sin(angle)} * radius);
  }
  return box;
}

void join_meeting(const std::vector<PathPiece>& pieces, double radius, double near, DisjointSets& groups) {
  std::vector<Box2> box;
  box.reserve(pieces.size());
  for (const PathPiece& piece : pieces) box.push_back(box_of(piece, radius));
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return box[a].low.x != box[b].low.x ? box[a].low.x < box[b].low.x : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const std::size_t b = order[j];
      if (box[b].low.x > box[a].high.x + near) break;
      if (box[b].low.y > box[a].high.y + near || box[b].high.y < box[a].low.y - near) continue;
      if (groups.root(a) != groups.root(b) && meet(pieces[a], pieces[b], radius, near)) groups.join(a, b);
    }
  }
}

// What the disk meets first on its way from a free place to +x.
class Ray {
 public:
  Ray(const OutlineFeatures& outline, double radius) : outline_(outline), radius_(radius) {}

  // Nothing of the outline is nearer to the disk's centre than `gap`.
  bool clear(Point2 centre, double gap) const {
    const auto far = [&](Point2 a, Point2 b) {
      return std::max(a.x, b.x) < centre.x - gap || std::min(a.x, b.x) > centre.x + gap ||
             std::max(a.y, b.y) < centre.y - gap || std::min(a.y, b.y) > centre.y + gap ||
             point_segment_distance(centre, a, b) >= gap;
    };
    for (const Point2 p : outline_.points) {
      if (!far(p, p)) return false;
    }
    for (const auto& [a, b] : outline_.edges) {
      if (!far(outline_.points[a], outline_.points[b])) return false;
    }
    return true;
  }
  // How far the disk moves until it touches; infinity when it leaves.
  double free_way(Point2 from) const {
    double way = infinity;
    for (const Point2 p : outline_.points) {
      const double y = p.y - from.y;
      if (p.x <= from.x || std::abs(y) >= radius_) continue;
      way = std::min(way, p.x - from.x - std::sqrt((radius_ - y) * (radius_ + y)));
    }
    for (const auto& [a, b] : outline_.edges) way = std::min(way, way_to(from, a, b));
    return std::max(way, 0.0);
  }

 private:
  // To the line beside the edge on which the disk touches the edge's inside.
  double way_to(Point2 from, std::uint32_t a, std::uint32_t b) const {
    const Point2 p = outline_.points[a];
    const Point2 along = outline_.points[b] - p;
    const double size = length(along);
    const Point2 normal = Point2{-along.y, along.x} * (1 / size);
    if (normal.x == 0) return infinity;
    const double beside = dot(from - p, normal);
    const double way = (beside > 0 ? radius_ - beside : -radius_ - beside) / normal.x;
    const double foot = dot(from + Point2{way, 0} - p, along);
    return way >= 0 && foot >= 0 && foot <= size * size ? way : infinity;
  }

  const OutlineFeatures& outline_;
  double radius_;
};

double rounding(const OutlineFeatures& outline, double radius) {
  double size = radius;
  for (const Point2 p : outline.points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  return 16 * std::numeric_limits<double>::epsilon() * size;
}

// The place of a piece furthest to +x: angles run from 0 to 2 pi, so it is an end of an arc, too.
Point2 rightmost(const PathPiece& piece) { return piece.to.x > piece.from.x ? piece.to : piece.from; }

struct Group {
  Point2 right{-infinity, 0};
  bool cut = false;
};

// The component that the free space to the right of a group belongs to; the group's own when it is open to
// infinity, none when there is an obstacle: then the group is the rim of a hole.
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

std::size_t leads_to(const std::vector<PathPiece>& pieces, std::size_t group, const Group& rim,
                     const Ray& ray, double radius, double near) {
  const Point2 beside = rim.right + Point2{near / 2, 0};
  if (!ray.clear(beside, radius + near / 8)) return none;
  const double way = ray.free_way(beside);
  if (way == infinity) return group;
  const Point2 touch = beside + Point2{way, 0};
  std::size_t nearest = group;
  double least = infinity;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double d = distance(pieces[i], radius, touch);
    if (d < least) {
      least = d;
      nearest = i;
    }
  }
  // A touch that no piece knows of lies where the disk was told not to look: out of reach.
  return least <= near ? nearest : none;
}

}  // namespace

std::vector<bool> number_components(std::vector<PathPiece>& pieces, const OutlineFeatures& outline,
                                    double radius) {
  const double near = 4 * std::sqrt(radius * rounding(outline, radius));
  DisjointSets groups(pieces.size());
  join_meeting(pieces, radius, near, groups);
  std::vector<Group> rim(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Group& group = rim[groups.root(i)];
    const Point2 right = rightmost(pieces[i]);
    if (right.x > group.right.x || (right.x == group.right.x && right.y > group.right.y)) group.right = right;
    // What goes on out of reach is out of reach itself.
    group.cut = group.cut || pieces[i].cut;
  }
  const Ray ray(outline, radius);
  const std::size_t outside = pieces.size();
  DisjointSets spaces(pieces.size() + 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (groups.root(i) != i || rim[i].cut) continue;
    const std::size_t to = leads_to(pieces, i, rim[i], ray, radius, near);
    if (to != none) spaces.join(i, to == i ? outside : groups.root(to));
  }
  std::vector<std::uint32_t> number(pieces.size(), 0);
  std::vector<bool> reached;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t group = groups.root(i);
    if (number[group] == 0) {
      reached.push_back(!rim[group].cut && spaces.root(group) == spaces.root(outside));
      number[group] = static_cast<std::uint32_t>(reached.size());
    }
    pieces[i].component = number[group] - 1;
  }
  return reached;
}

}  // namespace gabarit
