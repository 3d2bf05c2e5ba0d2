// formats/problem/names.h: which names expressions can use, and names in messages.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The functions that expressions know.
const std::vector<std::string>& expression_functions();

/// Why no parameter, and no field that an expression uses, can have this name: it is no identifier, or already means
/// something. Empty if one can.
std::string fault_of_name(std::string_view name);

/// `"a", "b" and "c"`; the first twenty of many, and how many more there are.
std::string quote_names(const std::vector<std::string>& names);

/// For a name that is not known: what it may have been meant to be, and what there is, as `; is "cell" meant? the faces
/// are "cell" and "fluid"`; `what` is a plural.
std::string known_names(std::string_view name, const std::string& what, const std::vector<std::string>& names);

/// The name as a step of a JSON pointer (RFC 6901): "/" in front, escaped.
std::string pointer_step(std::string_view name);

}  // namespace pliant
