// lib/pliant/geometry/describe.h: numbers and places in words, with as many digits as they need.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// For example "(0.25, 1)"; each number in the shortest form that reads back as the same double.
std::string describe_point(const Point& p);
std::string describe_number(double value);
/// The same, without digits smaller than `resolution`. For a place in a mesh that is 1e-6 of the mesh's size: places
/// far from the origin then keep the digits that tell them apart.
std::string describe_point(const Point& p, double resolution);
std::string describe_number(double value, double resolution);

/// The resolution for places in a mesh or a boundary, relative to its size.
inline constexpr double place_resolution = 1e-6;

/// Numbers that will stand beside each other, all with the same count of significant digits: the fewest, at least
/// `digits`, with which different numbers look different.
std::vector<std::string> describe_apart(std::span<const double> values, int digits = 6);

}  // namespace pliant
