#include <CLI/CLI.hpp>
#include <limits>
#include <stdexcept>

#include "filter.h"
#include "formats/report_json.h"
#include "formats/report_text.h"
#include "pliant/quality/condition.h"
#include "pliant/quality/quality_report.h"  // tools/qualityreport.cpp

namespace {

using namespace pliant;

/// A count that is not read in another base, nor wraps.
CLI::Validator count_up_to(int most) {
  return CLI::Validator(
      [most](std::string& text) {
        const bool is_count = !text.empty() && text.size() < 9 && (text == "0" || text[0] != '0') &&
                              text.find_first_not_of("0123456789") == std::string::npos && std::stoi(text) <= most;
        return is_count ? std::string() : "'" + text + "' is not a number from 0 to " + std::to_string(most);
      },
      "");
}

struct ReportOptions {
  QualityOptions quality;
  std::string format = "text";
  std::vector<std::string> condition_texts;
  std::vector<Condition> conditions;

  void add(CLI::App& app) {
    app.add_option("--format", format, "text, or a line of JSON a frame")
        ->type_name("text|json")
        ->check(CLI::IsMember({"text", "json"}).description(""))
        ->capture_default_str();
    app.add_option("--worst", quality.worst, "list this many worst elements of each metric")
        ->type_name("N")
        ->check(count_up_to(10'000'000))
        ->capture_default_str();
    app.add_option("--bins", quality.bins, "bins of the histograms; 0: none")
        ->type_name("N")
        ->check(count_up_to(100'000))
        ->capture_default_str();
    app.add_option("--face", quality.faces, "measure this face only; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--fail-if", condition_texts, "exit with status 1 if this holds for any frame; repeatable")
        ->type_name("'KEY OP NUMBER'")
        ->allow_extra_args(false);
  }

  void check() {
    for (const std::string& text : condition_texts) {
      try {
        conditions.emplace_back(text);
      } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--fail-if: ") + error.what());
      }
    }
  }
};

/// Says which conditions hold; true if any does.
bool complain(const ToolOptions& options, const Frame& frame, const std::vector<Condition>& conditions,
              const QualityReport& report) {
  bool any = false;
  for (const Condition& condition : conditions) {
    if (!condition.holds(report)) continue;
    any = true;
    char value[32];
    std::snprintf(value, sizeof value, "%.6g", *condition.value(report));
    say(options,
        frame.source + ": frame " + std::to_string(frame.index) + ": " + condition.text() + ": it is " + value);
  }
  return any;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measure the quality of a mesh: validity, shape, curvature, sizes, fields.", "qualityreport"};
  ToolOptions options;
  ReportOptions own;
  options.takes_msh = true;
  add_common_options(app, options, false);
  own.add(app);
  return run_tool(app, argc, argv, options, [&] {
    own.check();
    OutputFile output(options.output);
    bool has_failed = false;
    std::string text;
    for_each_mesh(options, [&](MeshData&& mesh, const Frame& frame) {
      Stopwatch watch;
      QualityReport report;
      try {
        report = report_quality(mesh, own.quality);
      } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--face: ") + error.what());
      }
      text.clear();
      if (own.format == "json") {
        write_report(report, text);
      } else {
        if (frame.index > 0) text += '\n';
        write_report_text(report, frame.source + ": frame " + std::to_string(frame.index), text);
      }
      output.write(text);
      if (options.verbose)
        say(options, frame.source + ": frame " + std::to_string(frame.index) + ": measured in " +
                         std::to_string(watch.lap()) + " s");
      has_failed = complain(options, frame, own.conditions, report) || has_failed;
    });
    output.commit();
    return has_failed ? status::check_failed : status::done;
  });
}
