// tools/problem/incompressible.h: from a problem's section `navierstokes` and a mesh to the flow that is solved for.
#pragma once
#include <string>

#include "formats/problem/problem_document.h"
#include "pliant/fem/navier_stokes/flow_problem.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The names of faces and curves as those of the mesh, the expressions compiled. Nothing of an earlier call is used.
///
/// Throws      InputError with a pointer below "/problem" (of the mesh document that carries the problem): a section, a
///             face, a curve or a name in an expression that is not there; a face without material; two conditions on
///             one curve, or none on an outer one; a stress or an outflow where both sides are fluid; an outflow that
///             moves; a constant that is out of its range
/// Complexity  in the size of the document, the faces and the curves
FlowProblem make_flow_problem(const ProblemDocument& problem, const Mesh& mesh);

/// The problem in words, a line each: parameters, what stands on each face and each curve, forces, initial velocity,
/// pressure; what nobody wrote is called a default.
/// Requires    a problem made of these by make_flow_problem
std::string explain(const FlowProblem& flow, const ProblemDocument& problem, const Mesh& mesh);

}  // namespace pliant
