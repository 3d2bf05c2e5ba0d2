// tools/export-msh.cpp: writes a mesh as a file of Gmsh's.
#include <CLI/CLI.hpp>
#include <string>

#include "formats/msh/msh_writer.h"
#include "options/frame_option.h"
#include "run/exit_status.h"
#include "run/output_file.h"
#include "run/run_tool.h"

namespace {

using namespace pliant;

/// Fields of which Gmsh has no kind are not changed without a word.
void say_what_is_split(const ToolOptions& options, const MeshData& mesh) {
  for (const Field& field : mesh.fields)
    if (field.components > 3 && field.components != 9)
      say(options, "the field " + field.name + " has " + std::to_string(field.components) +
                       " components, and Gmsh knows 1, 3 and 9: each is written as a view of its own");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write one mesh as a Gmsh MSH file.", "export-msh"};
  ToolOptions options;
  FrameOption frame;
  MshWriteOptions msh;
  std::string format = "msh41";
  add_common_options(app, options, false);
  app.add_option("--format", format, "msh41 or msh22")->check(CLI::IsMember({"msh41", "msh22"}))->capture_default_str();
  app.add_flag("--binary", msh.binary, "numbers as bytes: shorter, and read faster");
  frame.add(app);
  return run_tool(app, argc, argv, options, [&] {
    msh.version = format == "msh22" ? MshWriteOptions::Version::v2_2 : MshWriteOptions::Version::v4_1;
    OutputFile output(options.output);
    const MeshData mesh = frame.read(options);
    say_what_is_split(options, mesh);
    std::string text;
    write_msh(mesh, msh, text);
    output.write(text);
    output.commit();
    say_written(options, 1, mesh.triangle_faces.size(), text.size());
    return status::done;
  });
}
