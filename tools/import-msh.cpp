// tools/import-msh.cpp: reads a file of Gmsh's as a mesh.
#include <CLI/CLI.hpp>
#include <optional>

#include "formats/document/mesh_document.h"
#include "formats/msh/msh.h"
#include "options/field_option.h"
#include "options/numbers.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/frame_reports.h"
#include "run/history.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/run_tool.h"
#include "run/stopwatch.h"

namespace {

using namespace pliant;

/// A tangled mesh is a legal document, one whose triangles do not fit together is not.
void require_structure(const MshImport& import) {
  constexpr int most = 10;
  const std::vector<Fault> faults = check_structure(import.mesh, 3);
  if (faults.empty()) return;
  std::string text = "the triangles do not make a mesh (qualityreport audits such a file)";
  for (std::size_t k = 0; k < faults.size() && k < most; ++k) {
    const Fault fault = in_msh_words(import, faults[k]);
    text += "\n" + fault.place + ": " + fault.text + " (" + fault.invariant + ")";
  }
  throw InputError("", text);
}

PassReport summarize(const MshImport& import) {
  PassReport report;
  const MeshData& mesh = import.mesh;
  report.add("degree", mesh.degree);
  report.add("triangles", static_cast<double>(mesh.triangle_faces.size()));
  report.add("control_points", static_cast<double>(mesh.points.size()));
  report.add("faces", static_cast<double>(mesh.boundary.faces.size()));
  report.add("curves", static_cast<double>(mesh.boundary.curves.size()));
  report.notes = import.warnings;
  report.notes.insert(report.notes.end(), import.notes.begin(), import.notes.end());
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Read a Gmsh MSH file, versions 1 to 4.1, as a mesh of Bezier triangles.", "import-msh"};
  ToolOptions options;
  MshOptions msh;
  FieldOption fields;
  std::string time_text;
  add_common_options(app, options);
  add_form_option(app, options);
  app.get_option("--to")->description("the form of the document; json by default");
  app.add_flag("--orient", msh.orient, "turn parts of the mesh whose triangles run clockwise");
  fields.add(app);
  app.add_option("--step", msh.step, "which time step of each view is read, from 0; -1 is the last")->type_name("N");
  app.add_option("--time", time_text, "time of the mesh, instead of that of its views")->type_name("T");
  return run_tool(app, argc, argv, options, [&] {
    std::optional<double> time;
    if (app.count("--time") > 0) time = parse_number("--time", time_text);
    fields.check();
    OutputFile output(options.output);
    FrameReports reports(options);
    Stopwatch watch;
    for_msh(options, msh, [&](MshImport&& import, const Frame& frame) {
      if (!import.no_step.empty())
        throw UsageError(frame.source + ": " + import.no_step + ", and --step asks for step " +
                         std::to_string(*msh.step));
      normalize_unit(import.mesh);
      const double unit = import.mesh.boundary.unit;
      const double read = watch.lap();
      in_unit(unit, [&] { require_structure(import); });
      const double check = watch.lap();
      const PassReport report = summarize(import);
      Mesh mesh(std::move(import.mesh));
      if (time) mesh.time = *time;
      in_unit(unit, [&] { fields.apply(mesh); });
      MeshData data = mesh.to_data();
      restore_unit(data);
      record(options, data.extra);
      write_mesh(data, options.output_form(frame.form), [&](std::string_view piece) { output.write(piece); });
      reports.add(frame, mesh.time, report, {{"read", read}, {"check", check}, {"write", watch.lap()}});
    });
    output.commit();
    return status::done;
  });
}
