// tests/quality/condition_test.cpp: what the conditions of --fail-if compare, and which texts are refused.
#include "pliant/quality/element/condition.h"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "support/sample_meshes.h"

using namespace pliant;

TEST_CASE("conditions compare figures of the report", "[quality]") {
  const QualityReport report = report_quality(samples::disk(2));
  const auto holds = [&](const char* text) { return Condition(text).holds(report); };
  CHECK(holds("triangles == 24"));
  CHECK(holds("triangles==24"));
  CHECK(holds(" degree <= 2 "));
  CHECK(holds("degree != 3"));
  CHECK_FALSE(holds("invalid > 0"));
  CHECK_FALSE(holds("faults>0"));
  CHECK(holds("invalid >= 0"));
  CHECK(holds("min(shape) < 1"));
  CHECK(holds("max( distortion )>=1"));
  CHECK(holds("mean(logical_angle) > 5e0"));
  CHECK(holds("tangent_jump < 1e-10"));
  CHECK(holds("min(jacobian) > -1.5"));
  CHECK(holds("area > +2"));
  CHECK(Condition("max(edge_length) > 0").value(report) > 0);
}

TEST_CASE("a figure that does not exist fulfils no condition", "[quality]") {
  const QualityReport straight = report_quality(samples::disk(1));
  CHECK_FALSE(Condition("tangent_jump >= 0").holds(straight));
  CHECK_FALSE(Condition("tangent_jump < 1").holds(straight));
  const QualityReport empty = report_quality(MeshData{});
  CHECK_FALSE(Condition("min(shape) != 0").holds(empty));
  CHECK_FALSE(Condition("min(shape) < 1").value(empty).has_value());
}

TEST_CASE("what is no condition is refused with a reason", "[quality]") {
  const char* text =
      GENERATE("", "invalid", "> 3", "invalid >", "invalid > x", "invalid > 1 2", "invalid > nan", "invalid > inf",
               "invalid => 1", "invalid = 1", "invalid <> 1", "shape > 1", "median(shape) > 1", "min(shape > 1",
               "min() > 1", "min(area) > 1", "frobnicate > 1", "min (shape)) > 1", "invalid > 1 > 2");
  CAPTURE(text);
  CHECK_THROWS_AS(Condition(text), std::invalid_argument);
}
