// formats/svg_import/notices.cpp: one sentence for each kind of thing that a drawing has and Pliant does not read.
#include "formats/svg_import/notices.h"

#include <algorithm>

namespace pliant::svg {

namespace {
constexpr std::size_t most_kinds = 40;
}

void Notices::add(const std::string& what, const Element& element, long times) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.what == what; });
  if (found != entries_.end())
    found->times += times;
  else if (entries_.size() < most_kinds)
    entries_.push_back({what, element.line > 0 ? "line " + std::to_string(element.line) : "", times});
  else
    others_ += times;
}

void Notices::add(const std::string& what, long times) { add(what, Element{}, times); }

std::vector<std::string> Notices::sentences() const {
  std::vector<std::string> out;
  for (const Entry& e : entries_) {
    std::string text = e.what;
    if (e.times > 1)
      text += " (" + std::to_string(e.times) + " times" + (e.first.empty() ? "" : ", first at " + e.first) + ")";
    else if (!e.first.empty())
      text += " (" + e.first + ")";
    out.push_back(std::move(text));
  }
  if (others_ > 0) out.push_back("other things are not read (" + std::to_string(others_) + " times)");
  return out;
}

}  // namespace pliant::svg
