// formats/document/cbor/cbor_items.cpp: passes over CBOR items without making values of them.
#include "formats/document/cbor/cbor_items.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "formats/document/characters.h"

namespace pliant {

std::optional<CborHead> read_cbor_head(std::string_view bytes) {
  if (bytes.empty()) return {};
  const auto first = static_cast<unsigned char>(bytes.front());
  CborHead head{first >> 5, first & 31, static_cast<std::uint64_t>(first & 31), 1};
  if (head.info < 24 || head.info > 27) return head;
  const std::size_t more = std::size_t{1} << (head.info - 24);
  if (bytes.size() <= more) return {};
  head.value = 0;
  for (std::size_t k = 1; k <= more; ++k) head.value = head.value << 8 | static_cast<unsigned char>(bytes[k]);
  head.size = 1 + more;
  return head;
}

void CborItemEnd::end_item() {
  while (!left_.empty()) {
    if (left_.back() == no_end || --left_.back() > 0) return;
    left_.pop_back();
  }
  is_done_ = true;
}

void CborItemEnd::take(const CborHead& head) {
  constexpr std::size_t most = 200;  // levels of nesting, far more than readers take
  if (head.is_wrong() || left_.size() > most) {
    is_done_ = true;
  } else if (head.is_break()) {
    if (left_.empty() || left_.back() != no_end) {
      is_done_ = true;
      return;
    }
    left_.pop_back();
    end_item();
  } else if (head.major >= 2 && head.major <= 5 && head.is_indefinite()) {
    left_.push_back(no_end);
  } else if (head.major == 2 || head.major == 3) {
    skip_ = head.value;
    if (skip_ == 0) end_item();
  } else if ((head.major == 4 || head.major == 5) && head.value > 0) {
    constexpr std::uint64_t most_entries = no_end / 4;  // beyond every file
    left_.push_back(std::min(head.value, most_entries) * (head.major == 5 ? 2 : 1));
  } else if (head.major != 6) {
    end_item();
  }
}

void CborItemEnd::pass_string() {
  skip_ = 0;
  end_item();
}

const char* CborItemEnd::scan(const char* first, const char* last) {
  while (first != last && !is_done_) {
    if (skip_ > 0) {
      const std::uint64_t passed = std::min(skip_, static_cast<std::uint64_t>(last - first));
      skip_ -= passed;
      first += passed;
      if (skip_ == 0) end_item();
      continue;
    }
    const auto head = read_cbor_head({first, static_cast<std::size_t>(last - first)});
    if (!head) break;
    first += head->size;
    take(*head);
  }
  return first;
}

namespace {

/// Passes over items; at bytes that end early, or are no CBOR, it stays where it is.
class CborSkimmer {
 public:
  explicit CborSkimmer(std::string_view bytes) : bytes_(bytes) {}
  std::size_t at() const { return at_; }

  /// Goes to the element or member of that name in the value that starts here; false if there is none.
  bool enter(const std::string& name) {
    std::optional<CborHead> head = next_head();
    while (head && head->major == 6) {
      if (is_typed_array(head->value)) return false;  // its numbers are found by who knows their width
      head = next_head();
    }
    if (!head || head->is_wrong()) return false;
    if (head->major == 4) return enter_array(*head, name);
    return head->major == 5 && enter_map(*head, name);
  }

 private:
  std::optional<CborHead> next_head() {
    const auto head = read_cbor_head(bytes_.substr(at_));
    if (head) at_ += head->size;
    return head;
  }
  bool is_at_break() const { return at_ < bytes_.size() && bytes_[at_] == '\xFF'; }
  bool skip_item() {
    CborItemEnd item;
    const char* first = bytes_.data() + at_;
    at_ += static_cast<std::size_t>(item.scan(first, bytes_.data() + bytes_.size()) - first);
    return item.is_done();
  }
  bool enter_array(const CborHead& head, const std::string& name) {
    std::uint64_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc() || end != name.data() + name.size()) return false;
    for (std::uint64_t k = 0; head.is_indefinite() ? !is_at_break() : k < head.value; ++k) {
      if (at_ >= bytes_.size()) return false;
      if (k == index) return true;
      if (!skip_item()) return false;
    }
    return false;
  }
  bool enter_map(const CborHead& head, const std::string& name) {
    for (std::uint64_t k = 0; head.is_indefinite() ? !is_at_break() : k < head.value; ++k) {
      const std::size_t begin = at_;
      const auto key = next_head();
      if (!key || key->major != 3) return false;
      std::string found;
      if (key->is_indefinite()) {
        for (auto chunk = next_head(); chunk && chunk->major == 3; chunk = next_head()) {
          found += bytes_.substr(at_, chunk->value);
          at_ = std::min<std::uint64_t>(bytes_.size(), at_ + std::min<std::uint64_t>(chunk->value, bytes_.size()));
        }
      } else {
        found = bytes_.substr(at_, key->value);
        at_ = begin;
        if (!skip_item()) return false;
      }
      if (found == name) return at_ < bytes_.size();
      if (!skip_item()) return false;
    }
    return false;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::size_t find_cbor_value(std::string_view cbor, std::string_view& pointer) {
  CborSkimmer in(cbor);
  std::size_t found = 0;
  while (!pointer.empty() && pointer.front() == '/') {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    if (!in.enter(unescape_step(pointer.substr(1, end - 1)))) break;
    found = in.at();
    pointer.remove_prefix(end);
  }
  return found;
}

}  // namespace pliant
