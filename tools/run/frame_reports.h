// tools/run/frame_reports.h: --report, a JSON line a frame, and what -v prints.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formats/report/pass_report_json.h"
#include "run/frame.h"
#include "run/tool_options.h"

namespace pliant {

/// Where --report goes (a JSON line a frame, complete at once) and what -v prints.
class FrameReports {
 public:
  explicit FrameReports(const ToolOptions& options);
  ~FrameReports();
  FrameReports(const FrameReports&) = delete;
  FrameReports& operator=(const FrameReports&) = delete;
  /// Does anybody want to know? If not, what goes into `quality` need not be measured.
  bool is_wanted() const;
  /// `seconds` names the parts of the work: read, check, pass, write, and quality where that was measured.
  void add(const Frame& frame, double time, const PassReport& report,
           const std::vector<std::pair<std::string, double>>& seconds, const QualityChange* quality = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
