// tools/evolve/evolve_options.cpp: the options of evolve, read and checked.
#include "evolve/evolve_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "evolve/frame_output.h"
#include "options/numbers.h"
#include "run/exit_status.h"
#include "run/history.h"
#include "run/same_file.h"

namespace pliant {
namespace {

long parse_count(const std::string& option, const std::string& text, long least) {
  long count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count < least)
    throw UsageError(option + ": '" + text + "' is no whole number from " + std::to_string(least) + " on");
  return count;
}

/// The text of a step; a device that never ends is not read to its end.
std::string read_text(const std::string& path) {
  constexpr std::size_t most = 1 << 20;
  if (path == "-") throw UsageError("--step needs a file, not -");
  if (std::filesystem::is_directory(path)) throw std::system_error(EISDIR, std::generic_category(), path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  std::string text(most + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw std::system_error(errno, std::generic_category(), path);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > most) throw UsageError("--step: '" + path + "' is longer than 1 MiB, which no step is");
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw UsageError("--step: '" + path + "' is in UTF-16; save it as UTF-8");
  return text;
}

}  // namespace

std::string word_pair(const std::string& option, double value) {
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return " " + option + " " + std::string(digits, end);
}

std::string EvolveOptions::frame_options() const {
  std::string text;
  if (schedule.every > 0) text += word_pair("--every", static_cast<double>(schedule.every));
  for (const double time : schedule.at) text += word_pair("--at", time);
  if (courant > 0) text += word_pair("--cfl", courant);
  return text;
}

std::string EvolveOptions::end_options() const {
  return (schedule.until ? word_pair("--until", *schedule.until) : "") +
         (steady > 0 ? word_pair("--until-steady", steady) : "");
}

void EvolveCommand::add(CLI::App& app) {
  app.add_option("STEP", step_, "the step, a pipe of tools in quotes: 'advect --flow vortex --dt 0.01 | refine'");
  add_common_options(app, options_.tool, false);
  add_form_option(app, options_.tool);
  app.get_option("--output")->description("write the series to this file, a line a frame");
  app.get_option("--verbose")->description("print a line for each step");
  app.add_option("--step", step_file_, "read the step from this file; then there is no STEP")->type_name("FILE");
  app.add_option("--until", until_, "end at this time; the last step is shortened to meet it")->type_name("T");
  app.add_option("--steps", steps_, "end after so many steps")->type_name("N");
  app.add_option("--every", every_, "write a frame after each N steps")->type_name("N");
  app.add_option("--at", at_, "write frames at these times; a step is cut in two to meet one")->type_name("T,...");
  app.add_option("--frames", options_.frames, "write frames to numbered files, such as out/%05d.json, not to -o")
      ->type_name("PATTERN");
  app.add_option("--cfl", cfl_, "shorten steps to C times what crosses an element at the speed of the velocity field")
      ->type_name("C");
  app.add_option("--until-steady", steady_, "end when the velocity field changes by less than TOL of it in unit time")
      ->type_name("TOL");
  app.add_option("--log", options_.log, "write what each step did to this file, a line of JSON a step")
      ->type_name("FILE");
  app.add_option("--history", options_.history, "the same as a CSV table")->type_name("FILE");
  add_history_flag(app, options_.tool, "--add-history");
  app.add_flag("--resume", options_.resumes, "go on from the last complete frame of the output");
  app.add_flag("--print-pipe", options_.prints_pipe, "print the shell loop that this command equals, and do nothing");
}

void EvolveCommand::read_step(const CLI::App& app) {
  if (app.count("--step") > 0) {
    if (app.count("INPUT") > 0)
      throw UsageError("--step gives the step, and then '" + step_ + "' is one argument too many");
    if (app.count("STEP") > 0) options_.tool.input = step_;
    options_.step_text = read_text(step_file_);
  } else if (app.count("STEP") == 0) {
    throw UsageError("there is no STEP: a pipe of tools in quotes, such as 'advect --flow vortex --dt 0.01 | refine'");
  } else {
    options_.step_text = step_;
  }
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // what some editors begin a file of UTF-8 with
  if (options_.step_text.starts_with(byte_order_mark)) options_.step_text.erase(0, byte_order_mark.size());
}

void EvolveCommand::read_goals(const CLI::App& app) {
  ScheduleOptions& schedule = options_.schedule;
  if (app.count("--until") > 0) schedule.until = parse_number("--until", until_);
  if (app.count("--steps") > 0) schedule.steps = parse_count("--steps", steps_, 0);
  if (app.count("--cfl") > 0) options_.courant = parse_positive("--cfl", cfl_);
  if (app.count("--until-steady") > 0) options_.steady = parse_positive("--until-steady", steady_);
  schedule.even_steps = options_.courant == 0;
  if (!schedule.until && !schedule.steps && options_.steady == 0)
    throw UsageError("where to end is not said: give --until T or --steps N");
}

void EvolveCommand::read_times() {
  ScheduleOptions& schedule = options_.schedule;
  std::istringstream list(at_ + ",");
  for (std::string text; std::getline(list, text, ',');) {
    schedule.at.push_back(parse_number("--at", text));
    if (schedule.until && schedule.at.back() > *schedule.until)
      throw UsageError("--at " + text + " lies beyond --until " + until_);
  }
  std::ranges::sort(schedule.at);
}

void EvolveCommand::read_frames(const CLI::App& app) {
  ScheduleOptions& schedule = options_.schedule;
  if (app.count("--every") > 0 && app.count("--at") > 0) throw UsageError("--every and --at exclude each other");
  if (app.count("--every") > 0) schedule.every = parse_count("--every", every_, 1);
  if (app.count("--at") > 0) read_times();
  if (app.count("--frames") > 0) {
    if (app.count("-o") > 0) throw UsageError("--frames and -o exclude each other: frames go to one of them");
    check_pattern(options_.frames);
  }
  if (options_.resumes && !options_.is_numbered() && options_.tool.output == "-")
    throw UsageError("--resume goes on from the frames of the output: give -o FILE or --frames PATTERN");
  read_logs();
}

void EvolveCommand::read_logs() {
  const std::string standard = "-";
  const std::string step_beside =
      options_.is_numbered() ? beside_numbered(options_.frames, "step") : options_.tool.output + ".step";
  const std::pair<const char*, const std::string*> others[] = {{"--log", &options_.log},
                                                               {"-o", &options_.tool.output},
                                                               {"INPUT", &options_.tool.input},
                                                               {"--step", &step_file_},
                                                               {"the step of -o", &step_beside}};
  for (const auto& [option, path] : {std::pair("--log", &options_.log), std::pair("--history", &options_.history)}) {
    if (path->empty()) continue;
    if (*path == standard) throw UsageError(std::string(option) + " needs a file of its own, not -");
    for (const auto& [other, taken] : others)
      if (taken != path && !taken->empty() && *taken != standard && is_same_file(*path, *taken))
        throw UsageError(std::string(option) + " and " + other + " name the same file, '" + *path +
                         "'; give each one of its own");
  }
}

void EvolveCommand::tell_history(std::vector<std::string>& given) const {
  constexpr std::array<std::string_view, 5> changeable{"--step", "--until", "--steps", "--at", "--until-steady"};
  const std::size_t end = options_.step_text.find_last_not_of(" \t\r\n");  // a file ends with a line end
  std::vector<std::string> told{options_.step_text.substr(0, end + 1)};
  for (std::size_t k = 0; k + 1 < given.size(); k += 2)  // names and values in turn: flags are not told
    if (std::ranges::find(changeable, given[k]) == changeable.end()) told.insert(told.end(), {given[k], given[k + 1]});
  given = std::move(told);
}

EvolveOptions EvolveCommand::read(const CLI::App& app) {
  read_step(app);
  read_goals(app);
  read_frames(app);
  tell_history(options_.tool.given);
  return options_;
}

}  // namespace pliant
