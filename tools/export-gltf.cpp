// tools/export-gltf.cpp: writes a mesh, or a series as an animation, as glTF.
#include <CLI/CLI.hpp>
#include <stdexcept>

#include "formats/picture/gltf.h"
#include "options/picture_options.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/output_file.h"
#include "run/require_mesh.h"
#include "run/run_tool.h"

int main(int argc, char** argv) {
  using namespace pliant;
  CLI::App app{"Write a mesh as glTF 2.0, a series as an animation.", "export-gltf"};
  ToolOptions options;
  PictureOptions picture;
  GltfOptions gltf;
  bool binary = false;
  double outline = 0;
  add_common_options(app, options, false);
  picture.add(app);
  app.add_flag("--binary,!--no-binary", binary,
               "write .glb or, with --no-binary, .gltf with its buffer inside; by default .gltf only to a file of that "
               "name");
  app.add_option("--fps", gltf.frames_per_second, "meshes a second")
      ->type_name("N")
      ->check(CLI::Range(0.001, 1000.0))
      ->capture_default_str();
  app.add_option("--outline", outline,
                 "width of constrained edges, in mesh units; by default 1/400 of the first mesh's size")
      ->type_name("WIDTH")
      ->check(CLI::Range(0.0, 1e300));
  app.add_flag("--quantize", gltf.quantize,
               "16-bit positions, a smaller file for viewers that know KHR_mesh_quantization");

  return run_tool(app, argc, argv, options, [&] {
    picture.check();
    gltf.color = picture.color;
    gltf.map = picture.map;
    gltf.range = picture.range;
    gltf.subdivide = picture.subdivide;
    gltf.edges = !picture.no_edges;
    gltf.circles = picture.circles;
    if (app.count("--outline") > 0) gltf.outline_width = outline;
    if (app.count("--binary") == 0) binary = !options.output.ends_with(".gltf");
    OutputFile output(options.output);
    GltfWriter writer(gltf);
    std::size_t meshes = 0, triangles = 0;
    for_each_mesh(options, [&](MeshData&& mesh, const Frame&) {
      require_mesh(mesh, true);
      ++meshes;
      triangles += mesh.triangle_faces.size();
      try {
        writer.add(mesh);
      } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--color: ") + error.what());
      }
    });
    const std::string bytes = writer.finish(binary);
    output.write(bytes);
    output.commit();
    say_written(options, meshes, triangles, bytes.size());
    return status::done;
  });
}
