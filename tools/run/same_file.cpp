// tools/run/same_file.cpp: do two paths lead to one file?
#include "run/same_file.h"

#include <filesystem>
#include <system_error>

namespace pliant {

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto resolved = [&error](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  if (std::filesystem::equivalent(a, b, error) && !error) return true;
  return resolved(a) == resolved(b);
}

}  // namespace pliant
