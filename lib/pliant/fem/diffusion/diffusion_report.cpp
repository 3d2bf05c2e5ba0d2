// lib/pliant/fem/diffusion/diffusion_report.cpp: totals, extremes, energy and fluxes of a solution.
#include <algorithm>
#include <cmath>

#include "pliant/fem/diffusion/diffusion.h"
#include "pliant/fem/element_values.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/bernstein_range.h"

namespace pliant {

std::pair<double, double> Diffusion::extremes() const {
  constexpr double width = 1e-6;
  const std::vector<double> values = element_values(mesh_, field_, 0);
  const auto [low, high] = std::ranges::minmax(values);
  const std::size_t n = index(mesh_.net_size());
  double least = values[0], greatest = values[0];
  for (std::size_t k = 0; k < values.size(); k += n) {
    const auto element = std::span(values).subspan(k, n);
    const auto [lower, upper] = std::ranges::minmax(element);  // Bernstein coefficients enclose the values
    if (lower < least) least = std::min(least, enclose_minimum(mesh_.degree(), element, 0, width * (high - low)).lower);
    if (upper > greatest)
      greatest = std::max(greatest, enclose_maximum(mesh_.degree(), element, 0, width * (high - low)).upper);
  }
  return {least, greatest};
}

void Diffusion::report(PassReport& report) const {
  const double area_unit = mesh_.boundary().unit * mesh_.boundary().unit;
  report.add("unknowns", equation_.space().size());
  report.add("solves", static_cast<double>(solves_));
  report.add("iterations", static_cast<double>(iterations_));
  report.add("residual", worst_residual_);

  const std::vector<double> values = element_values(mesh_, field_, 0);
  const std::size_t n = index(mesh_.net_size());
  std::vector<double> amount(n), rate(n), varies(n), totals(mesh_.boundary().faces.size(), 0.0);
  double energy = 0;
  ElementTerms terms(problem_, mesh_);
  const Configuration now{mesh_.points(), mesh_.time};
  for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
    terms.set(now, t);
    const auto element = std::span(values).subspan(index(t) * n, n);
    multiply_pairs(terms.mass(), element, amount);
    // A constant has no energy, but would leave one by rounding: sought is that of what varies in the element.
    for (std::size_t i = 0; i < n; ++i) varies[i] = element[i] - element[0];
    multiply_pairs(terms.diffusion(), varies, rate);
    for (std::size_t i = 0; i < n; ++i) {
      totals[index(mesh_.face(t))] += amount[i];
      energy += 0.5 * rate[i] * varies[i];
    }
  }
  double total = 0;
  for (const double each : totals) total += each;
  report.add("total", area_unit * total);
  for (std::size_t f = 0; f < totals.size(); ++f)
    report.add("total:" + mesh_.boundary().faces[f].name, area_unit * totals[f]);
  report.add("energy", area_unit * energy);
  const auto [least, greatest] = extremes();
  report.add("min", least);
  report.add("max", greatest);
  const auto add_for_curve = [&](const std::string& what, std::size_t c, double value) {
    const std::string& name = mesh_.boundary().curves[c].name;
    const std::string key = what + (name.empty() ? std::to_string(c) : name);
    const auto found = std::ranges::find(report.values, key, &std::pair<std::string, double>::first);
    if (found != report.values.end())  // curves of one name count together
      found->second += area_unit * value;
    else
      report.add(key, area_unit * value);
  };
  for (std::size_t c = 0; c < curve_totals_.fluxes.size(); ++c) add_for_curve("flux:", c, curve_totals_.fluxes[c]);
  for (std::size_t c = 0; c < curve_totals_.freed.size(); ++c) {
    const Curve& curve = mesh_.boundary().curves[c];
    const int condition = problem_.condition_of_curve[c];
    if (condition != none && problem_.conditions[index(condition)].kind != DiffusionCondition::Kind::jump &&
        curve.left != outside && curve.right != outside && curve.left != curve.right)
      add_for_curve("freed:", c, curve_totals_.freed[c]);
  }
}

}  // namespace pliant
