// lib/pliant/improve/global/free_points.h: new places for all control points of a mesh, free ones in blocks.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The places of the control points of a mesh while many of them are sought at once; the mesh itself stays as it is.
///
/// The points that lie on no curve are free. They form *blocks* that move together: the points inside an edge, the
/// points inside an element, a vertex. Places are in a unit of their own, a power of two of about the size of an
/// element. So nothing is rounded, and nothing that is done with them depends on the unit of the mesh.
class FreePoints {
 public:
  struct Block {
    int first = 0, count = 0;  ///< its slots, which follow each other
    int elements = 0;          ///< how many elements contain it
    bool is_vertex = false;
  };
  explicit FreePoints(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  std::span<const Block> blocks() const { return blocks_; }
  /// The block of a point; none for a point that is not free.
  int block_of(PointId p) const { return block_of_[index(p)]; }
  int slot(PointId p) const { return slots_[index(p)]; }
  PointId point_in(int slot) const { return points_[index(slot)]; }
  /// x and y of a slot, followed by those of the next slots.
  double* coordinates(int slot) { return coordinates_[index(slot)].data(); }
  Point place(PointId p) const {
    const auto& xy = coordinates_[index(slot(p))];
    return {xy[0], xy[1]};
  }
  /// The place in the unit of the mesh.
  Point place_in_mesh(PointId p) const { return unit_ * place(p); }
  using Net = std::array<Point, net_size(max_degree)>;
  /// The net of an element with the places of now, written to `net`.
  std::span<const Point> gather(TriangleId t, Net& net) const;
  bool is_valid(TriangleId t) const;
  /// Is a net certified valid? Its points are in the unit of the places.
  bool is_valid(std::span<const Point> net) const;

 private:
  void put(PointId p);
  void add(std::span<const PointId> points, int elements, bool is_vertex);
  const Mesh* mesh_;
  double unit_ = 1;
  std::vector<int> slots_, block_of_;
  std::vector<PointId> points_;
  std::vector<std::array<double, 2>> coordinates_;
  std::vector<Block> blocks_;
};

}  // namespace pliant
