// lib/pliant/ops/refit/refit.h: a patch of elements before a change; fits geometry and fields of what replaces it.
#pragma once
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// The elements of a patch as they were: captured before a local change of topology, used after it to place the new
/// control points and to refit the fields. Reused from call to call without allocation.
class Patch {
 public:
  /// Copies the rows of the elements. Rows of points that the change reuses stay available here.
  void capture(const Mesh& mesh, std::span<const TriangleId> old);

  /// Places the free control points of the elements `now` (same logical region): the displacement field chi - identity
  /// of the logical region is fitted in the least-squares sense, never longer than the old displacement; where that is
  /// not valid, optimal placement. Displacements below `straight_below` of the extent count as none.
  /// True if all of `now` are certified valid.
  /// Paper §5.2.3; design: Flip, "Geometry first".
  bool fit_geometry(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                    double straight_below = 0) const;

  /// Refits the fields of the free control points in the (final) geometry of `now`: weighted least squares against the
  /// old function at physical quadrature points, integral kept and values limited as options.projection says.
  /// `region_kept`: old and new elements cover the same region; otherwise functions of degree <= 1 are reproduced and
  /// the integral is not asked for.
  /// Functions of degree <= 1 are reproduced always. False if an integral that was asked for cannot be kept within the
  /// limits: the operation is to be undone then.
  bool fit_fields(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                  const RefitOptions& options, bool region_kept = true) const;

  /// The best linear function of each field column over the old control values: value = c0 + c1 (x - x0) + c2 (y - y0).
  struct Linear {
    double c0 = 0, c1 = 0, c2 = 0;
  };
  Linear linear_of(int column, FaceId face) const;
  /// What the linear fits of all columns share: about the mean of the control points of the elements of a face.
  struct Moments {
    Point mean;
    double count = 0;
    bool along_x = true;              ///< the first of two orthogonal coordinates is x - mean, or y - mean
    double ss = 0, tt = 0, lean = 0;  ///< their squares; the second is the other one less lean times the first
    std::pair<double, double> split(const Vector& d) const {
      const Vector r = d - mean;
      return along_x ? std::pair{r.x, r.y - lean * r.x} : std::pair{r.y, r.x - lean * r.y};
    }
  };
  Moments moments_of(FaceId face) const;
  /// Residuals below this are what rounding leaves of a linear function in a column with values up to `largest`: they
  /// are not to be fitted, since fits enlarge noise.
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
    std::size_t first_row;  // into rows_, in doubles
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
  /// The displacements of the free points: those of the old elements, projected.
  void fit_displacement(const Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                        std::span<const double> displacement, std::span<Vector> solution) const;

  int degree_ = 0, n_ = 0, width_ = 0;
  double size_ = 0, reach_ = 0;  // of the mesh; of the coordinates
  Point origin_;
  std::vector<Element> elements_;
  std::vector<double> rows_;
};

/// ∫ B_k det J over the element for each control point k: the integral of a field is the sum of weight times value.
void integral_weights(int degree, std::span<const Point> net, std::span<double> weights);

/// The integral weight of one control point over all elements of the mesh that contain it (of one face if by face).
/// `local`: its number in the net of the element `inside`.
double weight_in_mesh(const Mesh& mesh, PointId p, TriangleId inside, int local, bool by_face);

}  // namespace pliant
