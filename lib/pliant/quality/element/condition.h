// lib/pliant/quality/element/condition.h: conditions on a report, as in --fail-if 'min(shape) < 0.2'.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pliant/quality/quality_report.h"

namespace pliant {

/// A condition KEY OP NUMBER.
///   KEY  a number in the report (`faults` is the number of faults), or min(METRIC), max(METRIC), mean(METRIC)
///   OP   one of < <= > >= == !=
class Condition {
 public:
  /// Throws      std::invalid_argument, which says what was expected and which names there are
  explicit Condition(const std::string& text);

  const std::string& text() const { return text_; }
  double bound() const { return bound_; }
  /// The value of the key; empty if the report has none (a tangent_jump without knots, a metric without elements).
  std::optional<double> value(const QualityReport& report) const;
  /// True if the value exists and fulfils the condition.
  bool holds(const QualityReport& report) const;

 private:
  enum class Statistic { scalar, min, max, mean };
  std::string text_, key_, operator_;
  Statistic statistic_ = Statistic::scalar;
  double bound_ = 0;
};

}  // namespace pliant
