// tools/options/refit_option.h: --projection, the same in every tool that refits fields.
#pragma once
#include "pliant/ops/refit_options.h"

namespace CLI {
class App;
}

namespace pliant {

/// Adds --projection l2|conservative|limited.
void add_projection_option(CLI::App& app, RefitOptions& options);

}  // namespace pliant
