// tools/run/same_file.h: do two paths lead to one file?
#pragma once
#include <string>

namespace pliant {

/// True also where the file is not there yet.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace pliant
