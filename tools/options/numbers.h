// tools/options/numbers.h: numbers from the texts of options.
#pragma once
#include <optional>
#include <string>
#include <utility>

namespace pliant {

/// A finite number from an option's text, all of it.   Throws UsageError that names the option
double parse_number(const std::string& option, const std::string& text);
/// The same, above zero.
double parse_positive(const std::string& option, const std::string& text);
double parse_not_negative(const std::string& option, const std::string& text);
/// What is wrong with the text of a number that is to lie between these two, both included; empty if nothing is. For
/// CLI11's `check`, whose own ranges let NaN pass.
std::string fault_of_number(const std::string& text, double low, double high);
/// The whole number in decimal digits that is all of the text; none where there is another text, or no long for it.
std::optional<long> whole_number(const std::string& text);
/// The same.   Throws UsageError that names the option where there is none
long parse_whole_number(const std::string& option, const std::string& text);
/// What is wrong with the text of a whole number that is to lie between these two, as fault_of_number. For options
/// whose text is parsed by parse_whole_number: CLI11 itself takes what is out of range for the greatest number that is
/// not, and 010 for 8.
std::string fault_of_whole_number(const std::string& text, long low, long high);
/// NAME=NUMBER, split at the last '='; the number finite and above zero.
std::pair<std::string, double> parse_named_number(const std::string& option, const std::string& text);

}  // namespace pliant
