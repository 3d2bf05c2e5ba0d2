// lib/pliant/generate/patch_fields.h: the fields of tangled elements, carried over to the elements that replace them.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit/region_integrals.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// The fields of elements of one face, some of them folded, as they were before others took their place.
///
/// Where the old elements lie over each other a place has several values, one of which is taken: that of a valid
/// element, if there is one there. The new function interpolates these values at the lattice nodes of each new element,
/// less the best linear function: functions of degree <= 1 stay themselves, whatever is folded.
///
/// The integral of each component stays, unless options.projection is l2. That of the old elements is signed: it is
/// the integral over the region if the field is a function of the place. As `limited` says new values stay within the
/// range of the old ones, but for what of the integral cannot be kept within it.
///
/// Complexity  O((new elements + free points) * old elements near a place * degree^3)
class PatchFields {
 public:
  void capture(const Mesh& mesh, std::span<const TriangleId> old);
  /// `free`: the new points, ascending: all points of `now` but those on the border of the region.
  void put(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free, const RefitOptions& options);

 private:
  struct Column {
    int field, component;
    Patch::Linear linear;
    double low, high;  ///< the range of the old values
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
  /// What the field has beside the linear function, one value for each column.
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
  std::vector<Point> points_;       // size_ for each old element
  std::vector<double> residuals_;   // size_ x count_ for each
  std::vector<OldElement> by_low_;  // by the least x of their boxes
  std::vector<char> is_set_;        // of the free points
};

}  // namespace pliant
