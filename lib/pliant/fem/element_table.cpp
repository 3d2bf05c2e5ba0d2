// lib/pliant/fem/element_table.cpp: fills the tables, once for each degree and rule.
#include "pliant/fem/element_table.h"

#include <array>
#include <memory>
#include <mutex>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/symmetric_rule.h"

namespace pliant {
namespace {

/// The derivatives of all basis functions at a point: those of one degree less, each of which adds to two of them.
void derivatives(int degree, const Barycentric& xi, std::span<double> along_2, std::span<double> along_3) {
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<double> lower(index(net_size(degree - 1)));
  bernstein_basis(degree - 1, xi, lower);
  const NetLayout& below = NetLayout::of(degree - 1);
  for (int k = 0; k < layout.size(); ++k) {
    const auto& [i, j, l] = layout.exponents(k);
    const double from_1 = i > 0 ? lower[index(below.index(i - 1, j))] : 0;
    along_2[index(k)] = degree * ((j > 0 ? lower[index(below.index(i, j - 1))] : 0) - from_1);
    along_3[index(k)] = degree * ((l > 0 ? lower[index(below.index(i, j))] : 0) - from_1);
  }
}

std::unique_ptr<ElementTable> build(int degree, int exact_degree) {
  auto made = std::make_unique<ElementTable>();
  ElementTable& table = *made;
  const auto rule = symmetric_rule(exact_degree);
  table.degree = degree;
  table.size = net_size(degree);
  table.points = static_cast<int>(rule.size());
  table.pairs = table.size * (table.size + 1) / 2;
  const std::size_t n = index(table.size);
  table.values.resize(rule.size() * n);
  table.along_2.resize(rule.size() * n);
  table.along_3.resize(rule.size() * n);
  for (std::size_t q = 0; q < rule.size(); ++q) {
    table.xi.push_back(rule[q].xi);
    table.weights.push_back(rule[q].weight);
    bernstein_basis(degree, rule[q].xi, std::span(table.values).subspan(q * n, n));
    derivatives(degree, rule[q].xi, std::span(table.along_2).subspan(q * n, n),
                std::span(table.along_3).subspan(q * n, n));
  }
  for (int q = 0; q < table.points; ++q) {
    const auto b = table.values_at(q), d2 = table.along_2_at(q), d3 = table.along_3_at(q);
    const double w = rule[index(q)].weight;
    const auto add = [n](std::vector<double>& to, const auto& entry) {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) to.push_back(entry(i, j));
    };
    add(table.masses, [&](std::size_t i, std::size_t j) { return w * b[i] * b[j]; });
    add(table.gradients, [&](std::size_t i, std::size_t j) { return w * d2[i] * d2[j]; });
    add(table.gradients, [&](std::size_t i, std::size_t j) { return w * (d2[i] * d3[j] + d3[i] * d2[j]); });
    add(table.gradients, [&](std::size_t i, std::size_t j) { return w * d3[i] * d3[j]; });
  }
  return made;
}

}  // namespace

const ElementTable& element_table(int degree, int exact_degree) {
  constexpr std::size_t rules = greatest_exact_degree + 1;
  static std::array<std::once_flag, (max_degree + 1) * rules> built;
  static std::array<std::unique_ptr<ElementTable>, (max_degree + 1) * rules> tables;
  const std::size_t k = index(degree) * rules + index(exact_degree);
  std::call_once(built[k], [&] { tables[k] = build(degree, exact_degree); });
  return *tables[k];
}

}  // namespace pliant
