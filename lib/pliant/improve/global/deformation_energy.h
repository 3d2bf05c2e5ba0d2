// lib/pliant/improve/global/deformation_energy.h: how far an element's map is from that of a wanted triangle.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// What an element should look like: the inverse of the matrix that maps the unit right triangle to a wanted triangle.
struct WantedShape {
  double xx = 1, xy = 0, yx = 0, yy = 1;
  /// The shape of the triangle with the corner 0 and these two sides, counter-clockwise.
  static WantedShape of(const Vector& u, const Vector& v);
  /// The gradient in the wanted triangle of a function with these slopes along the unit right triangle's sides.
  Vector gradient(const Vector& slope) const { return {slope.x * xx + slope.y * yx, slope.x * xy + slope.y * yy}; }
};

/// The deformation energy of one element as squares, half their sum being the energy: the mean over nodes of
///
///     |F|² / (2 det F) - 1  +  2 (u + 1 / u - 2)  =  (a² + b² + c²) / 2,     u = det F / m
///     a = (F11 - F22) / √det F,   b = (F12 + F21) / √det F,   c = 2 (√u - 1 / √u)
///
/// F is the gradient of the map from the wanted triangle to the element. m is the mean of det F over the element, or 1
/// if a certain area is wanted, too.
///
/// The first term measures shape: it is 1/τ - 1, with τ taken against the wanted triangle. The second term measures how
/// uneven det J is. (Its weight of four in c² is a compromise: more makes the least scaled Jacobian greater, and shapes
/// poorer.) Both terms are 0 where F is a rotation, and grow without bound as det F goes to 0, which makes a barrier.
/// Each of the squares vanishes with the energy, so near its zero the Gauss-Newton method is as good as Newton's.
///
/// With `smoothing` e > 0, det F is replaced by (det F + sqrt(e² + det F²)) / 2 in u and in the denominators. Then the
/// energy is finite everywhere, and the further an element is tangled the more it costs.
///
/// The nodes are the points of a lattice over the element, corners included, and the centres of the lattice's
/// triangles. Their weights are positive and make the rule exact for degree 2 on each triangle. `few` means p - 1
/// subdivisions (at least 1); `many` means 2p, for elements in which det F may be negative between few nodes.
///
/// Reference   the two terms (with m = 1, weights 1) and the smoothing: Garanzha, Kaporin, Kudryavtseva, Protais, Ray,
///             Sokolov, Foldover-free maps in 50 lines of code, 2021; the first one, with its barrier: Winslow's
///             functional in the form of Ivanenko and Charakhch'yan, 1988
class DeformationEnergy {
 public:
  static constexpr int residuals_each = 3;  // residuals at each node: a, b, c, weighted
  enum class Nodes { few, many };
  /// The energy for elements of this degree. It is built once for each; thread-safe.
  static const DeformationEnergy& of(int degree, Nodes nodes);

  int residual_count() const { return residuals_each * static_cast<int>(weights_.size()); }
  /// What an element is compared with.
  struct Target {
    WantedShape shape;
    bool any_area = false;  ///< any area will do: m is the mean of det F; else m is 1
    unsigned forgiven = 0;  ///< with bit k set the node in corner k does not count
    double smoothing = 0;   ///< the e of the smoothed energy
  };
  /// The residuals of an element's net, and, unless `jacobian` is null, their derivatives by the control points
  /// `moving` (indices into the net). The derivative of residual r by coordinate c of the m-th of these points goes to
  /// jacobian[(r * moving.size() + m) * 2 + c]. Returns false where the energy is not finite, which without smoothing
  /// is where det F <= 0 at a node.
  bool evaluate(std::span<const Point> net, const Target& target, std::span<double> residuals,
                std::span<const std::int8_t> moving, double* jacobian) const;

 private:
  DeformationEnergy(int degree, int subdivisions);
  int degree_;
  std::vector<Vector> slopes_;   // slopes of the basis functions along (xi2, xi3), by node; the corners come first
  std::vector<double> weights_;  // by node
};

}  // namespace pliant
