#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Ax2.hxx>

#include "checks/edge_pieces.h"
#include "model/brep_curve.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

class EdgePiecesOf : public step_shapes::StepFiles {};

TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
  gp_Trsf t;
  t.SetMirror(gp_Ax2({0, 0, 0}, {0, 1, 0}));
  return BRepBuilderAPI_Transform(shape, t, Standard_True);
}

// A closed edge begins where it ends, and runs either way round.
TEST_F(EdgePiecesOf, closed_rims_follow_their_curve_all_the_way_round) {
  const TopoDS_Shape tube = step_shapes::tube(10, 8, 30);
  for (const TopoDS_Shape& shape : {tube, step_shapes::as_splines(tube), mirrored(tube),
                                    mirrored(step_shapes::as_splines(tube)), step_shapes::turned(tube, 33)}) {
    const Model model = step_shapes::loaded(step(shape));
    const BrepView brep = view(*model.brep);
    const EdgePieces found = edge_pieces(model);
    EXPECT_GT(found.pieces.size(), 40U);
    for (const EdgePiece& piece : found.pieces) {
      ASSERT_NE(piece.edge, no_number) << piece.a.x << ' ' << piece.a.y;
      const Curve& curve = brep.curves[brep.edges[piece.edge].curve];
      EXPECT_LT(length(curve_point(brep, curve, piece.first).p - piece.a), 1e-6);
      EXPECT_LT(length(curve_point(brep, curve, piece.last).p - piece.b), 1e-6);
    }
  }
}

}  // namespace
}  // namespace gabarit
