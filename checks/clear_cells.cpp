#include "checks/clear_cells.h"

#include <algorithm>

namespace gabarit {
namespace {

constexpr double greatest_tilt = 0.49;  // radians, of a cell (CellQuery)

BallOptions looser(BallOptions balls, double by) {
  balls.separation = std::max(0.0, balls.separation - by - 1e-6);
  return balls;
}

class ClearCells {
 public:
  ClearCells(Probe probe, const ContactSurface& surface, const BallOptions& balls,
             const ClearOptions& options)
      : probe_(std::move(probe)),
        of_flat_(ball_probe(surface, looser(balls, options.normal_error))),
        of_curved_(ball_probe(surface, looser(balls, options.normal_error + greatest_tilt))),
        options_(options) {}

  void operator()(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    probe_(queries, answers);
    mark(queries, answers, false, of_flat_);
    mark(queries, answers, true, of_curved_);
  }

 private:
  void mark(std::span<const CellQuery> queries, std::span<CellAnswer> answers, bool curved,
            const Probe& loose) const {
    std::vector<CellQuery> asked;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const CellAnswer& a = answers[i];
      const bool large = 2 * static_cast<double>(queries[i].spacing) > options_.step;
      if ((queries[i].tilt > 0) != curved || !large || a.absence != Absence::none) continue;
      if (!(std::min(a.lower, a.value) >= options_.limit)) continue;
      asked.push_back(queries[i]), number.push_back(i);
    }
    std::vector<CellAnswer> found(asked.size());
    loose(asked, found);
    for (std::size_t k = 0; k < number.size(); ++k)
      answers[number[k]].clear = found[k].absence == Absence::none && found[k].lower >= options_.limit;
  }

  Probe probe_, of_flat_, of_curved_;
  ClearOptions options_;
};

}  // namespace

Probe with_clear_cells(Probe probe, const ContactSurface& surface, const BallOptions& balls,
                       const ClearOptions& options) {
  return ClearCells(std::move(probe), surface, balls, options);
}

}  // namespace gabarit
