// tools/qualityreport.cpp: measures meshes and writes what it found, for eyes, scripts and makefiles.
#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>

#include "formats/document/history.h"
#include "formats/report/report_csv.h"
#include "formats/report/report_html.h"
#include "formats/report/report_json.h"
#include "formats/report/report_text.h"
#include "options/obstacles.h"
#include "pliant/geometry/describe.h"
#include "pliant/mesh/documents/document_unit.h"
#include "pliant/quality/element/condition.h"
#include "pliant/quality/quality_report.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/run_tool.h"
#include "run/stopwatch.h"

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

CLI::Validator width_of_bounds() {
  return CLI::Validator(
      [](std::string& text) {
        double width = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), width);
        const bool is_width = error == std::errc() && end == text.data() + text.size() && width > 0 && width <= 1;
        return is_width ? std::string() : "'" + text + "' is not a number above 0 and at most 1";
      },
      "");
}

struct ReportOptions {
  QualityOptions quality;
  std::string format = "text";
  std::string title;
  std::vector<std::string> circle_texts, drawings;
  std::vector<Circle> circles;
  std::vector<std::vector<Point>> outlines;
  std::vector<std::string> condition_texts;
  std::vector<Condition> conditions;

  void add(CLI::App& app) {
    app.add_option("--format", format,
                   "text; a line of JSON a frame; a table with a line an element; a page that draws the mesh")
        ->type_name("text|json|csv|html")
        ->check(CLI::IsMember({"text", "json", "csv", "html"}).description(""))
        ->capture_default_str();
    app.add_option("--title", title, "heading of the HTML page")->type_name("TEXT");
    app.add_option("--circle", circle_texts, "draw a disk, an obstacle say, on the HTML page; repeatable")
        ->type_name("X,Y,R")
        ->allow_extra_args(false);
    app.add_option("--svg", drawings,
                   "draw the filled shapes of an SVG drawing as obstacles on the HTML page; repeatable")
        ->type_name("FILE")
        ->allow_extra_args(false);
    app.add_option("--worst", quality.worst, "list this many worst elements of each metric")
        ->type_name("N")
        ->check(count_up_to(10'000'000))
        ->capture_default_str();
    app.add_option("--bins", quality.bins, "bins of the histograms; 0: none")
        ->type_name("N")
        ->check(count_up_to(100'000))
        ->capture_default_str();
    app.add_option("--jacobian-width", quality.jacobian_width,
                   "how far the bounds of det J may be off, relative to its largest coefficient")
        ->type_name("W")
        ->check(width_of_bounds())
        ->capture_default_str();
    app.add_option("--face", quality.faces, "measure this face only; repeatable")
        ->type_name("FACE")
        ->allow_extra_args(false);
    app.add_option("--fail-if", condition_texts, "exit with status 1 if this holds for any frame; repeatable")
        ->type_name("'KEY OP NUMBER'")
        ->allow_extra_args(false);
  }

  void check() {
    if (format != "html" && !title.empty()) throw UsageError("--title belongs to --format html");
    if (format != "html" && !(circle_texts.empty() && drawings.empty()))
      throw UsageError("--circle and --svg belong to --format html");
    circles = parse_circles(circle_texts);
    for (const std::string& file : drawings)
      for (std::vector<Point>& outline : read_outlines(file)) outlines.push_back(std::move(outline));
    for (const std::string& text : condition_texts) {
      try {
        conditions.emplace_back(text);
      } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--fail-if: ") + error.what());
      }
    }
  }
};

/// Where a mesh came from, for people.
std::string place_of(const Frame& frame) { return frame.source + ": frame " + std::to_string(frame.index); }

/// The reports of a series in the chosen format.
class ReportWriter {
 public:
  ReportWriter(const ReportOptions& options, OutputFile& output) : options_(options), output_(output) {}

  bool wants_elements() const { return options_.format == "csv" || options_.format == "html"; }

  void write(const MeshData& mesh, const QualityReport& report, const ElementFigures& elements, const Frame& frame) {
    text_.clear();
    if (options_.format == "json") {
      write_report(report, history_of(mesh.extra), text_);
    } else if (options_.format == "csv") {
      if (!has_begun_) write_csv_header(elements, text_);
      write_csv_elements(mesh, elements, frame.index, text_);
    } else if (options_.format == "html") {
      if (!has_begun_)
        HtmlReport::begin({title(frame), options_.quality.worst, options_.circles, options_.outlines}, text_);
      HtmlReport::frame(mesh, report, elements, frame.source, text_);
    } else {
      if (has_begun_) text_ += '\n';
      write_report_text(report, history_of(mesh.extra), place_of(frame), text_);
    }
    has_begun_ = true;
    output_.write(text_);
  }

  /// Also where a later frame failed: a page is whole, with the frames before.
  void finish() {
    if (!has_begun_ || options_.format != "html") return;
    text_.clear();
    HtmlReport::end(text_);
    output_.write(text_);
  }

 private:
  std::string title(const Frame& frame) const {
    return options_.title.empty() ? "Quality of " + frame.source.substr(frame.source.rfind('/') + 1) : options_.title;
  }

  const ReportOptions& options_;
  OutputFile& output_;
  bool has_begun_ = false;
  std::string text_;
};

/// Says which conditions hold, also with -q; true if any does.
bool complain(const ToolOptions& options, const Frame& frame, const std::vector<Condition>& conditions,
              const QualityReport& report) {
  bool any = false;
  for (const Condition& condition : conditions) {
    if (!condition.holds(report)) continue;
    any = true;
    const std::array values{*condition.value(report), condition.bound()};
    say_failure(options, place_of(frame) + ": " + condition.text() + ": it is " + describe_apart(values).front());
  }
  return any;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measure the quality of a mesh: validity, shape, curvature, sizes, fields.", "qualityreport"};
  ToolOptions options;
  ReportOptions own;
  add_common_options(app, options, false);
  own.add(app);
  return run_tool(app, argc, argv, options, [&] {
    own.check();
    OutputFile output(options.output);
    ReportWriter writer(own, output);
    bool has_failed = false;
    const auto report_on = [&](MeshData&& mesh, const Frame& frame) {
      Stopwatch watch;
      QualityReport report;
      ElementFigures elements;
      normalize_unit(mesh);
      const double unit = mesh.boundary.unit;
      try {
        report = report_quality(mesh, own.quality, writer.wants_elements() ? &elements : nullptr);
      } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--face: ") + error.what());
      }
      if (options.verbose) say(options, place_of(frame) + ": measured in " + std::to_string(watch.lap()) + " s");
      restore_unit(report, elements, unit);
      restore_unit(mesh);
      if (unit != 1)
        for (Fault& fault : report.faults) fault.text += " (" + explain_unit(unit) + ")";
      writer.write(mesh, report, elements, frame);
      has_failed = complain(options, frame, own.conditions, report) || has_failed;
    };
    try {
      for_each_mesh(options, report_on);
    } catch (...) {
      writer.finish();
      throw;
    }
    writer.finish();
    output.commit();
    return has_failed ? status::check_failed : status::done;
  });
}
