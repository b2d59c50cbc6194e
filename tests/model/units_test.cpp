#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::load_bytes;
using mesh_files::said;
using testing::HasSubstr;

Result<Model> cube_of(double size, std::optional<Unit> unit = {}) {
  LoadOptions options;
  options.unit = unit;
  return load_bytes("cube.obj", mesh_files::obj(shapes::box({0, 0, 0}, {size, size / 2, size / 4})), options);
}

TEST(units, are_known_by_name_and_measured_in_millimetres) {
  EXPECT_EQ(millimetres(Unit::mm), 1);
  EXPECT_EQ(millimetres(Unit::cm), 10);
  EXPECT_EQ(millimetres(Unit::m), 1000);
  EXPECT_EQ(millimetres(Unit::in), 25.4);
  for (const Unit unit : {Unit::mm, Unit::cm, Unit::m, Unit::in}) EXPECT_EQ(unit_named(name(unit)), unit);
  EXPECT_FALSE(unit_named("km"));
  EXPECT_FALSE(unit_named("MM"));
}

TEST(units, without_one_are_millimetres_said_as_assumed) {
  const Result<Model> model = cube_of(50);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->unit, Unit::mm);
  EXPECT_FALSE(model->unit_declared);
  EXPECT_EQ(model->box.max, (Vec3d{50, 25, 12.5}));
  EXPECT_EQ(said(model), "");
}

TEST(units, scale_every_format_alike) {
  const shapes::Triangles cube = shapes::box({0, 0, 0}, {2, 1, 0.5});
  LoadOptions options;
  options.unit = Unit::in;
  for (const auto& [file, bytes] : std::vector<std::pair<const char*, std::string>>{
           {"a.stl", mesh_files::binary_stl(cube)},
           {"a.stl", mesh_files::ascii_stl(cube)},
           {"a.obj", mesh_files::obj(cube)},
           {"a.off", mesh_files::off(cube)},
           {"a.ply", mesh_files::ply(cube)},
           {"a.ply", mesh_files::ply(cube, PlyFormat::big_endian)}}) {
    const Result<Model> model = load_bytes(file, bytes, options);
    ASSERT_TRUE(model) << file;
    EXPECT_TRUE(model->unit_declared);
    EXPECT_EQ(model->box.max, (Vec3d{50.8, 25.4, 12.7})) << file;
  }
}

TEST(units, an_implausible_size_names_both_readings) {
  EXPECT_THAT(said(cube_of(2.2)),
              HasSubstr("warning: implausible size: 2.2 mm long in mm as assumed; 2200 mm if the "
                        "file is in metres: give --units m"));
  EXPECT_THAT(said(cube_of(2200, Unit::m)),
              HasSubstr("2200000 mm long in m as declared; 2200 mm if the file is in "
                        "millimetres: give --units mm"));
  EXPECT_THAT(said(cube_of(0.3, Unit::in)),
              HasSubstr("7.62 mm long in in as declared; 300 mm if the file is in metres"));
  EXPECT_THAT(said(cube_of(0.005, Unit::m)),
              HasSubstr("5 mm long in m as declared; a length that no part has"));
  EXPECT_THAT(said(cube_of(200'000)),
              HasSubstr("200000 mm long in mm as assumed; a length that no vehicle has"));
}

TEST(units, plausible_sizes_are_not_warned_of) {
  EXPECT_EQ(said(cube_of(10)), "");
  EXPECT_EQ(said(cube_of(100'000)), "");
  EXPECT_EQ(said(cube_of(18.75, Unit::m)), "");
  EXPECT_EQ(said(cube_of(86, Unit::in)), "");
}

}  // namespace
}  // namespace gabarit
