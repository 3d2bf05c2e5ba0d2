// lib/pliant/quality/duplicates.cpp: finds equal points by a hash table with open addressing.
#include "pliant/quality/duplicates.h"

#include <bit>
#include <cstddef>
#include <vector>

namespace pliant {
namespace {

/// Mixes all bits of both coordinates. Adding 0.0 turns -0.0 into 0.0, so that the two have one hash.
std::uint64_t hash(const Point& p) {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x + 0.0) * 0x9e3779b97f4a7c15U;
  h = (h ^ (h >> 32) ^ std::bit_cast<std::uint64_t>(p.y + 0.0)) * 0xd6e8feb86659fd93U;
  h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93U;
  return h ^ (h >> 32);
}

}  // namespace

std::int64_t count_duplicates(std::span<const Point> points, std::span<const char> use, char wanted) {
  std::size_t count = 0;
  for (const char u : use) count += u == wanted ? 1 : 0;
  const std::size_t mask = std::bit_ceil(2 * count + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1);  // 1 + the number of a point, or 0 for an empty slot
  std::int64_t duplicates = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (use[p] != wanted) continue;
    std::size_t place = hash(points[p]) & mask;
    while (table[place] != 0 && points[table[place] - 1] != points[p]) place = (place + 1) & mask;
    if (table[place] != 0)
      ++duplicates;
    else
      table[place] = static_cast<std::uint32_t>(p) + 1;
  }
  return duplicates;
}

}  // namespace pliant
