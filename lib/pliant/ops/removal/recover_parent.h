// lib/pliant/ops/removal/recover_parent.h: the element of which others are a de Casteljau subdivision.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {

inline constexpr double subdivision_tolerance = 1e-12;  ///< of the size: residual of what counts as a subdivision

/// The parent of some elements: its edges are told or found first, then its inner points. What is found has the pieces
/// as its sub-nets in the least-squares sense. Fields are found less their best linear function, so that functions of
/// degree <= 1 come back as they were, whatever the division's condition. Reused from call to call without allocation.
class ParentRecovery {
 public:
  /// Reads the pieces; nothing of the parent is known yet.
  void start(const Mesh& mesh, std::span<const TriangleId> pieces);
  /// Edge e of the parent is edge `from` of a piece.
  void take_edge(int e, int piece, int from);
  /// Edge e of the parent, divided at s, is edge `first` of a piece and then edge `second` of another one.
  bool find_edge(int e, double s, std::array<int, 2> first, std::array<int, 2> second);
  /// Puts the control points inside edge e elsewhere; fields follow as their best linear functions do.
  void place_edge(int e, std::span<const Point> points);
  /// The inner points. `corners`: where each piece's corners lie in the parent. False where the pieces of what was
  /// found differ from those that are by more than the mesh's tolerance, or by more of a field than its largest value
  /// times `subdivision_tolerance` and what its slope makes of that length.
  /// Complexity  O(p^8) for p > 2, else O(1)
  bool find_inner(std::span<const std::array<Barycentric, 3>> corners);

  /// All rows of the parent.
  std::span<const double> rows() const { return parent_; }
  std::span<const double> row(int k) const {
    return std::span<const double>(parent_).subspan(static_cast<std::size_t>(k * width_),
                                                    static_cast<std::size_t>(width_));
  }
  Point point(int k) const { return {row(k)[0], row(k)[1]}; }

 private:
  /// The same rows about the origin, without the linear part of the fields; and back.
  void reduce(std::span<double> rows) const;
  void complete(std::span<double> row) const;
  double* reduced(int k) { return reduced_.data() + static_cast<std::size_t>(k * width_); }
  bool subtract_pieces(std::span<const std::array<Barycentric, 3>> corners);

  int degree_ = 0, n_ = 0, width_ = 0;
  Point origin_;
  Patch patch_;
  std::vector<Patch::Linear> linear_;     // of each field's columns
  std::vector<double> largest_;           // of each field's column
  std::vector<double> tolerances_;        // of each column's residual
  std::vector<double> pieces_;            // reduced
  std::vector<double> parent_, reduced_;  // rows of the parent
  std::vector<double> residual_, image_, right_, units_;
};

}  // namespace pliant
