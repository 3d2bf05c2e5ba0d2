// lib/pliant/ops/refit/field_fit.h: the fit of some field components over the elements that replace those of a patch.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/ops/refit/refit.h"

namespace pliant {

/// Field components that are fitted together since they have the same unknowns: those of all continuous fields, or
/// those of all fields by face on one face.
struct FieldGroup {
  struct Component {
    int column;  ///< the column in the patch's rows
    int field, component;
  };
  std::vector<Component> components;
  bool by_face = false;
  FaceId face = none;  ///< the face, if by_face

  bool contains(FaceId f) const { return !by_face || f == face; }
};

/// Fits the fields of one group as Patch::fit_fields says. It fits *residuals*: values less those of the function that
/// fits the old elements best among the linear ones, so that linear functions are reproduced to rounding. An object's
/// memory is reused from fit to fit.
class FieldFit {
 public:
  /// False if an integral that was asked for is not kept to rounding.
  bool run(const Patch& patch, Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
           const FieldGroup& group, const RefitOptions& options, bool region_kept);

 private:
  struct Range {
    double low, high;
    double clamp(double v) const { return std::clamp(v, low, high); }
    Range moved(double by) const { return {low + by, high + by}; }
    void include(double v) { low = std::min(low, v), high = std::max(high, v); }
  };
  using Net = std::array<Point, net_size(max_degree)>;
  using Weights = std::array<double, net_size(max_degree)>;
  /// What is known of one component before its residuals are fitted.
  struct Component : FieldGroup::Component {
    Patch::Linear linear;  ///< the best linear function
    /// Ranges over the old control points: of the values, of their residuals, of the linear function.
    Range values, residuals, trends;
    double target;  ///< the integral that the residuals of the unknowns should have
  };
  struct OldPlace {
    std::size_t element;
    Barycentric xi;
  };

  /// Collects the unknowns: the free points in the group's new elements.
  void collect_unknowns(std::span<const PointId> free);
  /// The number of an unknown; -1 for any other point.
  int unknown_of(PointId p) const;
  /// Finds the best linear functions, the residuals of the old elements, their ranges and integrals.
  void take_residuals();
  /// Does so for one component in one old element.
  void take_residuals(std::size_t element, int c, const Net& net, const Weights& weights);
  /// Sets up the least-squares equations, and finds what each unknown weighs in the integral.
  void assemble();
  /// Sets `unknown_` and `known_` for one new element, and takes what is known out of the integral's target.
  void take_known(TriangleId t, const Net& net);
  /// Adds the samples of the old residuals in one new element, less what is known there, to the equations.
  void add_samples(const Net& net);
  /// The old element that contains a place, and where in it the place lies. For a place outside all of them, the
  /// element in which the least barycentric coordinate of the place is greatest.
  std::optional<OldPlace> find_old(const Point& place) const;

  /// Solves the least-squares problem for component c, with the integral as an equality. Residuals that leave their
  /// ranges are held at the bound, and the others (the *open* ones) are solved for again.
  void solve_component(int c);
  /// Solves for the open residuals.
  void solve_open(int c, double integral);
  /// Holds the open residuals that have left their ranges; true if there was one.
  bool hold_outside(const Component& component);
  /// The range in which the residual of a component must be at a place.
  Range residual_range(const Component& component, const Point& place) const;
  /// True if the old function is linear to rounding; no residual is fitted then.
  bool is_linear(const Component& component) const;
  /// Writes the values of the unknowns to the mesh. Returns what is missing of the integral.
  double put_values(const Component& component);
  /// Spreads what the unknowns could not keep of the integral over the known values on the edges of the new elements,
  /// and then over those at their corners. Returns what is still missing.
  double spread_missing(const Component& component, double missing, double noise);
  /// Collects the *takers*, the known values that may change to keep the integral: on the edges, or at the corners.
  void collect_takers(const Component& component, bool corners);

  int unknown_count() const { return static_cast<int>(unknowns_.size()); }
  /// The value of a component in the mesh as it is now.
  double current(PointId p, FaceId f, const Component& component) const {
    const std::ptrdiff_t first = mesh_->value_index(component.field, p, f);
    if (first < 0) return 0;
    const Field& field = mesh_->fields()[static_cast<std::size_t>(component.field)];
    return field.values[static_cast<std::size_t>(first + component.component)];
  }
  /// The value of the best linear function.
  double trend(const Component& component, const Point& place) const {
    return patch_->evaluate(component.linear, place);
  }

  const Patch* patch_ = nullptr;
  Mesh* mesh_ = nullptr;
  const FieldGroup* group_ = nullptr;
  std::span<const TriangleId> now_;
  bool conserves_ = false, limits_ = false;
  int columns_ = 0, size_ = 0;  // components of the group; control points of an element

  std::vector<PointId> unknowns_;
  std::vector<Component> components_;
  std::vector<double> old_residuals_;  // for each old element: size_ x columns_

  std::array<int, net_size(max_degree)> unknown_;  // for one new element: the unknown at each point, -1 if it is known,
  std::vector<double> known_;                      // and the known residuals, size_ x columns_
  std::vector<double> sample_;                     // the residual of each component at one sample
  std::vector<double> normal_, right_;             // the equations: unknowns x unknowns, unknowns x columns_
  std::vector<double> weights_;                    // what each unknown weighs in the integral
  double equation_scale_ = 0, weight_scale_ = 0;   // how large the entries of `normal_` and `weights_` are

  std::vector<double> solution_;  // residuals of the unknowns, for one component
  std::vector<char> held_;        // for each unknown: 1 if it is held at a bound
  std::vector<int> open_;         // the unknowns that are not held
  std::vector<double> system_, system_right_;

  std::vector<PointId> takers_;                       // for each taker: its point,
  std::vector<FaceId> taker_faces_;                   // the face from which it is seen,
  std::vector<double> taker_weights_, taker_values_;  // its weight in the integral, its value,
  std::vector<Range> taker_ranges_;                   // and its range (empty: no limits)
};

}  // namespace pliant
