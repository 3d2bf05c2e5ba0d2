// tools/measure/requests.cpp: takes the texts of --at, --line, --face and --curve apart.
#include "measure/requests.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "formats/problem/names.h"
#include "options/expression.h"
#include "options/numbers.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Splits off "NAME=" at the front, where NAME is a name and what follows is not "==".
std::string take_name(std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || text.substr(equals).starts_with("==") ||
      !std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(equals), is_part_of_name))
    return {};
  std::string name = text.substr(0, equals);
  text.erase(0, equals + 1);
  return name;
}

void check_name(const std::string& opening, const std::string& name) {
  if (name == "time") throw UsageError(opening + ": \"time\" is the column of the times");
  if (const std::string fault = fault_of_name(name); !fault.empty()) throw UsageError(opening + ": " + fault);
}

/// The text up to the first ':', which is cut off with it.
std::string take_part(std::string& text, const std::string& opening, const char* wanted) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw UsageError(opening + ": " + wanted + " is wanted");
  std::string part = text.substr(0, colon);
  text.erase(0, colon + 1);
  return part;
}

/// The longest of the names with which the text begins, and which a colon follows; both are cut off.
std::optional<std::string> take_known(std::string& text, const std::vector<std::string>& names) {
  const std::string* found = nullptr;
  for (const std::string& name : names)
    if (text.starts_with(name + ":") && (found == nullptr || name.size() > found->size())) found = &name;
  if (found == nullptr) return {};
  text.erase(0, found->size() + 1);
  return *found;
}

Point parse_place(const std::string& opening, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw UsageError(opening + ": '" + text + "' should be X,Y");
  return {parse_number(opening, text.substr(0, comma)), parse_number(opening, text.substr(comma + 1))};
}

/// The list of what is wanted at a place or along a line: fields and expressions alone.
std::vector<QuantityRequest> parse_list(const std::string& opening, const std::string& list, bool has_arguments) {
  std::vector<QuantityRequest> requests;
  for (std::string part : split_expressions(list)) {
    QuantityRequest request;
    request.column = take_name(part);
    if (!request.column.empty()) check_name(opening, request.column);
    request.text = request.what = part;
    if (part.find_first_not_of(" \t") == std::string::npos)
      throw UsageError(opening + ": there is nothing between two commas, or at an end of the list");
    const std::size_t open = part.find('(');
    if (has_arguments && open != std::string::npos) {
      if (part.back() != ')') throw UsageError(opening + ": '" + part + "' should end with the bracket it opens");
      request.what = part.substr(0, open);
      request.argument = part.substr(open + 1, part.size() - open - 2);
      if (request.argument.empty()) throw UsageError(opening + ": '" + part + "' says nothing between its brackets");
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

}  // namespace

std::string as_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    if (is_part_of_name(c))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

PlaceRequest parse_point(const std::string& text, int number) {
  const std::string opening = "--at " + text;
  PlaceRequest request;
  request.text = opening;
  std::string rest = text;
  request.prefix = take_name(rest);
  if (request.prefix.empty()) request.prefix = "p" + std::to_string(number);
  request.place = parse_place(opening, take_part(rest, opening, "[NAME=]X,Y:FIELD"));
  request.quantities = parse_list(opening, rest, false);
  return request;
}

PlaceRequest parse_region(PlaceRequest::Kind kind, const std::string& text, const std::vector<std::string>& names) {
  const bool is_face = kind == PlaceRequest::Kind::face;
  const std::string opening = (is_face ? "--face " : "--curve ") + text;
  PlaceRequest request;
  request.kind = kind;
  request.source = text;
  request.text = opening;
  std::string rest = text, name;
  std::optional<std::string> target = take_known(rest, names);
  if (!target) {
    name = take_name(rest);
    target = take_known(rest, names);
  }
  request.target =
      target ? *target : take_part(rest, opening, is_face ? "[NAME=]FACE:QUANTITY" : "[NAME=]CURVE:QUANTITY");
  request.prefix = !name.empty() ? name : request.target == "*" ? (is_face ? "all" : "outer") : as_name(request.target);
  if (request.prefix.empty()) request.prefix = is_face ? "face" : "curve";
  request.quantities = parse_list(opening, rest, true);
  return request;
}

LineRequest parse_line(const std::string& text, int number) {
  const std::string opening = "--line " + text;
  const char* const wanted = "[NAME=]X0,Y0:X1,Y1:N:FIELD";
  LineRequest request;
  request.text = opening;
  std::string rest = text;
  request.name = take_name(rest);
  if (request.name.empty()) request.name = std::to_string(number);
  request.from = parse_place(opening, take_part(rest, opening, wanted));
  request.to = parse_place(opening, take_part(rest, opening, wanted));
  const double samples = parse_number(opening, take_part(rest, opening, wanted));
  constexpr int most = 1000000;
  if (!(samples >= 2 && samples <= most) || samples != static_cast<int>(samples))
    throw UsageError(opening + ": the number of samples should be a whole one from 2 to " + std::to_string(most));
  request.samples = static_cast<int>(samples);
  request.quantities = parse_list(opening, rest, false);
  return request;
}

std::pair<std::string, std::string> parse_named(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(option + " " + text + ": NAME=" + (option == "--set" ? "NUMBER" : "EXPR") + " is wanted");
  check_name(option + " " + text, text.substr(0, equals));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace pliant
