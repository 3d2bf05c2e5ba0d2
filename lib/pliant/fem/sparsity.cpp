// lib/pliant/fem/sparsity.cpp: rows gathered from the groups around each unknown.
#include "pliant/fem/sparsity.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Where each unknown occurs among the members of one kind of groups: members' indices, unknown after unknown.
struct Occurrences {
  std::vector<int> starts, at;

  Occurrences(int unknowns, const Groups& groups) : starts(index(unknowns) + 1, 0), at(groups.members.size()) {
    for (const int unknown : groups.members) ++starts[index(unknown) + 1];
    for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
    std::vector<int> next(starts.begin(), starts.end() - 1);
    for (std::size_t k = 0; k < groups.members.size(); ++k)
      at[index(next[index(groups.members[k])]++)] = static_cast<int>(k);
  }
};

}  // namespace

Sparsity make_sparsity(int unknowns, std::span<const Groups> kinds) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  std::vector<Occurrences> occurrences;
  Sparsity sparsity;
  for (const Groups& groups : kinds) {
    if (groups.members.size() > most)
      throw std::length_error("there are more unknowns of elements than can be numbered");
    occurrences.emplace_back(unknowns, groups);
    sparsity.places.emplace_back(groups.members.size() * index(groups.size));
  }
  auto pattern = std::make_shared<CsrPattern>();
  pattern->starts.reserve(index(unknowns) + 1);
  std::vector<int> place(index(unknowns), -1);  // of each column in the row at hand
  std::vector<int> row;
  for (int i = 0; i < unknowns; ++i) {
    row.clear();
    const auto for_each_group = [&](const auto& act) {
      for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        const Occurrences& here = occurrences[kind];
        for (int k = here.starts[index(i)]; k < here.starts[index(i) + 1]; ++k)
          act(kind, index(here.at[index(k)]), index(kinds[kind].size));
      }
    };
    for_each_group([&](std::size_t kind, std::size_t member, std::size_t size) {
      for (const int column : kinds[kind].members.subspan(member - member % size, size))
        if (place[index(column)] < 0) {
          place[index(column)] = 0;
          row.push_back(column);
        }
    });
    std::ranges::sort(row);
    if (pattern->columns.size() + row.size() > most) throw std::length_error("the matrix has more than 2^31 entries");
    for (const int column : row) {
      place[index(column)] = static_cast<int>(pattern->columns.size());
      pattern->columns.push_back(column);
    }
    pattern->starts.push_back(static_cast<int>(pattern->columns.size()));
    for_each_group([&](std::size_t kind, std::size_t member, std::size_t size) {
      const std::size_t first = member - member % size;
      int* to = sparsity.places[kind].data() + member * size;
      for (const int column : kinds[kind].members.subspan(first, size)) *to++ = place[index(column)];
    });
    for (const int column : row) place[index(column)] = -1;
  }
  sparsity.pattern = std::move(pattern);
  return sparsity;
}

}  // namespace pliant
