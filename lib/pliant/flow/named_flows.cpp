// lib/pliant/flow/named_flows.cpp: closed-form flows by name: their parameters and velocities.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "pliant/flow/velocity_field.h"

namespace pliant {
namespace {

constexpr double pi = std::numbers::pi;

/// The values of all parameters of a flow, by name.
class Values {
 public:
  explicit Values(std::map<std::string, double> values) : values_(std::move(values)) {}
  double operator[](const char* name) const { return values_.at(name); }

 private:
  std::map<std::string, double> values_;
};

/// A flow of the library, and how it is made.
struct Entry {
  NamedFlow flow;
  std::vector<std::string> positive;  ///< parameters that must be greater than 0
  VelocityField (*make)(const Values&);
};

VelocityField make_uniform(const Values& v) {
  const Vector velocity{v["u"], v["v"]};
  return [velocity](const Point&, double) { return velocity; };
}

VelocityField make_shear(const Values& v) {
  return [rate = v["rate"], y0 = v["y"]](const Point& x, double) { return Vector{rate * (x.y - y0), 0}; };
}

VelocityField make_rotation(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, omega = v["omega"]](const Point& x, double) { return omega * perpendicular(x - centre); };
}

VelocityField make_stagnation(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, rate = v["rate"]](const Point& x, double) {
    return Vector{rate * (x.x - centre.x), -rate * (x.y - centre.y)};
  };
}

VelocityField make_rankine(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, strength = v["circulation"] / (2 * pi), core = v["core"]](const Point& x, double) {
    const Vector d = x - centre;
    return strength / std::max(squared_length(d), core * core) * perpendicular(d);
  };
}

VelocityField make_lamb_oseen(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, strength = v["circulation"] / (2 * pi), core = v["core"], nu = v["nu"]](const Point& x, double t) {
    const Vector d = x - centre;
    const double core2 = core * core + 4 * nu * t;
    const double s = squared_length(d) / core2;
    // (1 - exp(-s)) / s, which is 1 at the centre
    const double profile = s > 0 ? -std::expm1(-s) / s : 1;
    return strength * profile / core2 * perpendicular(d);
  };
}

VelocityField make_reversed_vortex(const Values& v) {
  return [speed = v["speed"], period = v["period"]](const Point& x, double t) {
    const double sx = std::sin(pi * x.x);
    const double sy = std::sin(pi * x.y);
    const double now = speed * std::cos(pi * t / period);
    return Vector{-now * sx * sx * std::sin(2 * pi * x.y), now * sy * sy * std::sin(2 * pi * x.x)};
  };
}

VelocityField make_taylor_green(const Values& v) {
  return [speed = v["speed"], k = 2 * pi / v["length"], nu = v["nu"]](const Point& x, double t) {
    const double now = speed * std::exp(-2 * nu * k * k * t);
    return Vector{now * std::sin(k * x.x) * std::cos(k * x.y), -now * std::cos(k * x.x) * std::sin(k * x.y)};
  };
}

VelocityField make_cylinder(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, r2 = v["radius"] * v["radius"], speed = v["speed"], swirl = v["circulation"] / (2 * pi)](
             const Point& x, double) {
    const Vector d = x - centre;
    const double rho2 = squared_length(d);
    if (rho2 < r2) {
      // The stream function inside is u y (rho^2 / r^2 - 1), so that the velocity there is smooth and divergence-free,
      // and continuous across the circle.
      return Vector{speed * ((rho2 + 2 * d.y * d.y) / r2 - 1), -2 * speed * d.x * d.y / r2} +
             swirl / r2 * perpendicular(d);
    }
    const double c = d.x / rho2;
    const double s = d.y / rho2;
    return Vector{speed * (1 - r2 * (c * d.x - s * d.y) / rho2), -2 * speed * r2 * c * s} +
           swirl / rho2 * perpendicular(d);
  };
}

VelocityField make_channel(const Values& v) {
  const double low = v["bottom"];
  const double high = v["top"];
  if (!(high > low)) throw std::invalid_argument("flow channel: top must be greater than bottom");
  return [low, high, speed = v["speed"]](const Point& x, double) {
    const double s = (x.y - low) / (high - low);
    return Vector{s > 0 && s < 1 ? 4 * speed * s * (1 - s) : 0.0, 0};
  };
}

VelocityField make_source(const Values& v) {
  const Point centre{v["x"], v["y"]};
  return [centre, strength = v["rate"] / (2 * pi), core = v["core"]](const Point& x, double) {
    const Vector d = x - centre;
    return strength / std::max(squared_length(d), core * core) * d;
  };
}

/// Flows whose velocity is a linear function of position.
std::vector<Entry> linear_flows() {
  return {
      {{"uniform", "the same velocity everywhere", {{"u", 1, "velocity along x"}, {"v", 0, "velocity along y"}}},
       {},
       make_uniform},
      {{"shear",
        "plane Couette flow: speed along x grows linearly with y",
        {{"rate", 1, "shear rate"}, {"y", 0, "height at rest"}}},
       {},
       make_shear},
      {{"rotation",
        "rigid rotation, counter-clockwise for omega > 0",
        {{"omega", 1, "angular velocity in radians"}, {"x", 0, "centre"}, {"y", 0, "centre"}}},
       {},
       make_rotation},
      {{"stagnation",
        "hyperbolic flow: stretches along x, squeezes along y for rate > 0",
        {{"rate", 1, "strain rate"}, {"x", 0, "stagnation point"}, {"y", 0, "stagnation point"}}},
       {},
       make_stagnation},
  };
}

/// Vortices, alone and in rows.
std::vector<Entry> vortices() {
  return {
      {{"rankine",
        "Rankine vortex: rigid rotation inside the core, potential vortex outside",
        {{"circulation", 1, "counter-clockwise"},
         {"core", 0.1, "radius of the core"},
         {"x", 0, "centre"},
         {"y", 0, "centre"}}},
       {"core"},
       make_rankine},
      {{"lamb-oseen",
        "Lamb-Oseen vortex: a potential vortex whose core spreads by viscosity",
        {{"circulation", 1, "counter-clockwise"},
         {"core", 0.1, "radius of the core at t = 0"},
         {"nu", 0, "kinematic viscosity; the squared radius grows by 4 nu t"},
         {"x", 0, "centre"},
         {"y", 0, "centre"}}},
       {"core"},
       make_lamb_oseen},
      {{"reversed-vortex",
        "the single vortex in the unit square of Rider and Kothe, reversed by cos(pi t / period): everything is back "
        "at t = period; also called vortex",
        {{"period", 8, "time after which everything is back"}, {"speed", 1, "greatest speed"}}},
       {"period"},
       make_reversed_vortex},
      {{"taylor-green",
        "Taylor-Green vortices: u = sin(kx) cos(ky), v = -cos(kx) sin(ky), k = 2 pi / length",
        {{"length", 1, "period in space"},
         {"speed", 1, "greatest speed at t = 0"},
         {"nu", 0, "kinematic viscosity: decay by exp(-2 nu k^2 t)"}}},
       {"length"},
       make_taylor_green},
  };
}

/// Flows along walls, past a body, out of a point.
std::vector<Entry> bounded_flows() {
  return {
      {{"cylinder",
        "potential flow along x past a cylinder; inside the cylinder a closed vortex of the same velocity on the "
        "circle, smooth and free of divergence",
        {{"radius", 1, "of the cylinder"},
         {"speed", 1, "far away"},
         {"x", 0, "centre"},
         {"y", 0, "centre"},
         {"circulation", 0, "counter-clockwise, around the cylinder"}}},
       {"radius"},
       make_cylinder},
      {{"channel",
        "Poiseuille flow along x between two walls, at rest outside",
        {{"speed", 1, "in the middle"},
         {"bottom", 0, "height of the lower wall"},
         {"top", 1, "height of the upper wall"}}},
       {},
       make_channel},
      {{"source",
        "point source (sink for rate < 0): radial, free of divergence outside the core, uniform expansion inside",
        {{"rate", 1, "area per time"}, {"core", 0.1, "radius of the core"}, {"x", 0, "centre"}, {"y", 0, "centre"}}},
       {"core"},
       make_source},
  };
}

/// All flows, in the order in which they are listed.
const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list;
    for (const auto& part : {linear_flows(), vortices(), bounded_flows()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

std::string parameter_names(const NamedFlow& flow) {
  std::string names;
  for (const NamedFlow::Parameter& parameter : flow.parameters) names += (names.empty() ? "" : ", ") + parameter.name;
  return names;
}

}  // namespace

const std::vector<NamedFlow>& named_flows() {
  static const std::vector<NamedFlow> flows = [] {
    std::vector<NamedFlow> list;
    for (const Entry& entry : entries()) list.push_back(entry.flow);
    return list;
  }();
  return flows;
}

VelocityField make_flow(const std::string& called, const std::map<std::string, double>& parameters) {
  const std::string name = called == "vortex" ? "reversed-vortex" : called;
  const auto found = std::ranges::find_if(entries(), [&](const Entry& entry) { return entry.flow.name == name; });
  if (found == entries().end()) {
    std::string names;
    for (const Entry& entry : entries()) names += (names.empty() ? "" : ", ") + entry.flow.name;
    throw std::invalid_argument("there is no flow \"" + name + "\"; there are " + names);
  }
  std::map<std::string, double> values;
  for (const NamedFlow::Parameter& parameter : found->flow.parameters) values[parameter.name] = parameter.value;
  for (const auto& [key, value] : parameters) {
    const auto place = values.find(key);
    if (place == values.end())
      throw std::invalid_argument("flow " + name + " has no parameter \"" + key + "\"; it has " +
                                  parameter_names(found->flow));
    if (!std::isfinite(value)) throw std::invalid_argument("flow " + name + ": " + key + " must be finite");
    place->second = value;
  }
  for (const std::string& key : found->positive)
    if (!(values[key] > 0)) throw std::invalid_argument("flow " + name + ": " + key + " must be greater than 0");
  return found->make(Values(std::move(values)));
}

}  // namespace pliant
