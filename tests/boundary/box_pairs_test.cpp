// tests/boundary/box_pairs_test.cpp: overlapping boxes are those that a comparison of all with all finds.
#include "pliant/boundary/box_pairs.h"

#include <catch2/catch.hpp>
#include <random>

using namespace pliant;

TEST_CASE("overlapping pairs of boxes are those that a comparison of all with all finds", "[boundary][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0, 1), extent(0, seed % 2 == 0 ? 0.05 : 0.4);
  std::vector<Box> boxes(seed == 0 ? 0 : 10 + 30 * seed);
  for (Box& box : boxes) {
    const Point low = seed % 3 == 0 ? Point{std::floor(10 * place(random)), 1} : Point{place(random), place(random)};
    box.extend(low);
    box.extend(low + Point{extent(random), extent(random)});
  }
  std::vector<std::array<int, 2>> expected;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
      if (boxes[static_cast<std::size_t>(i)].overlaps(boxes[static_cast<std::size_t>(j)])) expected.push_back({i, j});
  CHECK(overlapping_pairs(boxes) == expected);
}
