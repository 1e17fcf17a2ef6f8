// extract, map and export: from scans to the files that other programs open.
#include <gmock/gmock.h>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ModelTest : public ProgramTest {
 protected:
  void Register() const {
    Must(
        "register builtin:tour --set input.tour.scans=2 --set input.tour.scanner.slices=96 "
        "--set output.figures=false -q --out run");
  }
};

TEST_F(ModelTest, OfARunIsTheSameEveryTime) {
  Register();
  const std::string options = " -q --set octree.leaf_size=0.1 --set octomap.resolution=0.2";
  EXPECT_THAT(Must("map run" + options), HasSubstr("floor:    2 surfaces"));
  Must("map run --out again" + options);
  fs::rename(folder_ / "run/model", folder_ / "model");
  ExpectSameFiles("model", "again");
  for (const char* file : {"building.dxf", "building.wrl", "plan_1.50.svg", "mesh.ply", "mesh.glb",
                           "voxels.ply", "map.bt", "grid.pgm", "grid.yaml", "surfaces.csv", "README.txt"})
    EXPECT_TRUE(fs::exists(folder_ / "model" / file)) << file;
}

TEST_F(ModelTest, IsExportedInEachFormat) {
  Register();
  for (const char* format : {"dxf", "svg", "vrml", "ply", "glb", "pgm"})
    EXPECT_THAT(Must(std::string("export run --to ") + format), HasSubstr(" bytes\n")) << format;
  EXPECT_THAT(Content("run/plan.svg"), HasSubstr("<svg"));
  EXPECT_THAT(Content("run/model.wrl"), StartsWith("#VRML V2.0 utf8"));
  Must("export run --to bt --set octomap.resolution=0.2 --out out.bt");
  EXPECT_THAT(Content("out.bt"), HasSubstr("Octomap OcTree"));
  Must("export run --to dxf --part voxels --set octree.leaf_size=0.3 --out voxels.dxf");
  EXPECT_THAT(Content("voxels.dxf"), HasSubstr("3DFACE"));
}

TEST_F(ModelTest, WhatCannotBeIsSaid) {
  Register();
  const Ended unfit = Ariadne("export run --to svg --part mesh");
  EXPECT_EQ(unfit.status, 1);
  EXPECT_EQ(unfit.err, "ariadne: svg files hold no mesh; they hold: plan\n");
  EXPECT_THAT(Ariadne("export run --to xls").err, HasSubstr("dxf, svg, vrml, ply, glb, bt, ot, pgm"));
  EXPECT_THAT(Ariadne("export none --to dxf").err, HasSubstr("none/config.yaml"));
  EXPECT_THAT(Ariadne("map none -q").err, HasSubstr("none/config.yaml"));
  EXPECT_FALSE(fs::exists(folder_ / "none"));
  EXPECT_EQ(Ariadne("map run -q --set octree.leaf=0.1").status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "run/model"));
}

TEST_F(ModelTest, ScansWithoutSlicesAreToldWhatToDo) {
  WriteTwoScans("scans");
  const Ended ended = Ariadne("extract scans -q --out lines");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("surfaces.extract.method=region_growing"));
  Must("extract scans -q --out regions --set surfaces.extract.method=region_growing");
  EXPECT_THAT(Content("regions/surfaces.csv"), StartsWith("scan,class,normal_x"));
}

}  // namespace
}  // namespace ariadne
