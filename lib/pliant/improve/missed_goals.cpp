// lib/pliant/improve/missed_goals.cpp: one look at each element; the words for what was found.
#include "pliant/improve/missed_goals.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/improve/refine.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/turned_over.h"
#include "pliant/quality/too_curved.h"

namespace pliant {

MissedGoals count_missed(const Mesh& mesh, const QualityGoals& goals) {
  MissedGoals missed;
  const CurvatureTest test(mesh.degree(), {});
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    const bool is_fine = test.is_fine(net);
    if (!is_fine && certify_element(mesh, t) != Validity::valid) {
      ++missed.invalid;
      continue;
    }
    if (is_turned_over(net[0], net[1], net[2])) {
      ++missed.turned_over;
      continue;
    }
    const char* reason = refine_reason(mesh, t, goals);
    if (!is_fine || (reason && reason == std::string_view("too curved")))
      ++missed.too_curved;
    else if (reason)
      ++(reason == std::string_view("too large") ? missed.too_large : missed.too_poor);
  }
  return missed;
}

std::string describe(const MissedGoals& missed) {
  std::string text;
  for (const auto& [count, what] :
       {std::pair{missed.invalid, "not valid"}, std::pair{missed.turned_over, "turned over"},
        std::pair{missed.too_curved, "too curved"}, std::pair{missed.too_large, "too large"},
        std::pair{missed.too_poor, "too poor"}})
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  return text.empty() ? "no element" : text;
}

std::string advice_on(const MissedGoals& missed) {
  if (missed.invalid > 0) return "smoothcurves untangles what is not valid; the other passes take valid meshes only";
  if (missed.turned_over > 0) return "refine cuts and flips what is turned over";
  if (missed.too_large + missed.too_poor > 0)
    return "refine mends what is too large or too poor, as far as the curves let it";
  if (missed.too_curved > 0)
    return "smoothcurves mends what is too curved; where an edge on a curve is the cause, smoothcurves --split or "
           "refine --max-turning";
  return {};
}

}  // namespace pliant
