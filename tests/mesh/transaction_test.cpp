// tests/mesh/transaction_test.cpp: what is rolled back is bit for bit as it was.
#include <catch2/catch.hpp>
#include <random>

#include "mesh/same_mesh.h"
#include "ops/random_operations.h"
#include "pliant/mesh/check_mesh.h"

using namespace pliant;

namespace {

/// Calls every function that changes a mesh, at random, whether the result makes sense or not.
class RandomChanges {
 public:
  RandomChanges(Mesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {}
  /// Makes one change. This function is long since it is one list: a case for each function of Mesh that changes it.
  void change() {
    const PointId p = below(mesh_.point_slots());
    const TriangleId t = below(mesh_.triangle_slots());
    const HalfEdgeId h{below(3 * mesh_.triangle_slots())};
    const bool alive = mesh_.is_point_alive(p);
    switch (random_() % 17) {
      case 0:
        return mesh_.set_point(p, {number(), number()});
      case 1:
      case 2: {
        std::vector<double> row(static_cast<std::size_t>(mesh_.width()));
        for (double& x : row) x = number();
        return random_() % 2 ? mesh_.put_row(p, 0, row) : mesh_.put_fields(p, 0, row);
      }
      case 3:
        return mesh_.put_component(1, 1, p, 0, -0.0);
      case 4:
        mesh_.add_point();
        return;
      case 5:
        if (alive) mesh_.free_point(p);
        return;
      case 6:
        mesh_.add_triangle(0);
        return;
      case 7:
        if (mesh_.is_alive(t)) mesh_.free_triangle(t);
        return;
      case 8:
        return mesh_.set_net_point(t, static_cast<int>(random_() % static_cast<unsigned>(mesh_.net_size())), p);
      case 9:
        return mesh_.link(h, random_() % 3 ? HalfEdgeId{below(3 * mesh_.triangle_slots())} : none);
      case 10:
        return mesh_.set_constraint(h, none);
      case 11:
        constraints_.push_back(mesh_.add_constraint(0, number(), p));
        return mesh_.set_constraint(h, constraints_.back());
      case 12:
        if (mesh_.is_constrained(h)) mesh_.set_constraint_record(mesh_.constraint(h), 0, number(), p);
        return;
      case 13:
        if (mesh_.is_constrained(h)) {
          const ConstraintId c = mesh_.constraint(h);
          for (const HalfEdgeId g : mesh_.half_edges())
            if (mesh_.constraint(g) == c) mesh_.set_constraint(g, none);
          mesh_.free_constraint(c);
        }
        return;
      case 14:
        if (alive) mesh_.set_vertex_half_edge(p, random_() % 2 ? h : none);
        return;
      case 15: {
        const BSpline& spline = mesh_.spline(0);
        mesh_.set_curve_point(0, below(static_cast<std::int32_t>(spline.points().size())), {number(), number()});
        mesh_.set_removal_error(0, number());
        const std::vector<double> breaks = spline.breaks();
        const double knot = breaks[static_cast<std::size_t>(below(static_cast<std::int32_t>(breaks.size())))];
        if (random_() % 2)
          mesh_.remove_break(0, knot);
        else if (spline.multiplicity(knot) < spline.degree())
          mesh_.insert_knot(0, knot);
        return;
      }
      default:
        return mesh_.drop_place(p, 0);
    }
  }

 private:
  std::int32_t below(std::int32_t count) {
    return static_cast<std::int32_t>(random_() % static_cast<std::uint64_t>(count));
  }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Mesh& mesh_;
  std::mt19937_64 random_;
  std::vector<ConstraintId> constraints_;
};

/// Nests transactions at random: some are committed, some rolled back, some left to their destructor.
void nest(Mesh& mesh, RandomChanges& changes, std::mt19937_64& random, int depth) {
  const Mesh before = mesh;
  Transaction transaction(mesh);
  for (int k = 0; k < 6; ++k) {
    for (int n = 0; n < 5; ++n) changes.change();
    if (depth > 0) nest(mesh, changes, random, depth - 1);
  }
  const Mesh after = mesh;
  if (random() % 2) {
    transaction.commit();
    CHECK(difference(mesh, after).empty());
  } else {
    transaction.roll_back();
    CHECK(difference(mesh, before) == "");
  }
}

}  // namespace

TEST_CASE("what is rolled back is bit for bit as it was, however transactions nest", "[mesh][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  const bool by_face = GENERATE(false, true);
  CAPTURE(seed, by_face);
  Mesh mesh = carried_disk(2, by_face);
  RandomOperations(mesh, seed).run(30);  // so that there are free slots
  RandomChanges changes(mesh, seed);
  std::mt19937_64 random(seed + 1);
  const Mesh before = mesh;
  {
    const Transaction transaction(mesh);
    mesh.set_point(1, {9, 9});
    for (int k = 0; k < 3; ++k) nest(mesh, changes, random, 2);
    CHECK(difference(mesh, before) != "");
  }  // neither committed nor rolled back
  CHECK(difference(mesh, before) == "");
}

TEST_CASE("after a roll-back the mesh goes on as if nothing had been tried", "[mesh][property]") {
  // The lists of free slots are not visible, but the same operations must take the same slots.
  const int degree = GENERATE(1, 2, 3);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  Mesh mesh = carried_disk(degree, by_face);
  RandomOperations(mesh, 3).run(60);
  Mesh never = mesh;
  for (std::uint64_t round = 0; round < 5; ++round) {
    {
      Transaction outer(mesh);
      RandomOperations(mesh, 100 + round).run(20);
      {
        Transaction inner(mesh);
        RandomOperations(mesh, 200 + round).run(20);
        if (round % 2) inner.commit();
      }
      if (round != 4) outer.roll_back();
    }
    REQUIRE(difference(mesh, never) == "");
    RandomOperations(mesh, round).run(15);
    RandomOperations(never, round).run(15);
    REQUIRE(difference(mesh, never) == "");
    REQUIRE(check_mesh(mesh).empty());
  }
  mesh.compact();
  never.compact();
  CHECK(difference(mesh, never) == "");
}

TEST_CASE("a committed inner transaction goes when the outer one is rolled back, and stays when it is committed",
          "[mesh]") {
  Mesh mesh = carried_disk(2);
  const Mesh before = mesh;
  for (const bool commit : {false, true}) {
    Transaction outer(mesh);
    {
      Transaction inner(mesh);
      mesh.set_point(0, {7, 7});
      inner.commit();
    }
    CHECK(mesh.point(0) == Point{7, 7});
    if (commit)
      outer.commit();
    else
      outer.roll_back();
    CHECK(mesh.point(0) == (commit ? Point{7, 7} : before.point(0)));
  }
}
