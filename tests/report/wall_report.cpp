#include "tests/report/wall_report.h"

#include "checks/clearance.h"
#include "checks/thickness.h"
#include "rules/engine.h"
#include "rules/read_value.h"

namespace gabarit {

WallReport::WallReport(const shapes::Triangles& shape, const Limit& limit, const std::string& measure,
                       const std::string& method)
    : model(shapes::model(shape)) {
  model.file = "part.stl";
  model.bodies = {"body"};
  Rule rule;
  rule.id = "wall";
  rule.title = "Walls";
  rule.require.measure = measure == "thickness" ? &thickness_measure : &clearance_measure;
  rule.require.arguments.set("method", method);
  fill_defaults(rule.require.measure->parameters, rule.require.arguments);
  rule.require.limit = limit;
  rule.require.limit_text = "as the test says";
  RuleSet set;
  set.id = "walls";
  set.rules = {rule};
  outcome = run(model, {set}, {.device = Device::cpu(1)});
}

}  // namespace gabarit
