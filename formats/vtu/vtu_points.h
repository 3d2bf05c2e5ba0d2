// formats/vtu/vtu_points.h: the points of a VTK file, which has one for each face where a field has a value for each.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The points of a file: those of the mesh or, if a field is by face, its places, pairs of a point and a face.
class VtuPoints {
 public:
  /// Keeps a reference to the mesh.   Requires    M6
  explicit VtuPoints(const MeshData& mesh);
  std::size_t size() const { return places_ == nullptr ? mesh_.points.size() : places_->size(); }
  /// The number in the file of a control point of an element of this face.
  std::int32_t number(PointId point, FaceId face) const;
  /// The control point that has this number.
  PointId point(std::size_t number) const {
    return places_ == nullptr ? static_cast<PointId>(number) : (*places_)[number][0];
  }

 private:
  const MeshData& mesh_;
  const std::vector<std::array<std::int32_t, 2>>* places_ = nullptr;
  std::vector<std::int32_t> first_;  // for each control point its first place
};

/// Rows of numbers on control points: positions or the values of a field.
struct VtuRows {
  int width;
  std::span<const double> values;
  bool by_face;  ///< there is a row for each number of VtuPoints, else for each control point
};

/// For each number of `points` its control values or, if `at_nodes`, the values of the Bézier forms at the nodes of
/// Lagrange elements, of which (i, j, k) is at the barycentric coordinates (i, j, k) / degree.
class VtuNodes {
 public:
  VtuNodes(const MeshData& mesh, const VtuPoints& points, bool at_nodes);
  /// The row of each number. `storage` holds the result if it is none of the mesh's arrays.
  std::span<const double> rows(const VtuRows& control, std::vector<double>& storage) const;

 private:
  void evaluate(int width, std::span<const double> control, std::vector<double>& nodes) const;

  const MeshData& mesh_;
  const VtuPoints& points_;
  bool at_nodes_;
  std::vector<double> on_edge_;    // values of the basis of an edge at k / degree: degree + 1 for each k
  std::vector<double> on_inside_;  // values of the basis of the triangle at its inner nodes
};

}  // namespace pliant
