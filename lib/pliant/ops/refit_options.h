// lib/pliant/ops/refit_options.h: how operations fit fields and control points in the elements that they change.
#pragma once
namespace pliant {

/// How carried fields are fitted after a flip, a removal or a move. Functions of degree <= 1 are always reproduced.
enum class Projection {
  l2,            ///< least squares alone
  conservative,  ///< least squares that keep the integral of each component
  limited        ///< the same, with values limited by the range of the old ones
};

/// What is kept when an operation changes the region that the elements cover.
enum class RegionChange {
  reproduce,  ///< functions of degree <= 1
  conserve    ///< the integral of each component, over each face if the field is by face
};

struct RefitOptions {
  Projection projection = Projection::limited;
  /// A flip makes the new edge straight if the old elements are nearly so: no control point is farther from its
  /// straight place than this part of their longest edge (0: the old elements must be straight to rounding). For meshes
  /// whose inner edges are to be straight in the end.
  double straight_below = 0;
  RegionChange region_change = RegionChange::reproduce;
};

}  // namespace pliant
