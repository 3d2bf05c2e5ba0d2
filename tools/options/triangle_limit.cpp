// tools/options/triangle_limit.cpp: --max-triangles, and a warning of meshes that will be large.
#include "options/triangle_limit.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "pliant/geometry/describe.h"
#include "pliant/improve/thin_gaps.h"

namespace pliant {

void add_max_triangles(CLI::App& app, long& most) {
  app.add_option("--max-triangles", most, "stop, without a result, where a mesh would have more than N triangles")
      ->type_name("N")
      ->check(CLI::Range(1L, 2000000000L).description(""))
      ->capture_default_str();
}

void warn_of_thin_gaps(const Mesh& mesh, const QualityGoals& goals,
                       const std::function<void(const std::string&)>& say) {
  constexpr double many = 100'000;
  const ThinGaps gaps = find_thin_gaps(mesh, goals);
  if (gaps.triangles < many) return;
  say("filling thin gaps takes some " + describe_number(std::round(gaps.triangles / 1000) * 1000) +
      " triangles, most of them near " + describe_point(mesh.boundary().unit * gaps.thinnest) +
      "; --thin keep leaves such gaps in few long ones");
}

}  // namespace pliant
