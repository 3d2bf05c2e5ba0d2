// tools/run/run_filter.cpp: checks each mesh of a series, runs the stage, writes mesh and report.
#include "run/run_filter.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "formats/document/mesh_document.h"
#include "options/criteria_options.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/doubts.h"
#include "run/exit_status.h"
#include "run/frame_reports.h"
#include "run/history.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/progress_line.h"
#include "run/require_mesh.h"
#include "run/run_tool.h"
#include "run/stopwatch.h"
#include "stages/run_stage.h"

namespace pliant {
namespace {

/// By the document's criteria; a size that is no expression is for those to blame who ask for it.
MissedGoals count_missed(const Mesh& mesh) {
  SizeFunction size;
  try {
    if (mesh.criteria.size) size = compile_size(*mesh.criteria.size);
    return pliant::count_missed(mesh, goals_of(mesh, size));
  } catch (const std::exception&) {
    return pliant::count_missed(mesh, {});
  }
}

/// Completes a quality change after the pass, in the units of the document.
void measure_after(const MeshData& data, const Mesh& mesh, QualityChange& quality) {
  quality.after = summarize_quality(data);
  quality.missed_after = count_missed(mesh);
  for (QualitySummary* summary : {&quality.before, &quality.after})
    for (ComponentSize& size : summary->fields) size.l2 *= data.boundary.unit;  // the root of an integral over the area
}

}  // namespace

int run_filter(Stage& stage, int argc, char** argv) {
  CLI::App app{stage.description(), stage.name()};
  stage.add_options(app);
  ToolOptions options;
  add_common_options(app, options);
  add_form_option(app, options);
  return run_tool(app, argc, argv, options, [&] {
    stage.check(app);
    OutputFile output(options.output);
    FrameReports reports(options);
    ProgressLine line(options);
    Stopwatch watch;
    const StageContext context{[&options](const std::string& warning) { say(options, warning); }, line.counters(),
                               reports.is_wanted()};
    line.stage("read");
    for_each_mesh(options, [&](MeshData&& data, const Frame& frame, const std::function<void()>& forget_text) {
      normalize_unit(data);
      std::vector<std::pair<std::string, double>> seconds{{"read", watch.lap()}};
      line.stage("check");
      in_unit(data.boundary.unit, [&] { require_mesh(data, stage.accepts_tangled()); });
      std::optional<QualityChange> quality;
      double checking = watch.lap(), measuring = 0;
      if (reports.is_wanted()) {
        quality.emplace().before = summarize_quality(data);
        measuring = watch.lap();
      }
      forget_text();
      Mesh mesh(std::move(data));
      seconds.emplace_back("check", checking + watch.lap());
      if (quality) {
        quality->missed_before = count_missed(mesh);
        measuring += watch.lap();
      }
      if (stage.explains()) {
        in_unit(mesh.boundary().unit, [&] { output.write(stage.explanation(mesh)); });
        line.stage("read");
        watch.lap();
        return;
      }
      line.stage("work");
      const PassReport report = run_stage(stage, mesh, context);
      seconds.emplace_back("pass", watch.lap());
      line.stage("write");
      data = mesh.to_data();
      record(options, data.extra);
      const double unpacking = watch.lap();
      if (quality) {  // before the mesh may have its extreme size again
        line.stage("measure");
        measure_after(data, mesh, *quality);
        measuring += watch.lap();
        line.stage("write");
      }
      restore_unit(data);
      write_mesh(data, options.output_form(frame.form), [&](std::string_view piece) { output.write(piece); });
      seconds.emplace_back("write", unpacking + watch.lap());
      if (quality) seconds.emplace_back("quality", measuring);
      reports.add(frame, mesh.time, report, seconds, quality ? &*quality : nullptr);
      line.frames_done(frame.index + 1);
      line.stage("read");
      watch.lap();
    });
    output.commit();
    return status::done;
  });
}

}  // namespace pliant
