// tests/mesh/override_criteria_test.cpp: given criteria replace a document's, entry by entry.
#include "pliant/mesh/override_criteria.h"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "support/sample_meshes.h"

using namespace pliant;

namespace {

Criteria all_of(double number, const std::string& text, bool flag) {
  Criteria all;
  all.min_angle = all.max_area = all.max_turning = all.accuracy = all.min_size = number;
  all.size = all.size_field = text;
  all.keeps_thin = flag;
  return all;
}

void check_same(const Criteria& a, const Criteria& b) {
  CHECK(a.min_angle == b.min_angle);
  CHECK(a.max_area == b.max_area);
  CHECK(a.face_area == b.face_area);
  CHECK(a.size == b.size);
  CHECK(a.size_field == b.size_field);
  CHECK(a.max_turning == b.max_turning);
  CHECK(a.accuracy == b.accuracy);
  CHECK(a.min_size == b.min_size);
  CHECK(a.keeps_thin == b.keeps_thin);
}

}  // namespace

TEST_CASE("criteria that are not given stay, those that are given replace", "[mesh]") {
  const BoundaryComplex boundary = samples::three_disks(2).boundary;
  Criteria criteria = all_of(1, "x", true);
  override_criteria(criteria, {}, boundary);
  check_same(criteria, all_of(1, "x", true));
  override_criteria(criteria, all_of(2, "y", false), boundary);
  check_same(criteria, all_of(2, "y", false));
  Criteria none;
  override_criteria(none, all_of(3, "z", true), boundary);
  check_same(none, all_of(3, "z", true));
}

TEST_CASE("areas of faces are replaced face by face", "[mesh]") {
  const BoundaryComplex boundary = samples::three_disks(2).boundary;
  const std::string a = boundary.faces[0].name, b = boundary.faces[1].name, c = boundary.faces[2].name;
  Criteria criteria, given;
  criteria.face_area = {{a, 1}, {b, 2}};
  given.face_area = {{b, 3}, {c, 4}};
  override_criteria(criteria, given, boundary);
  const std::vector<std::pair<std::string, double>> wanted{{a, 1}, {b, 3}, {c, 4}};
  CHECK(criteria.face_area == wanted);
}

TEST_CASE("criteria with a face that does not exist leave everything as it was", "[mesh]") {
  Criteria criteria = all_of(1, "x", true), given = all_of(2, "y", false);
  given.face_area = {{samples::three_disks(2).boundary.faces[0].name, 1}, {"nowhere", 2}};
  CHECK_THROWS_WITH(override_criteria(criteria, given, samples::three_disks(2).boundary),
                    "the mesh has no face 'nowhere'");
  check_same(criteria, all_of(1, "x", true));
}
