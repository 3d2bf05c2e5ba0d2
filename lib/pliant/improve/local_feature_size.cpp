#include "pliant/improve/local_feature_size.h"

#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

namespace bgi = boost::geometry::index;
using Place = boost::geometry::model::d2::point_xy<double>;

constexpr double corner_angle = 0.05;  // radians: where tangents differ by more, a curve has a corner
constexpr double settled = 1e-9;       // relative change of a radius that ends the search

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A part of a curve without corners, and the vertices where it ends; none on a closed curve without corners.
struct Stretch {
  PointId first = none, last = none;

  bool meets(const Stretch& other) const {
    return first != none && (first == other.first || first == other.last || last == other.first || last == other.last);
  }
};

struct Sample {
  Point place;
  Vector tangent;  // unit; zero at corners and ends
  int stretch;
  std::array<PointId, 2> vertices;  // whose size it bounds
};

Vector unit(const Vector& v) {
  const double size = length(v);
  return size > 0 ? v / size : Vector{};
}

class FeatureSearch {
 public:
  FeatureSearch(const Mesh& mesh, const std::vector<CurveChain>& chains) : mesh_(mesh) {
    for (std::size_t c = 0; c < chains.size(); ++c)
      if (!chains[c].vertices.empty()) add_curve(mesh.boundary().curves[c].spline, chains[c]);
    std::vector<std::pair<Place, int>> places;
    places.reserve(samples_.size());
    for (std::size_t k = 0; k < samples_.size(); ++k)
      places.emplace_back(Place(samples_[k].place.x, samples_[k].place.y), static_cast<int>(k));
    tree_ = Tree(places.begin(), places.end());
  }

  std::vector<double> run() const {
    std::vector<double> sizes(at(mesh_.point_slots()), HUGE_VAL);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const Sample& sample = samples_[k];
      if (sample.tangent == Vector{}) continue;
      const Vector normal{-sample.tangent.y, sample.tangent.x};
      const double radius = std::min(radius_towards(sample, normal), radius_towards(sample, -1.0 * normal));
      for (const PointId v : sample.vertices) sizes[at(v)] = std::min(sizes[at(v)], radius);
    }
    return sizes;
  }

 private:
  using Tree = bgi::rtree<std::pair<Place, int>, bgi::quadratic<16>>;

  void add_curve(const BSpline& spline, const CurveChain& chain) {
    const std::size_t count = chain.vertices.size(), spans = chain.closed ? count : count - 1;
    const auto end_of = [&](std::size_t k) {
      return k + 1 < chain.breaks.size() ? chain.breaks[k + 1] : spline.last_parameter();
    };
    std::vector<bool> is_corner(count, false);
    for (std::size_t k = 0; k < count; ++k) {
      if (!chain.closed && (k == 0 || k + 1 == count)) {
        is_corner[k] = true;
        continue;
      }
      const double into = k == 0 ? spline.last_parameter() : chain.breaks[k];
      const Vector before = spline.derivative(into, true), after = spline.derivative(chain.breaks[k]);
      is_corner[k] = std::abs(std::atan2(cross(before, after), dot(before, after))) > corner_angle;
    }
    const auto first =
        static_cast<std::size_t>(std::find(is_corner.begin(), is_corner.end(), true) - is_corner.begin());
    const bool is_smooth = first == count;
    if (!is_smooth && std::count(is_corner.begin(), is_corner.end(), true) == 1)
      is_corner[(first + count / 2) % count] = true;  // both sides of the one corner are apart
    const std::size_t start = is_smooth ? 0 : first;
    for (std::size_t step = 0; step < spans; ++step) {
      const std::size_t k = (start + step) % count, next = (k + 1) % count;
      if (step == 0 || is_corner[k]) stretches_.push_back(is_smooth ? Stretch{} : Stretch{chain.vertices[k], none});
      const int stretch = static_cast<int>(stretches_.size()) - 1;
      if (is_corner[next]) stretches_.back().last = chain.vertices[next];
      const PointId v = chain.vertices[k], w = chain.vertices[next];
      if (!is_corner[k])
        samples_.push_back({mesh_.point(v), unit(spline.derivative(chain.breaks[k])), stretch, {v, v}});
      if (is_corner[k]) samples_.push_back({mesh_.point(v), {}, stretch, {v, v}});
      if (is_corner[next]) samples_.push_back({mesh_.point(w), {}, stretch, {w, w}});
      const double middle = (chain.breaks[k] + end_of(k)) / 2;
      samples_.push_back({spline.evaluate(middle), unit(spline.derivative(middle)), stretch, {v, w}});
    }
  }

  bool counts(const Sample& from, const Sample& to) const {
    if (from.stretch == to.stretch) return true;
    return !stretches_[at(from.stretch)].meets(stretches_[at(to.stretch)]);
  }

  /// The largest disk that touches at the sample, lies on the normal's side and has no other point inside: shrunk by
  /// the point nearest to its centre until there is none.
  double radius_towards(const Sample& sample, const Vector& normal) const {
    double radius = mesh_.size();
    for (;;) {
      const Point center = sample.place + radius * normal;
      double smaller = radius;
      const auto is_other = [&](const std::pair<Place, int>& entry) {
        const Sample& other = samples_[at(entry.second)];
        return &other != &sample && other.place != sample.place && counts(sample, other);
      };
      for (auto found = tree_.qbegin(bgi::nearest(Place(center.x, center.y), 1) && bgi::satisfies(is_other));
           found != tree_.qend(); ++found) {
        const Vector to = samples_[at(found->second)].place - sample.place;
        if (dot(normal, to) > 0) smaller = squared_length(to) / (2 * dot(normal, to));
      }
      if (!(smaller < radius * (1 - settled))) return radius;
      radius = smaller;
    }
  }

  const Mesh& mesh_;
  std::vector<Stretch> stretches_;
  std::vector<Sample> samples_;
  Tree tree_;
};

}  // namespace

std::vector<double> local_feature_sizes(const Mesh& mesh, const std::vector<CurveChain>& chains) {
  return FeatureSearch(mesh, chains).run();
}

}  // namespace pliant
