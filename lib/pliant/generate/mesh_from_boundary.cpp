// lib/pliant/generate/mesh_from_boundary.cpp: rounds of splitting, triangulating and lifting until all is valid.
#include "pliant/generate/mesh_from_boundary.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "pliant/generate/lift_triangles.h"
#include "pliant/generate/tame_spans.h"
#include "pliant/generate/wedges.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/spline/turning_angle.h"

namespace pliant {
namespace {

constexpr int most_rounds = 60;        // rounds of splits around invalid elements
constexpr int patient_rounds = 12;     // first rounds, in which spans are split rather than inner edges bent much
constexpr double mild_bending = 0.05;  // how far these rounds move a control point at most, in extents of its element
constexpr int most_ear_rounds = 20;    // rounds of points for ears, in each of those rounds
constexpr double straight = 1e-9;      // radians: spans that turn less are as good as their chords

class Generator {
 public:
  Generator(const BoundaryComplex& boundary, int degree, Progress* progress)
      : boundary_(boundary), degree_(degree), progress_(progress) {}

  GenerateOutcome run(Mesh& mesh) {
    elevate_curves(boundary_, degree_);
    if (progress_ != nullptr) progress_->start("generate", "rounds");
    for (int round = 0; round < most_rounds; ++round) {
      if (progress_ != nullptr) progress_->count(round);
      if (!triangulate_round()) return finish();
      LiftedMesh lifted(degree_, *spans_, planar_);
      const std::vector<int> invalid = lifted.untangle(round < patient_rounds ? mild_bending : HUGE_VAL);
      if (invalid.empty()) {
        finish_mesh(lifted, mesh);
        outcome_.report.add("rounds", round + 1);
        outcome_.report.add("untangled", static_cast<double>(lifted.untangled()));
        return finish();
      }
      if (!split_around(invalid)) return finish();
    }
    outcome_.failure =
        "elements stay invalid after " + std::to_string(most_rounds) + " rounds of splits, " + last_place_;
    return finish();
  }

 private:
  GenerateOutcome finish() {
    outcome_.report.add("knots_inserted", static_cast<double>(splits_));
    outcome_.report.add("ears_split", static_cast<double>(ears_));
    outcome_.report.add("first_triangles", static_cast<double>(planar_.corners.size()));
    return std::move(outcome_);
  }

  /// Tames the spans and triangulates their chords, with points for the ears at smooth or reflex corners. False if that
  /// fails; outcome_.failure says why.
  bool triangulate_round() {
    TameOutcome tame = tame_spans(boundary_);
    splits_ += tame.splits;
    outcome_.failure = std::move(tame.failure);
    if (!outcome_.failure.empty()) return false;
    spans_ = std::make_unique<BoundarySpans>(boundary_);
    for (int i = 0; i < most_ear_rounds; ++i) {
      outcome_.failure = triangulate_faces(boundary_, *spans_, free_points_, planar_);
      if (!outcome_.failure.empty()) return false;
      const std::vector<Point> ears = points_for_ears(*spans_, planar_);
      if (ears.empty()) return true;
      ears_ += static_cast<long>(ears.size());
      free_points_.insert(free_points_.end(), ears.begin(), ears.end());
    }
    return true;  // an ear that is left makes an invalid element, whose edges will be split
  }

  /// Splits spans at elements that could not be made valid: those that are curved, and straight ones on which the
  /// opposite corner encroaches. False if none could be split.
  bool split_around(const std::vector<int>& invalid) {
    std::set<std::size_t> chosen;
    for (const int t : invalid)
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        if (planar_.span(h) < 0) continue;
        const auto s = static_cast<std::size_t>(planar_.span(h));
        if (turning_angle(spans_->polygon(s)) > straight || is_encroached(h)) chosen.insert(s);
      }
    bool any = false;
    const double least = least_span(boundary_);
    const Wedges wedges(boundary_, *spans_);
    for (const std::size_t s : chosen) {
      if (!split_span(boundary_, (*spans_)[s], least, wedges.middle_of(s))) continue;
      any = true;
      ++splits_;
    }
    last_place_ = describe_place(invalid.front());
    if (!any)
      outcome_.failure = "no valid element was found " + last_place_ + " (" + std::to_string(invalid.size()) +
                         " elements are left without a certificate)";
    return any;
  }

  /// "near (0.5, 1), at curve 'wall' (2), parameters 0 to 1": a triangle's centre and the spans that it lies on.
  std::string describe_place(int t) const {
    Point center;
    for (const int v : planar_.corners[static_cast<std::size_t>(t)])
      center += planar_.points[static_cast<std::size_t>(v)] / 3;
    std::string text = "near " + describe_point(center);
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (planar_.span(h) >= 0)
        text += ", at " + describe_span(boundary_, (*spans_)[static_cast<std::size_t>(planar_.span(h))]);
    return text;
  }

  /// Does the opposite corner lie in the chord's diametral circle?
  bool is_encroached(int h) const {
    const auto point = [this](int g) { return planar_.points[static_cast<std::size_t>(planar_.origin(g))]; };
    const Point apex = point(h % 3 == 0 ? h + 2 : h - 1);
    return dot(point(h) - apex, point(h % 3 == 2 ? h - 2 : h + 1) - apex) < 0;
  }

  void finish_mesh(const LiftedMesh& lifted, Mesh& mesh) {
    MeshData data;
    data.degree = degree_;
    lifted.write(data);
    const int vertices = static_cast<int>(boundary_.vertices.size());
    for (const int node : lifted.cusps()) {
      if (node >= vertices) continue;
      if (std::find(boundary_.cusps.begin(), boundary_.cusps.end(), node) == boundary_.cusps.end())
        boundary_.cusps.push_back(node);
      outcome_.report.notes.push_back("vertex " + std::to_string(node) + " at " +
                                      describe_point(boundary_.vertices[static_cast<std::size_t>(node)]) +
                                      " is a cusp: the element there has det J = 0 at that corner");
    }
    std::sort(boundary_.cusps.begin(), boundary_.cusps.end());
    data.boundary = std::move(boundary_);
    mesh = Mesh(std::move(data));
    outcome_.ok = true;
  }

  BoundaryComplex boundary_;
  int degree_;
  Progress* progress_;
  std::unique_ptr<BoundarySpans> spans_;
  PlanarMesh planar_;
  std::vector<Point> free_points_;
  GenerateOutcome outcome_;
  std::string last_place_;
  long splits_ = 0, ears_ = 0;
};

}  // namespace

GenerateOutcome mesh_from_boundary(const BoundaryComplex& boundary, const GenerateOptions& options, Mesh& mesh) {
  int highest = 1;
  for (const Curve& curve : boundary.curves) highest = std::max(highest, curve.spline.degree());
  const int degree = options.degree > 0 ? options.degree : std::max(2, highest);
  GenerateOutcome outcome;
  if (degree < highest)
    outcome.failure =
        "a mesh of degree " + std::to_string(degree) + " cannot hold a curve of degree " + std::to_string(highest);
  else if (degree > max_degree)
    outcome.failure = "the degree " + std::to_string(degree) + " is above " + std::to_string(max_degree);
  else if (boundary.curves.empty())
    outcome.failure = "the boundary has no curves";
  if (!outcome.failure.empty()) return outcome;
  return Generator(boundary, degree, options.progress).run(mesh);
}

}  // namespace pliant
