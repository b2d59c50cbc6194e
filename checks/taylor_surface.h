// The derivatives of curves and surfaces of a Brep over a whole box of their parameters.
#pragma once

#include "checks/taylor_model.h"
#include "model/brep_view.h"

namespace gabarit {

// Derivatives by x and y, which run from -1 to 1 over the box. For S = A / w: u = A_u w - A w_u and so on, so
// that u and v are w² times the derivatives of S, and uu, uv, vv are so too but for what is tangent to the
// surface.
struct TaylorSurface {
  TaylorVector u, v, uu, uv, vv;
  TaylorModel scale;  // w²
};

// Of a spline, an extrusion or a revolution, inside one span and one turn. The parameter that an extrusion or
// a revolution does not change with is taken for a constant.
TaylorSurface taylor_surface(const BrepView& brep, const Surface& surface, const ParameterBox& box);

}  // namespace gabarit
