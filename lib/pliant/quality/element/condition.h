// lib/pliant/quality/element/condition.h: conditions on a report, as in --fail-if 'min(shape) < 0.2'.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pliant/quality/quality_report.h"

namespace pliant {

/// KEY OP NUMBER. KEY: a scalar of the report (`faults` is their number), or min(metric), max(metric), mean(metric).
/// OP: < <= > >= == !=.
class Condition {
 public:
  /// Throws      std::invalid_argument, with what was expected and what names there are
  explicit Condition(const std::string& text);

  const std::string& text() const { return text_; }
  double bound() const { return bound_; }
  /// The value of the key; empty where the report has none (tangent_jump without such knots, metrics of no element).
  std::optional<double> value(const QualityReport& report) const;
  /// A value that does not exist fulfils no condition.
  bool holds(const QualityReport& report) const;

 private:
  enum class Statistic { scalar, min, max, mean };
  std::string text_, key_, operator_;
  Statistic statistic_ = Statistic::scalar;
  double bound_ = 0;
};

}  // namespace pliant
