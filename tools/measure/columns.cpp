// tools/measure/columns.cpp: places, lines and values; faces and curves have a file of their own.
#include "measure/columns.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/document/write_json.h"
#include "formats/problem/names.h"
#include "measure/regions.h"
#include "options/expression.h"
#include "pliant/geometry/describe.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

void append_cell(std::string& out, double value) {
  if (std::isfinite(value)) append_number(out, value);
}

void measure_point(const PlaceRequest& request, const std::optional<Location>& location, MeasuredFunctions& functions,
                   std::vector<MeasuredColumn>& columns) {
  for (const QuantityRequest& wanted : request.quantities) {
    const std::string column = wanted.column.empty() ? request.prefix + "_" + as_name(wanted.text) : wanted.column;
    for (NamedFunction& each : functions.find(wanted.what, request.text)) {
      double value = no_value;
      if (location) {
        each.function.set(location->triangle);
        value = each.function.at(location->xi);
      }
      columns.push_back({column + each.suffix, wanted.what + " at " + describe_point(request.place), value});
    }
  }
}

void measure_points(const MeasureRequests& requests, MeasuredFunctions& functions,
                    std::vector<std::vector<MeasuredColumn>>& columns_of_place) {
  std::vector<Point> places;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < requests.places.size(); ++k) {
    if (requests.places[k].kind != PlaceRequest::Kind::point) continue;
    places.push_back(requests.places[k].place);
    numbers.push_back(k);
  }
  if (places.empty()) return;
  const auto found = locate_places(functions.mesh(), places, requests.outside);
  for (std::size_t k = 0; k < places.size(); ++k)
    measure_point(requests.places[numbers[k]], found[k], functions, columns_of_place[numbers[k]]);
}

/// Computes the values of --value, each from all columns before it.
void add_values(const MeasureRequests& requests, MeasuredFunctions& functions, std::vector<MeasuredColumn>& columns) {
  for (const auto& [name, text] : requests.values) {
    ExpressionNames names;
    std::vector<double> known;
    for (const MeasuredColumn& column : columns)
      if (fault_of_name(column.name).empty()) names.variables.push_back(column.name);
    for (const auto& parameter : functions.parameters())
      if (std::ranges::find(names.variables, parameter.first) == names.variables.end())
        names.constants.push_back(parameter);
    names.list = "; columns: " + quote_names(names.variables);
    if (!names.constants.empty()) {
      std::vector<std::string> parameters;
      for (const auto& constant : names.constants) parameters.push_back(constant.first);
      names.list += "; parameters: " + quote_names(parameters);
    }
    const std::string opening = "--value " + name + ": ";
    try {
      const Expression formula(text, names);
      if (formula.uses("x") || formula.uses("y"))
        throw UsageError(opening + "\"" + text + "\" uses x or y, but a value has no place");
      for (const std::string& variable : formula.variables())
        known.push_back(std::ranges::find(columns, variable, &MeasuredColumn::name)->value);
      columns.push_back({name, text, formula(0, 0, functions.mesh().time, known)});
    } catch (const std::invalid_argument& error) {
      throw UsageError(opening + error.what());
    }
  }
}

void refuse_doubles(const std::vector<MeasuredColumn>& columns) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (columns[i].name == columns[k].name)
        throw UsageError("two columns would be called \"" + columns[k].name + "\": " + columns[i].meaning + ", and " +
                         columns[k].meaning + "; name one with NAME= before the place or COLUMN= before the quantity");
}

/// The fields along one line, and which columns of the table they are.
struct LineColumns {
  std::vector<NamedFunction> functions;
  std::vector<std::size_t> columns;
};

LineColumns find_columns(const LineRequest& line, MeasuredFunctions& functions, std::vector<std::string>& table) {
  LineColumns result;
  for (const QuantityRequest& wanted : line.quantities)
    for (NamedFunction& each : functions.find(wanted.what, line.text)) {
      const std::string name = (wanted.column.empty() ? as_name(wanted.text) : wanted.column) + each.suffix;
      const auto known = std::ranges::find(table, name);
      const auto column = static_cast<std::size_t>(known - table.begin());
      if (known == table.end()) table.push_back(name);
      if (std::ranges::find(result.columns, column) != result.columns.end())
        throw UsageError(line.text + ": two columns would be called \"" + name + "\"; name one with COLUMN=");
      result.columns.push_back(column);
      result.functions.push_back(std::move(each));
    }
  return result;
}

void sample(const LineRequest& line, LineColumns& wanted, std::size_t width, const MeasureRequests& requests,
            const Mesh& mesh, LineTable& table) {
  std::vector<Point> places(static_cast<std::size_t>(line.samples));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(places.size() - 1);
    places[k] = k + 1 == places.size() ? line.to : line.from + part * (line.to - line.from);
  }
  const auto found = locate_places(mesh, places, requests.outside);
  std::vector<double> cells(width);
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::ranges::fill(cells, no_value);
    if (!found[k]) ++table.outside;
    for (std::size_t f = 0; found[k] && f < wanted.functions.size(); ++f) {
      MeshFunction& function = wanted.functions[f].function;
      function.set(found[k]->triangle);
      cells[wanted.columns[f]] = function.at(found[k]->xi);
    }
    append_cell(table.rows, mesh.time);
    table.rows += "," + line.name + ",";
    append_cell(table.rows, length(places[k] - line.from));
    for (const double value : {places[k].x, places[k].y}) append_cell(table.rows += ',', value);
    for (const double value : cells) append_cell(table.rows += ',', value);
    table.rows += '\n';
  }
}

}  // namespace

std::vector<MeasuredColumn> measure_columns(const MeasureRequests& requests, const Mesh& mesh) {
  MeasuredFunctions functions(mesh, requests.set);
  std::vector<std::vector<MeasuredColumn>> columns_of_place(requests.places.size());
  measure_points(requests, functions, columns_of_place);
  std::vector<MeasuredColumn> columns;
  for (std::size_t k = 0; k < requests.places.size(); ++k) {
    if (requests.places[k].kind != PlaceRequest::Kind::point)
      columns_of_place[k] = measure_region(requests.places[k], functions);
    for (MeasuredColumn& column : columns_of_place[k]) columns.push_back(std::move(column));
  }
  refuse_doubles(columns);
  add_values(requests, functions, columns);
  refuse_doubles(columns);
  return columns;
}

LineTable measure_lines(const MeasureRequests& requests, const Mesh& mesh) {
  MeasuredFunctions functions(mesh, requests.set);
  LineTable table;
  std::vector<std::string> names;
  std::vector<LineColumns> columns;
  for (const LineRequest& line : requests.lines) columns.push_back(find_columns(line, functions, names));
  for (std::size_t k = 0; k < columns.size(); ++k)
    sample(requests.lines[k], columns[k], names.size(), requests, mesh, table);
  table.header = "time,line,s,x,y";
  for (const std::string& name : names) table.header += "," + name;
  table.header += '\n';
  return table;
}

std::string header_of(const std::vector<MeasuredColumn>& columns) {
  std::string text = "time";
  for (const MeasuredColumn& column : columns) text += "," + column.name;
  return text + '\n';
}

std::string row_of(double time, const std::vector<MeasuredColumn>& columns) {
  std::string text;
  append_cell(text, time);
  for (const MeasuredColumn& column : columns) append_cell(text += ',', column.value);
  return text + '\n';
}

}  // namespace pliant
