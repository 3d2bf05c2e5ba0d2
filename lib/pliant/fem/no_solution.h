// lib/pliant/fem/no_solution.h: the exception of equations that were not solved.
#pragma once
#include <stdexcept>

namespace pliant {

/// No solution was reached: the text says how far it came.
class NoSolution : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pliant
