#include <memory>

#include <fmt/format.h>

#include "cli/brep_text.h"
#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "cli/model_options.h"
#include "report/number_text.h"

namespace gabarit {

static std::string point(const Vec3d& p) {
  return fmt::format("({}, {}, {})", number_text(p.x), number_text(p.y), number_text(p.z));
}

static std::string shape_text(const Model& model) {
  const Vec3d size = model.box.extent();
  return fmt::format(
      "facets       {}\nvertices     {}\nbodies       {}\nbox          {} to {} mm\nsize         {} × {} × "
      "{} mm\n",
      model.mesh.facet_count(), model.mesh.vertices.size(), model.bodies.size(), point(model.box.min),
      point(model.box.max), number_text(size.x), number_text(size.y), number_text(size.z));
}

static std::string defects_text(const Model& model) {
  const Defects& d = model.defects;
  return fmt::format(
      "watertight   {}\ndefects      {} facets not finite, {} degenerate, {} duplicate; "
      "edges: {} open, {} non-manifold, {} misoriented\n",
      watertight(d) ? "yes" : "no", d.not_finite, d.degenerate, d.duplicate, d.open_edges,
      d.non_manifold_edges, d.misoriented_edges);
}

static int run_info(const ModelOptions& options) {
  Progress progress(progress_is_visible());
  const Result<Model> model = options.load_model(progress);
  if (!model) return exit_bad_input;
  print_result(
      fmt::format(
          "file         {}\nsha256       {}\nformat       {}\nunit         {} ({})\nsag          {}\n",
          model->file, model->sha256, model->format, name(model->unit),
          model->unit_declared ? "declared" : "assumed",
          model->sag ? number_text(*model->sag) + " mm" : "not declared") +
      shape_text(*model) + brep_text(*model) + defects_text(*model));
  return exit_clean;
}

Command info_command(CLI::App& app) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* const command = app.add_subcommand("info", "Say what a model file holds, and its defects.");
  options->add_file_to(*command);
  options->add_options_to(*command);
  return {command, [options] { return run_info(*options); }};
}

}  // namespace gabarit
