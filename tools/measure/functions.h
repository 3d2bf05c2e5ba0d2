// tools/measure/functions.h: the fields and expressions that a command line names, as functions on a mesh.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pliant/fem/measures/mesh_function.h"
#include "problem/problem_names.h"

namespace pliant {

/// A function with what its column's name has behind that of the others of its text: "_x" and "_y" of a field with two
/// components, "_1", "_2" and so on of one with more.
struct NamedFunction {
  std::string suffix;
  MeshFunction function;
};

/// Looks texts up on one mesh, to which it refers.
class MeasuredFunctions {
 public:
  /// `set` are parameters, which come before those of the problem that the mesh carries.
  MeasuredFunctions(const Mesh& mesh, const std::vector<std::pair<std::string, double>>& set)
      : mesh_(mesh), set_(set) {}

  const Mesh& mesh() const { return mesh_; }
  /// All components of the field of this name, or one component (velocity_x), or an expression in x, y, t, parameters
  /// and fields.
  /// Throws      UsageError that begins with `opening`; InputError for a faulty problem in the mesh
  std::vector<NamedFunction> find(const std::string& text, const std::string& opening);
  /// Those of --set, and of the problem that the mesh carries.   Throws InputError
  const std::vector<std::pair<std::string, double>>& parameters();

 private:
  const ProblemNames& names();

  const Mesh& mesh_;
  const std::vector<std::pair<std::string, double>>& set_;
  std::unique_ptr<ProblemNames> names_;  ///< made when first needed: no other text depends on the problem
};

}  // namespace pliant
