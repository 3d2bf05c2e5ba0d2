// tools/problem/exact_solution.cpp: compiles what an option says, not a document.
#include "problem/exact_solution.h"

#include "pliant/boundary/fault.h"
#include "run/exit_status.h"

namespace pliant {

Coefficient exact_solution(const ProblemNames& names, const std::string& text, const std::string& expression) {
  try {
    CompiledCoefficient compiled = names.compile(expression, "--error");
    if (compiled.uses_fields) throw UsageError("--error " + text + ": the expression may not name fields");
    return std::move(compiled.coefficient);
  } catch (const InputError& error) {
    throw UsageError("--error " + text + ": " + error.what());
  }
}

}  // namespace pliant
