// tools/import-svg.cpp: reads the filled shapes of a drawing as a boundary.
#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "formats/document/byte_source.h"
#include "formats/document/mesh_document.h"
#include "formats/document/recognize.h"
#include "formats/svg_import/svg_reader.h"
#include "options/numbers.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/frame_reports.h"
#include "run/history.h"
#include "run/output_file.h"
#include "run/run_tool.h"
#include "run/stopwatch.h"

namespace {

using namespace pliant;

/// All of the input.
std::string read_input(const std::string& path, const std::string& name) {
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file;
  if (path != "-") {
    file.reset(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) throw std::system_error(errno, std::generic_category(), name);
  }
  ByteSource source(file == nullptr ? stdin : file.get(), name);
  return read_all(source, most_svg_bytes);
}

PassReport summarize(const SvgImport& import) {
  PassReport report;
  const auto count = [&](const char* name, long value) { report.add(name, static_cast<double>(value)); };
  count("shapes", import.shapes);
  count("faces", static_cast<long>(import.boundary.faces.size()));
  count("curves", static_cast<long>(import.boundary.curves.size()));
  count("pieces", import.pieces);
  count("fitted", import.fitted);
  count("smooth_joins", import.smooth);
  count("corners", import.corners);
  report.add("size", import.size);
  report.add("error", import.error);
  count("unfilled", import.unfilled);
  count("hidden", import.hidden);
  count("loops_without_area", import.no_area);
  count("loops_without_border", import.no_border);
  count("intersections", import.intersections);
  report.add("snapped", import.snapped);
  count("slivers", import.slivers);
  report.add("sliver_area", import.sliver_area);
  count("covered", import.covered);
  count("lines", import.lines);
  count("bare_lines", import.bare_lines);
  report.notes = import.warnings;
  report.notes.insert(report.notes.end(), import.costs.begin(), import.costs.end());
  return report;
}

/// Every line of an error starts with the file.
std::string with_file(const std::string& name, const InputError& error) {
  std::string out = name + ": " + (error.pointer().empty() ? "" : error.pointer() + ": ");
  for (const char c : std::string(error.what())) {
    out += c;
    if (c == '\n') out += name + ": ";
  }
  return out;
}

int parse_degree(const std::string& text) {
  const double degree = parse_number("--degree", text);
  if (degree != 2 && degree != 3) throw UsageError("--degree: '" + text + "' is neither 2 nor 3");
  return static_cast<int>(degree);
}

Strokes parse_strokes(const std::string& text) {
  if (text.empty()) return Strokes::left_out;
  if (text == "curves") return Strokes::curves;
  if (text == "area") return Strokes::area;
  throw UsageError("--strokes: '" + text + "' is neither curves nor area");
}

LengthUnit parse_unit(const std::string& text) {
  static constexpr std::array<std::pair<std::string_view, LengthUnit>, 5> units{{{"", LengthUnit::user},
                                                                                 {"mm", LengthUnit::mm},
                                                                                 {"cm", LengthUnit::cm},
                                                                                 {"in", LengthUnit::in},
                                                                                 {"px", LengthUnit::px}}};
  for (const auto& [name, unit] : units)
    if (name == text) return unit;
  throw UsageError("--unit: '" + text + "' is none of mm, cm, in, px");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Read the shapes of an SVG drawing as a boundary of B-splines.", "import-svg"};
  ToolOptions options;
  SvgReadOptions svg;
  std::string degree = "2", tolerance = "1e-6", unit, strokes;
  add_common_options(app, options);
  add_form_option(app, options);
  app.get_option("--to")->description("the form of the document; json by default");
  app.add_option("--degree", degree, "of the curves: 2, or 3, which takes cubic curves exactly")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--tolerance", tolerance,
                 "of cubic curves and arcs that are fitted, and of what meets, as a part of the drawing's size")
      ->type_name("T")
      ->capture_default_str();
  app.add_option("--unit", unit,
                 "mm, cm, in or px: coordinates are lengths on the page; without it they are user units")
      ->type_name("mm|cm|in|px");
  app.add_option("--strokes", strokes,
                 "curves: strokes cut faces; area: what they paint becomes faces; implies --planar")
      ->type_name("curves|area");
  app.add_flag("--planar", svg.planar, "take shapes that meet; each face is what is seen of its shape");
  return run_tool(app, argc, argv, options, [&] {
    constexpr double least_tolerance = 1e-12;
    svg.degree = parse_degree(degree);
    svg.tolerance = parse_positive("--tolerance", tolerance);
    if (svg.tolerance < least_tolerance || svg.tolerance > 1)
      throw UsageError("--tolerance: '" + tolerance + "' is not between 1e-12 and 1");
    svg.unit = parse_unit(unit);
    svg.strokes = parse_strokes(strokes);
    OutputFile output(options.output);
    FrameReports reports(options);
    Stopwatch watch;
    Frame frame;
    frame.source = options.input == "-" ? "standard input" : options.input;
    const std::string bytes = read_input(options.input, frame.source);
    SvgImport import;
    try {
      import = read_svg(bytes, svg);
    } catch (const InputError& e) {
      const std::string other = describe_other_kind(bytes, FileKind::svg);
      throw InputError("", other.empty() ? with_file(frame.source, e) : frame.source + ": " + other);
    }
    if (!options.verbose) {  // else they are notes of the report
      for (const std::string& warning : import.warnings) say(options, frame.source + ": " + warning);
      for (const std::string& cost : import.costs) say(options, frame.source + ": " + cost);
    }
    const double read = watch.lap();
    record(options, import.boundary.extra);
    std::string text;
    write_boundary(import.boundary, text, options.output_form(DocumentForm::json));
    output.write(text);
    reports.add(frame, 0, summarize(import), {{"read", read}, {"write", watch.lap()}});
    output.commit();
    return status::done;
  });
}
