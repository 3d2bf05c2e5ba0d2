// tests/geometry/validity_oracle_test.cpp: the certificate against exact answers, on a million elements.
#include "support/validity_oracle.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>

#include "pliant/geometry/validity/exact_validity.h"
#include "pliant/geometry/validity/validity.h"
#include "support/exact_elements.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

// A release build tests every element, which makes a million; sanitizers, which are some ten times slower, every tenth.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLIANT_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLIANT_SANITIZED
#endif
#ifdef PLIANT_SANITIZED
constexpr int stride = 10;
#else
constexpr int stride = 1;
#endif

std::vector<Point> in_doubles(const IntegerNet& net, int exponent = 0) {
  std::vector<Point> result;
  for (const auto& [x, y] : net) {
    for (const std::int64_t c : {x, y})
      if (static_cast<std::int64_t>(static_cast<double>(c)) != c) FAIL("not exact in doubles");
    result.push_back({std::ldexp(static_cast<double>(x), exponent), std::ldexp(static_cast<double>(y), exponent)});
  }
  return result;
}

Validity expected(int sign) { return sign > 0 ? Validity::valid : sign < 0 ? Validity::invalid : Validity::degenerate; }

/// Counts the elements of each kind, and checks that not one was judged wrongly.
class Tally {
 public:
  void compare(int degree, const IntegerNet& net, const Truth& truth, double minimum, std::uint64_t seed) {
    const auto points = in_doubles(net, -10);
    const Validity verdict = certify(degree, points);
    ++elements_;
    ++count_[{truth.sign, truth.place}];
    if (verdict == expected(truth.sign)) return;
    if (degree > 2 && verdict == Validity::degenerate) {  // right where the minimum is within the stated gap
      const Certificate exact = certify_exactly(degree, points, -1);
      if (minimum <= exact.gap * IntegerJacobian<Fixed<512>>(degree, net).greatest() * (1 + 1e-9)) {
        ++excused_;
        return;
      }
    }
    disagree(degree, truth.sign, verdict, seed);
  }

  /// The truth is what bisection in integers proves, in short ones if they suffice.
  void compare_enclosed(int degree, const IntegerNet& net, std::uint64_t seed) {
    const IntegerJacobian<Wide> jacobian(degree, net);
    const auto found = jacobian.enclose(jacobian.depth_of(127));
    if (!found.is_decided() || !judge(jacobian, found.sign, degree, net)) compare_long(degree, net, seed);
  }

  /// The same for long coordinates.
  void compare_long(int degree, const IntegerNet& net, std::uint64_t seed) {
    const IntegerJacobian<Fixed<1024>> jacobian(degree, net);
    const auto found = jacobian.enclose(40);
    if (found.is_decided() && judge(jacobian, found.sign, degree, net)) return;
    const auto points = in_doubles(net, -10);
    const double gap = certify(degree, points) == Validity::degenerate ? certify_exactly(degree, points, -1).gap : 0;
    const auto nearer = IntegerJacobian<Fixed<2048>>(degree, net).enclose(136, 40000, gap);
    if (gap == 0) {
      if (nearer.is_decided() && judge(jacobian, nearer.sign, degree, net)) return;
    } else if (nearer.sign >= 0 && nearer.lower >= -gap && nearer.upper <= gap) {
      ++elements_;
      ++excused_;
      return;
    }
    disagree(degree, nearer.sign, certify(degree, points), seed);
  }

  int count(int sign, Place place) const {
    const auto found = count_.find({sign, place});
    return found == count_.end() ? 0 : found->second;
  }
  int elements() const { return elements_; }
  int excused() const { return excused_; }
  int disagreements() const { return disagreements_; }
  std::string text() const {
    std::string result = std::to_string(elements_) + " elements";
    for (const auto& [kind, n] : count_)
      result += (kind.first > 0   ? ", valid "
                 : kind.first < 0 ? ", invalid "
                                  : ", degenerate ") +
                std::string(kind.second == Place::corner ? "corner "
                            : kind.second == Place::edge ? "edge "
                                                         : "face ") +
                std::to_string(n);
    return result + ", not separated " + std::to_string(excused_);
  }

 private:
  template <class Jacobian>
  bool judge(const Jacobian& jacobian, int sign, int degree, const IntegerNet& net) {
    if (certify(degree, in_doubles(net, -10)) != expected(sign)) return false;
    ++elements_;
    ++count_[{sign, sign == jacobian.sign_at_corners() ? Place::corner : Place::edge}];
    return true;
  }

  void disagree(int degree, int sign, Validity verdict, std::uint64_t seed) {
    ++disagreements_;
    const int got = static_cast<int>(verdict);
    CAPTURE(degree, seed, sign, got);
    FAIL_CHECK("the certificate is wrong");
  }

  int elements_ = 0, excused_ = 0, disagreements_ = 0;
  std::map<std::pair<int, Place>, int> count_;
};

/// Checks that there were enough elements with a minimum of this sign at such a place.
void check_populated(const Tally& tally, int sign, Place place, int at_least) {
  CAPTURE(sign, static_cast<int>(place));
  CHECK(tally.count(sign, place) >= at_least / stride);
}

/// An element with long coordinates: one of small integers, enlarged to about 2^46, and then changed in a few last
/// places.
IntegerNet nearly(IntegerNet net, Draw& draw) {
  for (auto& point : net)
    for (std::int64_t& x : point) {
      x *= std::int64_t{1} << 46;
      if (draw.one_in(2)) x += draw.integer(-2, 2);
    }
  return net;
}

}  // namespace

TEST_CASE("100,000 linear elements have the sign of their area", "[geometry][oracle]") {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 100000; seed += stride) {
    Draw draw(seed);
    IntegerNet net = seed / stride % 4 == 0 ? unbalanced_net(1, draw) : random_net(1, draw);
    if (seed / stride % 4 == 1) net = nearly(net, draw);
    const Wide area =
        Wide(net[1][0] - net[0][0]) * (net[2][1] - net[0][1]) - Wide(net[1][1] - net[0][1]) * (net[2][0] - net[0][0]);
    const int sign = sign_of(area);
    if (seed / stride % 4 == 2) shear_far(net, draw);
    tally.compare(1, net, {sign, Place::corner}, 0, seed);
  }
  INFO(tally.text());
  for (const int sign : {-1, 0, 1}) check_populated(tally, sign, Place::corner, 5000);
  CHECK(tally.disagreements() == 0);
}

TEST_CASE("500,000 quadratic elements have the sign of their exact minimum", "[geometry][oracle]") {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 500000; seed += stride) {
    Draw draw(seed);
    const std::uint64_t kind = seed / stride % 8;
    IntegerNet net = kind == 0 ? tilted_power(2, draw).net : kind == 1 ? unbalanced_net(2, draw) : random_net(2, draw);
    if (kind == 3) net = nearly(net, draw);
    const Truth truth = kind < 2 || kind == 3 ? quadratic_truth<Fixed<512>>(net) : quadratic_truth<Wide>(net);
    if (kind % 2 == 0) shear_far(net, draw);
    tally.compare(2, net, truth, 0, seed);
  }
  INFO(tally.text());
  for (const Place place : {Place::corner, Place::edge, Place::face}) {
    check_populated(tally, -1, place, 1000);
    check_populated(tally, 0, place, 100);
  }
  check_populated(tally, 1, Place::corner, 50000);
  CHECK(tally.disagreements() == 0);
}

TEST_CASE("400,000 elements of degree 3 to 6 have the sign of their exact minimum, or are as near to zero as stated",
          "[geometry][oracle]") {
  const int degree = GENERATE(3, 4, 5, 6);
  const std::uint64_t elements = degree == 3 ? 160000 : degree == 4 ? 120000 : degree == 5 ? 70000 : 50000;
  Tally random, known;
  for (std::uint64_t seed = 0; seed < elements; seed += stride) {
    Draw draw(seed);
    const std::uint64_t kind = seed / stride % 64;
    if (kind >= 16) {
      random.compare_enclosed(degree, random_net(degree, draw), seed);
    } else if (kind >= 14) {
      const bool is_near = draw.one_in(2);
      random.compare_long(degree, is_near ? nearly(random_net(degree, draw), draw) : unbalanced_net(degree, draw),
                          seed);
    } else {
      KnownElement element = kind >= 6   ? strip(degree, draw)
                             : kind >= 2 ? tilted_power(degree, draw)
                                         : many_roots(degree, draw);
      if (draw.one_in(3)) map_affinely(element, draw);
      if (draw.one_in(3)) shear_far(element.net, draw);
      known.compare(degree, element.net, element.truth, element.minimum, seed);
    }
  }
  CAPTURE(degree, random.text(), known.text());
  for (const Tally* tally : {&random, &known})
    for (const int sign : {-1, 0, 1}) check_populated(*tally, sign, Place::corner, 300);
  for (const Place place : {Place::edge, Place::face}) {
    check_populated(known, -1, place, 100);
    check_populated(known, 0, place, 100);
  }
  check_populated(random, -1, Place::edge, 100);
  CHECK(random.excused() <= random.elements() / 1000 + 2);
  CHECK(known.excused() <= known.elements() / 100 + 2);
  CHECK(random.disagreements() + known.disagreements() == 0);
}

TEST_CASE("at the corner of a cusp a zero of det J is forgiven, and a change of sign is not", "[geometry][oracle]") {
  const int degree = GENERATE(2, 3, 4, 5, 6);
  for (std::uint64_t seed = 0; seed < 800; seed += stride) {
    CAPTURE(degree, seed);
    Draw draw(seed);
    const Triangle t = random_triangle(draw, 4, 1);
    const int corner = draw.integer(0, 2);
    const auto power = [&](const Gauss& tilt) {  // like tilted_power, with the root at the corner
      return in_doubles(net_of(degree, t, [&](const std::vector<Gauss>& u) -> std::array<std::int64_t, 2> {
        Gauss product(degree, 0), sum(0, 0);
        for (const Gauss& z : u) product *= z - t[index(corner)], sum += std::conj(z);
        product += tilt * sum;
        return {product.real(), product.imag()};
      }));
    };
    const auto touching = power(Gauss(0, 0));
    CHECK(certify(degree, touching) == Validity::degenerate);
    CHECK(certify_cusp(degree, touching, corner) == Validity::valid);
    CHECK(certify_cusp(degree, touching, (corner + 1) % 3) == Validity::degenerate);
    const auto crossing = power(Gauss(0, draw.integer(1, 3)));
    CHECK(certify(degree, crossing) == Validity::invalid);
    CHECK(certify_cusp(degree, crossing, corner) == Validity::invalid);

    // (l^(q + 1), m): det J is a multiple of l^q, and l = 0 at the corner.
    using Forms = std::array<std::int64_t, 2>;
    std::array<Forms, 3> forms;
    for (Forms& f : forms) f = {draw.integer(1, 5), draw.integer(-5, 5)};
    forms[index(corner)][0] = 0;
    const std::int64_t area = (forms[1][0] - forms[0][0]) * (forms[2][1] - forms[0][1]) -
                              (forms[1][1] - forms[0][1]) * (forms[2][0] - forms[0][0]);
    const int q = draw.integer(1, degree - 1);
    const auto strip = in_doubles(net_of(degree, forms, [&](const std::vector<Forms>& u) -> Forms {
      std::vector<std::int64_t> l, m;
      for (const Forms& f : u) l.push_back(f[0]), m.push_back(f[1]);
      return {blossom_of_power(q + 1, l), blossom_of_power(1, m)};
    }));
    CHECK(certify(degree, strip) == expected(area < 0 ? -1 : 0));
    CHECK(certify_cusp(degree, strip, corner) == expected(sign_of(area)));
    CHECK(certify_cusp(degree, strip, (corner + 1) % 3) == expected(area < 0 ? -1 : 0));
  }
}

TEST_CASE("forgiving a corner changes nothing but a zero there", "[geometry][oracle]") {
  const int degree = GENERATE(2, 3, 4, 5);
  const NetLayout& layout = NetLayout::of(degree);
  std::map<std::pair<Validity, Validity>, int> count;
  for (std::uint64_t seed = 0; seed < 6000; seed += stride) {
    CAPTURE(degree, seed);
    Draw draw(seed);
    IntegerNet net = random_net(degree, draw);
    if (draw.one_in(2))  // the edges at corner 0 leave it in one direction
      for (std::size_t c = 0; c < 2; ++c)
        net[index(layout.edge_index(2, degree - 1))][c] =
            net[0][c] + draw.integer(1, 2) * (net[index(layout.edge_index(0, 1))][c] - net[0][c]);
    const auto points = in_doubles(net);
    const Validity strict = certify(degree, points);
    const Validity forgiving = certify_cusp(degree, points, 0);
    ++count[{strict, forgiving}];
    const bool is_zero_there = lattice_jacobian(degree, points, 1, 0, 0) == 0;
    if (!is_zero_there || strict != Validity::degenerate) REQUIRE(forgiving == strict);
    if (forgiving != Validity::valid || strict == Validity::valid) continue;
    const int n = 12;
    bool is_positive = true;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j <= n; ++j)
        is_positive = is_positive && lattice_jacobian(degree, points, i, j, n - i - j) > 0;
    REQUIRE(is_positive);
  }
  const int told_apart = count[{Validity::degenerate, Validity::valid}];
  const int both = count[{Validity::degenerate, Validity::degenerate}];
  CHECK(told_apart >= 100 / stride);
  CHECK(both >= 100 / stride);
}
