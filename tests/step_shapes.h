// Solids made with OpenCASCADE and written to a temporary folder, for the tests of the loaders.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include "model/load.h"
#include "tests/temporary_folder.h"

namespace gabarit::step_shapes {

TopoDS_Shape box(double x, double y, double z);
// With all twelve edges rounded.
TopoDS_Shape rounded_box(double x, double y, double z, double radius);
TopoDS_Shape cylinder(double radius, double height);
TopoDS_Shape tube(double outer, double inner, double height);
TopoDS_Shape cone(double bottom, double height);  // with its apex
TopoDS_Shape sphere(double radius);
TopoDS_Shape torus(double ring, double tube);
// Elliptic; its wall is an extrusion.
TopoDS_Shape elliptic_cylinder(double a, double b, double height);
// Its wall is the extrusion of a closed spline through points at these radii, evenly about z.
TopoDS_Shape lobed_cylinder(const std::vector<double>& radii, double height);
// Every face a rational spline.
TopoDS_Shape as_splines(const TopoDS_Shape& shape);
TopoDS_Shape minus(const TopoDS_Shape& a, const TopoDS_Shape& b);
// A plane polygon, counter-clockwise, swept along z.
TopoDS_Shape prism(const std::vector<std::array<double, 2>>& corners, double height);
TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z);
TopoDS_Shape turned(const TopoDS_Shape& shape, double degrees_about_x);
TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes);  // one compound
// Its closed shell without the first face.
TopoDS_Shape without_a_face(const TopoDS_Shape& shape);

struct NamedShape {
  std::string name;
  TopoDS_Shape shape;
};

class StepFiles : public testing::Test {
 protected:
  void SetUp() override;

  // The file; `unit` is "MM", "INCH" or "M".
  std::filesystem::path step(const TopoDS_Shape& shape, const std::string& unit = "MM") const;
  // A compound of solids as one product instead of an assembly.
  std::filesystem::path one_product(const TopoDS_Shape& solids) const;
  std::filesystem::path iges(const TopoDS_Shape& shape, const std::string& unit = "MM") const;
  // Its faces are by turns red by number and of a defined orange.
  std::filesystem::path painted_iges(const TopoDS_Shape& shape) const;
  // An assembly with one component for each, named through XCAF; equal shapes become instances of one
  // product.
  std::filesystem::path assembly(const std::vector<NamedShape>& parts) const;
  // Two of an assembly of `parts` in an assembly, placed by the two.
  std::filesystem::path nested(const std::vector<NamedShape>& parts, const gp_Trsf& one,
                               const gp_Trsf& other) const;
  std::filesystem::path text(const std::string& name, const std::string& content) const;

  const TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path();
};

// Fails the test when the file cannot be read.
Model loaded(const std::filesystem::path& file, const LoadOptions& options = {});
double volume(const Model& model);
std::string text_of(const std::filesystem::path& file);
// With the first of `what` replaced by the first of `by`, the next by the next.
std::string replaced(std::string content, const std::string& what, const std::vector<std::string>& by);

}  // namespace gabarit::step_shapes
