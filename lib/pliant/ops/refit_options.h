// lib/pliant/ops/refit_options.h: how operations fit what the mesh carries in the new elements.
#pragma once
namespace pliant {

/// How carried fields are fitted after a flip or a removal.
enum class Projection { l2, conservative, limited };

/// What is kept where an operation changes the region that elements cover: functions of degree <= 1 stay themselves, or
/// the integral of each component stays (of a field by face, over each face).
enum class RegionChange { reproduce, conserve };

struct RefitOptions {
  Projection projection = Projection::limited;
  /// A flip of elements whose control points are off their straight places by less than this part of their extent lays
  /// the new edge straight (0: only of straight ones): for meshes whose inner edges are to be straight in the end.
  double straight_below = 0;
  RegionChange region_change = RegionChange::reproduce;
};

}  // namespace pliant
