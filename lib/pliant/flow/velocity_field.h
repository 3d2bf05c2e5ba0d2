// lib/pliant/flow/velocity_field.h: velocities as functions of position and time; flows by name (paper §6.1).
#pragma once
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// The velocity at a position and time. It must be safe to call at any finite position; a result that is not finite
/// stops the pass. Where it has no value at all it throws NoVelocity.
using VelocityField = std::function<Vector(const Point&, double time)>;

/// There is no velocity at a place or time: the text says where, when and why. A step that meets it is not taken.
class NoVelocity : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A closed-form flow of the library: its name, what it is, and its parameters.
struct NamedFlow {
  struct Parameter {
    std::string name;
    double value;  ///< the default
    std::string meaning;
  };
  std::string name;
  std::string description;
  std::vector<Parameter> parameters;
};
/// All of them, in the order in which they are listed.
const std::vector<NamedFlow>& named_flows();

/// The velocity of the flow with this name; parameters that are not given have their defaults.
///
/// Throws      std::invalid_argument for unknown names, listing the known ones, and for values out of range
VelocityField make_flow(const std::string& name, const std::map<std::string, double>& parameters);

}  // namespace pliant
