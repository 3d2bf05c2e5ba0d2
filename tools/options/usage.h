// tools/options/usage.h: what is wrong with a command line, and what may have been meant.
#pragma once
#include <string>

namespace CLI {
class App;
}

namespace pliant {

/// What is wrong with the arguments that the parser did not take, and the nearest option there is; `complaint` is what
/// the parser says, for all other faults.
std::string explain_usage(const CLI::App& app, const std::string& complaint);

}  // namespace pliant
