// tools/options/triangle_limit.h: --max-triangles, and a warning of meshes that will be large.
#pragma once
#include <functional>
#include <string>

#include "pliant/improve/sizing.h"

namespace CLI {
class App;
}

namespace pliant {

/// --max-triangles N: more are no result.
void add_max_triangles(CLI::App& app, long& most);

/// Says beforehand that thin gaps ask for very many triangles, where, and what leaves them.
void warn_of_thin_gaps(const Mesh& mesh, const QualityGoals& goals, const std::function<void(const std::string&)>& say);

}  // namespace pliant
