#include "checks/exact_model.h"

#include <algorithm>
#include <numeric>

namespace gabarit {
namespace {

std::vector<double> face_reaches(const Brep& brep) {
  std::vector<double> reaches(brep.faces.size(), 0);
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    for (std::uint32_t i = brep.first_edge_of_face[f]; i < brep.first_edge_of_face[f + 1]; ++i) {
      const Edge& edge = brep.edges[brep.edges_of_face[i]];
      reaches[f] = std::max(reaches[f], 2 * edge.tolerance);
      for (const std::uint32_t v : edge.vertices)
        if (v != no_number) reaches[f] = std::max(reaches[f], 2 * brep.vertices[v].tolerance);
    }
  }
  return reaches;
}

std::vector<std::uint32_t> order_by_kind(const Brep& brep) {
  std::vector<FaceId> faces(brep.faces.size());
  std::iota(faces.begin(), faces.end(), 0U);
  std::stable_sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) {
    return brep.surfaces[brep.faces[a].surface].kind < brep.surfaces[brep.faces[b].surface].kind;
  });
  std::vector<std::uint32_t> order(faces.size());
  for (std::uint32_t place = 0; place < faces.size(); ++place) order[faces[place]] = place;
  return order;
}

template <class T>
Buffer<T> copy(const Device& device, const std::vector<T>& of) {
  return {device, std::span<const T>(of)};
}

}  // namespace

ExactModel::Copies::Copies(const Device& device, const Model& model)
    : surfaces(copy(device, model.brep->surfaces)),
      curves(copy(device, model.brep->curves)),
      poles(copy(device, model.brep->poles)),
      knots(copy(device, model.brep->knots)),
      faces(copy(device, model.brep->faces)),
      edges(copy(device, model.brep->edges)),
      brep_vertices(copy(device, model.brep->vertices)),
      first_edge_of_face(copy(device, model.brep->first_edge_of_face)),
      edges_of_face(copy(device, model.brep->edges_of_face)),
      trims(copy(device, model.brep->trims)),
      trim_pieces(copy(device, model.brep->trim_pieces)),
      trim_bins(copy(device, model.brep->trim_bins)),
      trim_listing(copy(device, model.brep->trim_listing)),
      facets(copy(device, model.brep->facets)),
      facet_corners(copy(device, model.mesh.facets)),
      vertices(copy(device, model.mesh.vertices)) {}

ExactModelView ExactModel::Copies::view() const {
  return {{surfaces.view(), curves.view(), poles.view(), knots.view(), faces.view(), edges.view(),
           brep_vertices.view(), first_edge_of_face.view(), edges_of_face.view(), trims.view(),
           trim_pieces.view(), trim_bins.view(), trim_listing.view()},
          facets.view(),
          facet_corners.view(),
          vertices.view(),
          {}};
}

ExactModel::ExactModel(const Model& model, const Device& device)
    : model_(&model),
      device_(device),
      order_(order_by_kind(*model.brep)),
      face_reach_(device, face_reaches(*model.brep)) {
  if (device.has_own_memory()) copies_.emplace(device, model);
}

ExactModelView ExactModel::view() const {
  const auto elements = []<class T>(const std::vector<T>& of) {
    return gabarit::view(std::span<const T>(of));
  };
  ExactModelView view = copies_ ? copies_->view()
                                : ExactModelView{gabarit::view(*model_->brep),
                                                 elements(model_->brep->facets),
                                                 elements(model_->mesh.facets),
                                                 elements(model_->mesh.vertices),
                                                 {}};
  view.face_reach = face_reach_.view();
  return view;
}

}  // namespace gabarit
