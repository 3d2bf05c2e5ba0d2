// tools/problem/problem_names.h: what expressions of a problem may name beside a mesh, and what they become.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formats/problem/problem_document.h"
#include "options/expression.h"
#include "pliant/fem/coefficient.h"

namespace pliant {

/// The values of a problem's parameters, in their order.
/// Throws      InputError with a pointer below `/problem` where the text of one is no expression in those before it, or
///             is not finite
std::vector<std::pair<std::string, double>> parameter_values(const ProblemDocument& problem);

/// A coefficient, and what its value depends on beside the place.
struct CompiledCoefficient {
  Coefficient coefficient;
  bool uses_time = false;
  bool uses_fields = false;  ///< the unknown, too
  bool uses_unknown = false;
};

/// The parameters of a problem and the fields of a mesh: a scalar field by its name, the components of others as NAME_x
/// and NAME_y where there are two, NAME_1, NAME_2 and so on where there are more.
class ProblemNames {
 public:
  /// The unknown is a field, with so many components, that expressions may name also where the mesh does not have it
  /// yet. Throws      InputError as parameter_values
  ProblemNames(const ProblemDocument& problem, const Mesh& mesh, const std::string& unknown, int components = 1);

  /// A constant where the text uses no variable. The coefficient is called by its place and text. It looks fields up in
  /// the mesh that it is asked about, by name, and is not a number where that mesh lacks one. Its copies share one
  /// compiled formula: one thread at a time.
  /// Throws      InputError at `place`, also where a constant is not finite
  CompiledCoefficient compile(const ProblemExpression& expression, const std::string& place) const;

  /// The parameters that the text uses, with their values, as "k = 0.1, h = 2"; empty for none.
  std::string describe_parameters(const ProblemExpression& expression) const;
  const std::vector<std::pair<std::string, double>>& parameters() const { return names_.constants; }
  /// Sentences on fields that no expression can name, each with the reason.
  std::vector<std::string> unusable_fields() const;

 private:
  struct Component {
    std::string field;
    int component = 0;
    int index = 0;  ///< of the field, where the mesh that is asked about has the same fields
  };
  class FieldFormula;

  void add(const std::string& name, const Component& component);
  void add_field(const std::string& name, int components, int index);
  /// Why the text cannot be compiled, beside the parser's message: the names in it that mean no single thing.
  std::string explain_names(const std::string& text) const;

  std::string unknown_;
  ExpressionNames names_;
  std::map<std::string, Component> components_;
  struct Unusable {
    std::string name, why;      ///< a sentence
    bool is_ambiguous = false;  ///< the name is known, but means something else too
  };
  std::vector<Unusable> unusable_;
};

}  // namespace pliant
