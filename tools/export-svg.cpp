// tools/export-svg.cpp: draws a mesh as SVG, PNG or PDF.
#include <CLI/CLI.hpp>
#include <optional>
#include <stdexcept>

#include "formats/picture/svg.h"
#include "options/drawing_options.h"
#include "options/frame_option.h"
#include "options/numbers.h"
#include "options/picture_options.h"
#include "run/exit_status.h"
#include "run/output_file.h"
#include "run/run_tool.h"
#ifdef PLIANT_RSVG
#include "formats/picture/rendering/render.h"
#endif

namespace {

/// The picture in the format that is wanted.
std::string in_format(std::string svg, pliant::DrawingOptions::Format format) {
#ifdef PLIANT_RSVG
  using namespace pliant;
  if (format == DrawingOptions::Format::svg) return svg;
  try {
    return render_svg(svg, format == DrawingOptions::Format::png ? RenderedFormat::png : RenderedFormat::pdf);
  } catch (const std::runtime_error& error) {
    throw NoResult(error.what());
  }
#else
  static_cast<void>(format);
  return svg;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Draw one mesh as a picture with exact curves: SVG, PNG or PDF.", "export-svg"};
  ToolOptions options;
  PictureOptions picture;
  DrawingOptions drawing;
  SvgOptions svg;
  FrameOption frame;
  std::string box, resolution;
  bool no_legend = false;
  add_common_options(app, options, false);
  picture.add(app);
  frame.add(app);
  drawing.add(app);
  app.add_option("--width", svg.width, "of the picture, in pixels")
      ->type_name("PIXELS")
      ->check([](const std::string& text) { return fault_of_number(text, 50, 100000); })
      ->capture_default_str();
  app.add_option("--box", box, "what is shown; by default all control points and a margin")->type_name("X0,Y0,X1,Y1");
  app.add_option(
         "--resolution", resolution,
         "of numbers, as a part of the size of the mesh or the box, 1e-7 by default; 1e-4 serves a small picture")
      ->type_name("R");
  app.add_flag("--no-legend", no_legend, "leave out the column that explains the colours");

  return run_tool(app, argc, argv, options, [&] {
    picture.check();
    svg.color = picture.color;
    if (picture.names_map()) svg.map = picture.map;
    drawing.check(options.output, svg);
    svg.range = picture.range;
    svg.subdivide = picture.subdivide;
    svg.edges = !picture.no_edges;
    svg.circles = picture.circles;
    svg.legend = !no_legend;
    if (!resolution.empty()) {
      svg.resolution = parse_positive("--resolution", resolution);
      if (svg.resolution < 1e-12 || svg.resolution > 0.01)
        throw UsageError("--resolution " + resolution + ": from 1e-12 to 0.01");
    }
    if (!box.empty()) {
      const std::vector<double> sides = parse_numbers("--box", box, ',', 4, "X0,Y0,X1,Y1");
      svg.box = Box{{sides[0], sides[1]}, {sides[2], sides[3]}};
      if (!(sides[0] < sides[2] && sides[1] < sides[3]))
        throw UsageError("--box " + box + ": X0 < X1 and Y0 < Y1 are wanted");
    }
    OutputFile output(options.output);
    std::string text;
    const MeshData mesh = frame.read(options);
    std::vector<std::string> left_out;
    try {
      left_out = write_svg(mesh, svg, text);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
    for (const std::string& words : left_out) say(options, words + ", and left out");
    text = in_format(std::move(text), drawing.format());
    output.write(text);
    output.commit();
    say_written(options, 1, mesh.triangle_faces.size(), text.size());
    return status::done;
  });
}
