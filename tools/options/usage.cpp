// tools/options/usage.cpp: what is wrong with a command line, and what may have been meant.
#include "options/usage.h"

#include <CLI/CLI.hpp>

#include "formats/document/recognize.h"

namespace pliant {

std::string explain_usage(const CLI::App& app, const std::string& complaint) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const std::string& argument : app.remaining()) {
    if (argument.size() < 2 || argument.front() != '-')
      return "one INPUT is read; '" + argument + "' is one argument too many";
    const std::string option = argument.substr(0, argument.find('='));
    std::string text = "there is no option " + option;
    if (const std::string nearest = nearest_word(option, names); !nearest.empty())
      text += "; the nearest one is " + nearest;
    return text;
  }
  return complaint;
}

}  // namespace pliant
