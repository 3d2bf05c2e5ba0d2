// formats/picture/isolines/sign_changes.cpp: where a polynomial on a segment changes its sign.
#include "formats/picture/isolines/sign_changes.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

constexpr int most_root_halvings = 52;

class Search {
 public:
  explicit Search(int degree) : degree_(degree) {}
  std::vector<double> found;

  void segment(const std::vector<double>& b, double from, double to, bool above_from, bool above_to, int depth) {
    // By Descartes's rule there are no more changes in the segment than between its coefficients.
    int changes = 0;
    for (std::size_t k = 1; k < b.size(); ++k) changes += (b[k] >= 0) != (b[k - 1] >= 0) ? 1 : 0;
    if (changes == 0 || depth == most_root_halvings) {
      if (above_from != above_to) found.push_back(std::abs(b.front()) <= std::abs(b.back()) ? from : to);
      return;
    }
    if (changes == 1 && above_from != above_to && (b.front() >= 0) == above_from && (b.back() >= 0) == above_to) {
      found.push_back(single(b, from, to));
      return;
    }
    std::vector<double> left(b.size()), right(b.size());
    split_polygon(degree_, 1, b, 0.5, left, right);
    const double middle = from + (to - from) / 2;
    const bool above_middle = right.front() >= 0;
    segment(left, from, middle, above_from, above_middle, depth + 1);
    segment(right, middle, to, above_middle, above_to, depth + 1);
  }

 private:
  double value(const std::vector<double>& b, double s) const {
    double result = 0;
    evaluate_polygon(degree_, 1, b, s, {&result, 1});
    return result;
  }
  /// The only change, by false position with halving of the end that stays (the Illinois rule), which needs no
  /// derivative and keeps the root between two signs.
  double single(const std::vector<double>& b, double from, double to) const {
    double s0 = 0, s1 = 1, f0 = b.front(), f1 = b.back();
    for (int round = 0; round < 100 && s1 - s0 > 0x1p-52; ++round) {
      double s = s0 - f0 * (s1 - s0) / (f1 - f0);
      if (!(s > s0 && s < s1)) s = s0 + (s1 - s0) / 2;
      if (!(s > s0 && s < s1)) break;
      const double f = value(b, s);
      if ((f >= 0) == (f1 >= 0)) {
        s1 = s, f1 = f;
        f0 /= 2;
      } else {
        s0 = s, f0 = f;
        f1 /= 2;
      }
      if (f == 0) return from + (to - from) * s;
    }
    return from + (to - from) * (std::abs(f0) < std::abs(f1) ? s0 : s1);
  }

  int degree_;
};

}  // namespace

std::vector<double> sign_changes(std::span<const double> coefficients, bool above_at_0, bool above_at_1) {
  Search search(static_cast<int>(coefficients.size()) - 1);
  search.segment({coefficients.begin(), coefficients.end()}, 0, 1, above_at_0, above_at_1, 0);
  std::sort(search.found.begin(), search.found.end());
  return std::move(search.found);
}

}  // namespace pliant
