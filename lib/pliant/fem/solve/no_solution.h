// lib/pliant/fem/solve/no_solution.h: what is thrown where no solution was reached.
#pragma once
#include <stdexcept>

namespace pliant {

/// No solution was reached: the text says how far it came.
class NoSolution : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pliant
