// tools/completion/value_type.cpp: takes the name of a value's type apart.
#include "completion/value_type.h"

#include <algorithm>
#include <cctype>

namespace pliant {
namespace {

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_in_word(char c) { return is_upper(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

ValueType take_apart(std::string text) {
  if (text.starts_with("[NAME=]")) text.erase(0, 7);
  if (text.starts_with("[FACE=]")) text = "FACE=" + text.substr(7);
  const auto first = std::ranges::find_if(text, is_upper);
  const auto last = std::find_if_not(first, text.end(), is_in_word);
  return {{text.begin(), first}, {first, last}, {last, text.end()}};
}

}  // namespace

std::vector<ValueType> value_types(const std::string& type_name) {
  std::vector<ValueType> types;
  const std::size_t open = type_name.find(":{"), close = type_name.find('}');
  const bool has_members = open != std::string::npos && close != std::string::npos;
  std::string list = has_members ? type_name.substr(open + 2, close - open - 2) : type_name;
  if (!has_members) list.erase(std::min(list.find(" in ["), list.size()));
  const char separator = has_members ? ',' : '|';
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t end = std::min(list.find(separator, from), list.size());
    const std::string text = list.substr(from, end - from);
    if (!text.empty()) types.push_back(has_members ? ValueType{text, {}, {}} : take_apart(text));
    from = end + 1;
  }
  return types;
}

bool is_name_word(const std::string& word) {
  return word == "FACE" || word == "CURVE" || word == "FIELD" || word == "FLOW" || word == "METRIC" ||
         word == "PARAMETER";
}

}  // namespace pliant
