#include "pliant/ops/recover_parent.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

bool recover_parent(int degree, int width, std::span<const PieceOfParent> pieces, std::span<const char> known,
                    std::span<double> parent, double tolerance, double size) {
  const int n = net_size(degree);
  const auto rows = static_cast<Eigen::Index>(pieces.size()) * n;
  // The subdivision as a matrix: sub_net applied to the unit nets.
  std::vector<double> identity(static_cast<std::size_t>(n * n), 0.0), image(identity.size());
  for (int k = 0; k < n; ++k) identity[static_cast<std::size_t>(k * n + k)] = 1;
  Eigen::MatrixXd subdivide(rows, n), wanted(rows, width);
  Eigen::Index first = 0;
  for (const PieceOfParent& piece : pieces) {
    sub_net(degree, n, identity, piece.a, piece.b, piece.c, image);
    for (int k = 0; k < n; ++k) {
      for (int m = 0; m < n; ++m) subdivide(first + k, m) = image[static_cast<std::size_t>(k * n + m)];
      for (int c = 0; c < width; ++c) wanted(first + k, c) = piece.rows[static_cast<std::size_t>(k * width + c)];
    }
    first += n;
  }
  const Eigen::MatrixXd pieces_rows = wanted;
  std::vector<int> open;
  for (int m = 0; m < n; ++m) {
    if (!known[static_cast<std::size_t>(m)]) {
      open.push_back(m);
      continue;
    }
    for (int c = 0; c < width; ++c) wanted.col(c) -= subdivide.col(m) * parent[static_cast<std::size_t>(m * width + c)];
  }
  if (!open.empty()) {
    Eigen::MatrixXd system(rows, static_cast<Eigen::Index>(open.size()));
    for (std::size_t k = 0; k < open.size(); ++k) system.col(static_cast<Eigen::Index>(k)) = subdivide.col(open[k]);
    const Eigen::MatrixXd found = system.colPivHouseholderQr().solve(wanted);
    wanted -= system * found;
    for (std::size_t k = 0; k < open.size(); ++k)
      for (int c = 0; c < width; ++c)
        parent[static_cast<std::size_t>(open[k] * width + c)] = found(static_cast<Eigen::Index>(k), c);
  }
  for (int c = 0; c < width; ++c) {
    const double scale = c < 2 ? 1.0 : pieces_rows.col(c).cwiseAbs().maxCoeff() / (size > 0 ? size : 1);
    if (!(wanted.col(c).cwiseAbs().maxCoeff() <= tolerance * scale)) return false;
  }
  return true;
}

}  // namespace pliant
