// lib/pliant/quality/nan.h: what a measure is where it has no value.
#pragma once
#include <limits>

namespace pliant {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace pliant
