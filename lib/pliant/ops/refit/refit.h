// lib/pliant/ops/refit/refit.h: keeps elements as they were before a change, and fits what replaces them.
#pragma once
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// A copy of some elements, made before a local change and used after it to place new control points and to refit the
/// fields. Reused from call to call without allocation.
class Patch {
 public:
  /// Copies the rows of the elements `old`, so that the change may reuse their points.
  void capture(const Mesh& mesh, std::span<const TriangleId> old);

  /// Places the free control points of the elements `now`, which replace the old ones in the same logical region. The
  /// displacement of the old elements from their straight triangles is fitted in the least-squares sense, and no point
  /// is displaced farther than the old ones were. If that is not valid, optimal placement is tried. Displacements up to
  /// `straight_below` times the longest edge count as none, if straight elements are valid. True if all of `now` are
  /// certified valid.
  ///
  /// Paper       §5.2.3
  bool fit_geometry(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                    double straight_below = 0) const;

  /// Refits the fields at the free control points, once the elements `now` have their final geometry: least squares
  /// against the old function at the same places, weighted by area. Functions of degree <= 1 are reproduced. The
  /// integral is kept, and values are limited, as options.projection says; the integral only if `region_kept`, that is
  /// if old and new elements cover the same region. False if the integral cannot be kept within the limits: the caller
  /// must undo the operation.
  bool fit_fields(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                  const RefitOptions& options, bool region_kept = true) const;

  /// A linear function c0 + c1 (x - x0) + c2 (y - y0), where (x0, y0) is the first corner of the patch.
  struct Linear {
    double c0 = 0, c1 = 0, c2 = 0;
  };
  /// The linear function that fits the old control values of a column best, on one face or (none) on all of them.
  Linear linear_of(int column, FaceId face) const;
  /// What the linear fits of all columns share: moments of the control points (of the elements of a face) about their
  /// mean.
  struct Moments {
    Point mean;
    double count = 0;
    /// The wider of x - mean and y - mean is the coordinate s; the other one, less lean times s, is the coordinate t.
    bool along_x = true;              ///< s is x - mean
    double ss = 0, tt = 0, lean = 0;  ///< sums of the squares of s and of t, which are orthogonal
    /// The coordinates s and t.
    std::pair<double, double> split(const Vector& d) const {
      const Vector r = d - mean;
      return along_x ? std::pair{r.x, r.y - lean * r.x} : std::pair{r.y, r.x - lean * r.y};
    }
  };
  Moments moments_of(FaceId face) const;
  /// Residuals up to this are rounding noise of a linear function in a column with values up to `largest`. They must
  /// not be fitted, since fits enlarge noise.
  double rounding_of(const Linear& linear, double largest) const {
    return 0x1p-44 * (largest + (std::abs(linear.c1) + std::abs(linear.c2)) * reach_);
  }
  Linear linear_of(int column, FaceId face, const Moments& moments) const;
  double evaluate(const Linear& linear, const Point& p) const {
    return linear.c0 + linear.c1 * (p.x - origin_.x) + linear.c2 * (p.y - origin_.y);
  }
  /// The rows of all old elements, one after the other.
  std::span<const double> all_rows() const { return rows_; }

 private:
  friend class FieldFit;  // reads the old elements
  struct Element {
    FaceId face;
    std::size_t first_row;  // index of its first row in rows_, in doubles
  };
  std::span<const double> rows(const Element& e) const {
    return std::span<const double>(rows_).subspan(e.first_row, static_cast<std::size_t>(n_ * width_));
  }
  Point old_point(const Element& e, int k) const {
    const std::size_t i = e.first_row + static_cast<std::size_t>(k * width_);
    return {rows_[i], rows_[i + 1]};
  }
  /// The longest edge of the old elements' straight triangles.
  double extent() const;
  /// Projects the displacement of the old elements: finds that of each free point. From degree 3 on, where all
  /// triangles are shapely, third derivatives count before positions: those of a new element's map must fall with h^3
  /// as those of the old ones do, or cubic elements lose their order.
  void fit_displacement(const Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                        std::span<const double> displacement, std::span<Vector> solution) const;

  int degree_ = 0, n_ = 0, width_ = 0;
  double size_ = 0, reach_ = 0;  // the size of the mesh; the largest coordinate of an old corner
  Point origin_;
  std::vector<Element> elements_;
  std::vector<double> rows_;
};

/// The weight of each control point in integrals, ∫ B_k det J over the element: the integral of a field is the sum of
/// weight times control value.
void integral_weights(int degree, std::span<const Point> net, std::span<double> weights);

/// The integral weight of control point p over all elements that contain it; if by face, over those with the same face
/// as `inside`. Element `inside` contains p, with number `local` in its net.
double weight_in_mesh(const Mesh& mesh, PointId p, TriangleId inside, int local, bool by_face);

}  // namespace pliant
