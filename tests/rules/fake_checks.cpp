#include "tests/rules/fake_checks.h"

#include <cmath>
#include <new>
#include <stdexcept>

namespace gabarit::fake {

namespace {

Region select_beyond(const Scene& scene, const Setup&, const Arguments& arguments) {
  Region region;
  for (FacetId f = 0; f < scene.mesh().facet_count(); ++f) {
    const double beyond_by = scene.mesh().centroid(f).x - arguments.number("from");
    region.facets.push_back(std::abs(beyond_by) < 0.25 ? Selected::maybe
                            : beyond_by > 0            ? Selected::yes
                                                       : Selected::no);
  }
  return region;
}

Region select_probe(const Scene& scene, const Setup& setup, const Arguments&) {
  band_seen = setup.height_band;
  Region region = whole_model(scene.mesh());
  region.depth.assign(region.facets.size(), 1.0F);
  return region;
}

Region select_band(const Scene& scene, const Setup&, const Arguments&) { return whole_model(scene.mesh()); }

Interval band_of(const Arguments& arguments) { return {arguments.number("from"), arguments.number("to")}; }

Region select_broken(const Scene&, const Setup&, const Arguments&) {
  throw std::runtime_error("the probe got stuck");
}

Field measure_altitude(const Scene& scene, const Setup& setup, const Region& region,
                       const Arguments& arguments) {
  Field field;
  for (FacetId f = 0; f < region.facets.size(); ++f) {
    if (region.facets[f] == Selected::no) continue;
    const Vec3d centroid = scene.mesh().centroid(f);
    const double height = setup.frame.height(centroid);
    const bool known = facet_normal(scene.mesh(), f) != Vec3d{};
    field.facets.push_back(f);
    field.value.push_back(known ? height : NAN);
    field.lower.push_back(known ? height - arguments.number("margin") : 0);
    field.upper.push_back(known ? height + arguments.number("margin") : INFINITY);
    field.at.push_back(centroid);
    field.contact.push_back(centroid);
    field.absence.push_back(known ? Absence::none : Absence::degenerate);
  }
  return field;
}

Field measure_greedy(const Scene&, const Setup&, const Region&, const Arguments&) { throw std::bad_alloc(); }

Field measure_broken(const Scene&, const Setup&, const Region&, const Arguments&) {
  throw std::runtime_error("the ball was lost");
}

Field measure_forgetful(const Scene& scene, const Setup& setup, const Region& region,
                        const Arguments& arguments) {
  Field field = measure_altitude(scene, setup, region, arguments);
  field.resize(field.size() - 1);
  return field;
}

const std::vector<Parameter> margin{{.name = "margin",
                                     .dimension = Dimension::length,
                                     .documentation = "How far the bounds stand off.",
                                     .default_text = "0 mm"}};

Measure measure(const std::string& name,
                Field (*function)(const Scene&, const Setup&, const Region&, const Arguments&)) {
  return {.name = name,
          .summary = "A measure for tests.",
          .documentation = "",
          .symbol = "h",
          .dimension = Dimension::length,
          .parameters = margin,
          .measure = function};
}

}  // namespace

Interval band_seen;

const Selector beyond{
    .name = "beyond",
    .variant = "",
    .summary = "The far end.",
    .documentation = "",
    .parameters = {{.name = "from", .dimension = Dimension::length, .documentation = "Where it begins."}},
    .select = select_beyond,
    .sentence = [](const Arguments&) { return std::string("it lies at the far end"); }};
const Selector probe{.name = "probe",
                     .variant = "",
                     .summary = "A probe.",
                     .documentation = "",
                     .parameters = {},
                     .select = select_probe};
const Selector band{.name = "band",
                    .variant = "",
                    .summary = "A band.",
                    .documentation = "",
                    .parameters = {},
                    .select = select_band,
                    .height_band = band_of};
const Selector broken_selector{.name = "broken",
                               .variant = "",
                               .summary = "Throws.",
                               .documentation = "",
                               .parameters = {},
                               .select = select_broken};

const Measure altitude = measure("altitude", measure_altitude);
const Measure greedy = measure("greedy", measure_greedy);
const Measure broken = measure("broken", measure_broken);
const Measure forgetful = measure("forgetful", measure_forgetful);

Where where(const Selector& selector, const Arguments& arguments) {
  return {.kind = Where::Kind::selector,
          .children = {},
          .selector = &selector,
          .arguments = arguments,
          .place = {}};
}

static Where tree(Where::Kind kind, std::vector<Where> children) {
  return {.kind = kind, .children = std::move(children), .selector = nullptr, .arguments = {}, .place = {}};
}
Where all(std::vector<Where> children) { return tree(Where::Kind::all, std::move(children)); }
Where any(std::vector<Where> children) { return tree(Where::Kind::any, std::move(children)); }
Where none_of(Where child) { return tree(Where::Kind::none_of, {std::move(child)}); }

Arguments number(const std::string& name, double value) {
  Arguments arguments;
  arguments.set(name, value);
  return arguments;
}

Rule rule(const std::string& id, const Measure& measure, const Limit& limit, double bounds) {
  Rule result;
  result.id = id;
  result.require = {.measure = &measure,
                    .arguments = number("margin", bounds),
                    .limit = limit,
                    .limit_text = "as the test says"};
  return result;
}

RuleSet ruleset(std::vector<Rule> rules) {
  RuleSet result;
  result.id = "test";
  result.rules = std::move(rules);
  return result;
}

Limit at_least(double low) { return {.kind = Limit::Kind::at_least, .low = low, .high = 0}; }
Limit at_most(double high) { return {.kind = Limit::Kind::at_most, .low = 0, .high = high}; }

}  // namespace gabarit::fake
