// tests/documents/shape.cpp: reads JSON and CBOR for what they are made of; what is no document is for others to
// refuse.
#include "shape.h"

#include <unordered_map>

namespace {

// The kinds of values. A path at which some numbers are integers and others fractions is one of fractions.
constexpr unsigned count = 1, integer = 3, fraction = 7, text_value = 8, truth = 16, null = 32, object = 64,
                   empty = 128;
constexpr int deepest = 200;

constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
  return hash ^ hash >> 29;
}

class Marks {
 public:
  void add(std::uint64_t path, unsigned kinds) { kinds_[path] |= kinds; }
  void add_array(std::uint64_t path, std::uint64_t length) { add(path, empty << (length < 3 ? length : 3)); }
  std::uint64_t hash() const {
    std::uint64_t sum = 0;
    for (const auto& [path, kinds] : kinds_) sum += mixed(mixed(path, kinds), 1);
    return sum;
  }
  static std::uint64_t member(std::uint64_t path, std::string_view name) {
    path = mixed(path, 2);
    for (const char c : name) path = mixed(path, static_cast<unsigned char>(c));
    return path;
  }
  static std::uint64_t item(std::uint64_t path) { return mixed(path, 3); }

 private:
  std::unordered_map<std::uint64_t, unsigned> kinds_;
};

/// Both readers: `value` returns false where the text ends, or cannot be read on.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}
  Shape shape(bool is_whole) const { return {marks_.hash(), is_whole ? at_ : 0}; }

 protected:
  bool at_end() const { return at_ >= text_.size(); }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Marks marks_;
};

class JsonReader : public Reader {
 public:
  using Reader::Reader;

  bool value(std::uint64_t path) {
    skip_space();
    if (at_end()) return false;
    switch (text_[at_]) {
      case '{':
        return container(path, '}');
      case '[':
        return container(path, ']');
      case '"':
        return marks_.add(path, text_value), string();
      case 't':
        return marks_.add(path, truth), word(4);
      case 'f':
        return marks_.add(path, truth), word(5);
      case 'n':
        return marks_.add(path, null), word(4);
      default:
        return number(path);
    }
  }

 private:
  void skip_space() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n')) ++at_;
  }

  bool word(std::size_t size) { return (at_ += size) <= text_.size(); }

  bool string() {
    for (++at_; !at_end(); ++at_) {
      if (text_[at_] == '"') return ++at_, true;
      if (text_[at_] == '\\') ++at_;
    }
    return false;
  }

  bool number(std::uint64_t path) {
    const std::size_t begin = at_;
    unsigned kind = count;
    for (; !at_end(); ++at_) {
      const char c = text_[at_];
      if (c == '.' || c == 'e' || c == 'E')
        kind = fraction;
      else if (c == '-')
        kind |= integer;
      else if (c != '+' && (c < '0' || c > '9'))
        break;
    }
    marks_.add(path, kind);
    return at_ > begin;
  }

  bool container(std::uint64_t path, char close) {
    if (++depth_ > deepest) return false;
    std::uint64_t length = 0;
    for (++at_;; ++length) {
      skip_space();
      if (!at_end() && text_[at_] == ',' && length > 0) ++at_, skip_space();
      if (at_end()) return false;
      if (text_[at_] == close) break;
      std::uint64_t inner = Marks::item(path);
      if (close == '}') {
        const std::size_t begin = at_;
        if (text_[at_] != '"' || !string()) return false;
        inner = Marks::member(path, text_.substr(begin, at_ - begin));
        skip_space();
        if (at_end() || text_[at_++] != ':') return false;
      }
      if (!value(inner)) return false;
    }
    ++at_;
    --depth_;
    if (close == '}')
      marks_.add(path, object);
    else
      marks_.add_array(path, length);
    return true;
  }
};

class CborReader : public Reader {
 public:
  using Reader::Reader;

  bool value(std::uint64_t path) {
    std::uint64_t argument = 0;
    const int major = head(argument);
    switch (major) {
      case 0:
        return marks_.add(path, count), true;
      case 1:
        return marks_.add(path, integer), true;
      case 2:
      case 3:
        return marks_.add(path, text_value), skip(argument);
      case 4:
      case 5:
        return container(path, argument, major == 5);
      case 6:
        return tagged(path, argument);
      case 7:
        return marks_.add(path, low_ >= 25 ? fraction : low_ >= 22 ? null : truth), true;
      default:
        return false;
    }
  }

 private:
  /// The major type, and its argument; -1 at the end, and where lengths are not given, which the tools do not write.
  int head(std::uint64_t& argument) {
    if (at_end()) return -1;
    const auto first = static_cast<unsigned char>(text_[at_++]);
    low_ = first & 31;
    argument = static_cast<std::uint64_t>(low_);
    if (low_ >= 28 || text_.size() - at_ < (low_ < 24 ? 0U : 1U << (low_ - 24))) return -1;
    if (low_ >= 24) argument = 0;
    for (int k = low_ < 24 ? 0 : 1 << (low_ - 24); k > 0; --k)
      argument = argument << 8 | static_cast<unsigned char>(text_[at_++]);
    return first >> 5;
  }

  bool skip(std::uint64_t size) {
    if (size > text_.size() - at_) return false;
    at_ += size;
    return true;
  }

  bool container(std::uint64_t path, std::uint64_t length, bool is_map) {
    if (++depth_ > deepest) return false;
    for (std::uint64_t k = 0; k < length; ++k) {
      std::uint64_t inner = Marks::item(path), size = 0;
      if (is_map) {
        if (head(size) != 3) return false;
        const std::size_t begin = at_;
        if (!skip(size)) return false;
        inner = Marks::member(path, text_.substr(begin, size));
      }
      if (!value(inner)) return false;
    }
    --depth_;
    if (is_map)
      marks_.add(path, object);
    else
      marks_.add_array(path, length);
    return true;
  }

  /// Tags 64 to 87 are those of typed arrays: integers without and with a sign, then floating-point numbers.
  bool tagged(std::uint64_t path, std::uint64_t tag) {
    if (tag < 64 || tag > 87) {
      const bool is_whole = ++depth_ <= deepest && value(path);
      --depth_;
      return is_whole;
    }
    std::uint64_t size = 0;
    if (head(size) != 2 || !skip(size)) return false;
    const std::uint64_t width = tag < 80 ? 1U << (tag & 3) : 2U << (tag & 3);
    marks_.add_array(path, size / width);
    if (size > 0) marks_.add(Marks::item(path), tag < 72 ? count : tag < 80 ? integer : fraction);
    return true;
  }

  int low_ = 0;
};

template <typename AnyReader>
Shape shape_by(std::string_view text) {
  AnyReader reader(text);
  const bool is_whole = reader.value(0);
  return reader.shape(is_whole);
}

}  // namespace

Shape shape_of_json(std::string_view text) { return shape_by<JsonReader>(text); }
Shape shape_of_cbor(std::string_view text) { return shape_by<CborReader>(text); }
