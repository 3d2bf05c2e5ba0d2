// tools/evolve/step_text.cpp: the text of a step, a pipe of stages, split into words as a shell splits it.
#include "evolve/step_text.h"

#include <algorithm>

#include "run/exit_status.h"

namespace pliant {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// What a shell would do where it finds this character outside quotes, and what to write instead; empty for one that
/// stands for itself.
const char* explain_special(char c) {
  switch (c) {
    case '$':
    case '`':
      return "a step is not run by a shell, so nothing is expanded: write the value, or put the step into \"...\" "
             "where "
             "your shell expands it";
    case ';':
    case '&':
      return "a step is one pipe: its commands are joined by |";
    case '<':
    case '>':
      return "nothing is redirected inside a step: evolve hands the mesh from one command to the next";
    case '(':
    case ')':
    case '{':
    case '}':
      return "commands cannot be grouped; an expression with such a character goes into '...'";
    case '*':
    case '?':
    case '[':
    case ']':
      return "this is a pattern for file names to a shell, and there are no files here; an expression with such a "
             "character "
             "goes into '...'";
    default:
      return nullptr;
  }
}

class StepSplitter {
 public:
  explicit StepSplitter(std::string_view text) : text_(text) {}

  std::vector<StepCommand> split() {
    while (at_ < text_.size()) take_next();
    if (!commands_.back().empty()) return std::move(commands_);
    if (commands_.size() == 1) fail(0, "the step is empty: it wants at least one command, such as flipdelaunay");
    fail(last_bar_, "no command follows this |");
  }

 private:
  [[noreturn]] void fail(std::size_t place, const std::string& what) const {
    throw UsageError("STEP, " + describe_step_place(text_, place) + ": " + what);
  }
  bool is_end() const { return at_ == text_.size(); }
  bool starts_line_end(std::size_t i) const {
    return i < text_.size() && (text_[i] == '\n' || (text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n'));
  }

  /// The carriage return of a line's end, which within quotes is a line feed alone.
  bool is_part_of_line_end(std::size_t i) const { return text_[i] == '\r' && starts_line_end(i); }
  /// A character that quotes have taken its meaning from; none gives a word a zero byte.
  char plain(std::size_t i) const {
    if (text_[i] == '\0') fail(i, "a control character, of code 0");
    return text_[i];
  }

  /// Takes what stands between two words, or one word.
  void take_next() {
    const char c = text_[at_];
    if (is_blank(c)) {
      ++at_;
    } else if (starts_line_end(at_)) {
      end_line();
    } else if (c == '\\' && starts_line_end(at_ + 1)) {
      at_ += text_[at_ + 1] == '\r' ? 3 : 2;  // the command goes on in the next line
    } else if (c == '#') {
      while (!is_end() && !starts_line_end(at_)) ++at_;
    } else if (c == '|') {
      end_command();
    } else {
      take_word();
    }
  }

  /// An empty line, or one that ends with |, is no end of the pipe; after a whole pipe only empty lines may follow.
  void end_line() {
    const std::size_t place = at_;
    at_ += text_[at_] == '\r' ? 2 : 1;
    if (commands_.back().empty()) return;
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at_);
    if (next == std::string_view::npos) {
      at_ = text_.size();
    } else if (text_[next] == '#') {
      at_ = next;
      while (!is_end() && !starts_line_end(at_)) ++at_;
      if (!is_end()) end_line();
    } else {
      fail(place, "a line that ends here ends the pipe, and more follows: end the line with | or with \\ to go on");
    }
  }

  void end_command() {
    if (text_.substr(at_, 2) == "||") fail(at_, "a step is one pipe: its commands are joined by one |");
    if (text_.substr(at_, 2) == "|&") fail(at_, "only standard output goes through a pipe: write |");
    if (commands_.back().empty()) fail(at_, "no command stands before this |");
    last_bar_ = at_++;
    commands_.emplace_back();
  }

  void take_word() {
    StepWord word;
    word.place = at_;
    if (text_[at_] == '~') fail(at_, "~ is not expanded here: write the folder's path");
    if (text_[at_] == '!' && (at_ + 1 == text_.size() || is_blank(text_[at_ + 1])))
      fail(at_, "a step is one pipe, and cannot be negated");
    while (!is_end() && !is_blank(text_[at_]) && text_[at_] != '|' && !starts_line_end(at_)) take_piece(word.text);
    commands_.back().push_back(std::move(word));
  }

  /// A quoted part of a word, or one character of it.
  void take_piece(std::string& word) {
    const char c = text_[at_];
    if (c == '\'') {
      take_literal(word);
    } else if (c == '"') {
      take_quoted(word);
    } else if (c == '\\') {
      take_escaped(word);
    } else if (const char* const reason = explain_special(c)) {
      fail(at_, std::string("'") + c + "': " + reason);
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      fail(at_, "a control character, of code " + std::to_string(static_cast<int>(c)));
    } else {
      word += c;
      ++at_;
    }
  }

  void take_literal(std::string& word) {
    const std::size_t end = text_.find('\'', at_ + 1);
    if (end == std::string_view::npos) fail(at_, "this ' is not closed");
    for (++at_; at_ < end; ++at_)
      if (!is_part_of_line_end(at_)) word += plain(at_);
    at_ = end + 1;
  }

  void take_quoted(std::string& word) {
    const std::size_t start = at_++;
    for (; !is_end() && text_[at_] != '"'; ++at_) {
      const char c = text_[at_];
      if (c == '$' || c == '`') fail(at_, std::string("'") + c + "': " + explain_special(c));
      if (c == '\\' && at_ + 1 < text_.size()) {
        const char next = text_[at_ + 1];
        if (starts_line_end(at_ + 1)) {
          at_ += next == '\r' ? 2 : 1;
          continue;
        }
        if (next == '$' || next == '`' || next == '"' || next == '\\') ++at_;
      }
      if (!is_part_of_line_end(at_)) word += plain(at_);
    }
    if (is_end()) fail(start, "this \" is not closed");
    ++at_;
  }

  void take_escaped(std::string& word) {
    if (at_ + 1 == text_.size()) fail(at_, "a character should follow this \\");
    if (starts_line_end(at_ + 1)) {
      at_ += text_[at_ + 1] == '\r' ? 3 : 2;
      return;
    }
    word += plain(at_ + 1);
    at_ += 2;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t last_bar_ = 0;
  std::vector<StepCommand> commands_ = std::vector<StepCommand>(1);
};

}  // namespace

std::vector<StepCommand> split_step(std::string_view text) { return StepSplitter(text).split(); }

std::string describe_step_place(std::string_view text, std::size_t place) {
  const std::string_view before = text.substr(0, place);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return "line " + std::to_string(line + 1) + ", column " + std::to_string(place - start + 1);
}

}  // namespace pliant
