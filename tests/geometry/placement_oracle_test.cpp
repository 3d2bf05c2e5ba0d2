// tests/geometry/placement_oracle_test.cpp: best places of one point are the optima that another method finds.
#include "support/placement_oracle.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "pliant/geometry/placement/optimal_placement.h"

// The other method cuts polygons, in long double. Values are compared at the place itself.
namespace {
using namespace pliant;
using samples::PlacementOracle;
using Outcome = Placement::Outcome;
using Program = Placement::Program;

constexpr double wanted = 1e-10;
constexpr double reach = 4, far = 200;  // in half extents: how far untangle_point looks, and far enough for tau

struct Deviations {
  double coefficient = 0;  // how far the least coefficient is from its optimum
  double shape = 0;        // how far tau at the place is from its optimum
  double bound = 0;        // how far the returned value is from tau at the place
  double control = 0;      // how far both programs of the control mesh are from their optima
  long placed = 0, hopeless = 0, stuck = 0, missed = 0, no_shape = 0;

  std::string text() const {
    return "coefficient " + std::to_string(coefficient * 1e10) + "e-10, shape " + std::to_string(shape * 1e10) +
           "e-10, bound " + std::to_string(bound * 1e10) + "e-10, control " + std::to_string(control * 1e10) +
           "e-10; placed " + std::to_string(placed) + ", hopeless " + std::to_string(hopeless) + ", stuck " +
           std::to_string(stuck) + " (missed " + std::to_string(missed) + ")" + ", no shape " +
           std::to_string(no_shape);
  }
};

samples::PlacementStar moved(samples::PlacementStar star, const Point& place) {
  star.move(place);
  return star;
}

void compare_true_measures(const samples::PlacementStar& star, const PlacementOracle& oracle, Deviations& worst) {
  const auto elements = star.elements();
  const Placement untangled = untangle_point(star.degree, elements, star.place());
  const Placement improved = improve_point(star.degree, elements, star.place(), PlacementMeasure::element, wanted);
  const Placement soon = improve_point(star.degree, elements, star.place(), PlacementMeasure::element, 2e-3);
  const auto coefficient = static_cast<double>(oracle.best_coefficient(reach));
  const auto best = oracle.best_shape(far);
  const auto shape = static_cast<double>(best.value);

  worst.placed += untangled.outcome == Outcome::placed;
  worst.hopeless += untangled.outcome == Outcome::hopeless;
  worst.stuck += untangled.outcome == Outcome::stuck;
  worst.no_shape += shape == 0;
  if (untangled.program != Program::area) FAIL_CHECK("untangling is an area program");
  if (untangled.outcome == Outcome::placed && !moved(star, untangled.place).is_valid()) FAIL_CHECK("not valid");
  if (untangled.outcome == Outcome::hopeless && shape > 0) FAIL_CHECK("hopeless, with a tau of " << shape);
  // Where det J is 0 up to rounding there can be no certificate, whatever tau is.
  const auto is_possible = [&] { return shape > wanted && oracle.best_area(far) > 1e-12L; };
  worst.missed += untangled.outcome == Outcome::stuck && is_possible();
  // Cuts raise the optimum above the least coefficient, which is then only a lower bound of it.
  if (untangled.outcome != Outcome::hopeless) {
    const double gap = coefficient - untangled.value, off = coefficient > 0 ? std::fabs(gap) : gap;
    worst.coefficient = std::max(worst.coefficient, off);
    if (off > wanted) FAIL_CHECK("least coefficient " << untangled.value << ", best " << coefficient);
  }

  for (const auto& [placement, accuracy] : {std::pair{improved, 0.0}, std::pair{soon, 2e-3}}) {
    if (placement.outcome == Outcome::placed && !moved(star, placement.place).is_valid()) FAIL_CHECK("not valid");
    if (placement.program == Program::area && is_possible()) FAIL_CHECK("area program, with a tau of " << shape);
    if (placement.program == Program::shape && placement.outcome != Outcome::placed) FAIL_CHECK("shape of no place");
    if (placement.program == Program::area) continue;
    const auto reached = static_cast<double>(oracle.shape_at(placement.place));
    if (std::fabs(shape - reached) > wanted + accuracy * shape) FAIL_CHECK("tau " << reached << ", best " << shape);
    if (placement.value > reached + 1e-12) FAIL_CHECK("tau " << reached << ", claimed " << placement.value);
  }
  if (improved.program == Program::area) return;
  const auto reached = static_cast<double>(oracle.shape_at(improved.place));
  worst.shape = std::max(worst.shape, std::fabs(shape - reached));
  worst.bound = std::max(worst.bound, reached - improved.value);
}

void compare_control_mesh(const samples::PlacementStar& star, const PlacementOracle& oracle, Deviations& worst) {
  const auto elements = star.elements();
  const Placement untangled = untangle_point(star.degree, elements, star.place(), PlacementMeasure::control_mesh);
  const Placement improved = improve_point(star.degree, elements, star.place(), PlacementMeasure::control_mesh);
  const auto area = static_cast<double>(oracle.best_control_area(reach));
  const auto best = oracle.best_control_shape(far);
  const auto shape = static_cast<double>(best.value);

  const double off = std::fabs(untangled.value - area);
  worst.control = std::max(worst.control, off);
  if (off > wanted) FAIL_CHECK("area " << untangled.value << ", best " << area);
  if ((untangled.outcome == Outcome::placed) != moved(star, untangled.place).is_valid()) FAIL_CHECK("wrong verdict");

  if (improved.outcome == Outcome::placed && !moved(star, improved.place).is_valid()) FAIL_CHECK("not valid");
  if (improved.program == Program::area) {
    if (shape > wanted && moved(star, best.place).is_valid()) FAIL_CHECK("area program, with a tau of " << shape);
    return;
  }
  const auto reached = static_cast<double>(oracle.control_shape_at(improved.place));
  if (std::fabs(improved.value - reached) > wanted) FAIL_CHECK("tau " << reached << ", claimed " << improved.value);
  if (star.is_valid() && reached < static_cast<double>(oracle.control_shape_at(star.place())) - wanted)
    FAIL_CHECK("worse than the start");
  // If the best place is certified it is taken; if not, nearly as good places are not looked for.
  if (shape < wanted || !moved(star, best.place).is_valid()) return;
  worst.control = std::max(worst.control, std::fabs(shape - reached));
  if (std::fabs(shape - reached) > wanted) FAIL_CHECK("tau " << reached << ", best " << shape);
}

Deviations compare(int degree, unsigned long stars, unsigned long first = 0) {
  Deviations worst;
  for (unsigned long seed = first; seed < first + stars; ++seed) {
    CAPTURE(degree, seed);
    const samples::PlacementStar star = samples::hard_star(degree, seed);
    const PlacementOracle oracle(star);
    compare_true_measures(star, oracle, worst);
    if (seed % 4 == 0) compare_control_mesh(star, oracle, worst);
  }
  return worst;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr unsigned long slower = 10;
#else
constexpr unsigned long slower = 1;
#endif

}  // namespace

TEST_CASE("the best place of a point of straight or quadratic elements is optimal to 1e-10", "[geometry][property]") {
  const int degree = GENERATE(1, 2);
  const Deviations worst = compare(degree, (degree == 1 ? 1000 : 4000) / slower);
  INFO(worst.text());
  CHECK(worst.placed > worst.hopeless);
  CHECK(worst.stuck * 200 <= worst.placed);
  CHECK(worst.missed == 0);
}

TEST_CASE("the best place of a point of elements of higher degree is optimal to 1e-10", "[geometry][property]") {
  const int degree = GENERATE(3, 4, 5);
  const Deviations worst = compare(degree, (degree == 3 ? 120 : degree == 4 ? 50 : 30) / slower);
  INFO(worst.text());
  CHECK(worst.placed > 0);
}

TEST_CASE("a million best places are optimal to 1e-10", "[.long]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const std::array<unsigned long, 5> stars{20000, 978500, 1000, 300, 200};
  const Deviations worst = compare(degree, stars[static_cast<std::size_t>(degree - 1)], 1000000);
  WARN("degree " << degree << ": " << worst.text());
  CHECK(worst.placed > worst.hopeless);
  CHECK(worst.missed * 10000 <= worst.placed);
}
