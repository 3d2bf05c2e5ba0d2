// tests/ops/flip_search_test.cpp: flips of strongly curved elements against a search for a place of the new edge.
#include <catch2/catch.hpp>
#include <random>

#include "ops/carried_domains.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/predicates.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/check_mesh.h"
#include "support/sample_boundaries.h"

using namespace pliant;

namespace {

/// The two elements after a flip of h, built from the four outer edges without the code under test.
struct Flipped {
  int degree;
  std::array<std::vector<Point>, 2> nets;
  std::vector<std::array<int, 2>> free;  // the index of each free point in either net; -1 if it is not in it

  Flipped(const Mesh& mesh, HalfEdgeId h) : degree(mesh.degree()) {
    const HalfEdgeId g = mesh.twin(h);
    const NetLayout& layout = mesh.layout();
    const Point c = mesh.point(mesh.apex(h)), d = mesh.point(mesh.apex(g));
    for (auto& net : nets) net.assign(index(mesh.net_size()), 0.5 * (c + d));
    // The first element (d, c, a) has edges dc, ca, ad; the second one (c, d, b) has edges cd, db, bc.
    const std::array<std::array<HalfEdgeId, 2>, 2> outer{{{previous(h), next(g)}, {previous(g), next(h)}}};
    for (std::size_t side = 0; side < 2; ++side)
      for (int e = 1; e < 3; ++e)
        for (int k = 0; k <= degree; ++k)
          nets[side][index(layout.edge_index(e, k))] = mesh.point(mesh.edge_point(outer[side][index(e - 1)], k));
    for (int k = 1; k < degree; ++k) free.push_back({layout.edge_index(0, k), layout.edge_index(0, degree - k)});
    for (int k = layout.first_interior(); k < mesh.net_size(); ++k) free.push_back({k, -1}), free.push_back({-1, k});
  }
  void place(const std::array<int, 2>& where, const Point& p) {
    for (std::size_t side = 0; side < 2; ++side)
      if (where[side] >= 0) nets[side][index(where[side])] = p;
  }
  Point point(const std::array<int, 2>& where) const {
    return where[0] >= 0 ? nets[0][index(where[0])] : nets[1][index(where[1])];
  }
  bool is_valid() const {
    return certify(degree, nets[0]) == Validity::valid && certify(degree, nets[1]) == Validity::valid;
  }
  Box box() const {
    Box box;
    for (const auto& net : nets)
      for (const Point& p : net) box.extend(p);
    return box;
  }
};

/// For p = 2: tries a grid of places for the one free point. True if some place makes both elements valid.
bool grid_finds(Flipped pair) {
  const Box box = pair.box();
  constexpr int n = 60;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      pair.place(pair.free[0],
                 {box.low.x + (box.high.x - box.low.x) * i / n, box.low.y + (box.high.y - box.low.y) * j / n});
      if (pair.is_valid()) return true;
    }
  return false;
}

/// For p > 2: sweeps of single placements from many random starts. True if one of them makes both elements valid.
bool search_finds(const Flipped& pair, std::mt19937_64& random) {
  const Box box = pair.box();
  std::uniform_real_distribution<double> x(box.low.x, box.high.x), y(box.low.y, box.high.y);
  for (int start = 0; start < 30; ++start) {
    Flipped trial = pair;
    for (const auto& where : trial.free) trial.place(where, {x(random), y(random)});
    for (int sweep = 0; sweep < 12; ++sweep) {
      for (const auto& where : trial.free) {
        std::vector<PlacementElement> around;
        for (std::size_t side = 0; side < 2; ++side)
          if (where[side] >= 0) around.push_back({trial.nets[side], where[side]});
        const Placement placement = untangle_point(trial.degree, around, trial.point(where));
        if (is_finite(placement.place)) trial.place(where, placement.place);
      }
      if (trial.is_valid()) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("a flip of strongly curved elements succeeds wherever a search finds a place for the new edge",
          "[ops][property]") {
  const int degree = GENERATE(2, 3);
  CAPTURE(degree);
  std::mt19937_64 random(7);
  long done = 0, missed = 0, impossible = 0;
  for (const BoundaryComplex& boundary : {samples::one_cell(degree), samples::annulus(degree),
                                          samples::three_cells(degree), samples::interface(degree)}) {
    Mesh original;
    const GenerateOutcome outcome = mesh_from_boundary(boundary, {degree}, original);
    REQUIRE(outcome.ok);
    for (int variant = 0; variant < (degree == 2 ? 6 : 3); ++variant) {
      Mesh bent = original;
      for (int k = 0; k < 30; ++k) {
        const auto t = static_cast<TriangleId>(random() % static_cast<unsigned>(bent.triangle_slots()));
        insert_point(bent, t, {1.0 / 3, 1.0 / 3, 1.0 / 3});
      }
      bend_inner_edges(bent, random);
      REQUIRE(find_invalid(bent).empty());
      for (const HalfEdgeId h : bent.half_edges()) {
        if (bent.twin(h) == none || bent.is_constrained(h) || h > bent.twin(h)) continue;
        // The flip may be refused since two edges on curves in one element would cover a corner of the boundary.
        const HalfEdgeId g = bent.twin(h);
        if ((bent.is_constrained(previous(h)) && bent.is_constrained(next(g))) ||
            (bent.is_constrained(previous(g)) && bent.is_constrained(next(h))))
          continue;
        Transaction undone(bent);
        const Flipped pair(bent, h);
        const Outcome flipped = flip_edge(bent, h);
        if (flipped == Outcome::done) ++done;
        if (flipped != Outcome::would_invert) continue;
        (degree == 2 ? grid_finds(pair) : search_finds(pair, random)) ? ++missed : ++impossible;
      }
    }
  }
  CHECK(done > 300);
  CHECK(impossible > 10);
  CHECK(static_cast<double>(missed) <= (degree == 2 ? 0.0 : 0.01) * static_cast<double>(done + missed));
}
