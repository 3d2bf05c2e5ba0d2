// formats/document/pointer_step.h: one step of a JSON pointer (RFC 6901) as the name that it stands for.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

inline std::string unescape_step(std::string_view step) {
  std::string name;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const bool is_escape = step[i] == '~' && i + 1 < step.size();
    name += !is_escape ? step[i] : step[++i] == '1' ? '/' : '~';
  }
  return name;
}

}  // namespace pliant
