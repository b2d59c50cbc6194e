// Splines and other general surfaces that are pieces of spheres, cylinders and rings.
#pragma once

#include <vector>

#include "gpu/device.h"
#include "model/brep.h"

namespace gabarit {

// By face: 1/r where the face is convex and lies on a sphere, a cylinder or a ring (torus) of tube radius r,
// to 1e-12 of its size; else 0. Only of splines, and of extrusions and revolutions of splines.
//
// A face is measured against the shape at as many places of every span between its knots as make it certain:
// on a span the distance from the shape is a polynomial of four times the surface's degree at most (times
// weights), and a polynomial of degree n that is no greater than e at n + 1 Chebyshev points is nowhere
// greater than 4 e (n <= 100: Rivlin, The Chebyshev Polynomials, 1974). So are its derivatives by Markov's
// inequality, and with them the curvature.
std::vector<double> rolled_balls(const Brep& brep, const Device& device);

}  // namespace gabarit
