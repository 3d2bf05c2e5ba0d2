// lib/pliant/ops/refit/region_integrals.cpp: sums integrals over elements, compares them, and restores them.
#include "pliant/ops/refit/region_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {

std::size_t RegionIntegrals::place(int column, FaceId f, bool by_face) const {
  const std::size_t first = index(column) * (faces_.size() + 1);
  if (!by_face) return first;
  return first + 1 + static_cast<std::size_t>(std::find(faces_.begin(), faces_.end(), f) - faces_.begin());
}

void RegionIntegrals::take(const Mesh& mesh, std::span<const TriangleId> elements) {
  faces_.clear();
  for (const TriangleId t : elements)
    if (std::find(faces_.begin(), faces_.end(), mesh.face(t)) == faces_.end()) faces_.push_back(mesh.face(t));
  std::sort(faces_.begin(), faces_.end());
  const int n = mesh.net_size(), width = mesh.width();
  sums_.assign(index(width) * (faces_.size() + 1), 0.0);
  sizes_.assign(sums_.size(), 0.0);
  std::array<Point, net_size(max_degree)> net;
  std::array<double, net_size(max_degree)> weights;
  thread_local std::vector<double> rows;
  rows.resize(index(n * width));
  for (const TriangleId t : elements) {
    mesh.gather_points(t, net);
    mesh.gather(t, rows);
    integral_weights(mesh.degree(), {net.data(), index(n)}, weights);
    for (int c = 2; c < width; ++c)
      for (const bool by_face : {false, true}) {
        const std::size_t i = place(c, mesh.face(t), by_face);
        for (int k = 0; k < n; ++k) {
          const double part = weights[index(k)] * rows[index(k * width + c)];
          sums_[i] += part;
          sizes_[i] += std::abs(part);
        }
      }
  }
}

double RegionIntegrals::change_to(const RegionIntegrals& now) const {
  double largest = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const double size = std::max(sizes_[i], now.sizes_[i]);
    if (size > 0) largest = std::max(largest, std::abs(now.sums_[i] - sums_[i]) / size);
  }
  return largest;
}

double RegionIntegrals::sum_of(int column, FaceId f, bool by_face) const { return sums_[place(column, f, by_face)]; }

void RegionIntegrals::restore(Mesh& mesh, std::span<const TriangleId> elements, const RegionIntegrals& now) const {
  thread_local std::vector<PointId> seen;
  thread_local std::vector<std::pair<PointId, double>> takers;
  const auto restore_in = [&](FaceId f, bool by_face) {
    seen.clear();
    takers.clear();
    double squares = 0;
    for (const TriangleId t : elements) {
      if (by_face && mesh.face(t) != f) continue;
      const auto ids = mesh.net(t);
      for (int k = 0; k < mesh.net_size(); ++k) {
        const PointId p = ids[index(k)];
        if (std::find(seen.begin(), seen.end(), p) != seen.end()) continue;
        seen.push_back(p);
        takers.emplace_back(p, weight_in_mesh(mesh, p, t, k, by_face));
        squares += takers.back().second * takers.back().second;
      }
    }
    int column = 2;
    for (int field = 0; field < static_cast<int>(mesh.fields().size()); ++field)
      for (int c = 0; c < mesh.fields()[index(field)].components; ++c, ++column) {
        if (mesh.fields()[index(field)].by_face != by_face || !(squares > 0)) continue;
        const double step = (sum_of(column, f, by_face) - now.sum_of(column, f, by_face)) / squares;
        for (const auto& [p, weight] : takers) {
          const auto first = static_cast<std::size_t>(mesh.value_index(field, p, f));
          mesh.put_component(field, c, p, f, mesh.fields()[index(field)].values[first + index(c)] + step * weight);
        }
      }
  };
  restore_in(none, false);
  for (const FaceId f : faces_) restore_in(f, true);
}

}  // namespace pliant
