// lib/pliant/generate/patch_fields.h: carries the fields of tangled elements over to the elements that replace them.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit/region_integrals.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// The fields of elements of one face, some of which are folded, before other elements take their place.
///
/// Where old elements lie over each other a place has several values. One of them is taken: that of a valid element, if
/// there is one. The best linear function is set apart, and the rest is interpolated at the lattice nodes of each new
/// element. So functions of degree at most 1 stay what they are, whatever is folded.
///
/// The integral of each component stays, unless options.projection is l2. The integral over the old elements is signed:
/// it is the integral over the region if the field is a function of the place. With the projection `limited` new values
/// stay within the range of the old ones, except where the integral cannot be kept so.
///
/// Complexity  O((new elements + free points) * old elements near a place * degree^3)
class PatchFields {
 public:
  void capture(const Mesh& mesh, std::span<const TriangleId> old);
  /// Gives the new elements `now` their fields. `free` lists the points that are new, ascending: those of `now` that
  /// are not on the border of the region.
  void put(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free, const RefitOptions& options);

 private:
  struct Column {
    int field, component;
    Patch::Linear linear;
    double low, high;  ///< the least and the greatest old value
    double integral;
    bool is_linear;  ///< but for rounding
  };
  struct OldElement {
    Box box;
    std::size_t index;
    bool is_valid;
  };
  void take_columns(const Mesh& mesh);
  std::span<const Point> old_net(std::size_t e) const { return {points_.data() + e * size_, size_}; }
  /// The fields at a place, less their linear functions: one value for each column.
  void sample(const Point& place, std::span<double> residuals) const;
  void fit_element(Mesh& mesh, TriangleId t, std::span<const PointId> free, bool is_limited);
  void put_residuals(Mesh& mesh, PointId p, FaceId f, std::span<const double> residuals, bool is_limited) const;
  void keep_integrals(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free, bool is_limited);

  int degree_ = 0, width_ = 0;
  std::size_t size_ = 0, count_ = 0;  // control points of an element; columns
  double tolerance_ = 0, widest_ = 0;
  Patch patch_;
  RegionIntegrals integrals_;
  std::vector<Column> columns_;
  std::vector<Point> points_;       // size_ points for each old element
  std::vector<double> residuals_;   // size_ x count_ values for each old element
  std::vector<OldElement> by_low_;  // the old elements, sorted by the least x of their boxes
  std::vector<char> is_set_;        // which of the free points have their values
};

}  // namespace pliant
