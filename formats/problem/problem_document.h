// formats/problem/problem_document.h: a problem, what is to be solved on meshes, as its document has it.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "pliant/boundary/extra_members.h"

namespace pliant {

/// A number, or the text of an expression. A document is read without looking into the text.
using ProblemExpression = std::variant<double, std::string>;

/// What one face is made of; what is left out has a default (formats/problem.md).
struct ProblemMaterial {
  std::vector<ProblemExpression> diffusivity;  ///< one, or xx, xy, yy; empty: left out
  std::optional<ProblemExpression> capacity;
  std::optional<ProblemExpression> source;
};

/// What holds on the curves of these names.
struct ProblemCondition {
  enum class Kind { value, flux, robin, jump } kind = Kind::value;
  std::vector<std::string> curves;  ///< at least one; "*": outer curves that no other condition names
  ProblemExpression first{0.0};     ///< the value or the flux; of robin and jump the transfer
  ProblemExpression second{0.0};    ///< of robin the ambient
};

/// Its member in the document.
const char* condition_name(ProblemCondition::Kind kind);

/// The section for `diffuse`.
struct DiffuseSection {
  std::string field;
  std::vector<std::pair<std::string, ProblemMaterial>> materials;  ///< by face; "*": faces that are not named
  std::vector<ProblemCondition> conditions;
  std::vector<std::pair<std::string, ProblemExpression>> initial;  ///< by face; one expression for all is that of "*"
  std::vector<ProblemExpression> convection;                       ///< two components, or none
};

/// The fluid on one face; what is left out has a default (formats/problem.md).
struct NavierStokesMaterial {
  std::optional<ProblemExpression> density;
  ProblemExpression viscosity{1.0};  ///< required in the document
};

/// What holds on the curves of these names.
struct NavierStokesCondition {
  enum class Kind { velocity, slip, traction, outflow, natural } kind = Kind::velocity;
  std::vector<std::string> curves;            ///< as those of ProblemCondition
  std::vector<ProblemExpression> components;  ///< two of velocity and traction, none of the others
  std::optional<bool> moves;                  ///< does the mesh follow the flow there?
};

/// Its member in the document.
const char* condition_name(NavierStokesCondition::Kind kind);

/// The section for `navierstokes`. Its vectors have two components, or none where they are left out.
struct NavierStokesSection {
  enum class Pressure { by_face, continuous };
  std::vector<std::pair<std::string, NavierStokesMaterial>> materials;  ///< by face; "*": faces that are not named
  std::vector<NavierStokesCondition> conditions;
  std::vector<std::pair<std::string, ProblemExpression>> surface_tension;  ///< by curve
  std::vector<ProblemExpression> gravity;
  std::vector<ProblemExpression> force;
  std::vector<ProblemExpression> initial;
  std::optional<Pressure> pressure;
};

/// Its text in the document.
const char* pressure_name(NavierStokesSection::Pressure pressure);

/// A problem: parameters, and a section for each tool that solves something.
struct ProblemDocument {
  std::vector<std::pair<std::string, ProblemExpression>> parameters;  ///< a text may name those before it
  std::optional<DiffuseSection> diffuse;
  std::optional<NavierStokesSection> navierstokes;
  ExtraMembers extra;  ///< other sections, too
};

}  // namespace pliant
