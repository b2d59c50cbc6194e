#include "checks/ball_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/ray_exits.h"
#include "gpu/maximal_sphere.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Contacts nearer than this share of the model's size are the surface itself.
constexpr double floor_share = 1e-6;
constexpr float greatest_tilt = 0.49F;  // radians, of a query

// Of one contact, when the point moves in its plane as far as the cell reaches and the direction tilts: a
// bound while the contact still counts there, as one on a facet does.
double greatest_around(const CellQuery& query, const SphereContact& found, double reach) {
  const Vec3d q = found.contact - query.point;
  const double h = dot(query.direction, q), qq = squared_length(q), tilt = query.tilt;
  const double aside = std::sqrt(std::max(0.0, qq - h * h)), farther = aside + reach;
  const auto turned = [&](double off) { return 1 - 0.5 * tilt * tilt - off / h * tilt; };
  if (!(turned(farther) > 0)) return infinity;
  return found.upper * (h * h + farther * farther) / qq * turned(aside) / turned(farther);
}

class BallProbe {
 public:
  BallProbe(const ContactSurface& surface, const BallOptions& options)
      : surface_(&surface), options_(options) {}

  void operator()(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    std::vector<SphereQuery> spheres(queries.size());
    for_each(queries, [&](std::size_t i) { spheres[i] = sphere(queries[i], queries[i].direction); });
    std::vector<SphereContact> found = balls(spheres);
    ask_again_across_folds(queries, found);
    for_each(queries, [&](std::size_t i) { answers[i] = answer(queries[i], found[i]); });
    mark_open(queries, answers);
  }

 private:
  template <class Work>
  void for_each(std::span<const CellQuery> queries, const Work& work) const {
    parallel_for_cpu(
        surface_->tree.device(), static_cast<std::int64_t>(queries.size()),
        [&](std::int64_t i) { work(static_cast<std::size_t>(i)); }, 4096);
  }

  SphereQuery sphere(const CellQuery& q, const Vec3d& direction) const {
    const bool around = options_.extreme == Extreme::smallest;
    const double lean = std::atan2(length(cross(q.direction, direction)), dot(q.direction, direction));
    const double tilt = std::min(static_cast<double>(greatest_tilt), static_cast<double>(q.tilt) + lean);
    return {q.point, direction, q.facet, q.sag, around ? q.spacing : 0.0F, static_cast<float>(tilt)};
  }

  std::vector<SphereContact> balls(std::span<const SphereQuery> spheres) const {
    std::vector<SphereContact> found(spheres.size());
    maximal_spheres(surface_->tree,
                    {.cos_separation = std::cos(options_.separation),
                     .greatest_radius = options_.greatest / 2,
                     .contact_floor = floor_share * surface_->size},
                    spheres, found);
    return found;
  }

  // A contact in front of the facet is reached from the wrong side of it: neighbours fold, and their smooth
  // normals lean too far. The facet speaks for itself there.
  void ask_again_across_folds(std::span<const CellQuery> queries, std::span<SphereContact> found) const {
    std::vector<SphereQuery> spheres;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const CellQuery& q = queries[i];
      if (found[i].primitive == SphereContact::none || dot(found[i].contact - q.point, q.across) > 0)
        continue;
      spheres.push_back(sphere(q, q.across));
      number.push_back(i);
    }
    const std::vector<SphereContact> again = balls(spheres);
    for (std::size_t i = 0; i < number.size(); ++i) found[number[i]] = again[i];
  }

  CellAnswer answer(const CellQuery& query, const SphereContact& found) const {
    CellAnswer answer{2 * found.radius, 2 * found.lower, 2 * found.upper, infinity, found.contact};
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

  // In a mesh that is not closed, where the ray along the normal leaves by a gap. In a closed one a ball that
  // nothing stops has no wall opposite, however large it grows, when that ray ends on the back of a wall.
  void mark_open(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    std::vector<CellQuery> asked;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (surface_->closed && answers[i].absence != Absence::open) continue;
      asked.push_back(queries[i]);
      number.push_back(i);
    }
    const std::vector<Exit> exits = exits_of(*surface_, asked, floor_share * surface_->size);
    for (std::size_t k = 0; k < number.size(); ++k) {
      Absence& absence = answers[number[k]].absence;
      const bool escapes = exits[k] == Exit::none && options_.side == Side::inside;
      if (surface_->closed && exits[k] == Exit::right && options_.extreme == Extreme::smallest)
        absence = Absence::none;
      if (!surface_->closed && (exits[k] == Exit::wrong || escapes)) absence = Absence::open;
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
