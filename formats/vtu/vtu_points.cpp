// formats/vtu/vtu_points.cpp: numbers the points of a VTK file, and evaluates elements at their Lagrange nodes.
#include "formats/vtu/vtu_points.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"

namespace pliant {

VtuPoints::VtuPoints(const MeshData& mesh) : mesh_(mesh) {
  const auto found = std::ranges::find(mesh.fields, true, &Field::by_face);
  if (found == mesh.fields.end()) return;
  places_ = &found->places;
  first_.resize(mesh.points.size(), none);
  for (std::size_t k = places_->size(); k-- > 0;) first_[index((*places_)[k][0])] = static_cast<std::int32_t>(k);
}

std::int32_t VtuPoints::number(PointId point, FaceId face) const {
  if (places_ == nullptr) return point;
  std::int32_t number = first_[index(point)];
  while ((*places_)[index(number)][1] != face) ++number;
  return number;
}

VtuNodes::VtuNodes(const MeshData& mesh, const VtuPoints& points, bool at_nodes)
    : mesh_(mesh), points_(points), at_nodes_(at_nodes && mesh.degree > 1) {
  if (!at_nodes_) return;
  const int p = mesh.degree;
  const NetLayout& layout = NetLayout::of(p);
  std::vector<double> basis(index(p + 1));
  for (int k = 0; k <= p; ++k) {
    bernstein_basis(p, double(k) / p, basis);
    on_edge_.insert(on_edge_.end(), basis.begin(), basis.end());
  }
  basis.resize(index(layout.size()));
  for (int n = layout.first_interior(); n < layout.size(); ++n) {
    const auto& [i, j, k] = layout.exponents(n);
    bernstein_basis(p, Barycentric{double(i) / p, double(j) / p, double(k) / p}, basis);
    on_inside_.insert(on_inside_.end(), basis.begin(), basis.end());
  }
}

std::span<const double> VtuNodes::rows(const VtuRows& control, std::vector<double>& storage) const {
  const bool has_all = control.by_face || points_.size() * index(control.width) == control.values.size();
  if (!at_nodes_ && has_all) return control.values;
  const auto width = index(control.width);
  std::vector<double> all;
  if (!has_all) {
    all.reserve(points_.size() * width);
    for (std::size_t number = 0; number < points_.size(); ++number) {
      const auto row = control.values.subspan(index(points_.point(number)) * width, width);
      all.insert(all.end(), row.begin(), row.end());
    }
  }
  if (!at_nodes_) {
    storage = std::move(all);
    return storage;
  }
  storage.assign(control.values.begin(), control.values.end());
  if (!has_all) storage = all;
  evaluate(control.width, has_all ? control.values : std::span<const double>(all), storage);
  return storage;
}

void VtuNodes::evaluate(int width, std::span<const double> control, std::vector<double>& nodes) const {
  const NetLayout& layout = NetLayout::of(mesh_.degree);
  const auto p = index(mesh_.degree), size = index(layout.size()), w = index(width);
  constexpr double greatest = std::numeric_limits<double>::max();
  std::vector<std::size_t> net(size), edge(p + 1);
  // The sums are means; rounding alone may take one of the greatest doubles out of range.
  const auto put = [&](std::size_t node, const double* weights, std::span<const std::size_t> from) {
    for (std::size_t c = 0; c < w; ++c) {
      double sum = 0;
      for (std::size_t m = 0; m < from.size(); ++m) sum += weights[m] * control[from[m] * w + c];
      nodes[node * w + c] = std::clamp(sum, -greatest, greatest);
    }
  };
  for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t) {
    for (std::size_t n = 0; n < size; ++n)
      net[n] = index(points_.number(mesh_.triangles[t * size + n], mesh_.triangle_faces[t]));
    for (int e = 0; e < 3; ++e) {
      for (std::size_t k = 0; k <= p; ++k) edge[k] = net[index(layout.edge_index(e, static_cast<int>(k)))];
      // Both triangles of an edge take it in the same direction, so that their sums are the same bit for bit.
      if (points_.point(edge.front()) > points_.point(edge.back())) std::ranges::reverse(edge);
      for (std::size_t k = 1; k < p; ++k) put(edge[k], &on_edge_[k * (p + 1)], edge);
    }
    const auto inner = index(layout.first_interior());
    for (std::size_t n = inner; n < size; ++n) put(net[n], &on_inside_[(n - inner) * size], net);
  }
}

}  // namespace pliant
