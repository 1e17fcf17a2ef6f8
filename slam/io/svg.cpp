#include "slam/io/svg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam/io/chunked_output.h"
#include "slam/io/file.h"
#include "slam/io/writable_drawing.h"

namespace ariadne::slam {
namespace {

constexpr double kFooter = 12.0;      // height of the scale bar with its text [mm]
constexpr double kLeastWidth = 60.0;  // of a page, so that the text fits [mm]
constexpr double kTextSize = 4.0;     // [mm]

/// The sheet: where the map lies on it, and how long its scale bar is.
struct Sheet {
  Eigen::Vector2d low_map;  // left and lower edge of what is drawn [m]
  double mm_per_meter = 1.0;
  double margin = 0.0;  // [mm]
  double width = 0.0;   // [mm]
  double height = 0.0;  // [mm]
  double bar = 1.0;     // [m]
};

/// The largest of 1, 2, 5, 10, 20 ... and their tenths that is not longer.
double RoundLength(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  const double factor = longest / power;
  return power * (factor >= 5.0 ? 5.0 : factor >= 2.0 ? 2.0 : 1.0);
}

Sheet LayOut(const Drawing& drawing, const SvgOptions& options) {
  const Box3 box = BoxAround(drawing);
  Sheet sheet;
  sheet.low_map = box.min().head<2>();
  sheet.mm_per_meter = 1000.0 / options.scale;
  sheet.margin = options.margin;
  const Eigen::Vector2d drawn = sheet.mm_per_meter * box.sizes().head<2>();
  const double width = std::max(drawn.x(), kLeastWidth);
  sheet.width = width + 2.0 * sheet.margin;
  sheet.height = drawn.y() + kFooter + 2.0 * sheet.margin;
  sheet.bar = RoundLength(0.5 * width / sheet.mm_per_meter);
  return sheet;
}

void PutHead(ChunkedOutput& svg, const Sheet& sheet, const SvgOptions& options) {
  svg.Print(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\"\n"
      "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
      "     width=\"{0:.2f}mm\" height=\"{1:.2f}mm\" viewBox=\"0 0 {0:.2f} {1:.2f}\">\n",
      sheet.width, sheet.height);
  svg.Print("<title>Plan 1:{:g}</title>\n", options.scale);
  svg.Print("<desc>ariadne: x to the right, y up; the coordinates of the layers are metres</desc>\n");
  svg.Print("<rect id=\"paper\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#ffffff\"/>\n", sheet.width,
            sheet.height);
}

void PutPoints(ChunkedOutput& svg, const DrawingLayer& layer, double size) {
  if (layer.points.empty()) return;
  svg.Print("<path class=\"points\" stroke-width=\"{:g}\" d=\"", size);
  for (const Eigen::Vector3d& p : layer.points) svg.Print("M{:.4f} {:.4f}h0\n", p.x(), p.y());
  svg.Print("\"/>\n");
}

void PutLine(ChunkedOutput& svg, const Polyline3& line) {
  svg.Print("<{} points=\"", line.closed ? "polygon" : "polyline");
  for (const Eigen::Vector3d& p : line.points) {
    svg.Print("{}{:.4f},{:.4f}", &p == line.points.data() ? "" : " ", p.x(), p.y());
  }
  svg.Print("\"/>\n");
}

double TwiceTheArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// All of them as one shape, in which upright ones remain as lines. They run in one sense, as the fill of
/// areas that cover each other in opposite senses cancels out.
void PutTriangles(ChunkedOutput& svg, const TriangleMesh& mesh, const std::string& color) {
  if (mesh.triangles.empty()) return;
  svg.Print("<path class=\"triangles\" fill=\"{}\" d=\"", color);
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3d* b = &mesh.vertices[triangle[1]];
    const Eigen::Vector3d* c = &mesh.vertices[triangle[2]];
    if (TwiceTheArea(a, *b, *c) < 0.0) std::swap(b, c);
    svg.Print("M{:.4f} {:.4f}L{:.4f} {:.4f}L{:.4f} {:.4f}Z\n", a.x(), a.y(), b->x(), b->y(), c->x(),
              c->y());
  }
  svg.Print("\"/>\n");
}

void PutLayer(ChunkedOutput& svg, const DrawingLayer& layer, const Sheet& sheet,
              const SvgOptions& options) {
  const double scale = sheet.mm_per_meter;
  const Rgb& rgb = layer.color;
  const std::string color = fmt::format("#{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b);
  svg.Print("<g id=\"layer_{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\" ", layer.name);
  svg.Print("transform=\"matrix({0} 0 0 {1} {2:.4f} {3:.4f})\" ", scale, -scale,
            sheet.margin - scale * sheet.low_map.x(),
            sheet.height - kFooter - sheet.margin + scale * sheet.low_map.y());
  svg.Print("fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" ", color, options.line_width / scale);
  svg.Print("stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
  PutTriangles(svg, layer.mesh, color);
  PutPoints(svg, layer, options.point_size / scale);
  for (const Polyline3& line : layer.lines) PutLine(svg, line);
  svg.Print("</g>\n");
}

void PutScaleBar(ChunkedOutput& svg, const Sheet& sheet, const SvgOptions& options) {
  const double y = sheet.height - sheet.margin, length = sheet.bar * sheet.mm_per_meter;
  svg.Print("<g id=\"scale\" inkscape:groupmode=\"layer\" inkscape:label=\"scale\" fill=\"#000000\">\n");
  svg.Print("<path id=\"scale_bar\" fill=\"none\" stroke=\"#000000\" stroke-width=\"0.5\" ");
  svg.Print("d=\"M{0:.2f} {1:.2f}v2h{2:.2f}v-2\"/>\n", sheet.margin, y - 2.0, length);
  svg.Print("<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"sans-serif\" font-size=\"{:g}\">{:g} m, 1:{:g}",
            sheet.margin, y - 3.5, kTextSize, sheet.bar, options.scale);
  svg.Print("</text>\n</g>\n");
}

void PutDrawing(std::ostream& out, const Drawing& drawing, const SvgOptions& options) {
  ChunkedOutput svg(out);
  const Sheet sheet = LayOut(drawing, options);
  PutHead(svg, sheet, options);
  for (const DrawingLayer& layer : drawing.layers) PutLayer(svg, layer, sheet, options);
  PutScaleBar(svg, sheet, options);
  svg.Print("</svg>\n");
  svg.Flush();
}

}  // namespace

void WriteSvg(const std::filesystem::path& path, const Drawing& drawing, const SvgOptions& options) {
  CheckOptions(options, "svg.");
  CheckWritable(drawing, path);
  WriteFileAtomically(path, [&](std::ostream& out) { PutDrawing(out, drawing, options); });
}

}  // namespace ariadne::slam
