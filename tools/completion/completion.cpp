// tools/completion/completion.cpp: what the options of a tool take, read from their definitions.
#include "completion/completion.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>

#include "completion/value_type.h"

namespace pliant {
namespace {

/// What the files of an option are called; an option that is not here takes any file.
const std::map<std::string, std::vector<std::string>>& usual_extensions() {
  static const std::map<std::string, std::vector<std::string>> table{
      {"--problem", {"json", "cbor"}},
      {"--report", {"jsonl"}},
      {"--log", {"jsonl"}},
      {"--csv", {"csv"}},
      {"--lines-csv", {"csv"}},
      {"--history", {"csv"}},
      {"--svg", {"svg"}},
      {"--flow", {"json", "jsonl", "cbor", "gz", "zst"}}};
  return table;
}

std::vector<std::string> input_extensions(const std::string& tool) {
  if (tool == "import-svg") return {"svg", "svgz"};
  if (tool == "import-msh") return {"msh", "gz", "zst"};
  return {"json", "jsonl", "cbor", "msh", "gz", "zst"};
}

}  // namespace

void fill_in(std::string& script, const std::string& place, const std::string& with) {
  for (std::size_t at = script.find(place); at != std::string::npos; at = script.find(place, at + with.size()))
    script.replace(at, place.size(), with);
}

std::vector<const CLI::Option*> shown_options(const CLI::App& app) {
  std::vector<const CLI::Option*> shown;
  const auto add = [&shown](const CLI::App& from, bool whole) {
    for (const CLI::Option* option : from.get_options())
      if (!option->get_positional() && !option->get_group().empty() && (whole || option != from.get_help_ptr()))
        shown.push_back(option);
  };
  add(app, true);
  // Groups of options are subcommands without a name, each with a --help of its own.
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    if (group->get_name().empty()) add(*group, false);
  return shown;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

bool is_repeatable(const CLI::Option& option) {
  return option.get_expected_max() > 1 || option.get_multi_option_policy() != CLI::MultiOptionPolicy::Throw;
}

ValueForm form_of(const CLI::App& app, const CLI::Option& option) {
  ValueForm form;
  if (option.get_positional()) {
    form.is_file = option.get_name() == "INPUT";
    if (form.is_file) form.extensions = input_extensions(app.get_name());
    return form;
  }
  for (const ValueType& each : value_types(option.get_type_name())) {
    if (each.word == "FILE" || each.word == "PATTERN")
      form.is_file = true;
    else if (each.word.empty() && !each.literal.empty())
      form.choices.push_back(each.literal);
    else if (is_name_word(each.word))
      form.has_names = true;
  }
  if (form.is_file)
    for (const std::string& name : names_of(option))
      if (const auto found = usual_extensions().find(name); found != usual_extensions().end())
        form.extensions = found->second;
  return form;
}

void add_completion(CLI::App& app) {
  app.add_option_function<std::string>(
         "--completion",
         [&app](const std::string& shell) {
           const std::string script = shell == "bash" ? bash_completion(app) : zsh_completion(app);
           throw CLI::CallForVersion(script.substr(0, script.size() - 1), 0);  // which prints it and ends the line
         },
         "print the script that completes this tool's options in a shell, and exit")
      ->type_name("bash|zsh")
      ->check(CLI::IsMember({"bash", "zsh"}).description(""));
}

bool answer_completion(const CLI::App& app, int argc, char** argv) {
  if (argc < 4 || std::string(argv[1]) != "--complete-value") return false;
  alarm(2);  // somebody waits for it, with a finger on the Tab key
  const std::string answer = value_candidates(app, std::vector<std::string>(argv + 2, argv + argc));
  std::fwrite(answer.data(), 1, answer.size(), stdout);
  std::fflush(stdout);
  return true;
}

}  // namespace pliant
