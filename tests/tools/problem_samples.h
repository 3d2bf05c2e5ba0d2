// tests/tools/problem_samples.h: a mesh and problems for it, for tests of what problems become.
#pragma once
#include <stdexcept>
#include <string>

#include "formats/problem/problem_json.h"
#include "pliant/boundary/fault.h"
#include "pliant/fem/coefficient.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "problem/diffusion.h"
#include "support/sample_boundaries.h"

namespace pliant::testing {

/// A channel: face "plasma" around "cell" (curve "membrane") and "other" ("second"); outer curves "wall 0", "end",
/// "wall 2", "end"; a curve "slit" with plasma on both sides.
inline Mesh channel(int degree) {
  BoundaryComplex boundary = samples::interface(std::min(degree, 3));
  boundary.curves[1].name = boundary.curves[3].name = "end";
  boundary.vertices.push_back({3.2, 0.4});
  boundary.vertices.push_back({3.6, 0.6});
  boundary.curves.push_back(samples::open_curve(boundary, "slit", 4, 5, {}, 0, 0));
  GenerateOptions options;
  options.degree = degree;
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, options, mesh);
  if (!outcome.ok) throw std::runtime_error(outcome.failure);
  return mesh;
}

/// Adds or replaces a field; on one face, if that is not none.
inline void set_field(Mesh& mesh, const std::string& name, int components, FaceId face, const NodeFunction& function) {
  std::string why;
  Field field = make_field(mesh, name, components, face, function, why);
  if (!why.empty()) throw std::runtime_error(why);
  mesh.set_field(std::move(field));
}

/// A document whose section `diffuse` has these members beside `field`.
inline ProblemDocument problem_of(const std::string& members, const std::string& parameters = "{}") {
  return read_problem(R"({"format": "pliant-problem", "version": 1, "parameters": )" + parameters +
                      R"(, "diffuse": {"field": "u", )" + members + "}}");
}

/// The point xi of a triangle, at some time.
inline CoefficientPoint point_of(const Mesh& mesh, TriangleId t, const Barycentric& xi, double time = 0) {
  std::array<double, net_size(max_degree)> basis;
  bernstein_basis(mesh.degree(), xi, basis);
  Point place;
  for (std::size_t n = 0; n < mesh.net(t).size(); ++n) place += basis[n] * mesh.point(mesh.net(t)[n]);
  return {mesh, t, xi, mesh.boundary().unit * place, time};
}

/// Some triangle of a face.
inline TriangleId triangle_in(const Mesh& mesh, int face) {
  for (TriangleId t{0}; t < mesh.triangle_slots(); ++t)
    if (mesh.face(t) == face) return t;
  throw std::runtime_error("no triangle");
}

inline const std::string plain = R"("materials": {"*": {}})";

/// A document whose section `navierstokes` has these members.
inline ProblemDocument flow_problem_of(const std::string& members, const std::string& parameters = "{}") {
  return read_problem(R"({"format": "pliant-problem", "version": 1, "parameters": )" + parameters +
                      R"(, "navierstokes": {)" + members + "}}");
}

struct Refusal {
  std::string pointer = "accepted", text;
};

/// What `make`, make_diffusion_problem or make_flow_problem, says of a problem.
template <class Made>
Refusal refusal_of(const ProblemDocument& problem, const Mesh& mesh,
                   Made (*make)(const ProblemDocument&, const Mesh&)) {
  try {
    make(problem, mesh);
  } catch (const InputError& e) {
    return {e.pointer(), e.what()};
  }
  return {};
}

inline Refusal refusal_of(const ProblemDocument& problem, const Mesh& mesh) {
  return refusal_of(problem, mesh, make_diffusion_problem);
}

/// The value of an expression as a source, at a point.
inline double value_at(const std::string& expression, const CoefficientPoint& at,
                       const std::string& parameters = "{}") {
  const DiffusionProblem problem = make_diffusion_problem(
      problem_of(R"("materials": {"*": {"source": ")" + expression + "\"}}", parameters), at.mesh);
  return (*problem.materials[index(at.mesh.face(at.triangle))].source)(at);
}

}  // namespace pliant::testing
