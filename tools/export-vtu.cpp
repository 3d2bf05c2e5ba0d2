// tools/export-vtu.cpp: writes a mesh, or a series, for VTK and ParaView.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "formats/vtu/vtu_writer.h"
#include "formats/vtu/xml_text.h"
#include "options/frame_option.h"
#include "pliant/mesh/documents/document_unit.h"
#include "pliant/quality/metrics.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/output_file.h"
#include "run/require_mesh.h"
#include "run/run_tool.h"

namespace {

using namespace pliant;

/// The metrics of these names; "all" and "none" stand alone.
std::vector<const Metric*> find_metrics(const std::vector<std::string>& names) {
  std::vector<const Metric*> metrics;
  if (names.size() == 1 && names[0] == "none") return metrics;
  if (names.size() == 1 && names[0] == "all") {
    for (const Metric& metric : all_metrics()) metrics.push_back(&metric);
    return metrics;
  }
  for (const std::string& name : names) {
    if (name == "all" || name == "none") throw UsageError("--metric " + name + " stands alone, without others");
    const Metric* metric = find_metric(name);
    if (metric == nullptr) {
      std::string known;
      for (const Metric& each : all_metrics()) known.append(known.empty() ? "" : ", ").append(each.name);
      throw UsageError("--metric: there is none of the name '" + name + "'; there are " + known +
                       ", and alone all and none");
    }
    if (std::ranges::find(metrics, metric) == metrics.end()) metrics.push_back(metric);
  }
  return metrics;
}

/// What has been written, for -v.
struct Written {
  std::size_t meshes = 0, triangles = 0, bytes = 0;
};

/// Writes one mesh, whose file appears whole or not at all.
void write_mesh_to(OutputFile& output, MeshData& mesh, const VtuOptions& vtu, Written& written) {
  normalize_unit(mesh);  // metrics are products of lengths
  write_vtu(mesh, vtu, [&](std::string_view part) {
    output.write(part);
    written.bytes += part.size();
  });
  output.commit();
  ++written.meshes;
  written.triangles += mesh.triangle_faces.size();
}

/// The files of a series: the list NAME.pvd, and NAME_0000.vtu and so on beside it.
class Series {
 public:
  explicit Series(const std::string& list)
      : stem_(list.substr(0, list.size() - suffix.size())), name_(stem_.substr(stem_.rfind('/') + 1)) {
    if (!is_xml_text(name_))
      throw UsageError("-o " + list +
                       ": a .pvd file names the others in XML, which takes UTF-8 without control "
                       "characters");
  }
  static constexpr std::string_view suffix = ".pvd";

  /// The path of the next file.
  std::string next(double time) {
    constexpr std::size_t digits = 4;
    std::string number = std::to_string(entries_.size());
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    entries_.push_back({time, name_ + "_" + number + ".vtu"});
    return stem_ + "_" + number + ".vtu";
  }

  /// The list. Where times do not ascend, programs would confuse the frames, so these are numbered instead.
  std::string list(const ToolOptions& options) {
    const auto falls = [](const PvdEntry& a, const PvdEntry& b) { return !(a.time < b.time); };
    if (std::ranges::adjacent_find(entries_, falls) != entries_.end()) {
      say(options, "the times of the meshes do not ascend, so the list has their numbers instead");
      for (std::size_t k = 0; k < entries_.size(); ++k) entries_[k].time = double(k);
    }
    return write_pvd(entries_);
  }

 private:
  std::string stem_, name_;
  std::vector<PvdEntry> entries_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a mesh for VTK and ParaView as .vtu, or a series as .pvd with a .vtu for each mesh.",
               "export-vtu"};
  ToolOptions options;
  FrameOption frame;
  VtuOptions vtu;
  std::vector<std::string> metrics{"shape", "scaled_jacobian", "element_area"};
  add_common_options(app, options, false);
  app.add_flag("--lagrange", vtu.lagrange,
               "Lagrange triangles, with their points on the curves, in place of B\u00e9zier triangles");
  app.add_flag("--curves", vtu.curves, "the edges on curves as cells too");
  app.add_option("--metric", metrics, "a metric of qualityreport as cell data; repeatable; or alone: all, none")
      ->type_name("METRIC|all|none")
      ->allow_extra_args(false)
      ->capture_default_str();
  frame.add(app);
  return run_tool(app, argc, argv, options, [&] {
    vtu.metrics = find_metrics(metrics);
    Written written;
    if (!has_ending(options.output, Series::suffix)) {
      OutputFile output(options.output);
      MeshData mesh = frame.read(options);
      write_mesh_to(output, mesh, vtu, written);
    } else {
      if (app.count("--frame") > 0)
        throw UsageError("--frame: one mesh goes to a .vtu file, and -o " + options.output + " is for a series");
      Series series(options.output);
      OutputFile output(options.output);
      for_each_mesh(options, [&](MeshData&& mesh, const Frame&) {
        require_mesh(mesh, true);
        OutputFile file(series.next(mesh.time));
        write_mesh_to(file, mesh, vtu, written);
      });
      const std::string list = series.list(options);
      output.write(list);
      output.commit();
      written.bytes += list.size();
    }
    say_written(options, written.meshes, written.triangles, written.bytes);
    return status::done;
  });
}
