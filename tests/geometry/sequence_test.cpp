// tests/geometry/sequence_test.cpp: a Sequence is a vector, and curves of a million knots change at little cost.
#include "pliant/geometry/sequence.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/geometry/spline/bspline.h"

using namespace pliant;

TEST_CASE("a sequence is the vector that the same insertions and erasures make, short and long",
          "[geometry][property]") {
  const std::size_t start = GENERATE(std::size_t{0}, std::size_t{10}, std::size_t{2040}, std::size_t{5000});
  const bool at_one_place = GENERATE(false, true);
  CAPTURE(start, at_one_place);
  std::mt19937 random(3);
  std::vector<double> plain(start);
  for (double& value : plain) value = static_cast<double>(random());
  Sequence<double> sequence = plain;
  const auto agree = [&] {
    return sequence.size() == plain.size() && sequence.to_vector() == plain &&
           std::equal(sequence.begin(), sequence.end(), plain.begin(), plain.end());
  };
  for (const unsigned grows : {9u, 1u, 5u}) {  // how many of ten changes are insertions
    for (int k = 0; k < 6000; ++k) {
      const bool inserts = plain.empty() || random() % 10 < grows;
      const std::size_t most = plain.size() - (inserts ? 0 : 1);
      const std::size_t i = at_one_place ? most / 3 : random() % (most + 1);
      const auto place = plain.begin() + static_cast<std::ptrdiff_t>(i);
      const double value = static_cast<double>(random());
      if (inserts) {
        sequence.insert(i, value);
        plain.insert(place, value);
      } else {
        sequence.erase(i);
        plain.erase(place);
      }
      if (k % 500 == 0) CHECK(agree());
      if (plain.empty()) continue;
      const std::size_t j = random() % plain.size();
      sequence[j] = plain[j] = value + 1;
      CHECK(sequence.front() == plain.front());
      CHECK(sequence.back() == plain.back());
    }
    CHECK(agree());
    const Sequence<double> copy = sequence;
    CHECK(copy == sequence);
  }
}

// This took minutes when each change moved all knots after it.
TEST_CASE("a curve of a million spans gains and loses a hundred thousand knots, with few edits for each",
          "[geometry]") {
  const bool closed = GENERATE(false, true);
  CAPTURE(closed);
  constexpr int spans = 1000000, changes = 50000, p = 2;
  std::vector<double> knots;
  if (!closed) knots.assign(p, 0.0);
  for (int i = 0; i <= spans; ++i) knots.push_back(i);
  if (!closed) knots.insert(knots.end(), p, spans);
  std::vector<Point> points;
  for (int i = 0; i < (closed ? spans : spans + p); ++i) points.push_back({std::cos(i * 1e-3), std::sin(i * 1e-3)});
  const BSpline before(p, closed, knots, points);
  BSpline curve = before;
  BSpline::Edits edits;
  std::size_t most = 0;
  std::size_t last = 0;
  const auto note = [&] {
    most = std::max(most, edits.size() - last);
    last = edits.size();
  };
  for (int k = 0; k < changes; ++k) {
    curve.insert_knot(static_cast<double>(k * 7919LL % spans) + 0.5, &edits);
    note();
  }
  for (int k = 0; k < changes; ++k) {  // from the start, so that on a closed curve each is the first break in turn
    REQUIRE(curve.remove_break(curve.closed() ? curve.first_parameter() : curve.span_end(0), &edits));
    note();
  }
  CHECK(most <= 4 * (2 * p + 2) + 4);
  CHECK(curve.span_count() == spans);
  for (; !edits.empty(); edits.pop_back()) curve.take_back(edits.back());
  CHECK(curve.knots() == before.knots());
  CHECK(curve.points() == before.points());
}
