// lib/pliant/geometry/describe.h: numbers and places in words, with as many digits as they need.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// "(0.25, 1)", in the shortest form that reads back.
std::string describe_point(const Point& p);
std::string describe_number(double value);
/// The same of values of which no digits beyond a resolution are wanted. Places in a mesh: 1e-6 of its size, so that
/// far from the origin they have as many digits as tell them apart.
std::string describe_point(const Point& p, double resolution);
std::string describe_number(double value, double resolution);

inline constexpr double place_resolution = 1e-6;  ///< of the size of what holds the place

/// Numbers that stand beside each other, all with the same count of significant digits: the fewest, at least `digits`,
/// that tell each from every other one that is not equal to it.
std::vector<std::string> describe_apart(std::span<const double> values, int digits = 6);

}  // namespace pliant
