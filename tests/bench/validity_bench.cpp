// tests/bench/validity_bench.cpp: the certificate of one element, by degree and by what it takes to decide.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

#include "pliant/geometry/validity/jacobian.h"
#include "pliant/geometry/validity/jacobian_terms.h"
#include "pliant/geometry/validity/validity.h"
#include "support/triangles.h"

namespace {

using namespace pliant;

/// The nets of many elements one behind the other, as an audit meets them.
using Nets = std::vector<Point>;

void certify_all(benchmark::State& state, int degree, const Nets& nets) {
  const auto size = static_cast<std::size_t>(net_size(degree));
  std::int64_t valid = 0;
  for (auto _ : state)
    for (std::size_t k = 0; k < nets.size(); k += size)
      valid += certify(degree, {nets.data() + k, size}) == Validity::valid;
  benchmark::DoNotOptimize(valid);
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(nets.size() / size),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Bent, with only positive coefficients of det J: the common case.
void valid_elements(benchmark::State& state) {
  const int degree = static_cast<int>(state.range(0));
  Nets nets;
  for (int seed = 0; seed < 1000; ++seed)
    for (const Point& p : samples::random_valid_net(degree, seed)) nets.push_back(p);
  certify_all(state, degree, nets);
}

/// Valid, with a negative coefficient: bisections have to prove it.
void strongly_curved_elements(benchmark::State& state) {
  const int degree = static_cast<int>(state.range(0));
  Nets nets;
  std::array<double, max_jacobian_size> coefficients;
  for (int seed = 0; nets.size() < static_cast<std::size_t>(200 * net_size(degree)); ++seed) {
    const auto net = samples::random_valid_net(degree, seed, 0.5);
    jacobian_net(degree, net, coefficients);
    const auto end = coefficients.cbegin() + net_size(jacobian_degree(degree));
    if (*std::min_element(coefficients.cbegin(), end) < 0 && certify(degree, net) == Validity::valid)
      nets.insert(nets.end(), net.begin(), net.end());
  }
  certify_all(state, degree, nets);
}

/// One zero of det J inside, at no point that bisection meets: exact arithmetic to the last.
void touching_elements(benchmark::State& state) {
  const int degree = static_cast<int>(state.range(0));
  const auto net = samples::power_net(degree, std::complex<double>(0x155p-10, 0x133p-10));
  certify_all(state, degree, net);
}

BENCHMARK(valid_elements)->DenseRange(1, 6);
BENCHMARK(strongly_curved_elements)->DenseRange(2, 6);
BENCHMARK(touching_elements)->DenseRange(2, 6);

}  // namespace
