// tools/problem/diffusion.h: from a problem's section `diffuse` and a mesh to the equation that is solved.
#pragma once
#include <string>

#include "formats/problem/problem_document.h"
#include "pliant/fem/diffusion/diffusion_problem.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The names of faces and curves as those of the mesh, the expressions compiled. Nothing of an earlier call is used.
///
/// Throws      InputError with a pointer below "/problem" (of the mesh document that carries the problem): a section, a
///             face, a curve or a name in an expression that is not there; a face without material; two conditions on
///             one curve; a jump where there are not two faces; a constant that is out of its range
/// Complexity  in the size of the document, the faces and the curves
DiffusionProblem make_diffusion_problem(const ProblemDocument& problem, const Mesh& mesh);

/// The problem in words, a line each: parameters, what stands on each face and each curve, initial values, convection;
/// what nobody wrote is called a default.
/// Requires    a problem made of these by make_diffusion_problem
std::string explain(const DiffusionProblem& diffusion, const ProblemDocument& problem, const Mesh& mesh);

}  // namespace pliant
