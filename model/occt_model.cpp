#include "model/occt_model.h"

#include <algorithm>
#include <map>

#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp_Explorer.hxx>
#include <fmt/format.h>

#include "model/brep_deviation.h"
#include "model/collapsed_facets.h"
#include "model/occt_tessellation.h"
#include "model/occt_topology.h"
#include "model/split_facets.h"

namespace gabarit {
namespace {

constexpr double default_sag = 0.05;       // mm
constexpr double default_fraction = 1e-3;  // of the longest side of the box
constexpr double least_fraction = 1e-6;    // likewise
constexpr double deviation_margin = 1.1;   // of the true greatest deviation over that of the samples
constexpr double least_sag = 1e-6;         // mm; nothing is known better than that
constexpr int tessellation_rounds = 4;
constexpr std::uint64_t most_split_facets = 5'000'000;

double longest_side(const std::vector<OcctPart>& parts) {
  Bnd_Box box;
  for (const OcctPart& part : parts) BRepBndLib::Add(part.shape, box, Standard_False);
  if (box.IsVoid() || box.IsOpen()) return 0;
  const gp_XYZ size = box.CornerMax().XYZ() - box.CornerMin().XYZ();
  return std::max({size.X(), size.Y(), size.Z()});
}

// A damaged file may hold a part as large as a planet: even that gets a number of facets that can be made.
double sag_for(double longest) {
  if (!(longest > 0)) return default_sag;
  return std::max({least_sag, std::min(default_sag, default_fraction * longest), least_fraction * longest});
}

class Filling {
 public:
  Filling(std::vector<OcctPart> parts, OcctNames names, const std::string& file, const LoadOptions& options,
          const Handle(OcctProgress) & progress, Model& model)
      : parts_(std::move(parts)),
        names_(std::move(names)),
        file_(file),
        options_(&options),
        progress_(progress),
        model_(&model) {}

  Diagnostics run() {
    repair();
    for (const OcctPart& part : parts_) model_->bodies.push_back(part.name);
    if (progress_->time_is_over()) return out_of_time(file_, *options_);
    model_->brep.emplace();
    model_->brep->invalid_bodies = invalid_;
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      first_face_.push_back(static_cast<FaceId>(model_->brep->faces.size()));
      add_topology(parts_[i].shape, i, *model_->brep);
      names_.add_labels(parts_[i].shape, model_->brep->labels);
    }
    tessellate();
    if (progress_->time_is_over()) return out_of_time(file_, *options_);
    face_outwards();
    report();
    return {};
  }

 private:
  void warn(std::string message, Diagnostic::Level level = Diagnostic::Level::warning) {
    model_->warnings.push_back({.level = level, .file = file_, .message = std::move(message)});
  }

  // Repairs what is invalid and nothing else. Instances of one product are checked once.
  void repair() {
    std::map<const void*, std::pair<TopoDS_Shape, bool>> known;  // and whether it was valid
    for (OcctPart& part : parts_) {
      const TopLoc_Location at = part.shape.Location();
      const auto [it, is_new] =
          known.try_emplace(part.shape.TShape().get(), part.shape.Located(TopLoc_Location()), true);
      if (is_new) it->second = valid(it->second.first, part.name);
      part.shape = it->second.first.Located(at * it->second.first.Location());
      invalid_ += it->second.second ? 0 : 1;
    }
  }

  std::pair<TopoDS_Shape, bool> valid(const TopoDS_Shape& shape, const std::string& name) {
    if (BRepCheck_Analyzer(shape).IsValid()) return {shape, true};
    ShapeFix_Shape fix(shape);
    fix.Perform(progress_->start(0.5, 0.5));
    const TopoDS_Shape fixed = fix.Shape();
    names_.hand_on(shape, [&](const TopoDS_Shape& part) { return fix.Context()->Apply(part); });
    const bool whole = !fixed.IsNull() && TopExp_Explorer(fixed, TopAbs_FACE).More();
    const bool good = whole && BRepCheck_Analyzer(fixed).IsValid();
    warn(fmt::format("body '{}' is not valid as it stands in the file; {}", name,
                     good ? "OpenCASCADE repaired it"
                          : "OpenCASCADE could not repair it: what is measured near the fault may be wrong"));
    return {whole ? fixed : shape, false};
  }

  void tessellate() {
    const double asked = options_->sag.value_or(sag_for(longest_side(parts_)));
    std::vector<double> deflections(parts_.size(), asked);
    for (int round = 1; round <= tessellation_rounds && !progress_->time_is_over(); ++round) {
      make_facets(deflections, 0.5 + 0.04 * round);
      bool enough = true;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (deviation_[i] * deviation_margin <= asked) continue;
        enough = false;
        deflections[i] *= std::max(0.2, 0.7 * asked / (deviation_[i] * deviation_margin));
        if (round < tessellation_rounds) BRepTools::Clean(parts_[i].shape);
      }
      if (enough) break;
    }
    const double reached = deviation_margin * *std::max_element(deviation_.begin(), deviation_.end());
    model_->sag = std::max(least_sag, reached);
    if (reached > asked)
      warn(fmt::format("a sag of {:.4g} mm was asked for, {:.4g} mm were reached", asked, reached));
  }

  void make_facets(const std::vector<double>& deflections, double progress) {
    Brep& brep = *model_->brep;
    model_->mesh = {};
    brep.facets.clear();
    first_facet_.clear();
    deviation_.clear();
    facets_ = {};
    cut_off_ = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const TessellationOptions options{.sag = deflections[i]};
      triangulate(parts_[i].shape, options, progress_->start(progress, progress));
      const auto first = static_cast<FacetId>(model_->mesh.facet_count());
      first_facet_.push_back(first);
      const Tessellation made = append_facets(parts_[i].shape, static_cast<std::uint32_t>(i), first_face_[i],
                                              model_->mesh, brep.facets);
      const auto last = static_cast<FacetId>(model_->mesh.facet_count());
      flip_collapsed_facets(model_->mesh, brep.facets, first, last);
      for (FacetId f = first; f < last; ++f) settle_poles(brep, brep.facets[f]);
      if (options_->facet_size)
        cut_off_ |=
            !split_facets(brep, *options_->facet_size, most_split_facets, first, model_->mesh, brep.facets);
      facets_.faces_without += made.faces_without;
      facets_.edges_unmatched += made.edges_unmatched;
      deviation_.push_back(
          greatest_deviation(brep, model_->mesh, first, static_cast<FacetId>(model_->mesh.facet_count())));
    }
    first_facet_.push_back(static_cast<FacetId>(model_->mesh.facet_count()));
  }

  // A solid whose facets enclose a negative volume is inside out.
  void face_outwards() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (!parts_[i].solid || volume(i) >= 0) continue;
      Brep& brep = *model_->brep;
      for (FacetId f = first_facet_[i]; f < first_facet_[i + 1]; ++f) {
        std::swap(model_->mesh.facets[f][1], model_->mesh.facets[f][2]);
        std::swap(brep.facets[f].corners[1], brep.facets[f].corners[2]);
      }
      for (Face& face : brep.faces) face.sign = face.body == i ? -face.sign : face.sign;
      turn_edges(static_cast<std::uint32_t>(i));
      warn(fmt::format("body '{}' is inside out in the file; it was turned", parts_[i].name));
    }
  }

  void turn_edges(std::uint32_t body) {
    Brep& brep = *model_->brep;
    for (Edge& e : brep.edges) {
      if (e.faces[0] == no_number || brep.faces[e.faces[0]].body != body) continue;
      std::swap(e.least_turn, e.greatest_turn);
      e.least_turn = -e.least_turn, e.greatest_turn = -e.greatest_turn;
      if (e.kind == EdgeKind::convex)
        e.kind = EdgeKind::concave;
      else if (e.kind == EdgeKind::concave)
        e.kind = EdgeKind::convex;
    }
  }

  // mm³, about the first vertex to keep its digits.
  double volume(std::size_t body) const {
    const TriangleMesh& mesh = model_->mesh;
    if (first_facet_[body] == first_facet_[body + 1]) return 0;
    const Vec3d origin = mesh.corner(first_facet_[body], 0);
    double six = 0;
    for (FacetId f = first_facet_[body]; f < first_facet_[body + 1]; ++f) {
      const auto [a, b, c] = mesh.corners(f);
      six += dot(a - origin, cross(b - origin, c - origin));
    }
    return six / 6;
  }

  void report() {
    const auto open = std::count_if(parts_.begin(), parts_.end(), [](const OcctPart& p) { return !p.solid; });
    if (open > 0)
      warn(fmt::format("{} of {} bodies are open surfaces, not solids: they have no inside", open,
                       parts_.size()));
    if (facets_.faces_without > 0)
      warn(
          fmt::format("{} faces could not be turned into facets: nothing is measured there, and what they "
                      "hide counts as reachable",
                      facets_.faces_without));
    if (facets_.edges_unmatched > 0)
      warn(fmt::format("the facets do not fit together along {} edges", facets_.edges_unmatched));
    if (cut_off_)
      warn(fmt::format("facets of {:g} mm would be more than {} million; their sides are longer",
                       *options_->facet_size, most_split_facets / 1'000'000));
    report_trims();
    if (model_->brep->approximated > 0)
      warn(fmt::format(
               "{} offset surfaces or curves are measured as splines that are within {:.2g} mm of them",
               model_->brep->approximated, model_->brep->approximation_error),
           Diagnostic::Level::note);
  }

  void report_trims() {
    if (model_->brep->untrimmed > 0)
      warn(fmt::format("the curves that bound {} faces are not known: the whole surfaces are taken",
                       model_->brep->untrimmed));
    if (model_->brep->leaky > 0)
      warn(fmt::format("the curves that bound {} faces leave gaps; they were closed by straight lines",
                       model_->brep->leaky));
  }

  std::vector<OcctPart> parts_;
  OcctNames names_;
  std::string file_;
  const LoadOptions* options_;
  Handle(OcctProgress) progress_;
  std::uint64_t invalid_ = 0;
  Model* model_;
  std::vector<FaceId> first_face_;
  std::vector<FacetId> first_facet_;
  std::vector<double> deviation_;
  Tessellation facets_;
  bool cut_off_ = false;  // facets of the size asked for would be too many
};

}  // namespace

Diagnostics out_of_time(const std::string& file, const LoadOptions& options) {
  return {
      {.file = file,
       .message = fmt::format("was not read within {:.0f} s; export only the parts that are to be checked",
                              options.time_limit)}};
}

Diagnostics fill_model(std::vector<OcctPart> parts, OcctNames names, const std::string& file,
                       const LoadOptions& options, const Handle(OcctProgress) & progress, Model& model) {
  if (parts.empty())
    return {{.file = file,
             .message = "holds no solid and no surface that OpenCASCADE 7.6 can read: export it as a "
                        "solid, or as STL"}};
  return Filling(std::move(parts), std::move(names), file, options, progress, model).run();
}

}  // namespace gabarit
