// lib/pliant/geometry/placement/touching_disks.cpp: disks that shrink until no sample is inside.
#include "pliant/geometry/placement/touching_disks.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>

namespace pliant {
namespace {

namespace bgi = boost::geometry::index;
using Place = boost::geometry::model::d2::point_xy<double>;
using Entry = std::pair<Place, std::size_t>;
using Tree = bgi::rtree<Entry, bgi::quadratic<16>>;

constexpr double settled = 1e-9;  // when a radius shrinks by less than this, relatively, the search ends

bool meet(const CurveStretch& a, const CurveStretch& b) {
  const auto is_end_of_b = [&b](int place) { return place >= 0 && (place == b.first || place == b.last); };
  return is_end_of_b(a.first) || is_end_of_b(a.last);
}

}  // namespace

std::vector<double> touching_disks(std::span<const CurveSample> samples, std::span<const CurveStretch> stretches,
                                   double widest) {
  std::vector<Entry> entries;
  entries.reserve(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k)
    entries.emplace_back(Place(samples[k].place.x, samples[k].place.y), k);
  const Tree tree(entries.begin(), entries.end());

  // The disk is shrunk until it touches the sample nearest to its centre, again and again until none is inside.
  const auto radius_towards = [&](const CurveSample& sample, const Vector& normal) {
    const auto counts = [&](const Entry& entry) {
      const CurveSample& other = samples[entry.second];
      if (other.place == sample.place) return false;
      return other.stretch == sample.stretch || !meet(stretches[static_cast<std::size_t>(sample.stretch)],
                                                      stretches[static_cast<std::size_t>(other.stretch)]);
    };
    for (double radius = widest;;) {
      const Point center = sample.place + radius * normal;
      double smaller = radius;
      for (auto found = tree.qbegin(bgi::nearest(Place(center.x, center.y), 1) && bgi::satisfies(counts));
           found != tree.qend(); ++found) {
        const Vector to = samples[found->second].place - sample.place;
        if (dot(normal, to) > 0) smaller = squared_length(to) / (2 * dot(normal, to));
      }
      if (!(smaller < radius * (1 - settled))) return radius;
      radius = smaller;
    }
  };

  std::vector<double> radii;
  radii.reserve(samples.size());
  for (const CurveSample& sample : samples) {
    const Vector normal{-sample.tangent.y, sample.tangent.x};
    radii.push_back(sample.tangent == Vector{}
                        ? widest
                        : std::min(radius_towards(sample, normal), radius_towards(sample, -1.0 * normal)));
  }
  return radii;
}

}  // namespace pliant
