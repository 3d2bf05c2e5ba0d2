// tools/options/refit_option.cpp: --projection, the same in every tool that refits fields.
#include "options/refit_option.h"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace pliant {

void add_projection_option(CLI::App& app, RefitOptions& options) {
  const std::map<std::string, Projection> names{
      {"l2", Projection::l2}, {"conservative", Projection::conservative}, {"limited", Projection::limited}};
  app.add_option_function<std::string>(
         "--projection", [&options, names](const std::string& name) { options.projection = names.at(name); },
         "how fields are refitted: least squares, with the integral kept, or limited as well (default)")
      ->type_name("l2|conservative|limited")
      ->check(CLI::IsMember({"l2", "conservative", "limited"}).description(""));
}

}  // namespace pliant
