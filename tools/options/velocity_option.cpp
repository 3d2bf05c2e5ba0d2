// tools/options/velocity_option.cpp: the velocity that moves a mesh, from the texts of options.
#include "options/velocity_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "options/expression.h"
#include "options/numbers.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

std::string list_flows() {
  std::ostringstream text;
  text << "Flows for --flow NAME[:KEY=VALUE,...]; a key that is not given has the value shown.\n";
  for (const NamedFlow& flow : named_flows()) {
    text << '\n' << flow.name << "\n  " << flow.description << '\n';
    for (const NamedFlow::Parameter& parameter : flow.parameters)
      text << "    " << parameter.name << '=' << parameter.value << "  " << parameter.meaning << '\n';
  }
  std::string lines = text.str();
  lines.pop_back();  // the end of the last line
  return lines;
}

/// NAME[:KEY=VALUE,...]
VelocityField parse_flow(const std::string& text) {
  const std::size_t colon = text.find(':');
  std::map<std::string, double> parameters;
  if (colon != std::string::npos) {
    for (const std::string& part : split_expressions(text.substr(colon + 1))) {
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos || equals == 0)
        throw UsageError("--flow " + text + ": KEY=VALUE is wanted, not \"" + part + "\"");
      const std::string key = part.substr(0, equals);
      if (!parameters.emplace(key, parse_number("--flow: " + key, part.substr(equals + 1))).second)
        throw UsageError("--flow " + text + ": " + key + " is given twice");
    }
  }
  try {
    return make_flow(text.substr(0, colon), parameters);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--flow: ") + error.what());
  }
}

Expression parse_component(const std::string& option, const std::string& text) {
  try {
    return Expression(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

/// The index of a field of two components; `what` it is, for the error.
int find_vectors(const Mesh& mesh, const std::string& name, const std::string& what) {
  const auto named = std::ranges::find(mesh.fields(), name, &Field::name);
  if (named == mesh.fields().end()) {
    std::string others;
    for (const Field& other : mesh.fields()) others += (others.empty() ? "; there is \"" : ", \"") + other.name + "\"";
    throw InputError("/fields", "there is no field \"" + name + "\"" + others);
  }
  const std::string place = "/fields/" + std::to_string(named - mesh.fields().begin());
  if (named->components != 2)
    throw InputError(place + "/components", what + " has 2 components, not " + std::to_string(named->components));
  if (named->by_face) throw InputError(place + "/by_face", what + " must be continuous, not by face");
  return static_cast<int>(named - mesh.fields().begin());
}

}  // namespace

void VelocityOption::add(CLI::App& app) {
  app.add_option("--vx", vx_, "velocity along x: an expression in x, y, t")->type_name("EXPR");
  app.add_option("--vy", vy_, "velocity along y: an expression in x, y, t")->type_name("EXPR");
  app.add_option_function<std::string>(
         "--flow",
         [this](const std::string& text) {
           flow_ = text;
           if (text == "help") throw CLI::CallForVersion(list_flows(), 0);  // which prints it and ends the line
         },
         "a named flow; \"help\" lists them")
      ->type_name("NAME[:KEY=VALUE,...]");
  app.add_option("--velocity-field", field_, "a field of two components that the mesh carries")->type_name("NAME");
  app.add_option("--acceleration-field", acceleration_,
                 "with --velocity-field: another such field, for a step of second order in time")
      ->type_name("NAME");
}

void VelocityOption::check(const CLI::App& app) {
  const bool x = app.count("--vx") > 0;
  const bool y = app.count("--vy") > 0;
  if (x != y) throw UsageError("--vx and --vy go together");
  if (x + (app.count("--flow") > 0) + (app.count("--velocity-field") > 0) != 1)
    throw UsageError("exactly one of --vx with --vy, --flow and --velocity-field is wanted");
  if (app.count("--acceleration-field") > 0 && app.count("--velocity-field") == 0)
    throw UsageError("--acceleration-field needs --velocity-field");
  if (x) {
    velocity_ = [u = parse_component("--vx", vx_), v = parse_component("--vy", vy_)](const Point& place, double time) {
      return Vector{u(place.x, place.y, time), v(place.x, place.y, time)};
    };
  } else if (app.count("--flow") > 0) {
    velocity_ = parse_flow(flow_);
  }
}

int VelocityOption::find_field(const Mesh& mesh) const { return find_vectors(mesh, field_, "a velocity"); }

int VelocityOption::find_acceleration(const Mesh& mesh) const {
  return acceleration_.empty() ? none : find_vectors(mesh, acceleration_, "an acceleration");
}

}  // namespace pliant
