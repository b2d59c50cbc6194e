#include "checks/ball_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/ray_exits.h"
#include "gpu/maximal_sphere.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Contacts nearer than this share of the model's size are the surface itself.
constexpr double floor_share = 1e-6;

// Of one contact, when the point moves in its plane as far as the cell reaches.
double greatest_around(const CellQuery& query, const SphereContact& found, double reach) {
  const Vec3d q = found.contact - query.point;
  const double h = dot(query.direction, q), qq = squared_length(q);
  const double aside = std::sqrt(std::max(0.0, qq - h * h)) + reach;
  return found.upper * (h * h + aside * aside) / qq;
}

class BallProbe {
 public:
  BallProbe(const ContactSurface& surface, const BallOptions& options)
      : surface_(&surface), options_(options) {}

  void operator()(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    std::vector<SphereQuery> spheres(queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const CellQuery& q = queries[i];
      const bool around = options_.extreme == Extreme::smallest;
      spheres[i] = {q.point, q.direction, q.facet, q.sag, around ? q.spacing : 0.0F, q.tilt};
    }
    std::vector<SphereContact> found(queries.size());
    maximal_spheres(surface_->tree,
                    {.cos_separation = std::cos(options_.separation),
                     .greatest_radius = options_.greatest / 2,
                     .contact_floor = floor_share * surface_->size},
                    spheres, found);
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer(queries[i], found[i]);
    mark_open(queries, answers);
  }

 private:
  CellAnswer answer(const CellQuery& query, const SphereContact& found) const {
    CellAnswer answer{2 * found.radius, 2 * found.lower, 2 * found.upper, infinity, found.contact,
                      Absence::none,    std::nullopt};
    if (found.primitive == SphereContact::none) {
      // A part has an end; a gap need not.
      const bool capped = options_.greatest < 4 * surface_->size;
      answer.value = options_.side == Side::inside && capped ? options_.greatest : infinity;
      answer.upper = infinity;
      answer.contact = query.point;
      if (options_.side == Side::inside && !capped) answer.absence = Absence::open;
      return answer;
    }
    answer.greatest = 2 * greatest_around(query, found, static_cast<double>(query.spacing));
    return answer;
  }

  void mark_open(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    if (surface_->closed) return;
    const std::vector<Exit> exits = exits_of(*surface_, queries, floor_share * surface_->size);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bool escapes = exits[i] == Exit::none && options_.side == Side::inside;
      if (exits[i] == Exit::wrong || escapes) answers[i].absence = Absence::open;
    }
  }

  const ContactSurface* surface_;
  BallOptions options_;
};

}  // namespace

Probe ball_probe(const ContactSurface& surface, const BallOptions& options) {
  return BallProbe(surface, options);
}

}  // namespace gabarit
