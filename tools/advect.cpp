// tools/advect.cpp: carries meshes along in a flow by one step.
#include "pliant/flow/advect.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>

#include "criteria_options.h"
#include "expression.h"
#include "field_option.h"
#include "filter.h"

namespace {

using namespace pliant;

/// Two times closer than this part of the step are the same: a sum of steps misses a round time by a few bits.
constexpr double same_time = 1e-9;

std::string list_flows() {
  std::ostringstream text;
  text << "Flows for --flow NAME[:KEY=VALUE,...]; a key that is not given has the value shown.\n";
  for (const NamedFlow& flow : named_flows()) {
    text << '\n' << flow.name << "\n  " << flow.description << '\n';
    for (const NamedFlow::Parameter& parameter : flow.parameters)
      text << "    " << parameter.name << '=' << parameter.value << "  " << parameter.meaning << '\n';
  }
  return text.str();
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

struct VelocityOptions {
  std::string vx, vy, flow, field;
  VelocityField velocity;  ///< empty with --velocity-field

  void add(CLI::App& app) {
    app.add_option("--vx", vx, "velocity along x: an expression in x, y, t")->type_name("EXPR");
    app.add_option("--vy", vy, "velocity along y: an expression in x, y, t")->type_name("EXPR");
    app.add_option("--flow", flow, "a named flow; \"help\" lists them")->type_name("NAME[:KEY=VALUE,...]");
    app.add_option("--velocity-field", field, "a field of two components that the mesh carries")->type_name("NAME");
  }

  void check(const CLI::App& app) {
    const bool x = app.count("--vx") > 0;
    const bool y = app.count("--vy") > 0;
    if (x != y) throw UsageError("--vx and --vy go together");
    if (x + (app.count("--flow") > 0) + (app.count("--velocity-field") > 0) != 1)
      throw UsageError("exactly one of --vx with --vy, --flow and --velocity-field is wanted");
    if (x) {
      velocity = [u = parse_component("--vx", vx), v = parse_component("--vy", vy)](const Point& place, double time) {
        return Vector{u(place.x, place.y, time), v(place.x, place.y, time)};
      };
    } else if (app.count("--flow") > 0) {
      velocity = parse_flow(flow);
    }
  }

  /// The index of the field that --velocity-field names.
  int find(const Mesh& mesh) const {
    const auto named = std::ranges::find(mesh.fields(), field, &Field::name);
    if (named == mesh.fields().end()) {
      std::string others;
      for (const Field& other : mesh.fields())
        others += (others.empty() ? "; there is \"" : ", \"") + other.name + "\"";
      throw InputError("/fields", "there is no field \"" + field + "\"" + others);
    }
    const std::string place = "/fields/" + std::to_string(named - mesh.fields().begin());
    if (named->components != 2)
      throw InputError(place + "/components", "a velocity has 2 components, not " + std::to_string(named->components));
    if (named->by_face) throw InputError(place + "/by_face", "a velocity must be continuous, not by face");
    return static_cast<int>(named - mesh.fields().begin());
  }
};

/// Why no step was taken, in words.
std::string explain(const AdvectOutcome& outcome, double dt) {
  using Status = AdvectOutcome::Status;
  std::ostringstream text;
  text.precision(6);
  const std::string note = outcome.report.notes.empty() ? "" : outcome.report.notes.front();
  if (outcome.status == Status::unsafe)
    text << "a step of " << dt << " is not proved safe beyond " << outcome.fraction << " of it (dt "
         << outcome.fraction * dt << "): " << note << "; --limit takes a safe part of it";
  else
    text << "no step was taken: " << note;
  return text.str();
}

/// The time that a step led to, without the rounding errors that steps of a round length pile up: 100 steps of 0.05
/// from 0 end at 5. It is the nearest number of at most 12 digits, if that is the same time.
double round_time(double time, double dt) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.12g", time);
  const double round = std::strtod(digits, nullptr);
  constexpr double few_bits = 4 * std::numeric_limits<double>::epsilon();
  const double allowed = std::min(same_time * dt, few_bits * std::max(std::abs(time), dt));
  return std::abs(round - time) <= allowed ? round : time;
}

/// A loop until some time would never end.
void require_progress(double before, double after) {
  if (after > before) return;
  const double next = std::nextafter(before, std::numeric_limits<double>::infinity()) - before;
  std::ostringstream text;
  text.precision(17);
  text << "the step does not advance the time " << before;
  text.precision(3);
  text << ": the next number is " << next << " later, so that --dt must be at least that; or let the time begin at 0";
  throw NoResult(text.str());
}

struct StepOptions {
  AdvectOptions advect;
  double dt = 0;
  std::optional<double> until;

  void add(CLI::App& app) {
    app.add_option("--dt", dt_text_, "the time step")->type_name("DT");
    app.add_option("--until", until_text_, "step by min(DT, T - time); a mesh at T or later passes through")
        ->type_name("T");
    app.add_option("--substeps", advect.substeps, "Runge-Kutta steps within DT")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    app.add_flag("--limit", limit_, "where the step is unsafe, take a shorter one that is safe");
    app.add_flag("--force", force_, "take the step also if it inverts elements");
    app.add_flag("--keep-area", advect.keep_area, "keep the area inside each closed curve, by one normal offset");
  }

  void check(const CLI::App& app) {
    if (limit_ && force_) throw UsageError("--limit and --force exclude each other");
    if (app.count("--dt") == 0) throw UsageError("--dt is required");
    dt = parse_positive("--dt", dt_text_);
    if (app.count("--until") > 0) until = parse_number("--until", until_text_);
    advect.policy = limit_ ? StepPolicy::limit : force_ ? StepPolicy::force : StepPolicy::refuse;
  }

 private:
  std::string dt_text_, until_text_;
  bool limit_ = false, force_ = false;
};

/// What is reported of a mesh that is late enough already.
PassReport report_no_step(const Mesh& mesh) {
  PassReport passed;
  passed.add("dt", 0);
  passed.add("time", mesh.time);
  return passed;
}

/// Takes the step, or no step where the mesh is late enough already.
PassReport take_step(Mesh& mesh, const StepOptions& step, const VelocityOptions& flow, const ToolOptions& tool) {
  AdvectOptions options = step.advect;
  options.dt = step.dt;
  const double before = mesh.time;
  bool reaches = false;  // the time at which to stop
  if (step.until) {
    const double left = *step.until - before;
    if (!(left > 0)) return report_no_step(mesh);
    reaches = left <= step.dt * (1 + same_time);
    if (reaches) options.dt = left;
  }
  require_progress(before, reaches ? *step.until : before + options.dt);
  const double unit = mesh.boundary().unit;
  const VelocityField in_unit = [&flow, unit](const Point& place, double time) {
    return flow.velocity(unit * place, time) / unit;
  };
  AdvectOutcome outcome = flow.velocity ? advect(mesh, unit == 1 ? flow.velocity : in_unit, options)
                                        : advect_by_field(mesh, flow.find(mesh), options);
  using Status = AdvectOutcome::Status;
  if (outcome.status != Status::done && outcome.status != Status::limited) throw NoResult(explain(outcome, options.dt));
  if (options.policy == StepPolicy::force && outcome.blocking != none)
    say(tool, "forced an unsafe step: " + outcome.report.notes.back());
  require_progress(before, mesh.time);
  if (outcome.status == Status::done) mesh.time = reaches ? *step.until : round_time(mesh.time, options.dt);
  for (auto& [name, value] : outcome.report.values)
    if (name == "time") value = mesh.time;
  return outcome.report;
}

/// --flow help wants no input and no other option, as --help.
bool asks_for_flows(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--flow=help" || (argument == "--flow" && i + 1 < argc && std::string(argv[i + 1]) == "help"))
      return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Carry a mesh along in a flow by one step, certified: no element is inverted on the way.", "advect"};
  VelocityOptions flow;
  StepOptions step;
  FieldOption fields;
  flow.add(app);
  step.add(app);
  fields.add(app);
  if (asks_for_flows(argc, argv)) {
    std::fputs(list_flows().c_str(), stdout);
    return status::done;
  }
  FilterOptions filter;
  ToolOptions tool;
  filter.prepare = [&](const ToolOptions& parsed) {
    tool = parsed;
    step.check(app);
    flow.check(app);
    fields.check();
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        fields.apply(mesh);
        return take_step(mesh, step, flow, tool);
      },
      filter);
}
