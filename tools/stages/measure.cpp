// tools/stages/measure.cpp: the options of measure, and where its tables go.
#include "stages/measure.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "options/numbers.h"
#include "run/exit_status.h"
#include "run/same_file.h"

namespace pliant {

void MeasureStage::add_options(CLI::App& app) {
  const auto add = [&app](const char* name, std::vector<std::string>& texts, const char* help, const char* type) {
    app.add_option(name, texts, help)->type_name(type)->allow_extra_args(false);
  };
  app.add_option("--csv", csv_,
                 "append a line for each mesh to this table, with a header if it is new; -: standard output, and no "
                 "meshes")
      ->type_name("FILE");
  add("--at", points_, "fields or expressions at a place (repeatable)", "[NAME=]X,Y:FIELD,...");
  add("--face", faces_,
      "quantities of a face, or of the mesh (*): area, centre, perimeter, circularity, deformation, inclination, "
      "mean(FIELD), integral(FIELD), min(FIELD), max(FIELD), flux(FIELD) (repeatable)",
      "[NAME=]FACE:QUANTITY,...");
  add("--curve", curves_,
      "quantities of the curves of a name, or of all outer ones (*): length, centre, area, circularity, deformation, "
      "inclination, force, mean(FIELD), integral(FIELD), min(FIELD), max(FIELD), flux(FIELD) (repeatable)",
      "[NAME=]CURVE:QUANTITY,...");
  add("--value", values_, "a column computed from those before it, parameters and t (repeatable)", "NAME=EXPR");
  add("--set", set_, "a parameter for expressions, before those of the mesh's problem (repeatable)",
      "PARAMETER=NUMBER");
  add("--line", lines_, "N samples of fields or expressions along a line, for --lines-csv (repeatable)",
      "[NAME=]X0,Y0:X1,Y1:N:FIELD,...");
  app.add_option("--lines-csv", lines_csv_, "append a line for each sample to this table; -: standard output")
      ->type_name("FILE");
  app.add_option("--outside", outside_, "a place outside the mesh gives an empty cell, or the boundary's nearest point")
      ->type_name("empty|nearest")
      ->capture_default_str();
  app.add_flag("--explain", wants_explanation_, "print what the columns are; write no tables and no meshes");
}

void MeasureStage::check(const CLI::App& app) {
  if (outside_ != "empty" && outside_ != "nearest")
    throw UsageError("--outside: \"" + outside_ + "\" is neither empty nor nearest");
  read_requests();
  const bool has_columns = !requests_.places.empty() || !requests_.values.empty();
  if (!has_columns && requests_.lines.empty())
    throw UsageError("there is nothing to measure: give --at, --face, --curve, --value or --line");
  if (!wants_explanation_) {
    if (has_columns && csv_.empty()) throw UsageError("--csv FILE is required: where the columns go");
    if (!requests_.lines.empty() && lines_csv_.empty())
      throw UsageError("--line needs --lines-csv FILE: where the samples go");
  }
  if (!has_columns && !csv_.empty()) throw UsageError("--csv has no columns: give --at, --face, --curve or --value");
  if (requests_.lines.empty() && !lines_csv_.empty()) throw UsageError("--lines-csv has no samples: give --line");
  check_files(app);
}

void MeasureStage::read_requests() {
  requests_ = {};
  for (const std::string& text : points_)
    requests_.places.push_back(parse_point(text, static_cast<int>(requests_.places.size()) + 1));
  for (const std::string& text : faces_) requests_.places.push_back(parse_region(PlaceRequest::Kind::face, text));
  for (const std::string& text : curves_) requests_.places.push_back(parse_region(PlaceRequest::Kind::curve, text));
  for (const std::string& text : lines_) {
    requests_.lines.push_back(parse_line(text, static_cast<int>(requests_.lines.size()) + 1));
    const std::string& name = requests_.lines.back().name;
    if (std::ranges::count(requests_.lines, name, &LineRequest::name) > 1)
      throw UsageError("--line " + text + ": another line is called " + name + ", too");
  }
  for (const std::string& text : values_) requests_.values.push_back(parse_named("--value", text));
  for (const std::string& text : set_) {
    const auto [name, value] = parse_named("--set", text);
    if (std::ranges::find(requests_.set, name, &std::pair<std::string, double>::first) != requests_.set.end())
      throw UsageError("--set " + text + ": " + name + " is given twice");
    requests_.set.emplace_back(name, parse_number("--set " + name, value));
  }
  requests_.outside = outside_ == "nearest" ? OutsidePlaces::nearest : OutsidePlaces::empty;
}

void MeasureStage::check_files(const CLI::App& app) {
  const auto is_one_file = [](const std::string& a, const std::string& b) {
    if (a.empty() || b.empty() || a == "/dev/null") return false;
    return a == "-" || b == "-" ? a == b : is_same_file(a, b);
  };
  if (is_one_file(csv_, lines_csv_))
    throw UsageError("--csv and --lines-csv are two tables, and cannot go to one file");
  for (const char* const option : {"INPUT", "--output", "--report"}) {
    const CLI::Option* const other = app.get_option_no_throw(option);
    if (other == nullptr || other->count() == 0) continue;
    for (const std::string& table : {csv_, lines_csv_})
      if (table != "-" && is_one_file(table, other->as<std::string>()))
        throw UsageError("'" + table + "' is both a table and " + option);
  }
  table_.reset();
  lines_table_.reset();
  if (!csv_.empty() && csv_ != "-") table_ = std::make_unique<TableFile>("--csv", csv_);
  if (!lines_csv_.empty() && lines_csv_ != "-") lines_table_ = std::make_unique<TableFile>("--lines-csv", lines_csv_);
}

std::string MeasureStage::explanation(Mesh& mesh) const {
  const std::vector<MeasuredColumn> columns = measure_columns(requests_, mesh);
  const LineTable lines = measure_lines(requests_, mesh);
  std::string text;
  if (wants_explanation_) {
    text += "time: the time of the mesh\n";
    for (const MeasuredColumn& column : columns) text += column.name + ": " + column.meaning + "\n";
    if (!requests_.lines.empty()) text += "samples along lines: " + lines.header;
    return text;
  }
  if (table_) table_->append(header_of(columns), mesh.time, row_of(mesh.time, columns));
  if (lines_table_) lines_table_->append(lines.header, mesh.time, lines.rows);
  const std::string header = csv_ == "-" ? header_of(columns) : lines.header;
  if (std::exchange(printed_header_, header) != header) text += header;
  return text + (csv_ == "-" ? row_of(mesh.time, columns) : lines.rows);
}

PassReport MeasureStage::run(Mesh& mesh, const StageContext&) const {
  // All is measured before anything is written, so that a mesh that is refused leaves both tables as they were.
  const std::vector<MeasuredColumn> columns = measure_columns(requests_, mesh);
  const LineTable lines = measure_lines(requests_, mesh);
  if (table_) table_->append(header_of(columns), mesh.time, row_of(mesh.time, columns));
  if (lines_table_) lines_table_->append(lines.header, mesh.time, lines.rows);
  PassReport report;
  report.add("columns", static_cast<double>(columns.size()));
  report.add("empty", static_cast<double>(std::ranges::count_if(
                          columns, [](const MeasuredColumn& column) { return !std::isfinite(column.value); })));
  report.add("outside", static_cast<double>(lines.outside));
  return report;
}

}  // namespace pliant
