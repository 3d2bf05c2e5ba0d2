// lib/pliant/mesh/mesh_log.h: the kinds of change that a transaction notes (private to this layer).
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

// The kind of a change to a value of field f is `value` + f.
enum class Mesh::Log : std::uint32_t {
  point_x,
  point_y,
  net,
  face,
  twin,
  constraint,
  vertex_half_edge,
  constraint_curve,
  constraint_first,
  constraint_start,
  grow_triangles,
  grow_points,
  grow_constraints,
  grow_places,
  pop_triangle,
  pop_point,
  pop_constraint,
  pop_place,
  push_triangle,
  push_point,
  push_constraint,
  push_place,
  insert_place,
  erase_place,
  curve_edit,
  removal_error,
  value
};

}  // namespace pliant
