// tools/filter.cpp: a mesh-to-mesh tool: checks each mesh of a series, runs the pass, writes mesh and report.
#include "filter.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>

#include "criteria_options.h"
#include "doubts.h"
#include "formats/document/mesh_json.h"
#include "pliant/geometry/describe.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/document_unit.h"
#include "progress_line.h"
#include "series.h"

namespace pliant {
namespace {

std::string list_elements(const InvalidElements& bad) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t count = 0;
  for (const auto* elements : {&bad.invalid, &bad.degenerate})
    for (const TriangleId t : *elements)
      if (count++ < most) text += (text.empty() ? "" : ", ") + std::to_string(t);
  return count > most ? text + ", ..." : text;
}

}  // namespace

BadMesh::BadMesh(std::vector<Fault> faults)
    : InputError(faults.front().place, faults.front().text), faults_(std::move(faults)) {}

std::string explain_unit(double unit) {
  if (unit == 1) return {};
  return "places and lengths are given in units of 2^" + std::to_string(std::ilogb(unit));
}

void in_unit(double unit, const std::function<void()>& work) {
  if (unit == 1) return work();
  const std::string tail = " (" + explain_unit(unit) + ")";
  try {
    work();
  } catch (const BadMesh& e) {
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults) fault.text += tail;
    throw BadMesh(std::move(faults));
  } catch (const InputError& e) {
    throw InputError(e.pointer(), e.what() + tail);
  } catch (const NoResult& e) {
    throw NoResult(e.what() + tail);
  }
}

void require_mesh(const MeshData& data, bool accepts_tangled) {
  std::vector<Fault> faults = check_structure(data, 3);
  constexpr std::size_t most = 10;
  if (faults.size() > most) faults.resize(most);
  for (Fault& fault : faults) fault.text += " (" + fault.invariant + ")";
  if (!faults.empty()) throw BadMesh(std::move(faults));
  if (accepts_tangled) return;
  const InvalidElements bad = find_invalid(data);
  if (bad.empty()) return;
  const std::size_t count = bad.invalid.size() + bad.degenerate.size();
  const TriangleId first = bad.invalid.empty() ? bad.degenerate.front() : bad.invalid.front();
  const std::size_t all = data.triangle_faces.size();
  throw BadMesh({{"M3", "/triangles/" + std::to_string(first * net_size(data.degree)),
                  std::to_string(count) + " of " + std::to_string(all) + " elements are not valid (" +
                      list_elements(bad) + "); smoothcurves may untangle them"}});
}

void report_in_document(PassReport& report, double unit) {
  restore_unit(report, unit);
  if (unit != 1 && !report.notes.empty()) report.notes.push_back("in these notes " + explain_unit(unit));
}

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

}  // namespace

int run_filter(CLI::App& app, int argc, char** argv, const std::function<PassReport(Mesh&)>& pass,
               const FilterOptions& filter) {
  ToolOptions options;
  add_common_options(app, options);
  return run_tool(app, argc, argv, options, [&] {
    if (filter.prepare) filter.prepare(options);
    OutputFile output(options.output);
    FrameReports reports(options);
    ProgressLine line(options);
    Stopwatch watch;
    std::string text;
    Doubts doubts(options);
    for_each_document(options, FileKind::mesh, [&](std::string_view document, const Frame& frame) {
      watch.lap();
      line.stage("read");
      MeshData data = read_mesh(document, doubts.found());
      doubts.say_new(document, frame);
      normalize_unit(data);
      const double unit = data.boundary.unit;
      std::vector<std::pair<std::string, double>> seconds{{"read", watch.lap()}};
      line.stage("check");
      in_unit(unit, [&] { require_mesh(data, filter.accepts_tangled); });
      double checking = watch.lap(), measuring = 0;
      std::optional<QualityChange> quality;
      if (reports.is_wanted()) {
        quality.emplace().before = summarize_quality(data);
        measuring = watch.lap();
      }
      Mesh mesh(std::move(data));
      seconds.emplace_back("check", checking + watch.lap());
      if (quality) {
        quality->missed_before = count_missed(mesh);
        measuring += watch.lap();
      }
      line.stage("work");
      PassReport report;
      in_unit(unit, [&] { report = pass(mesh); });
      report.resolution = place_resolution * mesh.size();
      report_in_document(report, unit);
      seconds.emplace_back("pass", watch.lap());
      line.stage("write");
      text.clear();
      data = mesh.to_data();
      const double unpacking = watch.lap();
      if (quality) {  // before the mesh may have its extreme size again
        line.stage("measure");
        quality->after = summarize_quality(data);
        quality->missed_after = count_missed(mesh);
        for (QualitySummary* summary : {&quality->before, &quality->after})
          for (ComponentSize& size : summary->fields) size.l2 *= unit;  // the root of an integral over the area
        measuring += watch.lap();
        line.stage("write");
      }
      restore_unit(data);
      write_mesh(data, text);
      output.write(text);
      seconds.emplace_back("write", unpacking + watch.lap());
      if (quality) seconds.emplace_back("quality", measuring);
      reports.add(frame, mesh.time, report, seconds, quality ? &*quality : nullptr);
    });
    output.commit();
    return status::done;
  });
}

}  // namespace pliant
