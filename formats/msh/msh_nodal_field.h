// formats/msh/msh_nodal_field.h: a field that is being read, as values at nodes, which may differ between faces.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Collects the values of elements at the nodes of their nets, and finds out whether they fit together: whether they
/// are the same in all elements of a face around a node, and whether they are the same in all faces.
class MshNodalField {
 public:
  MshNodalField(const MeshData& mesh, int components);

  /// Gives a node its value in all faces.
  void set(PointId node, const double* value);
  /// Gives the nodes of triangle t their values there, net_size(degree) rows in the order of NetLayout.
  void set_triangle(std::size_t t, const double* values, const MeshData& mesh);

  /// Where the values of two triangles of one face differ most. The difference is one of rounding if is_rounding is
  /// true.
  struct Jump {
    double size = 0;
    PointId node = none;
    std::size_t triangle = 0;  ///< the later one of the two
  };
  const Jump& jump_inside_face() const { return inside_; }
  /// True if the difference is not more than rounding of the values' largest.
  bool is_rounding(double difference) const { return difference <= same_value * largest_; }
  /// True if the values of two faces differ at a node.
  bool differs_between_faces() const;
  /// True if all values of the last of three components are 0.
  bool is_flat() const;
  /// Makes the rows narrower: drops all components behind the first `components`.
  void keep_components(int components);

  /// Turns the nodal values into control values, as they are in a document.
  /// Ensures     each edge is converted once for each face, from its vertex of the lower number
  Field take(const MeshData& mesh, bool by_face) &&;

 private:
  static constexpr double same_value = 1e-12;  ///< part of the largest value by which equal values may differ
  std::size_t slot(PointId node, FaceId face, bool& is_new);
  std::size_t slot(PointId node, FaceId face) const;

  std::size_t width_;
  std::size_t points_;
  std::vector<double> values_;      ///< a row for each node, and then one for each further face at a node
  std::vector<FaceId> first_face_;  ///< for each node the face of its row; empty if all faces have the same values
  std::unordered_map<std::uint64_t, std::size_t> further_;  ///< rows of further faces, by node and face
  double largest_ = 0;
  Jump inside_;
};

}  // namespace pliant
