// lib/pliant/fem/diffusion/diffusion.cpp: solves the equation at one time, and takes steps of one or two such
// solutions.
#include "pliant/fem/diffusion/diffusion.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pliant/boundary/fault.h"
#include "pliant/fem/element_values.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

constexpr int most_nonlinear_iterations = 100;
constexpr double nonlinear_tolerance = 1e-11;  // of the change in one iteration, relative to the solution

/// At rest factors serve many steps, and are worth more than the time that they take; above, they take much memory.
constexpr int largest_direct_at_rest = 200'000;

/// A field of zeros.
Field make_zeros(const Mesh& mesh, const std::string& name, bool by_face) {
  Field field;
  field.name = name;
  field.by_face = by_face;
  if (by_face) field.places = field_places(mesh);
  field.values.assign(by_face ? field.places.size() : index(mesh.point_slots()), 0.0);
  return field;
}

double sum_of(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

void remove_mean(std::span<double> values) {
  const double mean = sum_of(values) / static_cast<double>(values.size());
  for (double& value : values) value -= mean;
}

}  // namespace

Diffusion::Diffusion(const DiffusionProblem& problem, Mesh& mesh, const DiffusionOptions& options)
    : problem_(problem), mesh_(mesh), options_(options), equation_(problem, mesh) {
  find_field();
}

void Diffusion::find_field() {
  field_ = pliant::find_field(mesh_, problem_.field);
  const bool jumps =
      std::ranges::any_of(problem_.conditions, [](const auto& c) { return c.kind == DiffusionCondition::Kind::jump; });
  if (field_ != none) {
    const Field& field = mesh_.fields()[index(field_)];
    if (field.components != 1)
      throw InputError("/fields/" + std::to_string(field_), "the field \"" + field.name + "\" has " +
                                                                std::to_string(field.components) +
                                                                " components; an unknown has one");
    if (field.by_face || !jumps) return;
    const std::vector<double> unknowns = unknowns_of(equation_.space(), element_values(mesh_, field_, 0));
    Field by_face = make_zeros(mesh_, problem_.field, true);
    by_face.extra = field.extra;
    mesh_.set_field(std::move(by_face));
    put(unknowns);
    return;
  }
  std::vector<double> unknowns(index(equation_.space().size()), 0.0);
  const bool all = std::ranges::all_of(problem_.initial, [](const auto& each) { return each.has_value(); });
  for (std::size_t f = 0; f < problem_.initial.size() && options_.needs_initial; ++f)
    if (!problem_.initial[f])
      throw InputError("/problem/diffuse/initial", "the mesh has no field \"" + problem_.field +
                                                       "\", and there is no initial value for face \"" +
                                                       mesh_.boundary().faces[f].name + "\"");
  if (all) unknowns = equation_.initial_unknowns({mesh_.points(), mesh_.time});
  mesh_.set_field(make_zeros(mesh_, problem_.field, jumps));
  field_ = pliant::find_field(mesh_, problem_.field);
  put(unknowns);
}

void Diffusion::put(std::span<const double> unknowns) {
  mesh_.set_field(with_unknowns(mesh_, field_, equation_.space(), unknowns));
}

void Diffusion::assemble(const Configuration& at, std::optional<double> shift, bool serves_again) {
  if (!serves_again || !is_assembled_)
    equation_.assemble(at, system_);
  else if (problem_.depends_on_time)
    equation_.assemble_load(at, system_.load);
  if (serves_again && is_assembled_ && prepared_shift_ == shift && solver_ != nullptr) return;
  is_assembled_ = serves_again;
  factor(shift);
  prepared_shift_ = shift;
}

std::unique_ptr<LinearSolver> Diffusion::choose_solver(std::optional<double> shift) const {
  if (!equation_.is_symmetric()) return make_direct_general();
  const int rows = equation_.space().size();
  // Which solver it is must not depend on how many steps follow: steps one by one give the bytes of many at once.
  if (is_assembled_ && rows <= largest_direct_at_rest) return make_direct_symmetric();
  const CoarseSpace coarse = equation_.coarse_space();
  return make_symmetric_solver(rows, shift.has_value(), &coarse);
}

void Diffusion::factor(std::optional<double> shift) {
  const CsrPattern& pattern = equation_.pattern();
  matrix_.pattern = system_.mass.pattern;
  matrix_.values.resize(pattern.columns.size());
  for (std::size_t k = 0; k < matrix_.values.size(); ++k)
    matrix_.values[k] =
        shift ? system_.mass.values[k] + *shift * system_.stiffness.values[k] : system_.stiffness.values[k];
  const std::vector<char>& fixed = equation_.is_fixed();
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      const int j = pattern.columns[index(k)];
      if (i != j && (fixed[index(i)] != 0 || fixed[index(j)] != 0)) matrix_.values[index(k)] = 0;
    }
  solver_ = choose_solver(shift);
  if (const std::string why = solver_->factor(matrix_); !why.empty()) throw NoSolution(why);
}

void Diffusion::solve(std::vector<double> b, std::span<double> x, std::optional<double> shift) {
  const CsrPattern& pattern = equation_.pattern();
  const std::vector<char>& fixed = equation_.is_fixed();
  if (equation_.fixes_any())
    for (std::size_t i = 0; i < b.size(); ++i)
      for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k) {
        const std::size_t j = index(pattern.columns[index(k)]);
        if (fixed[i] != 0) {
          if (i == j) b[i] = matrix_.values[index(k)] * x[i];
        } else if (fixed[j] != 0) {
          const double stiffness = system_.stiffness.values[index(k)];
          b[i] -= (shift ? system_.mass.values[index(k)] + *shift * stiffness : stiffness) * x[j];
        }
      }
  if (shift && equation_.is_closed()) return solve_around_mean(std::move(b), x);
  take_note(solver_->solve(b, x, solver_tolerance), 1);
}

void Diffusion::solve_around_mean(std::vector<double> b, std::span<double> x) {
  // The columns of the stiffness sum to zero, so that the mean of the solution is known before. Without it, what is
  // left has no part along constants, for which the matrix of a long step is singular up to rounding.
  std::vector<double> weights(b.size());
  multiply(system_.mass, std::vector<double>(b.size(), 1.0), weights);
  const double weight = sum_of(weights), size = norm(b);
  double mean = 0;
  for (int k = 0; k < 2; ++k) {  // once more for what rounding leaves
    const double part = sum_of(b) / weight;
    for (std::size_t i = 0; i < b.size(); ++i) b[i] -= part * weights[i];
    mean += part;
  }
  for (double& each : x) each -= mean;
  const double part_of_size = size > 0 ? norm(b) / size : 1;
  const double tolerance = part_of_size > solver_tolerance ? solver_tolerance / part_of_size : 1;
  take_note(solver_->solve(b, x, tolerance), part_of_size);
  if (options_.conservative) {
    // The solver leaves a residual; its sum is an amount that came from nowhere, which a constant takes away again.
    // Summed are differences: those of two sums would leave more by rounding than the solver does.
    multiply(system_.mass, x, weights);
    for (std::size_t i = 0; i < b.size(); ++i) b[i] -= weights[i];
    mean += sum_of(b) / weight;
  }
  for (double& each : x) each += mean;
}

void Diffusion::take_note(const SolveOutcome& outcome, double part_of_size) {
  ++solves_;
  iterations_ += outcome.iterations;
  worst_residual_ = std::max(worst_residual_, outcome.residual * part_of_size);
  if (!outcome.converged) throw NoSolution(outcome.why);
}

void Diffusion::solve_at(const Configuration& at, std::optional<double> shift, bool serves_again,
                         const RightSide& right_side, std::span<double> x) {
  const auto solve_once = [&] {
    assemble(at, shift, serves_again);
    std::vector<double> b = right_side();
    for (std::size_t i = 0; i < b.size(); ++i) b[i] += (shift ? *shift : 1) * system_.load[i];
    equation_.fix(at, x);
    solve(std::move(b), x, shift);
  };
  solve_once();
  if (!problem_.depends_on_unknown) return;
  std::vector<double> before(x.size());
  double change = 0;
  for (int k = 1; k < most_nonlinear_iterations; ++k) {
    std::ranges::copy(x, before.begin());
    put(x);
    solve_once();
    for (std::size_t i = 0; i < x.size(); ++i) before[i] -= x[i];
    change = norm(before) / std::max(norm(x), 1e-300);
    if (change <= nonlinear_tolerance) return;
  }
  std::ostringstream text;
  text << "the coefficients depend on the unknown, and " << most_nonlinear_iterations
       << " iterations (Picard) do not settle: the last one changed the solution by " << change
       << " of it; a shorter time step helps usually";
  throw NoSolution(text.str());
}

void Diffusion::solve_steady() {
  equation_.require_determined();
  const Configuration now{mesh_.points(), mesh_.time};
  std::vector<double> x = unknowns_of(equation_.space(), element_values(mesh_, field_, 0));
  const std::size_t n = x.size();
  solve_at(
      now, std::nullopt, false, [n] { return std::vector<double>(n, 0.0); }, x);
  if (options_.wants_fluxes) {
    fluxes_ = std::make_unique<CurveFluxes>(problem_, mesh_);
    std::vector<double> unused(n);
    equation_.apply(now, element_values(equation_.space(), x), 0, unused, 1, unused, fluxes_.get());
    curve_totals_ = fluxes_->totals();
  }
  put(x);
}

void Diffusion::step(std::span<const Point> from, double t0) {
  const bool moves = !from.empty();
  if (moves) is_assembled_ = false;
  if (options_.wants_fluxes) fluxes_ = std::make_unique<CurveFluxes>(problem_, mesh_);
  if (options_.conservative)
    step_conservatively(moves ? from : mesh_.points(), t0, moves);
  else
    step_by_derivatives(moves ? from : mesh_.points(), t0, moves);
  if (!fluxes_) return;
  curve_totals_ = fluxes_->totals();
  for (double& each : curve_totals_.fluxes) each /= mesh_.time - t0;
  for (double& each : curve_totals_.freed) each /= mesh_.time - t0;
}

namespace {

/// The places at a part of a motion on straight lines.
std::vector<Point> between(std::span<const Point> from, std::span<const Point> to, double part) {
  std::vector<Point> points;
  points.reserve(from.size());
  for (std::size_t p = 0; p < from.size(); ++p) points.push_back(from[p] + part * (to[p] - from[p]));
  return points;
}

/// The coefficient on the diagonal of SDIRK2: the first stage is at this part of the step, and this is the part of the
/// step for which the rate of each stage counts in its own equation.
const double gamma = 1 - std::sqrt(0.5);

}  // namespace

void Diffusion::step_conservatively(std::span<const Point> from, double t0, bool moves) {
  const double dt = mesh_.time - t0;
  const Space& space = equation_.space();
  const std::vector<double> values = element_values(mesh_, field_, 0);
  std::vector<double> x = unknowns_of(space, values), rates(x.size(), 0.0), unused(x.size());
  const bool again = !moves && !problem_.matrices_depend_on_time && !problem_.depends_on_unknown;
  const Configuration start{from, t0}, end{mesh_.points(), mesh_.time};

  // What there is at the start; for crank_nicolson, half of what comes in at the rate of then, too.
  std::vector<double> amounts(x.size(), 0.0);
  const double part = options_.scheme == TimeScheme::crank_nicolson ? 0.5 * dt : 0;
  equation_.apply(start, values, 1, amounts, part, amounts, fluxes_.get());
  const auto solve_stage = [&](const Configuration& at, double shift) {
    solve_at(
        at, shift, again, [&amounts] { return amounts; }, x);
  };
  const auto note_fluxes = [&](const Configuration& at, double amount_factor, double rate_factor) {
    if (fluxes_)
      equation_.apply(at, element_values(space, x), amount_factor, unused, rate_factor, unused, fluxes_.get());
  };

  double last = dt - part;
  if (options_.scheme == TimeScheme::sdirk2) {
    last = gamma * dt;
    const std::vector<Point> then = moves ? between(from, mesh_.points(), gamma) : std::vector<Point>();
    const Configuration middle{moves ? std::span<const Point>(then) : mesh_.points(), t0 + gamma * dt};
    solve_stage(middle, last);
    multiply(system_.stiffness, x, rates);
    if (equation_.is_closed()) remove_mean(rates);  // it is rounding, which a long step would multiply
    for (std::size_t i = 0; i < x.size(); ++i) amounts[i] += (dt - last) * (system_.load[i] - rates[i]);
    note_fluxes(middle, 0, dt - last);
  }
  solve_stage(end, last);
  note_fluxes(end, -1, last);
  put(x);
}

void Diffusion::step_by_derivatives(std::span<const Point> from, double t0, bool moves) {
  const double dt = mesh_.time - t0;
  const Space& space = equation_.space();
  const std::vector<double> before = unknowns_of(space, element_values(mesh_, field_, 0));
  std::vector<double> x = before, base = before, derivative(x.size());
  const bool again = !moves && !problem_.matrices_depend_on_time && !problem_.depends_on_unknown;
  const auto solve_stage = [&](const Configuration& at, double shift, double weight) {
    solve_at(
        at, shift, again,
        [&] {
          std::vector<double> amounts(x.size());
          multiply(system_.mass, base, amounts);
          return amounts;
        },
        x);
    for (std::size_t i = 0; i < x.size(); ++i) derivative[i] = (x[i] - base[i]) / shift;
    if (!fluxes_) return;
    std::vector<double> unused(x.size());
    equation_.apply(at, element_values(space, derivative), -weight, unused, 0, unused, fluxes_.get());
    equation_.apply(at, element_values(space, x), 0, unused, weight, unused, fluxes_.get());
  };
  double last = dt;
  if (options_.scheme == TimeScheme::sdirk2) {
    last = gamma * dt;
    const std::vector<Point> then = moves ? between(from, mesh_.points(), gamma) : std::vector<Point>();
    solve_stage({moves ? std::span<const Point>(then) : mesh_.points(), t0 + gamma * dt}, last, dt - last);
    for (std::size_t i = 0; i < x.size(); ++i) base[i] += (dt - last) * derivative[i];
  }
  solve_stage({mesh_.points(), mesh_.time}, last, last);
  put(x);
}

}  // namespace pliant
