// lib/pliant/fem/navier_stokes/navier_stokes.cpp: one linear equation a step, some for a steady flow.
#include "pliant/fem/navier_stokes/navier_stokes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pliant/boundary/fault.h"
#include "pliant/fem/element_values.h"
#include "pliant/fem/interpolate.h"
#include "pliant/fem/solve/gmres.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

constexpr int most_newton_iterations = 15;
constexpr int most_with_old_factors = 25;   // iterations of GMRES; more cost as much as new factors
constexpr int most_solves = 150;            // of a steady flow, over all parts of convection
constexpr double newton_tolerance = 1e-11;  // of the change in one iteration, relative to the velocity
constexpr double newton_rounding = 1e-12;   // ... and to velocities that rounding makes
constexpr double least_weight = 1e-6;       // of a density in a projection, relative to the greatest
constexpr int least_triangles = 3;          // of an enclosed flow: with two, there are pressures that nothing feels
constexpr double greatest_growth = 1e4;     // a change that has grown so much does not come back
constexpr double least_raise = 1.0 / 1024;  // of convection, between two solutions
constexpr double greatest_ratio = 2;        // of a step's length to the last one's, for bdf2

}  // namespace

NavierStokes::NavierStokes(const FlowProblem& problem, Mesh& mesh, const FlowOptions& options)
    : problem_(problem),
      mesh_(mesh),
      options_(options),
      equation_((mesh.degree() >= 2
                     ? problem
                     : throw InputError("/degree",
                                        "velocities need a mesh of degree 2 or more: pressures have one degree less")),
                mesh, options.by_splines) {
  require_fields(mesh_);
}

void NavierStokes::require_fields(const Mesh& mesh) {
  for (const char* name : {"velocity", "acceleration", "mesh_velocity"}) {
    const int k = find_field(mesh, name);
    if (k == none) continue;
    const Field& field = mesh.fields()[index(k)];
    if (field.components == 2 && !field.by_face) continue;
    throw InputError("/fields/" + std::to_string(k),
                     "the field \"" + field.name + "\" has " + std::to_string(field.components) + " components" +
                         (field.by_face ? " by face" : "") + "; the flow needs a continuous one of two");
  }
}

bool NavierStokes::has_inertia() const {
  return std::ranges::any_of(problem_.materials, [](const auto& each) { return each.density.constant() != 0.0; });
}

double NavierStokes::greatest_density() const {
  double greatest = 0;
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    const Coefficient& density = problem_.materials[index(mesh_.face(t))].density;
    for (int c = 0; c < 3; ++c) {
      Barycentric xi{0, 0, 0};
      xi[index(c)] = 1;
      const Point place = mesh_.boundary().unit * mesh_.point(mesh_.corner(t, c));
      greatest = std::max(greatest, evaluate_at(density, {mesh_, t, xi, place, mesh_.time}));
    }
  }
  return greatest;
}

std::vector<double> NavierStokes::field_values(const char* name) const {
  const int k = find_field(mesh_, name);
  return k == none ? std::vector<double>() : mesh_.fields()[index(k)].values;
}

void NavierStokes::put(const char* name, std::vector<double> values) {
  Field field;
  if (const int k = find_field(mesh_, name); k != none) field = mesh_.fields()[index(k)];
  field.name = name;
  field.components = 2;
  field.values = std::move(values);
  mesh_.set_field(std::move(field));
}

void NavierStokes::put_state() {
  put("velocity", state_.velocity);
  std::vector<double> values = elevated_values(equation_.pressures(), state_.pressure, mesh_.degree());
  for (double& value : values) value *= mesh_.boundary().unit;
  put_scalar("pressure", values, equation_.pressure_jumps());
}

void NavierStokes::put_scalar(const char* name, std::span<const double> element_values, bool by_face) {
  Field field;
  if (const int k = find_field(mesh_, name); k != none) field.extra = mesh_.fields()[index(k)].extra;
  field.name = name;
  field.by_face = by_face;
  if (by_face) field.places = field_places(mesh_);
  field.values.assign(by_face ? field.places.size() : index(mesh_.point_slots()), 0.0);
  mesh_.set_field(field);
  const int k = find_field(mesh_, name);
  std::size_t at = 0;
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
    for (const PointId p : mesh_.net(t))
      field.values[index(mesh_.value_index(k, p, mesh_.face(t)))] = element_values[at++];
  mesh_.set_field(std::move(field));
}

void NavierStokes::require_triangles() const {
  const VelocityUnknowns& velocities = equation_.velocities();
  std::vector<int> triangles(velocities.enclosed().size(), 0);
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) ++triangles[index(velocities.part_of(t))];
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    const int count = triangles[index(velocities.part_of(t))];
    if (count >= least_triangles || !velocities.is_enclosed(velocities.part_of(t))) continue;
    std::ostringstream text;
    text << "the face \"" << mesh_.boundary().faces[index(mesh_.face(t))].name << "\" has " << count
         << (count == 1 ? " triangle" : " triangles") << " between walls, where some pressure is felt by no velocity: "
         << "it needs " << least_triangles << " or more (refine)";
    throw NoSolution(text.str());
  }
}

void NavierStokes::solve(const Configuration& at, const FlowTerms& terms, bool reuses_factors) {
  require_triangles();
  std::vector<double> given(2 * index(mesh_.point_slots())), load;
  equation_.velocities().give(at, given);
  equation_.assemble(at, terms, given, matrix_, load);
  const bool is_symmetric = (terms.convecting.empty() && equation_.form().is_symmetric) || terms.projects;
  if (!is_symmetric) equation_.pin_pressures(matrix_, load);
  std::vector<double> x(load.size(), 0.0);
  const auto solve_by = [&](LinearSolver& solver) -> SolveOutcome {
    if (const std::string why = solver.factor(matrix_); !why.empty())
      return {.why = why + "; does something hold the fluid, and has each face between walls three triangles or more?"};
    return solver.solve(load, x, solver_tolerance);
  };
  std::unique_ptr<LinearSolver>& solver = is_symmetric ? symmetric_solver_ : general_solver_;
  if (solver == nullptr)
    solver = is_symmetric ? make_quasi_definite(equation_.multipliers()) : make_saddle_general(equation_.multipliers());
  SolveOutcome outcome;
  if (reuses_factors && has_factors_)
    outcome = solve_by_gmres(matrix_, *solver, load, x, {.most_iterations = most_with_old_factors});
  if (!outcome.converged) {
    std::ranges::fill(x, 0.0);
    outcome = solve_by(*solver);
    has_factors_ = !is_symmetric && outcome.converged;
  }
  if (!is_symmetric && !outcome.converged) {
    // Factors without pivots have grown too much.
    std::ranges::fill(x, 0.0);
    if (pivoting_solver_ == nullptr) pivoting_solver_ = make_direct_general();
    outcome = solve_by(*pivoting_solver_);
  }
  ++counts.solves;
  counts.worst_residual = std::max(counts.worst_residual, outcome.residual);
  if (!outcome.converged) throw NoSolution(outcome.why);
  state_ = equation_.state(at, x, given);
  if (terms.newton) rounded_ = velocity_of_terms(load, x);
}

double NavierStokes::velocity_of_terms(std::span<const double> load, std::span<const double> x) const {
  std::vector<double> velocities;
  for (int i = 0; i < equation_.velocities().size(); ++i) {
    double sum = std::abs(load[index(i)]), diagonal = 0;
    for (int k = matrix_.pattern->starts[index(i)]; k < matrix_.pattern->starts[index(i) + 1]; ++k) {
      const int column = matrix_.pattern->columns[index(k)];
      sum += std::abs(matrix_.values[index(k)] * x[index(column)]);
      if (column == i) diagonal = std::abs(matrix_.values[index(k)]);
    }
    if (diagonal > 0) velocities.push_back(sum / diagonal);
  }
  return norm(velocities);
}

void NavierStokes::solve_without_convection(const Configuration& at) { solve(at, FlowTerms{}); }

void NavierStokes::solve_steady() {
  const Configuration now{mesh_.points(), mesh_.time};
  solve_without_convection(now);
  if (has_inertia()) {
    double reached = 0, raise = 1;
    while (reached < 1) {
      const double next = std::min(reached + raise, 1.0);
      if (iterate(now, next)) {
        reached = next;
        raise *= 2;
        continue;
      }
      raise /= 4;
      if (raise >= least_raise && counts.solves < most_solves) continue;
      std::ostringstream text;
      text
          << "Newton's method does not converge: with " << next << " of the convection the last iteration changed the "
          << "velocity by " << last_change_ << " of it, with " << reached << " it has converged (" << counts.solves
          << " solutions in all); the flow may have no steady state that is stable: steps in time, a greater viscosity "
             "or a finer mesh help usually";
      throw NoSolution(text.str());
    }
  }
  FlowTerms terms;
  terms.convecting = has_inertia() ? std::span<const double>(state_.velocity) : std::span<const double>();
  find_forces(now, terms);
  put_state();
}

bool NavierStokes::iterate(const Configuration& at, double convection) {
  const FlowState start = state_;
  double first = 0;
  for (int k = 0; k < most_newton_iterations && counts.solves < most_solves; ++k) {
    const std::vector<double> before = state_.velocity;
    FlowTerms terms;
    terms.convecting = before;
    terms.newton = true;
    terms.convection = convection;
    try {
      solve(at, terms, k > 0);
    } catch (const NoSolution&) {
      break;  // with less convection there may be one
    }
    std::vector<double> change = state_.velocity;
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= before[i];
    last_change_ = norm(change) / std::max(norm(state_.velocity), 1e-300);
    if (last_change_ <= newton_tolerance || norm(change) <= newton_rounding * rounded_) return true;
    if (k == 0) first = last_change_;
    if (!(last_change_ <= greatest_growth * first)) break;
  }
  state_ = start;
  return false;
}

void NavierStokes::initialise() {
  if (find_field(mesh_, "velocity") != none) return;
  const Configuration now{mesh_.points(), mesh_.time};
  if (!has_inertia()) {
    solve_without_convection(now);
    find_forces(now, FlowTerms{});
    return put_state();
  }
  std::vector<double> values(2 * index(mesh_.point_slots()), 0.0);
  if (problem_.initial) {
    const Space space = Space::continuous(mesh_);
    for (std::size_t component = 0; component < 2; ++component) {
      const std::vector<double> unknowns =
          interpolate(space, mesh_, now, [&](FaceId) -> const Coefficient& { return (*problem_.initial)[component]; });
      std::size_t at = 0;
      for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
        for (const PointId p : mesh_.net(t)) values[2 * index(p) + component] = unknowns[index(space.unknowns()[at++])];
    }
  }
  FlowTerms terms;
  terms.history = values;
  terms.projects = true;
  terms.least_weight = least_weight * greatest_density();
  solve(now, terms);
  std::ranges::fill(state_.pressure, 0.0);  // of a projection it has no meaning
  put_state();
}

void NavierStokes::step(std::span<const Point> from, double t0, std::optional<double> last_dt) {
  const double dt = mesh_.time - t0, unit = mesh_.boundary().unit;
  const std::vector<double> before = field_values("velocity"), rate = field_values("acceleration");
  const std::vector<double> last_motion = field_values("mesh_velocity");
  const bool convects = has_inertia() && !options_.mesh_follows, moves = !from.empty() || !last_motion.empty();
  const double ratio = last_dt ? dt / *last_dt : 0;
  const bool is_bdf2 = options_.scheme == FlowOptions::Scheme::bdf2 && last_dt && !rate.empty() &&
                       ratio <= greatest_ratio && ratio > 0 && (!convects || !moves || !last_motion.empty());
  if (!is_bdf2) ++counts.euler_steps;
  // rate of the velocity at the end: weight * (change in this step) / dt - (weight - 1) * (the same of the last step)
  const double weight = is_bdf2 ? (1 + 2 * ratio) / (1 + ratio) : 1;

  std::vector<double> history(before.size()), convecting, motion(before.size(), 0.0);
  for (std::size_t i = 0; i < before.size(); ++i)
    history[i] = weight / dt * before[i] + (is_bdf2 ? (weight - 1) * rate[i] : 0);
  for (std::size_t p = 0; p < from.size(); ++p) {
    const Vector moved = (unit / dt) * (mesh_.point(static_cast<PointId>(p)) - from[p]);
    motion[2 * p] = moved.x;
    motion[2 * p + 1] = moved.y;
  }
  // Relative to the mesh, whose rate is taken as that of the velocity.
  const auto relative = [&](std::vector<double> velocity) {
    for (std::size_t i = 0; i < velocity.size() && moves; ++i)
      velocity[i] -= weight * motion[i] - (is_bdf2 ? (weight - 1) * last_motion[i] : 0);
    return velocity;
  };
  if (convects) {
    convecting = before;
    for (std::size_t i = 0; i < before.size() && is_bdf2; ++i) convecting[i] += dt * rate[i];
    convecting = relative(std::move(convecting));
  }
  FlowTerms terms;
  terms.inertia = weight / dt;
  terms.history = history;
  terms.convecting = convecting;
  terms.tension_time = dt;
  terms.before = before;
  const Configuration now{mesh_.points(), mesh_.time};
  solve(now, terms);
  for (int k = 0; k < options_.corrections && convects; ++k) {
    convecting = relative(state_.velocity);
    terms.convecting = convecting;
    solve(now, terms, true);
  }
  find_forces(now, terms);

  std::vector<double> change = state_.velocity;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = (change[i] - before[i]) / dt;
  put("acceleration", std::move(change));
  if (convects && moves) put("mesh_velocity", std::move(motion));
  put_state();
}

}  // namespace pliant
