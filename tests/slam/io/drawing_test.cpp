#include <gmock/gmock.h>

#include <boost/property_tree/xml_parser.hpp>
#include <limits>
#include <locale>
#include <map>

#include "slam/io/dxf.h"
#include "slam/io/dxf_colors.h"
#include "slam/io/export.h"
#include "slam/io/svg.h"
#include "slam/io/vrml.h"
#include "slam/io/writable_drawing.h"
#include "tests/slam/io/drawings.h"
#include "tests/slam/io/other_programs.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::StartsWith;
using testing::UnorderedElementsAre;

struct DrawingWriter {
  std::string name;
  std::function<void(const fs::path&, const Drawing&)> write;
};

const std::vector<DrawingWriter> kDrawingWriters{
    {"plan.dxf", [](const fs::path& path, const Drawing& drawing) { WriteDxf(path, drawing); }},
    {"plan.svg", [](const fs::path& path, const Drawing& drawing) { WriteSvg(path, drawing); }},
    {"plan.wrl", [](const fs::path& path, const Drawing& drawing) { WriteVrml(path, drawing); }}};

/// The groups of a DXF file: a code, and the value on the line below.
std::vector<std::pair<int, std::string>> DxfGroups(const std::string& text) {
  std::vector<std::pair<int, std::string>> groups;
  std::istringstream lines(text);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    std::size_t used = 0;
    groups.emplace_back(std::stoi(code, &used), value);
    EXPECT_EQ(used, code.size()) << code;
  }
  return groups;
}

/// An entity of a DXF file, with all its groups by their codes.
using DxfEntity = std::multimap<int, std::string>;

std::vector<DxfEntity> DxfEntities(const std::string& text) {
  std::vector<DxfEntity> entities;
  for (const auto& [code, value] : DxfGroups(text)) {
    if (code == 0) entities.emplace_back();
    if (!entities.empty()) entities.back().emplace(code, value);
  }
  return entities;
}

std::string ValueOf(const DxfEntity& entity, int code) {
  const auto found = entity.find(code);
  return found == entity.end() ? "" : found->second;
}

TEST(Dxf, IsReadByAssimp) {
  ARIADNE_REQUIRE_PROGRAM("assimp");
  const TemporaryFolder folder;
  WriteDxf(folder / "plan.dxf", SmallDrawing());
  const AssimpInfo info = InfoByAssimp(folder / "plan.dxf");  // without points, and with y up: (x, z, -y)
  EXPECT_THAT(info.faces, ElementsAre(5 + 12));               // edges: a line, the open outline; triangles
  EXPECT_THAT(info.low, ElementsAre(0.0, 0.0, -4.0));
  EXPECT_THAT(info.high, ElementsAre(5.0, 1.75, 1.0));
}

TEST(Dxf, HasEntitiesInLayers) {
  const TemporaryFolder folder;
  WriteDxf(folder / "plan.dxf", SmallDrawing());
  const std::string text = ContentOf(folder / "plan.dxf");
  EXPECT_THAT(text, HasSubstr("9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n6\n9\n$EXTMIN\n10\n-3.5000\n"));
  std::map<std::string, int> counts;
  for (const DxfEntity& entity : DxfEntities(text)) ++counts[ValueOf(entity, 0) + " " + ValueOf(entity, 8)];
  std::erase_if(counts,
                [](const auto& count) { return count.first.back() == ' '; });  // tables and sections
  EXPECT_THAT(counts, UnorderedElementsAre(Pair("POINT scan-000", 3), Pair("LINE walls", 1),
                                           Pair("POLYLINE walls", 2), Pair("VERTEX walls", 7),
                                           Pair("SEQEND walls", 2), Pair("3DFACE objects", 12)));
}

TEST(Dxf, ClosesOutlinesAndColorsFaces) {
  const TemporaryFolder folder;
  WriteDxf(folder / "plan.dxf", SmallDrawing());
  std::vector<std::string> flags, layer_colors;
  for (const DxfEntity& entity : DxfEntities(ContentOf(folder / "plan.dxf"))) {
    if (ValueOf(entity, 0) == "POLYLINE") flags.push_back(ValueOf(entity, 70));
    if (ValueOf(entity, 0) == "LAYER") layer_colors.push_back(ValueOf(entity, 62));
    if (ValueOf(entity, 0) == "3DFACE") {
      EXPECT_NE(ValueOf(entity, 62), "");
      EXPECT_EQ(ValueOf(entity, 13), ValueOf(entity, 12));  // the fourth corner is the third
    }
  }
  EXPECT_THAT(flags, ElementsAre("9", "8"));
  EXPECT_THAT(layer_colors, ElementsAre("1", "7", "3"));
}

TEST(DxfColors, ArePaletteEntries) {
  EXPECT_EQ(NearestAci({250, 4, 3}), 1);
  EXPECT_EQ(NearestAci({0, 0, 0}), 7);
  EXPECT_EQ(NearestAci({255, 255, 255}), 7);
  EXPECT_EQ(NearestAci({255, 127, 0}), 30);  // the orange of the palette
  for (int number = 1; number <= 255; ++number) {
    const Rgb color = ColorOfAci(number);
    EXPECT_EQ(ColorOfAci(NearestAci(color)), color) << number;
  }
}

using boost::property_tree::ptree;

ptree ReadXml(const fs::path& path) {
  ptree tree;
  boost::property_tree::read_xml(path.string(), tree);
  return tree;
}

TEST(Svg, IsXmlWithLayersToScale) {
  const TemporaryFolder folder;
  WriteSvg(folder / "plan.svg", SmallDrawing(), {.scale = 50.0, .margin = 7.0});
  const ptree svg = ReadXml(folder / "plan.svg").get_child("svg");
  EXPECT_EQ(svg.get<std::string>("<xmlattr>.width"), "184.00mm");   // 8.5 m at 1:50, and two margins
  EXPECT_EQ(svg.get<std::string>("<xmlattr>.height"), "126.00mm");  // 5 m, two margins, the scale bar
  std::map<std::string, ptree> layers;
  for (const auto& [name, child] : svg) {
    if (name == "g") layers[child.get<std::string>("<xmlattr>.inkscape:label")] = child;
  }
  ASSERT_EQ(layers.size(), 4U);
  EXPECT_EQ(layers["walls"].count("polyline"), 2U);
  EXPECT_EQ(layers["walls"].get<std::string>("polygon.<xmlattr>.points"),
            "0.0000,0.0000 5.0000,0.0000 5.0000,4.0000 0.0000,4.0000");
  EXPECT_EQ(layers["walls"].get<std::string>("<xmlattr>.inkscape:groupmode"), "layer");
  // x = -3.5 m is at the left margin, y = -1 m above the lower one and the scale bar.
  EXPECT_EQ(layers["walls"].get<std::string>("<xmlattr>.transform"), "matrix(20 0 0 -20 77.0000 87.0000)");
  const auto points = layers["scan-000"].get<std::string>("path.<xmlattr>.d");
  EXPECT_EQ(std::ranges::count(points, 'M'), 3);
  EXPECT_THAT(points, HasSubstr("M-3.5000 4.0000h0"));
  const auto triangles = layers["objects"].get<std::string>("path.<xmlattr>.d");
  EXPECT_EQ(std::ranges::count(triangles, 'Z'), 12);
  EXPECT_EQ(layers["scale"].get<std::string>("path.<xmlattr>.d"), "M7.00 117.00v2h40.00v-2");
  EXPECT_EQ(layers["scale"].get<std::string>("text"), "2 m, 1:50");
}

TEST(Svg, IsReadByXmllint) {
  ARIADNE_REQUIRE_PROGRAM("xmllint");
  const TemporaryFolder folder;
  WriteSvg(folder / "plan.svg", SmallDrawing());
  EXPECT_EQ(OutputOf("xmllint --noout " + (folder / "plan.svg").string()), "");
}

TEST(Svg, TakesADrawingOfOnePoint) {
  const TemporaryFolder folder;
  Drawing drawing;
  drawing.layers.push_back({"a", {}, {{1e5, -1e5, 0.0}}, {}, {}});
  WriteSvg(folder / "plan.svg", drawing);
  EXPECT_EQ(ReadXml(folder / "plan.svg").get<std::string>("svg.<xmlattr>.viewBox"), "0 0 80.00 32.00");
}

/// Counts of points, vertices, lines and polygons, and bounds, per actor of VTK's VRML importer.
constexpr const char* kVtkScript = R"(
import sys
from vtkmodules.vtkIOImport import vtkVRMLImporter
import vtkmodules.vtkRenderingOpenGL2
importer = vtkVRMLImporter()
importer.SetFileName(sys.argv[1])
importer.Read()
actors = importer.GetRenderer().GetActors()
actors.InitTraversal()
for i in range(actors.GetNumberOfItems()):
    d = actors.GetNextActor().GetMapper().GetInput()
    print(d.GetNumberOfPoints(), d.GetNumberOfVerts(), d.GetNumberOfLines(), d.GetNumberOfPolys(),
          *["%.4g" % b for b in d.GetBounds()])
)";

TEST(Vrml, IsReadByVtk) {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOImport' >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "python3-vtk9 is not installed, the one reader of VRML in Debian that needs no display";
  }
  const TemporaryFolder folder;
  const fs::path script = folder.Write("read.py", kVtkScript);
  const auto read = [&](const char* name) {
    return OutputOf("/usr/bin/python3 " + script.string() + " " + (folder / name).string());
  };
  WriteVrml(folder / "drawing.wrl", SmallDrawing());
  EXPECT_EQ(read("drawing.wrl"),
            "3 3 0 0 -3.5 1 0 4 0 1\n9 0 3 0 0 5 0 4 0 0\n8 0 0 12 1 3 -1 2 0.25 1.75\n");
  WriteVrml(folder / "mesh.wrl", ColoredBox());
  EXPECT_EQ(read("mesh.wrl"), "8 0 0 12 1 3 -1 2 0.25 1.75\n");
}

TEST(Vrml, IsReadByTovrmlx3d) {
  ARIADNE_REQUIRE_PROGRAM("tovrmlx3d");
  const TemporaryFolder folder;
  WriteVrml(folder / "plan.wrl", SmallDrawing());
  const std::string x3d = OutputOf("tovrmlx3d --encoding=xml " + (folder / "plan.wrl").string());
  EXPECT_THAT(x3d, HasSubstr("coordIndex=\"0 1 -1 2 3 4 5 2 -1 6 7 8 -1\""));
  EXPECT_THAT(x3d, HasSubstr("DEF=\"layer_scan-000\""));
}

TEST(Vrml, ClosesWhatItOpens) {
  const TemporaryFolder folder;
  WriteVrml(folder / "plan.wrl", SmallDrawing());
  const std::string text = ContentOf(folder / "plan.wrl");
  EXPECT_THAT(text, StartsWith("#VRML V2.0 utf8\n"));
  std::string open;
  for (const char c : text) {
    if (c == '{' || c == '[') open += c;
    if (c != '}' && c != ']') continue;
    ASSERT_FALSE(open.empty());
    EXPECT_EQ(open.back(), c == '}' ? '{' : '[');
    open.pop_back();
  }
  EXPECT_EQ(open, "");
  EXPECT_THAT(text, HasSubstr("DEF layer_walls Group"));
  EXPECT_THAT(text, HasSubstr("\n2 3 4 5 2 -1\n"));  // the outline, closed
  EXPECT_THAT(text, HasSubstr("color Color { color [\n0.000 0.392 1.000\n"));
  EXPECT_THAT(text, HasSubstr("coordIndex [\n0 2 1 -1\n"));
}

/// Damages a drawing, and expects the sentence from each of the writers, and no file.
void ExpectRefused(const std::function<void(Drawing&)>& damage, const std::string& sentence) {
  Drawing drawing = SmallDrawing();
  damage(drawing);
  for (const DrawingWriter& writer : kDrawingWriters) {
    const TemporaryFolder folder;
    const std::string error = ErrorOf([&] { writer.write(folder / writer.name, drawing); });
    EXPECT_EQ(error, (folder / writer.name).string() + ": cannot be written: " + sentence);
    EXPECT_TRUE(fs::is_empty(folder.path()));
  }
}

TEST(Drawings, AreRefusedWhereTheyAreDamaged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused([](Drawing& d) { d = {}; }, "the drawing is empty");
  ExpectRefused([](Drawing& d) { d.layers = {{"a", {}, {}, {}, {}}}; }, "the drawing is empty");
  ExpectRefused(
      [&](Drawing& d) { d.layers[0].points[1].y() = nan; },
      "point 1 of layer 'scan-000' is (1, nan, 0.5) m; a place must be finite and within 1000 km");
  ExpectRefused([](Drawing& d) { d.layers[1].lines[0].points[1].x() = -2e6; },
                "line point 1 of layer 'walls' is (-2000000, 0, 0) m; a place must be finite and within "
                "1000 km");
  ExpectRefused([](Drawing& d) { d.layers[1].lines[0].points.pop_back(); },
                "a line of layer 'walls' has fewer than two points");
  ExpectRefused([](Drawing& d) { d.layers[2].mesh.triangles[3][2] = 8; },
                "triangle 3 of layer 'objects' names vertex 8, but there are only 8");
  ExpectRefused([](Drawing& d) { d.layers[2].mesh.colors.pop_back(); },
                "7 colours for 8 vertices of layer 'objects'; give one per vertex or none");
  ExpectRefused([](Drawing& d) { d.layers[0].name = "WALLS"; },
                "two layers are named 'walls', if case does not count");
  for (const std::string name :
       {"", "a b", "a/b", "a<b", "W\xc3\xa4nde", "0123456789012345678901234567890x"}) {
    ExpectRefused([&](Drawing& d) { d.layers[0].name = name; },
                  "a layer cannot be named '" + name + "'; use 1 to 31 letters, digits, '_' and '-'");
  }
}

TEST(Drawings, LeaveTheOldFileWhereTheNewOneFails) {
  for (const DrawingWriter& writer : kDrawingWriters) {
    const TemporaryFolder folder;
    folder.Write(writer.name, "old");
    Drawing damaged = SmallDrawing();
    damaged.layers[0].points[0].x() = std::numeric_limits<double>::infinity();
    ErrorOf([&] { writer.write(folder / writer.name, damaged); });
    EXPECT_EQ(ContentOf(folder / writer.name), "old");
    if (!fs::exists("/dev/full")) continue;
    fs::remove(folder / writer.name);
    fs::create_symlink("/dev/full", folder / writer.name);
    EXPECT_THAT(ErrorOf([&] { writer.write(folder / writer.name, SmallDrawing()); }),
                HasSubstr("cannot be written: No space left on device"));
  }
}

struct CommaAndGroups : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

TEST(Drawings, HaveTheSameBytesInEveryLocale) {
  for (const DrawingWriter& writer : kDrawingWriters) {
    const TemporaryFolder folder;
    writer.write(folder / writer.name, SmallDrawing());
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaAndGroups));
    writer.write(folder / ("german_" + writer.name), SmallDrawing());
    std::locale::global(before);
    EXPECT_EQ(ContentOf(folder / ("german_" + writer.name)), ContentOf(folder / writer.name));
  }
}

TEST(Export, KnowsItsFormats) {
  for (const ExportFormatInfo& info : ExportFormats()) {
    EXPECT_EQ(&InfoOf(info.format), &info);
    EXPECT_EQ(ExportFormatFromName(info.name), info.format);
    EXPECT_EQ(ExportFormatFromName(info.extension), info.format);
  }
  EXPECT_EQ(ExportFormatFromName("wrl"), ExportFormat::kVrml);
  EXPECT_EQ(ErrorOf([] { ExportFormatFromName("dwg"); }),
            "there is no export format named 'dwg'; use one of dxf, svg, vrml, ply, glb, bt, ot, pgm");
}

}  // namespace
}  // namespace ariadne::slam
