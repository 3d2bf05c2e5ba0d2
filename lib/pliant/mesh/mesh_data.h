// lib/pliant/mesh/mesh_data.h: a mesh as its document has it: plain arrays, nothing derived, nothing assumed.
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

/// A function carried by the mesh: control values in the basis of the geometry (isoparametric).
struct Field {
  std::string name;
  int components = 1;
  bool by_face = false;
  std::vector<double> values;  ///< components fastest, in the order of points, or of `places` if by face
  std::vector<std::array<std::int32_t, 2>> places;  ///< by face: (point, face), sorted; otherwise empty
  ExtraMembers extra;
};

struct ConstrainedEdge {
  CurveId curve = none;
  int span = 0;                 ///< number of the curve's span
  std::vector<PointId> points;  ///< degree + 1, in the curve's direction
};

/// What the mesh promises: the defaults of refine and coarsen. Angles in degrees, areas and lengths in mesh units.
struct Criteria {
  std::optional<double> min_angle;
  std::optional<double> max_area;
  std::vector<std::pair<std::string, double>> face_area;
  std::optional<std::string> size;        ///< expression in x, y, t
  std::optional<std::string> size_field;  ///< name of a field of wanted lengths
  std::optional<double> max_turning;
  std::optional<double> min_size;
  std::optional<bool> keeps_thin;  ///< `thin`: "keep" (true) or "refine"
  ExtraMembers extra;
};

struct MeshData {
  int degree = 2;
  double time = 0;
  std::vector<Point> points;
  std::vector<PointId> triangles;  ///< net_size(degree) indices a triangle, in the order of NetLayout
  std::vector<FaceId> triangle_faces;
  std::vector<ConstrainedEdge> constrained_edges;
  std::vector<Field> fields;
  BoundaryComplex boundary;
  Criteria criteria;
  ExtraMembers extra;
};

}  // namespace pliant
