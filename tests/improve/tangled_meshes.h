// tests/improve/tangled_meshes.h: random meshes of many kinds that are too curved or tangled.
#pragma once
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <string>

#include "formats/msh/msh.h"
#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"

namespace pliant::improve_meshes {

/// A mesh of about this many elements or more, with good angles.
inline Mesh refined(const Sample& sample, int degree, int elements) {
  Mesh mesh = mesh_of(sample.boundary, degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / elements;
  refine(mesh, options);
  return mesh;
}

/// Moves each point that is on no curve by `push` at the point; vertices only if `vertices`.
template <class Push>
MeshData moved(const Mesh& mesh, bool vertices, const Push& push) {
  MeshData data = mesh.to_data();
  std::vector<char> on_curve(data.points.size(), 0);
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_constrained(h))
      for (int k = 0; k <= mesh.degree(); ++k) on_curve[static_cast<std::size_t>(mesh.edge_point(h, k))] = 1;
  for (std::size_t p = 0; p < data.points.size(); ++p)
    if (!on_curve[p] && (vertices || !mesh.is_vertex(static_cast<PointId>(p)))) data.points[p] += push(data.points[p]);
  return data;
}

/// A mesh of some 20 to 120 elements, made from a refined boundary, a grid, scattered points or many operations. Its
/// points, with or without the vertices, were moved by noise, a shear or a swirl of random strength. It has no fields
/// or the two of improve_meshes.h.
struct Tangled {
  std::string name;
  Mesh mesh;
};
inline Tangled tangled(int degree, std::uint64_t seed) {
  std::mt19937_64 random(seed * 977 + static_cast<unsigned>(degree));
  std::uniform_real_distribution<double> uniform(0, 1), both(-1, 1);
  const auto kind = seed % 4;
  Tangled made{"refined", Mesh()};
  if (kind == 0) {
    const std::vector<Sample> all = boundaries(degree);
    const Sample& sample = all[random() % all.size()];
    made = {sample.name, refined(sample, degree, 20 + static_cast<int>(random() % 40))};
  } else if (kind == 1) {
    made = {"grid", grid(degree, 3 + static_cast<int>(random() % 4), seed)};
  } else if (kind == 2) {
    made = {"scattered", scattered(degree, 10 + static_cast<int>(random() % 20), seed)};
  } else {
    made = {"operated on", carried_disk(degree)};
    RandomOperations(made.mesh, seed, 60).run(200);
    made.mesh.compact();
  }
  const double step = std::sqrt(area_of(made.mesh) / made.mesh.triangle_count()), strength = uniform(random);
  const bool vertices = random() % 2;
  const double wave = (0.3 + uniform(random)) / step, phase = 6 * uniform(random);
  MeshData data;
  switch (random() % 3) {
    case 0:
      data = moved(made.mesh, vertices, [&](const Point&) {
        return (vertices ? 0.4 : 0.7) * strength * step * Vector{both(random), both(random)};
      });
      break;
    case 1:
      data = moved(made.mesh, vertices, [&](const Point& p) {
        return 2 * strength * step * Vector{std::sin(wave * p.y + phase), 0.3 * std::sin(wave * p.x)};
      });
      break;
    default:
      data = moved(made.mesh, vertices, [&](const Point& p) {
        return 1.5 * strength * step *
               Vector{-std::cos(wave * p.x) * std::sin(wave * p.y + phase),
                      std::sin(wave * p.x) * std::cos(wave * p.y + phase)};
      });
  }
  if (random() % 2) data.fields.clear();
  made.mesh = Mesh(std::move(data));
  return made;
}

/// The mesh in a file that Gmsh wrote, in tests/improve.
inline Mesh mesh_of_gmsh(const std::string& name) {
  std::ifstream file(PLIANT_GMSH_MESHES "/" + name, std::ios::binary);
  REQUIRE(file);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return Mesh(read_msh(bytes).mesh);
}

}  // namespace pliant::improve_meshes
