// tools/completion/value_type.h: the name of a value's type, such as `FLOW[:KEY=VALUE,...]|FILE`, taken apart.
#pragma once
#include <string>
#include <vector>

namespace pliant {

/// One of the forms that the name of a type lists: `field:FIELD[.COMPONENT]` is the literal "field:", the word FIELD
/// and what follows; `keep` is a literal alone. A name that may be given in front ("[NAME=]FACE:...") is left out.
struct ValueType {
  std::string literal;
  std::string word;
  std::string follows;
};

/// The forms, which `|` separates. What CLI11 adds to a name, {a,b} for choices and bounds of numbers, is understood.
std::vector<ValueType> value_types(const std::string& type_name);

/// Whether the word is one whose names are known: FACE, CURVE, FIELD, FLOW, METRIC, PARAMETER.
bool is_name_word(const std::string& word);

}  // namespace pliant
