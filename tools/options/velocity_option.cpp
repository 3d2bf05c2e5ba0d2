// tools/options/velocity_option.cpp: the velocity that moves a mesh, from the texts of options.
#include "options/velocity_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "options/expression.h"
#include "options/flow_file.h"
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
    const std::string name = text.substr(0, colon);
    const bool is_known = std::ranges::find(named_flows(), name, &NamedFlow::name) != named_flows().end();
    throw UsageError(std::string("--flow: ") + error.what() + (is_known ? "" : "; and no file has this name"));
  }
}

/// The options with which the tool reads another file than its input. A step of evolve has no --quiet of its own.
ToolOptions as_input(const CLI::App& app, const std::string& file) {
  ToolOptions options;
  options.tool = app.get_name();
  options.input = file;
  const CLI::Option* const quiet = app.get_option_no_throw("--quiet");
  options.quiet = quiet != nullptr && quiet->count() > 0;
  return options;
}

Expression parse_component(const std::string& option, const std::string& text) {
  try {
    return Expression(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
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
         "a named flow (\"help\" lists them), or the velocity field of another mesh or series of meshes: a FILE "
         "contains \"/\", ends in .json, .jsonl, .cbor, .msh, .gz or .zst, or exists and is no flow's name")
      ->type_name("FLOW[:KEY=VALUE,...]|FILE");
  app.add_option("--flow-field", flow_field_, "with --flow FILE: the name of the field")
      ->type_name("FIELD")
      ->capture_default_str();
  app.add_option("--outside", outside_,
                 "with --flow FILE, outside its mesh or its times: \"error\", or \"nearest\" for the nearest point and "
                 "frame")
      ->type_name("error|nearest")
      ->capture_default_str();
  app.add_option("--velocity-field", field_, "a field of two components that the mesh carries")->type_name("FIELD");
  app.add_option("--acceleration-field", acceleration_,
                 "with --velocity-field: another such field, for a step of second order in time")
      ->type_name("FIELD");
}

bool VelocityOption::is_given(const CLI::App& app) {
  const char* const ways[] = {"--vx", "--vy", "--flow", "--velocity-field"};
  return std::ranges::any_of(ways, [&app](const char* way) { return app.count(way) > 0; });
}

void VelocityOption::check(const CLI::App& app) {
  const bool x = app.count("--vx") > 0;
  const bool y = app.count("--vy") > 0;
  if (x != y) throw UsageError("--vx and --vy go together");
  if (x + (app.count("--flow") > 0) + (app.count("--velocity-field") > 0) != 1)
    throw UsageError("exactly one of --vx with --vy, --flow and --velocity-field is wanted");
  if (app.count("--acceleration-field") > 0 && app.count("--velocity-field") == 0)
    throw UsageError("--acceleration-field needs --velocity-field");
  const bool is_file = app.count("--flow") > 0 && is_flow_file(flow_);
  for (const char* option : {"--flow-field", "--outside"})
    if (app.count(option) > 0 && !is_file) throw UsageError(std::string(option) + " needs --flow with a file");
  if (outside_ != "error" && outside_ != "nearest")
    throw UsageError("--outside: \"error\" or \"nearest\" is wanted, not \"" + outside_ + "\"");
  if (x) {
    velocity_ = [u = parse_component("--vx", vx_), v = parse_component("--vy", vy_)](const Point& place, double time) {
      return Vector{u(place.x, place.y, time), v(place.x, place.y, time)};
    };
  } else if (app.count("--flow") > 0) {
    const MeshFlow::Outside policy = outside_ == "nearest" ? MeshFlow::Outside::nearest : MeshFlow::Outside::refuse;
    velocity_ = is_file ? read_flow(as_input(app, flow_), flow_field_, policy) : parse_flow(flow_);
  }
}

int VelocityOption::find_field(const Mesh& mesh) const { return find_vectors(mesh.fields(), field_, "a velocity"); }

int VelocityOption::find_acceleration(const Mesh& mesh) const {
  return acceleration_.empty() ? none : find_vectors(mesh.fields(), acceleration_, "an acceleration");
}

}  // namespace pliant
