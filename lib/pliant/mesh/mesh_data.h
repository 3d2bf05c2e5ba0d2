// lib/pliant/mesh/mesh_data.h: a mesh as its document (formats/mesh.md) has it: plain arrays, nothing derived.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/mesh/ids.h"

namespace pliant {

/// A function carried by the mesh: control values in the basis of the geometry (isoparametric). A field *by face* may
/// jump across curves: it has one value for each *place*, a pair of a control point and a face around it.
struct Field {
  std::string name;
  int components = 1;
  bool by_face = false;
  std::vector<double> values;  ///< for each point (by face: for each of `places`) in order, all its components
  std::vector<std::array<std::int32_t, 2>> places;  ///< only by face: (point, face), sorted
  ExtraMembers extra;
};

/// An edge that lies on a curve of the boundary complex: one span of it.
struct ConstrainedEdge {
  CurveId curve = none;
  int span = 0;                 ///< number of the curve's span
  std::vector<PointId> points;  ///< degree + 1, in the curve's direction
};

/// What the mesh promises about its elements; refine and coarsen take their defaults from here.
///
/// Units       angles in degrees; areas and lengths in the document's units
struct Criteria {
  std::optional<double> min_angle;
  std::optional<double> max_area;
  std::vector<std::pair<std::string, double>> face_area;  ///< face's name, greatest area of its elements
  std::optional<std::string> size;                        ///< the wanted edge length, an expression in x, y, t
  std::optional<std::string> size_field;                  ///< name of a field whose values are wanted edge lengths
  std::optional<double> max_turning;                      ///< greatest angle by which an edge turns
  std::optional<double> accuracy;                         ///< how far curves may be from those that they stand for
  std::optional<double> min_size;                         ///< no two vertices are closer than this
  std::optional<bool> keeps_thin;                         ///< member `thin`: "keep" is true, "refine" is false
  ExtraMembers extra;
};

struct MeshData {
  int degree = 2;
  double time = 0;
  std::vector<Point> points;
  std::vector<PointId> triangles;  ///< net_size(degree) indices per triangle, in the order of NetLayout
  std::vector<FaceId> triangle_faces;
  std::vector<ConstrainedEdge> constrained_edges;
  std::vector<Field> fields;
  BoundaryComplex boundary;
  Criteria criteria;
  ExtraMembers extra;

  HalfEdgeRange half_edges() const { return HalfEdgeRange(static_cast<TriangleId>(triangle_faces.size())); }
};

}  // namespace pliant
