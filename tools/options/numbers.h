// tools/options/numbers.h: numbers from the texts of options.
#pragma once
#include <string>
#include <utility>

namespace pliant {

/// A finite number from an option's text, all of it.   Throws UsageError that names the option
double parse_number(const std::string& option, const std::string& text);
/// The same, above zero.
double parse_positive(const std::string& option, const std::string& text);
double parse_not_negative(const std::string& option, const std::string& text);
/// NAME=NUMBER, split at the last '='; the number finite and above zero.
std::pair<std::string, double> parse_named_number(const std::string& option, const std::string& text);

}  // namespace pliant
