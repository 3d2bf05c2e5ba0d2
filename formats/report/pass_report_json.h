// formats/report/pass_report_json.h: what a pass did to one mesh, as one line of JSON (formats/pass_report.md).
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "pliant/improve/missed_goals.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/quality/quality_summary.h"

namespace pliant {

/// The mesh that a pass was given, and the one that it left.
struct QualityChange {
  QualitySummary before, after;
  MissedGoals missed_before, missed_after;  ///< of the document's criteria
};

/// Which pass it was, and how long its parts took: their names and seconds, in order.
struct PassRun {
  std::string tool;
  std::int64_t frame = 0;
  double time = 0;  ///< of the mesh that was written
  std::vector<std::pair<std::string, double>> seconds;
};

/// Appends the line with its newline; without `quality`, the members that tell of the meshes are left out.
void write_pass_report(const PassRun& run, const PassReport& report, const QualityChange* quality, std::string& out);

}  // namespace pliant
