// lib/pliant/mesh/check/check_arrays.cpp: are the arrays of a document well-formed? All other questions rely on it.
#include <cmath>
#include <string>

#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

std::string numbered(const char* array, std::size_t index) { return std::string(array) + std::to_string(index); }

template <class Indices>
void check_range(std::vector<Fault>& faults, const Indices& indices, const std::string& array, std::size_t count,
                 const char* what, std::int32_t least = 0) {
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (indices[k] < least || indices[k] >= static_cast<std::int64_t>(count)) {
      faults.push_back({"document", array + "/" + std::to_string(k),
                        "index " + std::to_string(indices[k]) + " is out of range: there are " + std::to_string(count) +
                            " " + what});
      return;
    }
}

void check_field(std::vector<Fault>& faults, const MeshData& data, std::size_t k) {
  const Field& field = data.fields[k];
  const std::string place = numbered("/fields/", k);
  if (field.components < 1) {
    faults.push_back({"document", place + "/components", "must be at least 1"});
    return;
  }
  const std::size_t rows = field.by_face ? field.places.size() : data.points.size();
  const std::size_t wanted = rows * static_cast<std::size_t>(field.components);
  if (field.values.size() != wanted)
    faults.push_back({"document", place + "/values",
                      "has " + std::to_string(field.values.size()) + " numbers; " + std::to_string(wanted) +
                          " are needed (" + std::to_string(rows) + (field.by_face ? " places" : " points") + " times " +
                          std::to_string(field.components) + " components)"});
  for (std::size_t i = 0; i < field.values.size(); ++i)
    if (!std::isfinite(field.values[i])) {
      faults.push_back({"document", place + numbered("/values/", i), "is not a finite number"});
      break;
    }
  for (std::size_t i = 0; i < field.places.size(); ++i) {
    const auto [point, face] = field.places[i];
    if (point < 0 || point >= static_cast<std::int64_t>(data.points.size()) || face < 0 ||
        face >= static_cast<std::int64_t>(data.boundary.faces.size())) {
      faults.push_back({"document", place + numbered("/places/", 2 * i), "names no point and face of this mesh"});
      break;
    }
  }
}

}  // namespace

std::vector<Fault> check_arrays(const MeshData& data) {
  std::vector<Fault> faults;
  if (data.degree < 1 || data.degree > max_degree) {
    faults.push_back({"document", "/degree",
                      "is " + std::to_string(data.degree) + "; it must be 1 to " + std::to_string(max_degree)});
    return faults;
  }
  if (!std::isfinite(data.time)) faults.push_back({"document", "/time", "is not a finite number"});
  for (std::size_t p = 0; p < data.points.size(); ++p)
    if (!is_finite(data.points[p])) {
      faults.push_back({"document", numbered("/points/", 2 * p), "is not a finite number"});
      break;
    }
  const std::size_t n = static_cast<std::size_t>(net_size(data.degree));
  if (data.triangles.size() % n != 0)
    faults.push_back({"document", "/triangles",
                      "has " + std::to_string(data.triangles.size()) + " indices, no multiple of the " +
                          std::to_string(n) + " of a triangle of degree " + std::to_string(data.degree)});
  if (data.triangle_faces.size() != data.triangles.size() / n)
    faults.push_back({"document", "/triangle_faces",
                      "has " + std::to_string(data.triangle_faces.size()) + " entries for " +
                          std::to_string(data.triangles.size() / n) + " triangles"});
  check_range(faults, data.triangles, "/triangles", data.points.size(), "points");
  check_range(faults, data.triangle_faces, "/triangle_faces", data.boundary.faces.size(), "faces");
  std::vector<int> span_counts;
  for (const Curve& curve : data.boundary.curves) span_counts.push_back(curve.spline.span_count());
  for (std::size_t k = 0; k < data.constrained_edges.size(); ++k) {
    const ConstrainedEdge& edge = data.constrained_edges[k];
    const std::string place = numbered("/constrained_edges/", k);
    if (edge.points.size() != static_cast<std::size_t>(data.degree) + 1)
      faults.push_back({"document", place + "/points",
                        "has " + std::to_string(edge.points.size()) + " entries; degree + 1 are needed"});
    check_range(faults, edge.points, place + "/points", data.points.size(), "points");
    if (edge.curve < 0 || edge.curve >= static_cast<CurveId>(data.boundary.curves.size())) {
      faults.push_back({"document", place + "/curve", "names no curve of the boundary"});
    } else {
      const int spans = span_counts[static_cast<std::size_t>(edge.curve)];
      if (edge.span < 0 || edge.span >= spans)
        faults.push_back({"document", place + "/span",
                          "is " + std::to_string(edge.span) + "; the curve has " + std::to_string(spans) + " spans"});
    }
    if (faults.size() > 20) break;
  }
  for (std::size_t k = 0; k < data.fields.size(); ++k) check_field(faults, data, k);
  check_range(faults, data.boundary.cusps, "/boundary/cusps", data.boundary.vertices.size(), "vertices");
  return faults;
}

}  // namespace pliant
