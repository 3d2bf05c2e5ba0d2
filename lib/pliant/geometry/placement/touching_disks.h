// lib/pliant/geometry/placement/touching_disks.h: the disks that touch a curve and reach to the next one beside it.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// A part of a curve without corners, given by the numbers of the places where it starts and ends; -1 where it has no
/// end. Samples of two stretches that share an end do not limit each other's disks.
struct CurveStretch {
  int first = -1, last = -1;
};
struct CurveSample {
  Point place;
  Vector tangent;  ///< of length 1, or zero if no disk is wanted here
  int stretch;
};

/// For each sample, the radius of the smaller one of two disks. They touch its curve there, one from each side, and are
/// the largest ones without another sample inside that limits them. The radius is at most `widest`, and is `widest`
/// where no disk is wanted.
/// Reference   Ma, Bae, Choi, 3D medial axis point approximation using nearest neighbors and the normal field
/// Complexity  expected O(samples * log)
std::vector<double> touching_disks(std::span<const CurveSample> samples, std::span<const CurveStretch> stretches,
                                   double widest);

}  // namespace pliant
