#include "checks/contact_notes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace gabarit {
namespace {

constexpr double trace_sag = 1;         // mm
constexpr double joined = 1e-3;         // mm between ends that go on in each other
constexpr std::size_t most_places = 5;  // in one sentence

std::vector<Point2> points_of(const PathPiece& piece, double radius) {
  if (!piece.arc) return {piece.from, piece.to};
  const double turn = piece.to_angle - piece.from_angle;
  const double step = 2 * std::acos(std::max(0.0, 1 - trace_sag / radius));
  const int steps = 1 + static_cast<int>(turn / step);
  std::vector<Point2> points{piece.from};
  for (int i = 1; i < steps; ++i) {
    const double angle = piece.from_angle + turn * i / steps;
    points.push_back(piece.centre + Point2{std::cos(angle), std::sin(angle)} * radius);
  }
  points.push_back(piece.to);
  return points;
}

// Finds the piece that goes on where another one ends.
class Chain {
 public:
  explicit Chain(const std::vector<PathPiece>& pieces) : pieces_(pieces), used_(pieces.size(), false) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const Point2 p : {pieces[i].from, pieces[i].to}) ends_.push_back({p, i});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y != b.at.y ? a.at.y < b.at.y : a.piece < b.piece;
    });
  }
  bool used(std::size_t i) const { return used_[i]; }

  // From the piece on, as far as it goes.
  std::vector<Point2> from(std::size_t piece, double radius) {
    used_[piece] = true;
    std::vector<Point2> line = points_of(pieces_[piece], radius);
    for (std::size_t next = after(line.back()); next < pieces_.size(); next = after(line.back())) {
      used_[next] = true;
      std::vector<Point2> more = points_of(pieces_[next], radius);
      if (length(more.back() - line.back()) < length(more.front() - line.back()))
        std::reverse(more.begin(), more.end());
      line.insert(line.end(), more.begin() + 1, more.end());
    }
    return line;
  }

 private:
  struct End {
    Point2 at;
    std::size_t piece;
  };
  std::size_t after(Point2 p) const {
    std::size_t best = pieces_.size();
    double least = joined;
    auto end = std::lower_bound(ends_.begin(), ends_.end(), p.x - joined,
                                [](const End& e, double x) { return e.at.x < x; });
    for (; end != ends_.end() && end->at.x <= p.x + joined; ++end) {
      const double gap = length(end->at - p);
      if (used_[end->piece] || gap > least || (gap == least && best < pieces_.size())) continue;
      least = gap;
      best = end->piece;
    }
    return best;
  }

  const std::vector<PathPiece>& pieces_;
  std::vector<bool> used_;
  std::vector<End> ends_;
};

// Of the facets that are only maybe touched, gathered in cubes as wide as the column.
std::vector<Vec3d> doubtful_places(const Region& region, const TriangleMesh& mesh, double size) {
  std::map<std::array<double, 3>, std::pair<Vec3d, int>> cubes;
  for (FacetId f = 0; f < region.facets.size(); ++f) {
    if (region.facets[f] != Selected::maybe) continue;
    const Vec3d at = mesh.centroid(f);
    auto& [sum, count] = cubes[{std::floor(at.x / size), std::floor(at.y / size), std::floor(at.z / size)}];
    sum += at;
    ++count;
  }
  std::vector<Vec3d> places;
  places.reserve(cubes.size());
  for (const auto& [cube, content] : cubes) places.push_back(content.first / content.second);
  return places;
}

std::string doubt(const Region& region, const TriangleMesh& mesh, double size, const char* cause) {
  const std::vector<Vec3d> places = doubtful_places(region, mesh, size);
  const auto facets = std::count(region.facets.begin(), region.facets.end(), Selected::maybe);
  if (facets == 0) return {};
  std::string text = fmt::format("Whether {} {} touched depends on {}. They lie near ", facets,
                                 facets == 1 ? "facet is" : "facets are", cause);
  for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i) {
    text += fmt::format("{}({:.1f}, {:.1f}, {:.1f}) mm", i > 0 ? ", " : "", places[i].x, places[i].y,
                        places[i].z);
  }
  const std::size_t more = places.size() - std::min(places.size(), most_places);
  return text + (more > 0 ? fmt::format(" and at {} more places.", more) : ".");
}

}  // namespace

static Trace trace_of(const std::vector<Point2>& line, bool closed, const Frame& frame) {
  Trace trace{.name = "path of the column's axis", .points = {}, .closed = closed};
  trace.points.reserve(line.size());
  for (const Point2 p : line) trace.points.push_back(frame.from_vehicle({p.x, p.y, 0}));
  return trace;
}

std::vector<Trace> contact_traces(const DiskPath& path, const Frame& frame) {
  std::vector<Trace> traces;
  for (const Contour& contour : path.contours)
    traces.push_back(trace_of(contour.points, contour.closed, frame));
  if (!traces.empty()) return traces;
  Chain chain(path.pieces);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    if (chain.used(i)) continue;
    const std::vector<Point2> line = chain.from(i, path.radius);
    traces.push_back(trace_of(line, line.size() > 2 && length(line.back() - line.front()) <= joined, frame));
  }
  return traces;
}

std::vector<std::string> contact_notes(const Region& region, const TriangleMesh& mesh,
                                       const PlanProjection& plan, const DiskPath& path, double spacing) {
  std::vector<std::string> notes;
  if (plan.left_out() > 0) {
    notes.push_back(fmt::format("{} {} left out: coordinates that are not finite or beyond 1000 km.",
                                plan.left_out(), plan.left_out() == 1 ? "facet was" : "facets were"));
  }
  if (plan.empty()) {
    notes.push_back("No facet lies within the column's heights, so it touches nothing.");
    return notes;
  }
  notes.push_back(
      spacing > 0 ? fmt::format("The path of the column's axis is known at the {} places where lines {:g} mm "
                                "apart cross it.",
                                path.pieces.size(), spacing)
                  : fmt::format("The column goes around {} separate outline{} of the plan view.",
                                path.components, path.components == 1 ? "" : "s"));
  const char* cause = spacing > 0 ? "the sag and on where the column stands between these lines"
                                  : "the sag: a column larger or smaller by it reaches others";
  if (std::string text = doubt(region, mesh, 2 * path.radius, cause); !text.empty())
    notes.push_back(std::move(text));
  return notes;
}

}  // namespace gabarit
