// formats/picture/gltf_surface.cpp: what lies in a frame of a glTF scene: vertices with heights, bands, normals.
#include "formats/picture/gltf_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr double smooth_cosine = 0.999999;  // cosine of the angle (0.08 degrees) below which two edges share a pair

/// The values of heights at the cuts of an edge, from one side of it.
class EdgeHeights {
 public:
  EdgeHeights(const MeshData& mesh, const MeshEdges& edges, const ElementValues* heights)
      : mesh_(mesh), edges_(edges), heights_(heights), of_constrained_(mesh.constrained_edges.size(), none) {
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
      if (const std::int32_t c = edges.edges[e].constrained; c != none)
        of_constrained_[static_cast<std::size_t>(c)] = static_cast<std::int32_t>(e);
  }

  std::int32_t edge(std::size_t constrained) const { return of_constrained_[constrained]; }

  /// Requires    a triangle on this side
  double at(std::size_t constrained, std::size_t side, double s) const {
    const std::int32_t edge = of_constrained_[constrained];
    const TriangleId t = edges_.edges[static_cast<std::size_t>(edge)].sides[side];
    std::size_t e = 0;
    while (e < 2 && edges_.of_half_edge[index(half_edge(t, static_cast<int>(e)))] != edge) ++e;
    const auto size = mesh_.triangles.size() / mesh_.triangle_faces.size();
    const PointId first = mesh_.triangles[static_cast<std::size_t>(t) * size + e];
    const bool is_forward = first == mesh_.constrained_edges[constrained].points.front();
    Barycentric xi{};
    xi[e] = is_forward ? 1 - s : s;
    xi[(e + 1) % 3] = is_forward ? s : 1 - s;
    return heights_->at(t, xi);
  }

 private:
  const MeshData& mesh_;
  const MeshEdges& edges_;
  const ElementValues* heights_;
  std::vector<std::int32_t> of_constrained_;  // the edge of each constrained one; none where no triangle has it
};

}  // namespace

std::vector<Point> corners_of(const Circle& circle) {
  constexpr int count = 128;
  std::vector<Point> corners;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    corners.push_back(circle.center + circle.radius * Vector{std::cos(angle), std::sin(angle)});
  }
  return corners;
}

void GltfBox::extend(std::span<const Point> points, std::span<const double> values) {
  for (const Point& p : points) plane.extend(p);
  for (const double value : values) heights.extend(value);
}

GltfBand outline_band(const MeshData& mesh, const MeshEdges& edges, const ElementValues* heights,
                      const std::vector<int>& cuts, const BandOptions& options) {
  const EdgeHeights edge_heights(mesh, edges, heights);
  GltfBand band;
  const auto add = [&band, heights](const Point& p, double height) {
    band.points.push_back(p);
    if (heights != nullptr) band.heights.push_back(height);
  };
  for (std::size_t side = 0; side < (heights != nullptr && heights->depends_on_face() ? 2 : 1); ++side) {
    PointId last_point = none;
    Vector last_tangent;
    for (std::size_t c = 0; c < mesh.constrained_edges.size(); ++c) {
      const std::vector<PointId>& points = mesh.constrained_edges[c].points;
      const std::int32_t edge = edge_heights.edge(c);
      const bool is_there = edge != none && edges.edges[static_cast<std::size_t>(edge)].sides[side] != none;
      if ((heights != nullptr || side > 0) && !is_there) continue;
      const std::vector<Point> polygon = positions(mesh, points);
      int n = options.subdivide > 0 ? options.subdivide : edge_pieces(polygon, options.tolerance);
      if (heights != nullptr) n = std::max(n, cuts[static_cast<std::size_t>(edge)]);
      const Polyline line = sample_edge(polygon, n);
      const bool joins = points.front() == last_point && dot(line.tangents.front(), last_tangent) > smooth_cosine;
      for (std::size_t k = joins ? 1 : 0; k < line.points.size(); ++k) {
        const Vector across = perpendicular(line.tangents[k]) * options.half_width;
        const double height = heights == nullptr ? 0 : edge_heights.at(c, side, double(k) / n);
        if (k == 0 && !band.points.empty()) {
          // Two pairs that are points: from the last curve to this one without area.
          const Point from = band.points.back();
          for (int twice = 0; twice < 2; ++twice) add(from, heights == nullptr ? 0 : band.heights.back());
          for (int twice = 0; twice < 2; ++twice) add(line.points[k] - across, height);
        }
        add(line.points[k] - across, height);
        add(line.points[k] + across, height);
      }
      last_point = points.back();
      last_tangent = line.tangents.back();
    }
  }
  return band;
}

std::vector<std::array<float, 3>> vertex_normals(const Tessellation& pieces, const GltfBox& box, const Vector& unit) {
  std::vector<std::array<double, 3>> sums(pieces.vertices.size(), {0, 0, 0});
  const auto local = [&](std::uint32_t v) {
    const Point& p = pieces.vertices[v];
    return std::array<double, 3>{p.x / unit.x, p.y / unit.y, pieces.heights.empty() ? 0 : box.place(pieces.heights[v])};
  };
  for (const std::vector<std::uint32_t>* part : {&pieces.triangles, &pieces.marked})
    for (std::size_t i = 0; i + 2 < part->size(); i += 3) {
      const auto a = local((*part)[i]), b = local((*part)[i + 1]), c = local((*part)[i + 2]);
      std::array<double, 3> u{}, v{};
      for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t k = 0; k < 3; ++k)
          sums[(*part)[i + corner]][k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    }
  std::vector<std::array<float, 3>> normals;
  normals.reserve(sums.size());
  for (const std::array<double, 3>& sum : sums) {
    const double size = std::hypot(sum[0], sum[1], sum[2]);
    if (!(size > 0) || !std::isfinite(size)) {
      normals.push_back({0, 0, 1});
      continue;
    }
    normals.push_back(
        {static_cast<float>(sum[0] / size), static_cast<float>(sum[1] / size), static_cast<float>(sum[2] / size)});
  }
  return normals;
}

}  // namespace pliant
