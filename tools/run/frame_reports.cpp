// tools/run/frame_reports.cpp: --report, a JSON line a frame, and what -v prints.
#include "run/frame_reports.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "formats/document/write_json.h"
#include "pliant/geometry/describe.h"
#include "run/exit_status.h"

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

/// Counts come without a fraction or an exponent; what is not finite is null.
void append_value(std::string& out, double value) {
  if (!std::isfinite(value))
    out += "null";
  else if (value == std::floor(value) && std::abs(value) < 1e15)
    append_integer(out, static_cast<std::int64_t>(value));
  else
    append_number(out, value);
}

std::string number(double value) {
  std::string text;
  append_value(text, value);
  return text;
}

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

void write_summary(JsonWriter& out, const QualitySummary& summary) {
  out.begin_object().name("triangles").value(summary.triangles);
  out.name("invalid").value(summary.invalid).name("degenerate").value(summary.degenerate);
  out.name("min_logical_angle").raw(number(summary.min_logical_angle));
  out.name("min_scaled_jacobian").raw(number(summary.min_scaled_jacobian));
  out.name("min_shape").raw(number(summary.min_shape)).name("max_distortion").raw(number(summary.max_distortion));
  out.name("fields").begin_array();
  for (const ComponentSize& size : summary.fields) {
    out.begin_object().name("name").value(size.field).name("component").value(size.component);
    out.name("largest").raw(number(size.largest)).name("l2").raw(number(size.l2)).end_object();
  }
  out.end_array().end_object();
}

void write_missed(JsonWriter& out, const MissedGoals& missed) {
  out.begin_object().name("invalid").value(missed.invalid).name("turned_over").value(missed.turned_over);
  out.name("too_curved").value(missed.too_curved).name("too_large").value(missed.too_large);
  out.name("too_poor").value(missed.too_poor).end_object();
}

void write_change(JsonWriter& out, const QualityChange& quality) {
  out.name("before");
  write_summary(out, quality.before);
  out.name("after");
  write_summary(out, quality.after);
  out.name("missed_before");
  write_missed(out, quality.missed_before);
  out.name("missed_after");
  write_missed(out, quality.missed_after);
  out.name("growth").begin_array();
  for (const ComponentGrowth& growth : field_growth(quality.before, quality.after)) {
    out.begin_object().name("name").value(growth.field).name("component").value(growth.component);
    out.name("largest").raw(number(growth.largest)).name("l2").raw(number(growth.l2)).end_object();
  }
  out.end_array();
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
  JsonWriter out(line);
  out.begin_object().name("tool").value(options.tool).name("frame").value(static_cast<std::int64_t>(frame.index));
  out.name("time").raw(number(time)).name("values").begin_object();
  for (const auto& [name, value] : report.values) out.name(name).raw(number(value));
  out.end_object().name("refusals").begin_object();
  for (const auto& [reason, times] : report.refusals) out.name(reason).value(static_cast<std::int64_t>(times));
  out.end_object().name("refused_at").begin_array();
  for (const auto& [reason, place] : report.refused_at) {
    out.begin_object().name("reason").value(reason);
    out.name("x").raw(number(place.x)).name("y").raw(number(place.y)).end_object();
  }
  out.end_array().name("notes").begin_array();
  for (const std::string& note : report.notes) out.value(note);
  out.end_array();
  if (quality != nullptr) write_change(out, *quality);
  out.name("seconds").begin_object();
  for (const auto& [name, value] : seconds) out.name(name).raw(text_of("%.6f", value));
  out.end_object().end_object();
  line += '\n';
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

namespace {

/// Do both paths lead to one file, there or not?
bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto resolved = [&error](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  if (std::filesystem::equivalent(a, b, error) && !error) return true;
  return resolved(a) == resolved(b);
}

}  // namespace

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
