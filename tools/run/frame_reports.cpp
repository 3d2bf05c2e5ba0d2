// tools/run/frame_reports.cpp: --report, a JSON line a frame, and what -v prints.
#include "run/frame_reports.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <optional>
#include <system_error>

#include "formats/report/pass_report_json.h"
#include "pliant/geometry/describe.h"
#include "run/exit_status.h"
#include "run/same_file.h"

namespace pliant {

using Seconds = std::vector<std::pair<std::string, double>>;

struct FrameReports::State {
  const ToolOptions& options;
  std::FILE* file = nullptr;

  void write_line(const Frame& frame, double time, const PassReport& report, const Seconds& seconds,
                  const QualityChange* quality) const;
  void print(const Frame& frame, double time, const PassReport& report, const Seconds& seconds,
             const QualityChange* quality) const;
};

namespace {

std::string text_of(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Where it was refused first; nothing if the pass did not say.
std::string some_places(const PassReport& report, const std::string& reason, long times) {
  constexpr long most = 3;
  std::string text;
  long count = 0;
  for (const RefusedAt& refused : report.refused_at) {
    if (refused.reason != reason || count == most) continue;
    ++count;
    text += (count > 1 ? ", " : ", at ") + describe_point(refused.place, report.resolution);
  }
  return text + (count > 0 && times > count ? ", ..." : "");
}

std::string in_words(const QualitySummary& summary) {
  return std::to_string(summary.triangles) + " triangles, " + std::to_string(summary.invalid + summary.degenerate) +
         " not valid, least logical angle " + text_of("%.4g", summary.min_logical_angle) + ", scaled Jacobian " +
         text_of("%.4g", summary.min_scaled_jacobian) + ", shape " + text_of("%.4g", summary.min_shape) +
         ", largest distortion " + text_of("%.4g", summary.max_distortion);
}

/// The components that have grown most; nothing if no field came through.
std::string growth_in_words(const QualityChange& quality) {
  const std::vector<ComponentGrowth> all = field_growth(quality.before, quality.after);
  if (all.empty()) return {};
  const auto most = [&all](double ComponentGrowth::*member) {
    const auto grown = std::ranges::max_element(all, {}, member);
    return text_of("%.8g", *grown.*member) + " (" + grown->field + ", component " + std::to_string(grown->component) +
           ")";
  };
  return "fields grew at most by: largest |u| " + most(&ComponentGrowth::largest) + ", L2 norm " +
         most(&ComponentGrowth::l2);
}

}  // namespace

void FrameReports::State::write_line(const Frame& frame, double time, const PassReport& report, const Seconds& seconds,
                                     const QualityChange* quality) const {
  std::string line;
  write_pass_report({options.tool, frame.index, time, seconds}, report, quality, line);
  if (std::fwrite(line.data(), 1, line.size(), file) != line.size() || std::fflush(file) != 0)
    throw std::system_error(errno, std::generic_category(), options.report);
}

void FrameReports::State::print(const Frame& frame, double time, const PassReport& report, const Seconds& seconds,
                                const QualityChange* quality) const {
  std::string line = "frame " + std::to_string(frame.index) + ", time " + text_of("%.12g", time) + ": ";
  const char* comma = "";
  for (const auto& [name, value] : report.values) {
    line += comma + name + " " + text_of("%.10g", value);
    comma = ", ";
  }
  double total = 0;
  for (const auto& [name, value] : seconds) total += value;
  line += std::string(comma) + text_of("%.3f s", total);
  say(options, line);
  for (const auto& [reason, times] : report.refusals)
    say(options, "  refused " + std::to_string(times) + (times == 1 ? " time: " : " times: ") + reason +
                     some_places(report, reason, times));
  for (const std::string& note : report.notes) say(options, "  " + note);
  if (quality == nullptr) return;
  say(options, "  before: " + in_words(quality->before));
  say(options, "  after: " + in_words(quality->after));
  const std::string growth = growth_in_words(*quality);
  if (!growth.empty()) say(options, "  " + growth);
  if (quality->after.min_shape < quality->before.min_shape)
    say(options, "  the least shape has fallen from " + text_of("%.4g", quality->before.min_shape) + " to " +
                     text_of("%.4g", quality->after.min_shape));
  const std::string advice = advice_on(quality->missed_after);
  say(options, "  goals missed before: " + describe(quality->missed_before) +
                   "; after: " + describe(quality->missed_after) + (advice.empty() ? "" : "; " + advice));
}

FrameReports::FrameReports(const ToolOptions& options) : state_(new State{options}) {
  if (options.report.empty()) return;
  if (options.report == "-") throw UsageError("--report - would mix the report with the result; give it a file");
  for (const auto& [path, what] : {std::pair(options.output, "-o"), std::pair(options.input, "INPUT")})
    if (path != "-" && is_same_file(options.report, path))
      throw UsageError("--report and " + std::string(what) + " name the same file, '" + options.report +
                       "'; give the report one of its own");
  state_->file = std::fopen(options.report.c_str(), "we");
  if (state_->file == nullptr) throw std::system_error(errno, std::generic_category(), options.report);
}

FrameReports::~FrameReports() {
  if (state_->file != nullptr) std::fclose(state_->file);
}

bool FrameReports::is_wanted() const { return state_->file != nullptr || state_->options.verbose; }

void FrameReports::add(const Frame& frame, double time, const PassReport& report, const Seconds& seconds,
                       const QualityChange* quality) {
  if (state_->file != nullptr) state_->write_line(frame, time, report, seconds, quality);
  if (state_->options.verbose) state_->print(frame, time, report, seconds, quality);
}

}  // namespace pliant
