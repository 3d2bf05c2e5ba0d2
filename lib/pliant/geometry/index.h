// lib/pliant/geometry/index.h: signed indices, converted to the unsigned ones of the standard library's containers.
#pragma once
#include <concepts>
#include <cstddef>

namespace pliant {

/// The index as a std::size_t.   Requires    i >= 0
template <std::integral I>
constexpr std::size_t index(I i) {
  return static_cast<std::size_t>(i);
}

}  // namespace pliant
