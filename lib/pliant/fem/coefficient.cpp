// lib/pliant/fem/coefficient.cpp: what is said of values that no equation can use.
#include "pliant/fem/coefficient.h"

#include <cmath>
#include <sstream>

#include "pliant/boundary/fault.h"
#include "pliant/geometry/describe.h"

namespace pliant {

void refuse_value(const Coefficient& coefficient, double value, const Point& place, double time, const char* what) {
  const std::string& name = coefficient.name();
  const std::size_t colon = name.starts_with('/') ? name.find(": ") : std::string::npos;
  const std::string pointer = colon == std::string::npos ? "/problem" : name.substr(0, colon);
  std::ostringstream text;
  text << (colon == std::string::npos ? name : name.substr(colon + 2)) << " is "
       << describe_number(std::isnan(value) ? std::abs(value) : value) << " at " << describe_point(place)
       << " and time " << describe_number(time) << "; it must be " << what;  // a nan has no sign to be told
  throw InputError(pointer, text.str());
}

double evaluate_at(const Coefficient& coefficient, const CoefficientPoint& at) {
  const double value = coefficient(at);
  if (!std::isfinite(value)) refuse_value(coefficient, value, at.place, at.time, "a finite number");
  return value;
}

}  // namespace pliant
