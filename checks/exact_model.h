// The exact faces of a model and the facets that stand for them, where kernels look at them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "model/brep_view.h"
#include "model/model.h"

namespace gabarit {

struct ExactModelView {
  BrepView brep;
  View<const FacetOrigin> facets;
  View<const std::array<VertexId, 3>> facet_corners;
  View<const Vec3d> vertices;
  View<const double> face_reach;  // mm: twice the greatest tolerance of a face's edges and vertices
};

class ExactModel {
 public:
  // Of a model with a Brep, which must outlive this. On a CPU the model's own arrays serve, elsewhere copies.
  ExactModel(const Model& model, const Device& device);

  const Model& model() const { return *model_; }
  const Device& device() const { return device_; }
  ExactModelView view() const;  // of the device's memory
  // By face: its place in an order that goes by the kinds of surfaces first.
  const std::vector<std::uint32_t>& order_of_faces() const { return order_; }

 private:
  // What a device of its own memory holds.
  struct Copies {
    Buffer<Surface> surfaces;
    Buffer<Curve> curves;
    Buffer<Pole> poles;
    Buffer<double> knots;
    Buffer<Face> faces;
    Buffer<Edge> edges;
    Buffer<BrepVertex> brep_vertices;
    Buffer<std::uint32_t> first_edge_of_face;
    Buffer<EdgeId> edges_of_face;
    Buffer<FaceTrim> trims;
    Buffer<TrimPiece> trim_pieces;
    Buffer<std::uint32_t> trim_bins, trim_listing;
    Buffer<FacetOrigin> facets;
    Buffer<std::array<VertexId, 3>> facet_corners;
    Buffer<Vec3d> vertices;

    Copies(const Device& device, const Model& model);
    ExactModelView view() const;
  };

  const Model* model_;
  Device device_;
  std::vector<std::uint32_t> order_;
  Buffer<double> face_reach_;
  std::optional<Copies> copies_;
};

}  // namespace gabarit
