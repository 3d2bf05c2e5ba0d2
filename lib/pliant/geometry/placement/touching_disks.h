// lib/pliant/geometry/placement/touching_disks.h: the disks beside a curve that reach the next point of a curve.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// A part of a curve without corners: numbers of the places where it starts and ends, or -1, which is no place.
/// Stretches that share an end do not count for each other.
struct CurveStretch {
  int first = -1, last = -1;
};
struct CurveSample {
  Point place;
  Vector tangent;  ///< unit; zero: no disk is asked for here
  int stretch;
};

/// For each sample the radius of the smaller of the two disks that touch its curve there, one from each side, and have
/// no other sample inside that counts; at most `widest`, and that where no disk is asked for.
/// Reference   Ma, Bae, Choi, 3D medial axis point approximation using nearest neighbors and the normal field
/// Complexity  expected O(samples * log)
std::vector<double> touching_disks(std::span<const CurveSample> samples, std::span<const CurveStretch> stretches,
                                   double widest);

}  // namespace pliant
