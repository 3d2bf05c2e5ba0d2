// lib/pliant/mesh/transaction.cpp: changes of a mesh undone, in the reverse order.
#include <algorithm>
#include <bit>

#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh_log.h"

namespace pliant {

// This function is long since it is one list: every kind of change, and how it is taken back.
void Mesh::undo(std::size_t mark) {
  while (log_.size() > mark) {
    const LogEntry entry = log_.back();
    log_.pop_back();
    const std::size_t i = entry.index;
    const auto integer = static_cast<std::int32_t>(static_cast<std::int64_t>(entry.bits));
    const auto real = std::bit_cast<double>(entry.bits);
    switch (entry.what) {
      case Log::point_x:
        points_[i].x = real;
        break;
      case Log::point_y:
        points_[i].y = real;
        break;
      case Log::net:
        nets_[i] = integer;
        break;
      case Log::face:
        triangle_count_ += (integer >= 0 ? 1 : 0) - (faces_[i] >= 0 ? 1 : 0);
        faces_[i] = integer;
        break;
      case Log::twin:
        twins_[i] = HalfEdgeId{integer};
        break;
      case Log::constraint:
        constraints_[i] = integer;
        break;
      case Log::vertex_half_edge:
        vertex_half_edges_[i] = HalfEdgeId{integer};
        break;
      case Log::constraint_curve:
        constraint_curves_[i] = integer;
        break;
      case Log::constraint_first:
        constraint_firsts_[i] = integer;
        break;
      case Log::constraint_start:
        constraint_starts_[i] = real;
        break;
      case Log::grow_triangles:
        faces_.pop_back();
        nets_.resize(nets_.size() - index(net_size_));
        twins_.resize(twins_.size() - 3);
        constraints_.resize(constraints_.size() - 3);
        break;
      case Log::grow_points:
        points_.pop_back();
        vertex_half_edges_.pop_back();
        for (Field& field : fields_)
          if (!field.by_face) field.values.resize(field.values.size() - index(field.components));
        break;
      case Log::grow_constraints:
        constraint_curves_.pop_back();
        constraint_firsts_.pop_back();
        constraint_starts_.pop_back();
        break;
      case Log::grow_places:
        --place_count_;
        for (Field& field : fields_)
          if (field.by_face) field.values.resize(index(place_count_) * index(field.components));
        break;
      case Log::pop_triangle:
        free_triangles_.push_back(integer);
        break;
      case Log::pop_point:
        free_points_.push_back(integer);
        break;
      case Log::pop_constraint:
        free_constraints_.push_back(integer);
        break;
      case Log::pop_place:
        free_places_.push_back(integer);
        break;
      case Log::push_triangle:
        free_triangles_.pop_back();
        break;
      case Log::push_point:
        free_points_.pop_back();
        break;
      case Log::push_constraint:
        free_constraints_.pop_back();
        break;
      case Log::push_place:
        free_places_.pop_back();
        break;
      case Log::insert_place:
        erase_place(places_.find(entry.bits));
        break;
      case Log::erase_place:
        insert_place(entry.bits, static_cast<std::int32_t>(entry.index));
        break;
      case Log::curve_edit:
        boundary_.curves[i].spline.take_back(curve_edits_.back());
        curve_edits_.pop_back();
        break;
      case Log::removal_error:
        boundary_.curves[i].removal_error = real;
        break;
      default: {
        const auto field = static_cast<std::uint32_t>(entry.what) - static_cast<std::uint32_t>(Log::value);
        fields_[field].values[i] = real;
      }
    }
  }
}

void Transaction::commit() {
  assert(open_);
  open_ = false;
  if (--mesh_.recording_ == 0) {
    mesh_.log_.clear();
    mesh_.curve_edits_.clear();
    if (!mesh_.changed_pinches_.empty()) mesh_.forget_stale_pinches();
  }
}

void Transaction::roll_back() {
  assert(open_);
  open_ = false;
  mesh_.undo(mark_);
  --mesh_.recording_;
  // Half-edges that were noted at pinched vertices stay noted: such a mesh is derived anew.
  if (mesh_.changed_pinches_.empty()) mesh_.stale_ = stale_;
}

}  // namespace pliant
