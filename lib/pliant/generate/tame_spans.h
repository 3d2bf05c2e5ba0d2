// lib/pliant/generate/tame_spans.h: inserts knots until every span may be replaced by its chord.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {

/// What tame_spans has done.
struct TameOutcome {
  std::string failure;  ///< why it failed, with the place; empty if it did not
  long splits = 0;
};
/// Splits spans by knot insertion, which changes no shape, until
/// - no control polygon turns by more than 60 degrees,
/// - no two spans have both ends in common,
/// - the convex hulls of any two spans are apart but for a common end.
/// Then the chords are a planar straight-line graph of the same topology.
///
/// At a cusp hulls cannot be apart, and at angles below 1e-3 radians only those of very short spans could be. There the
/// ends of the spans on both sides get the same distances from the corner, which puts their chords in the order of the
/// curves.
///
/// Refuses     where a span would become shorter than 1e-13 of the boundary's size
/// Complexity  O(n log n) for each of a few rounds
TameOutcome tame_spans(BoundaryComplex& boundary);

/// The length below which no span is made.
///
/// Complexity  O(boundary)
double least_span(const BoundaryComplex& boundary);

/// Splits a span at s in (0, 1); false if one of its parts would be shorter than `least`.
bool split_span(BoundaryComplex& boundary, const BoundarySpan& span, double least, double s = 0.5);

/// Names a span, for example "curve 'wall' (2), parameters 0.5 to 1".
std::string describe_span(const BoundaryComplex& boundary, const BoundarySpan& span);

/// The direction in which a span leaves one of its ends: the first leg of its polygon that has a length.
Vector tangent_at_end(std::span<const Point> polygon, bool at_start);

/// True if the directions of two spans at a common end differ by less than 1e-3 radians.
bool is_narrow(const Vector& a, const Vector& b);

/// True if the directions of two spans at a common end differ by less than 1e-9 radians.
bool is_cusp(const Vector& a, const Vector& b);

}  // namespace pliant
