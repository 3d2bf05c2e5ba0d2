// formats/svg_import/notices.h: one sentence for each kind of thing that a drawing has and Pliant does not read.
#pragma once
#include <string>
#include <vector>

#include "formats/svg_import/element_tree.h"

namespace pliant::svg {

class Notices {
 public:
  /// Counts one occurrence of `what`, seen in `element`.
  void add(const std::string& what, const Element& element, long times = 1);
  void add(const std::string& what, long times);
  /// Sentences such as "text is not read: 3 times, first at line 12", in the order of first occurrence.
  std::vector<std::string> sentences() const;

 private:
  struct Entry {
    std::string what, first;
    long times;
  };
  std::vector<Entry> entries_;
  long others_ = 0;  ///< kinds beyond most_kinds, counted only, so that a hostile file does not make a page of them
};

}  // namespace pliant::svg
