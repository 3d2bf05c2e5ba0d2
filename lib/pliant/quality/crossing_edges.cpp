#include "pliant/quality/crossing_edges.h"  // lib/pliant/quality/crossing_edges.cpp: boxes first, then contacts

#include <cstddef>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/curve_contact.h"

namespace pliant {

std::int64_t count_crossings(const EdgeCurves& edges) {
  std::vector<Box> boxes(edges.ends.size());
  for (std::size_t e = 0; e < boxes.size(); ++e)
    for (const Point& p : edges.polygon(e)) boxes[e].extend(p);
  const auto curve = [&edges](int e) {
    const auto k = static_cast<std::size_t>(e);
    return ContactCurve{edges.polygon(k), edges.ends[k].first, edges.ends[k].second};
  };
  std::int64_t count = 0;
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    const auto contact = find_contact(curve(a), curve(b));
    count += contact && contact->kind == Contact::Kind::meets ? 1 : 0;
  }
  return count;
}

}  // namespace pliant
