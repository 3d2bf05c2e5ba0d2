// tools/export-gltf.cpp: writes a mesh, or a series as an animation, as glTF.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "formats/picture/gltf.h"
#include "options/numbers.h"
#include "options/picture_options.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/output_file.h"
#include "run/require_mesh.h"
#include "run/run_tool.h"

namespace {

using namespace pliant;

/// Reads FIELD[.COMPONENT][:SCALE]. What follows the last colon is the scale if it is a number.
void read_height(const std::string& text, GltfOptions& gltf) {
  std::string name = text;
  if (const std::size_t colon = text.rfind(':'); colon != std::string::npos) {
    double scale = 0;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + colon + 1, last, scale);
    if (end == last && (error != std::errc() || !std::isfinite(scale)))
      throw UsageError("--height " + text + ": SCALE must be a finite number");
    if (end == last) {
      name = text.substr(0, colon);
      gltf.height_scale = scale;
    }
  }
  if (name.empty()) throw UsageError("--height " + text + ": FIELD[:SCALE] is wanted");
  gltf.height = {ColorBy::Kind::field, name};
}

void require_height(const MeshData& mesh, const GltfOptions& gltf) {
  try {
    if (gltf.height) ElementValues(mesh, *gltf.height);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--height: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a mesh as glTF 2.0, a series as an animation.", "export-gltf"};
  ToolOptions options;
  PictureOptions picture;
  GltfOptions gltf;
  bool binary = false;
  double outline = 0;
  std::string precision = "quantized", height;
  add_common_options(app, options, false);
  picture.add(app);
  app.add_flag("--binary,!--no-binary", binary,
               "write .glb or, with --no-binary, .gltf with its buffer inside; by default .gltf only to a file of that "
               "name");
  app.add_option("--fps", gltf.frames_per_second, "meshes a second")
      ->type_name("N")
      ->check([](const std::string& text) { return fault_of_number(text, 0.001, 1000); })
      ->capture_default_str();
  app.add_option("--outline", outline,
                 "width of constrained edges, in mesh units; by default 1/400 of the first mesh's size")
      ->type_name("WIDTH")
      ->check([](const std::string& text) { return fault_of_number(text, 0, 1e300); });
  app.add_option("--precision", precision,
                 "positions in 16 bits, for viewers that know KHR_mesh_quantization, or in single precision")
      ->type_name("quantized|float")
      ->check(CLI::IsMember({"quantized", "float"}).description(""))
      ->capture_default_str();
  app.add_option("--height", height,
                 "lift the surface by a field, times SCALE; by default its range is a quarter of the first mesh's size")
      ->type_name("FIELD[:SCALE]");
  app.add_flag("--lit", gltf.lit,
               "add normals, and let light shade the elements; by default colours are shown as they are");

  return run_tool(app, argc, argv, options, [&] {
    picture.check();
    gltf.color = picture.color;
    gltf.map = picture.map;
    gltf.range = picture.range;
    gltf.subdivide = picture.subdivide;
    gltf.edges = !picture.no_edges;
    gltf.circles = picture.circles;
    gltf.quantize = precision == "quantized";
    if (app.count("--height") > 0) read_height(height, gltf);
    if (app.count("--outline") > 0) gltf.outline_width = outline;
    if (app.count("--binary") == 0) binary = !has_ending(options.output, ".gltf");
    OutputFile output(options.output);
    GltfWriter writer(gltf);
    std::size_t meshes = 0, triangles = 0;
    for_each_mesh(options, [&](MeshData&& mesh, const Frame& frame) {
      require_mesh(mesh, true);
      ++meshes;
      triangles += mesh.triangle_faces.size();
      require_height(mesh, gltf);
      try {
        writer.add(mesh);
      } catch (const std::invalid_argument& error) {
        throw UsageError(frame.source + ": frame " + std::to_string(frame.index) + ": --color: " + error.what());
      }
    });
    const std::string bytes = writer.finish(binary);
    output.write(bytes);
    output.commit();
    say_written(options, meshes, triangles, bytes.size());
    return status::done;
  });
}
