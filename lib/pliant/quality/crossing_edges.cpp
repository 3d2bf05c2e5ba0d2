// lib/pliant/quality/crossing_edges.cpp: pairs of edges whose boxes overlap, then a test of each pair.
#include "pliant/quality/crossing_edges.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/curve_contact.h"

namespace pliant {

std::vector<Crossing> find_crossings(const EdgeCurves& edges, std::size_t most) {
  std::vector<Box> boxes(edges.ends.size());
  for (std::size_t e = 0; e < boxes.size(); ++e)
    for (const Point& p : edges.polygon(e)) boxes[e].extend(p);
  const auto curve = [&edges](std::size_t e) {
    return ContactCurve{edges.polygon(e), edges.ends[e].first, edges.ends[e].second};
  };
  std::vector<Crossing> crossings;
  visit_overlapping_pairs(boxes, [&](int i, int j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const auto contact = find_contact(curve(a), curve(b));
    if (contact && contact->kind == Contact::Kind::meets) crossings.push_back({a, b, contact->place});
    return crossings.size() < most;
  });
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return std::pair(c.first, c.second); });
  return crossings;
}

}  // namespace pliant
