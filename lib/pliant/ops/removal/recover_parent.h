// lib/pliant/ops/removal/recover_parent.h: finds the element (the parent) of which others are a subdivision.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {

/// Elements count as a subdivision if residuals of a field are below this times its largest value.
inline constexpr double subdivision_tolerance = 1e-12;

/// Finds the parent of some elements, the *pieces*, which are its sub-nets if they come from a de Casteljau
/// subdivision. First its edges are given or found, then its inner points, by least squares. The best linear function
/// is taken out of each field before, so that functions of degree <= 1 come back as they were, however badly
/// conditioned the subdivision is. Reused from call to call without allocation.
class ParentRecovery {
 public:
  /// Reads the pieces; the parent is not known yet.
  void start(const Mesh& mesh, std::span<const TriangleId> pieces);
  /// Edge e of the parent is edge `from` of a piece.
  void take_edge(int e, int piece, int from);
  /// Finds edge e of the parent, which is divided at s into edge `first` and then edge `second`; both are given as
  /// (piece, its edge). False if they are not the halves of one edge, to the tolerances of find_inner.
  bool find_edge(int e, double s, std::array<int, 2> first, std::array<int, 2> second);
  /// Moves the control points inside edge e to `points`; fields change there as their best linear functions do.
  void place_edge(int e, std::span<const Point> points);
  /// Finds the inner points; corners[i] says where the corners of piece i lie in the parent. False if the sub-nets of
  /// the parent found differ from the pieces: points by more than the mesh's tolerance, or a field by more than
  /// `subdivision_tolerance` times its largest value plus its slope times the mesh's tolerance.
  ///
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
  /// *Reduces* rows: positions become relative to origin_, and fields lose their best linear function.
  void reduce(std::span<double> rows) const;
  /// Undoes that for one row.
  void complete(std::span<double> row) const;
  double* reduced(int k) { return reduced_.data() + static_cast<std::size_t>(k * width_); }
  bool subtract_pieces(std::span<const std::array<Barycentric, 3>> corners);

  int degree_ = 0, n_ = 0, width_ = 0;
  Point origin_;
  Patch patch_;
  std::vector<Patch::Linear> linear_;     // the best linear function of each field column
  std::vector<double> largest_;           // the largest absolute value in each column
  std::vector<double> tolerances_;        // the largest residual allowed in each column
  std::vector<double> pieces_;            // the pieces' rows, reduced
  std::vector<double> parent_, reduced_;  // the parent's rows, as they are and reduced
  std::vector<double> residual_, image_, right_, units_;
};

}  // namespace pliant
