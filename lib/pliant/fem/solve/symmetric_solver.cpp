// lib/pliant/fem/solve/symmetric_solver.cpp: which solver is the fastest for a symmetric positive definite matrix.
#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/linear_solver.h"

namespace pliant {
namespace {

constexpr int largest_direct_mass = 2000;
constexpr int largest_direct_with_coarse = 20000;
constexpr int largest_direct = 2000000;

}  // namespace

std::unique_ptr<LinearSolver> make_symmetric_solver(int rows, bool mass_dominated, const CoarseSpace* coarse) {
  if (mass_dominated) return rows <= largest_direct_mass ? make_direct_symmetric() : make_conjugate_gradients();
  if (coarse) return rows <= largest_direct_with_coarse ? make_direct_symmetric() : make_two_level(*coarse);
  return rows <= largest_direct ? make_direct_symmetric() : make_conjugate_gradients();
}

}  // namespace pliant
