// tools/problem/exact_solution.h: the expressions of --error, which solutions are compared with.
#pragma once
#include <string>

#include "pliant/fem/coefficient.h"
#include "problem/problem_names.h"

namespace pliant {

/// What --error TEXT compares with: an expression in x, y, t and parameters.
/// Throws      UsageError where it is no expression, or names a field
Coefficient exact_solution(const ProblemNames& names, const std::string& text, const std::string& expression);

}  // namespace pliant
