// lib/pliant/mesh/renumber.cpp: triangles sorted along Hilbert's curve, then points, then what names them.
#include "pliant/mesh/renumber.h"

#include <algorithm>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/hilbert_order.h"

namespace pliant {
namespace {

void reorder_triangles(MeshData& data) {
  const std::size_t n = index(net_size(data.degree)), count = data.triangle_faces.size();
  Box box;
  for (const Point& p : data.points) box.extend(p);
  const HilbertOrder order(box, 20);
  std::vector<std::pair<std::uint64_t, std::size_t>> places;
  places.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto corner = [&](std::size_t c) { return data.points[index(data.triangles[t * n + c])]; };
    places.emplace_back(order((1.0 / 3) * (corner(0) + corner(1) + corner(2))), t);
  }
  std::sort(places.begin(), places.end());
  std::vector<PointId> triangles;
  std::vector<FaceId> faces;
  triangles.reserve(data.triangles.size());
  faces.reserve(count);
  for (const auto& [place, t] : places) {
    const auto net = data.triangles.begin() + static_cast<std::ptrdiff_t>(t * n);
    triangles.insert(triangles.end(), net, net + static_cast<std::ptrdiff_t>(n));
    faces.push_back(data.triangle_faces[t]);
  }
  data.triangles = std::move(triangles);
  data.triangle_faces = std::move(faces);
}

/// The new number of each point.
std::vector<PointId> numbers_by_use(const MeshData& data) {
  std::vector<PointId> number(data.points.size(), none);
  PointId next = 0;
  for (const PointId p : data.triangles)
    if (number[index(p)] == none) number[index(p)] = next++;
  for (PointId& p : number)
    if (p == none) p = next++;
  return number;
}

/// Moves the `width` values of each old place to its new one.
template <class T>
void permute(std::vector<T>& values, std::size_t width, const std::vector<PointId>& number) {
  std::vector<T> moved(values.size());
  for (std::size_t k = 0; k < number.size(); ++k)
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(k * width), width,
                moved.begin() + static_cast<std::ptrdiff_t>(index(number[k]) * width));
  values = std::move(moved);
}

void renumber_places(Field& field, const std::vector<PointId>& number) {
  for (auto& place : field.places) place[0] = number[index(place[0])];
  std::vector<PointId> sorted(field.places.size()), rank(sorted.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = static_cast<PointId>(k);
  std::sort(sorted.begin(), sorted.end(),
            [&](PointId a, PointId b) { return field.places[index(a)] < field.places[index(b)]; });
  for (std::size_t k = 0; k < sorted.size(); ++k) rank[index(sorted[k])] = static_cast<PointId>(k);
  permute(field.places, 1, rank);
  permute(field.values, index(field.components), rank);
}

}  // namespace

void renumber_along_hilbert(MeshData& data) {
  reorder_triangles(data);
  const std::vector<PointId> number = numbers_by_use(data);
  permute(data.points, 1, number);
  for (PointId& p : data.triangles) p = number[index(p)];
  for (ConstrainedEdge& edge : data.constrained_edges)
    for (PointId& p : edge.points) p = number[index(p)];
  for (Field& field : data.fields) {
    if (field.by_face)
      renumber_places(field, number);
    else
      permute(field.values, index(field.components), number);
  }
}

}  // namespace pliant
