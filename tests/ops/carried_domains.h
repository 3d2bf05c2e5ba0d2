// tests/ops/carried_domains.h: meshes of several domains, which carry fields of every kind.
#pragma once
#include <catch2/catch.hpp>
#include <random>

#include "ops/random_operations.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_boundaries.h"

namespace pliant {

struct Domain {
  const char* name;
  BoundaryComplex (*boundary)(int degree);
};
inline const Domain domains[] = {{"cell", samples::one_cell},
                                 {"annulus, a hole", [](int degree) { return samples::annulus(degree); }},
                                 {"cells in a channel, interfaces", samples::interface},
                                 {"gear, corners", [](int) { return samples::gear(6); }}};

/// Moves the control points inside inner edges at random, if elements stay valid.
inline void bend_inner_edges(Mesh& mesh, std::mt19937_64& random, int rounds = 40) {
  std::normal_distribution<double> normal;
  const int p = mesh.degree();
  for (int round = 0; round < rounds; ++round)
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h) || mesh.twin(h) == none) continue;
      const double length = distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)));
      for (int k = 1; k < p; ++k) {
        const PointId q = mesh.edge_point(h, k);
        Transaction attempt(mesh);
        mesh.set_point(q, mesh.point(q) + 0.15 * length * Vector{normal(random), normal(random)});
        if (certify_element(mesh, triangle_of(h)) == Validity::valid &&
            certify_element(mesh, triangle_of(mesh.twin(h))) == Validity::valid)
          attempt.commit();
      }
    }
}

/// The mesh of a domain, whose inner edges are bent `bends` times. Field 0 is linear, field 1 is noise with two
/// components, field 2 is noise by face.
inline Mesh carried(const Domain& domain, int degree, int bends = 0) {
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(domain.boundary(degree), {degree}, mesh);
  if (!outcome.ok) FAIL(outcome.failure);
  std::mt19937_64 bending(3);
  bend_inner_edges(mesh, bending, bends);
  MeshData data = mesh.to_data();
  samples::add_field(data, "linear", 1, [](const Point& p) { return std::vector<double>{p.x + 2 * p.y - 3}; });
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> noise(-1, 1);
  samples::add_field(data, "noise", 2, [&](const Point&) { return std::vector<double>{noise(random), noise(random)}; });
  Field field;
  field.name = "by face";
  field.by_face = true;
  const auto n = static_cast<std::size_t>(net_size(degree));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    field.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::sort(field.places.begin(), field.places.end());
  field.places.erase(std::unique(field.places.begin(), field.places.end()), field.places.end());
  for (std::size_t k = 0; k < field.places.size(); ++k) field.values.push_back(noise(random));
  data.fields.push_back(std::move(field));
  return Mesh(std::move(data));
}

/// The sums that operations must keep: the area of each face, then the integral of each component of fields 1 and 2.
inline std::vector<double> kept_sums(const Mesh& mesh) {
  std::vector<double> sums(mesh.boundary().faces.size() + 3);
  const std::size_t faces = mesh.boundary().faces.size();
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  std::vector<double> weights(net.size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    sums[static_cast<std::size_t>(mesh.face(t))] += element_area(mesh.degree(), net);
    integral_weights(mesh.degree(), net, weights);
    for (std::size_t k = 0; k < net.size(); ++k) {
      const auto value = [&](int field, int c) {
        return mesh.fields()[static_cast<std::size_t>(field)]
            .values[static_cast<std::size_t>(mesh.value_index(field, mesh.net(t)[k], mesh.face(t)) + c)];
      };
      sums[faces] += weights[k] * value(1, 0);
      sums[faces + 1] += weights[k] * value(1, 1);
      sums[faces + 2] += weights[k] * value(2, 0);
    }
  }
  return sums;
}

inline double box_area(const Mesh& mesh) {
  const Box box = mesh.box();
  return (box.high.x - box.low.x) * (box.high.y - box.low.y);
}

inline void require_every_invariant(const Mesh& mesh) {
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  REQUIRE(find_invalid(mesh).empty());
}

}  // namespace pliant
