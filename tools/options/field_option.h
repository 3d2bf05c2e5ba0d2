// tools/options/field_option.h: --field NAME[@FACE]=EXPR[,EXPR] of bspline2mesh and advect.
#pragma once
#include <string>
#include <vector>

#include "options/expression.h"
#include "pliant/mesh/mesh.h"

namespace CLI {
class App;
}

namespace pliant {

/// The fields that the command line asks for.
class FieldOption {
 public:
  /// Adds --field (repeatable).
  void add(CLI::App& app);
  /// Reads the texts; call it before any input is read (Stage::check).   Throws UsageError
  void check();
  bool empty() const { return texts_.empty(); }
  /// Makes or replaces the fields in the order given: the expressions at the elements' interpolation nodes and at the
  /// mesh's time, brought to Bézier form. With @FACE the field is by face and only that face's values are set.
  /// Throws      UsageError where the face does not exist or the number of components differs from the field's on other
  ///             faces; NoResult where an expression is not finite at a node
  void apply(Mesh& mesh) const;

 private:
  struct Request {
    std::string name, face;
    std::vector<Expression> components;
  };
  std::vector<std::string> texts_;
  std::vector<Request> requests_;
};

}  // namespace pliant
