// tools/problem/problem_words.h: what any section of a problem says, in words, for --explain.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formats/problem/problem_document.h"
#include "pliant/boundary/boundary_complex.h"
#include "problem/problem_names.h"

namespace pliant {

/// Expressions of a problem as they were written, beside what its parameters are.
class ProblemWords {
 public:
  ProblemWords(const ProblemDocument& problem, ProblemNames names) : problem_(problem), names_(std::move(names)) {}

  std::string shown(const ProblemExpression& expression) const;
  /// One expression as such, several in brackets.
  std::string shown(const std::vector<ProblemExpression>& expressions) const;
  /// A line for each field that no expression can name.
  std::string notes() const;
  /// A line for each parameter.
  std::string parameters() const;

 private:
  const ProblemDocument& problem_;
  ProblemNames names_;
};

/// What an object has for a face: by its name, or by "*"; null where neither is there.
template <class Value>
const std::pair<std::string, Value>* entry_of(const std::vector<std::pair<std::string, Value>>& entries,
                                              const std::string& face) {
  const auto find = [&entries](const std::string& name) {
    return std::ranges::find(entries, name, &std::pair<std::string, Value>::first);
  };
  auto entry = find(face);
  if (entry == entries.end()) entry = find("*");
  return entry == entries.end() ? nullptr : &*entry;
}

/// A face, and whether what stands on it is that of "*": `entry` is the name that it has in the document.
std::string describe_face(const BoundaryComplex& boundary, std::size_t face, const std::string& entry);
/// Which condition stands on the curve, and whether it is there by "*": `names` are those of the condition.
std::string describe_origin(int condition, const std::vector<std::string>& names, const Curve& curve);

}  // namespace pliant
