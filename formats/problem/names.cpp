// formats/problem/names.cpp: names of parameters and fields against those that expressions have anyway.
#include "formats/problem/names.h"

#include <algorithm>

#include "formats/document/characters.h"
#include "formats/document/recognize.h"
#include "formats/document/write_json.h"

namespace pliant {
namespace {

bool starts_name(char c) { return is_letter(c) || c == '_'; }

}  // namespace

const std::vector<std::string>& expression_functions() {
  static const std::vector<std::string> names{"sin",  "cos",   "tan",   "asin",  "acos",  "atan",  "atan2", "sinh",
                                              "cosh", "tanh",  "asinh", "acosh", "atanh", "exp",   "ln",    "log",
                                              "log2", "log10", "sqrt",  "abs",   "sign",  "rint",  "min",   "max",
                                              "sum",  "avg",   "pow",   "mod",   "hypot", "floor", "ceil"};
  return names;
}

std::string fault_of_name(std::string_view name) {
  constexpr std::size_t longest = 64;
  if (name.empty() || !starts_name(name.front()) ||
      !std::ranges::all_of(name, [](char c) { return starts_name(c) || is_digit(c); }))
    return "a name in expressions consists of letters, digits and _, and does not begin with a digit";
  if (name.size() > longest) return "a name in expressions has at most " + std::to_string(longest) + " characters";
  if (name == "x" || name == "y") return "\"" + std::string(name) + "\" is a coordinate";
  if (name == "t") return "\"t\" is the time";
  if (name == "pi" || name == "_pi" || name == "_e") return "\"" + std::string(name) + "\" is a number of its own";
  if (std::ranges::find(expression_functions(), name) != expression_functions().end())
    return "\"" + std::string(name) + "\" is a function";
  return {};
}

std::string quote_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  const std::size_t shown = names.size() > most + 1 ? most : names.size();  // one more is not worth "1 more"
  std::string text;
  for (std::size_t k = 0; k < shown; ++k) {
    if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
    append_string(text, names[k]);
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

std::string known_names(std::string_view name, const std::string& what, const std::vector<std::string>& names) {
  if (names.empty()) return "; there are no " + what;
  const std::string nearest = nearest_word(name, names);
  std::string text;
  if (!nearest.empty()) {
    text += "; is ";
    append_string(text, nearest);
    text += " meant?";
  } else {
    text += ";";
  }
  return text + (names.size() == 1 ? " there is only " : " the " + what + " are ") + quote_names(names);
}

std::string pointer_step(std::string_view name) {
  std::string step = "/";
  for (const char c : name) {
    if (c == '~')
      step += "~0";
    else if (c == '/')
      step += "~1";
    else
      step += c;
  }
  return step;
}

}  // namespace pliant
