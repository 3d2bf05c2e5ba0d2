// lib/pliant/flow/velocity_field.h: velocities as functions of place and time (paper §6.1).
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Velocity at a place and time. It must be safe to call with any finite place; a non-finite result stops the pass.
using VelocityField = std::function<Vector(const Point&, double time)>;

/// One flow of the library: name, what it is, its parameters with defaults and meanings.
struct NamedFlow {
  struct Parameter {
    std::string name;
    double value;
    std::string meaning;
  };
  std::string name;
  std::string description;
  std::vector<Parameter> parameters;
};
const std::vector<NamedFlow>& named_flows();

/// The flow of that name; parameters not given take their defaults.
/// Throws      std::invalid_argument, naming the flow or parameter and what there is
VelocityField make_flow(const std::string& name, const std::map<std::string, double>& parameters);

}  // namespace pliant
