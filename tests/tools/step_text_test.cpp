// tests/tools/step_text_test.cpp: a step is split as a shell splits it, and what only a shell can do is refused.
#include "evolve/step_text.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "run/exit_status.h"

using namespace pliant;

namespace {

/// The words of the commands, each in brackets, commands separated by bars.
std::string brackets(const std::vector<StepCommand>& commands) {
  std::string text;
  for (const StepCommand& command : commands) {
    if (!text.empty()) text += '|';
    for (const StepWord& word : command) text += "[" + word.text + "]";
  }
  return text;
}

std::string split(const std::string& text) { return brackets(split_step(text)); }

std::string refusal(const std::string& text) {
  try {
    split_step(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

/// What sh makes of the arguments in each text.
std::string words_of_shell(const std::vector<std::string>& texts) {
  char name[] = "/tmp/pliant_step_XXXXXX";
  const int file = mkstemp(name);
  REQUIRE(file >= 0);
  {
    std::ofstream script(name);
    script << "show() { for word; do printf '[%s]' \"$word\"; done; echo; }\n";
    for (const std::string& text : texts) script << "show " << text << "\n";
  }
  std::FILE* const pipe = popen((std::string("sh ") + name + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string words;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) words += static_cast<char>(c);
  pclose(pipe);
  std::remove(name);
  return words;
}

}  // namespace

TEST_CASE("a step is a pipe of commands, each of words", "[tools]") {
  CHECK(split("refine") == "[refine]");
  CHECK(split("  advect --flow vortex:period=8 --dt 0.01\t|refine|coarsen --tolerance 1e-4 ") ==
        "[advect][--flow][vortex:period=8][--dt][0.01]|[refine]|[coarsen][--tolerance][1e-4]");
  CHECK(split("advect --vx 'y * (1 - y)' --vy \"0\" --dt=.1") == "[advect][--vx][y * (1 - y)][--vy][0][--dt=.1]");
  CHECK(split("a ''\"\" b''c d\\ e \"f\\\"g\\h\" 'i\\'") == "[a][][bc][d e][f\"g\\h][i\\]");
  CHECK(split("a#b c# # d | e") == "[a#b][c#]");
}

TEST_CASE("a step may go over several lines as in a script", "[tools]") {
  CHECK(split("# one step\n\nadvect --dt 1 |  # moves\n\n  refine \\\n  --max-area 1 |\r\ncoarsen\n# the end\n\n") ==
        "[advect][--dt][1]|[refine][--max-area][1]|[coarsen]");
  CHECK(split("a b\\\nc 'd\ne'") == "[a][bc][d\ne]");
  CHECK(split("a 'b\r\nc' \"d\r\ne\\\r\nf\" g\\\r\nh\r\n") == "[a][b\nc][d\nef][gh]");  // as on Windows
  CHECK(refusal("advect --dt 1\nrefine") ==
        "STEP, line 1, column 14: a line that ends here ends the pipe, and more follows: end the line with | or with "
        "\\ to go "
        "on");
  CHECK_FALSE(refusal("advect --dt 1\n| refine").empty());
}

TEST_CASE("each word knows its place", "[tools]") {
  const std::string text = "a 'b c' |\n  dd";
  const std::vector<StepCommand> commands = split_step(text);
  CHECK(describe_step_place(text, commands[0][1].place) == "line 1, column 3");
  CHECK(describe_step_place(text, commands[1][0].place) == "line 2, column 3");
}

TEST_CASE("what only a shell can do is refused, with the place and a word on why", "[tools]") {
  const auto& [text, column, word] = GENERATE(table<std::string, int, std::string>({
      {"advect --dt $DT", 13, "expanded"},
      {"advect --dt \"$DT\"", 14, "expanded"},
      {"a `date`", 3, "expanded"},
      {"a; b", 2, "joined by |"},
      {"a & b", 3, "joined by |"},
      {"a && b", 3, "joined by |"},
      {"a || b", 3, "one |"},
      {"a |& b", 3, "standard output"},
      {"a > out.json", 3, "redirected"},
      {"a < in.json", 3, "redirected"},
      {"a 2>/dev/null", 4, "redirected"},
      {"(a)", 1, "grouped"},
      {"{ a; }", 1, "grouped"},
      {"a *.json", 3, "pattern"},
      {"a x?", 4, "pattern"},
      {"a [x]", 3, "pattern"},
      {"a --vx y*2", 9, "'...'"},
      {"a ~/flow.json", 3, "~"},
      {"! a", 1, "negated"},
      {"a 'b", 3, "not closed"},
      {"a \"b", 3, "not closed"},
      {"a \"b\\\"", 3, "not closed"},
      {"a \\", 3, "follow"},
      {"| a", 1, "before this |"},
      {"a | | b", 5, "before this |"},
      {"a |", 3, "follows this |"},
      {"a | # b", 3, "follows this |"},
      {"", 1, "empty"},
      {" \n # a\n", 1, "empty"},
      {"a \x01", 3, "control character"},
      {"a b\rc", 4, "code 13"},
      {std::string("a b\0", 4), 4, "code 0"},
      {std::string("a 'b\0'", 6), 5, "code 0"},
      {std::string("a \"b\0\"", 6), 5, "code 0"},
      {std::string("a \"b\\\0\"", 7), 6, "code 0"},
      {std::string("a b\\\0", 5), 5, "code 0"},
  }));
  CAPTURE(text);
  const std::string message = refusal(text);
  CAPTURE(message);
  CHECK(message.find("STEP, line 1, column " + std::to_string(column) + ": ") == 0);
  CHECK(message.find(word) != std::string::npos);
}

TEST_CASE("words are those that sh makes", "[tools][property]") {
  std::mt19937 random(7);
  const std::string alphabet = "ab=,.:-#+/@%^' '\"\"\\\\  \t";
  std::vector<std::string> accepted;
  std::string expected;
  for (int k = 0; k < 4000; ++k) {
    std::string text = "x ";
    for (int n = static_cast<int>(random() % 14); n > 0; --n) text += alphabet[random() % alphabet.size()];
    CAPTURE(text);
    try {
      const std::vector<StepCommand> commands = split_step(text);
      REQUIRE(commands.size() == 1);
      accepted.push_back(text);
      expected += brackets(commands) + "\n";
    } catch (const UsageError&) {
      // Only what is not closed, or ends with a backslash, is refused here.
      const bool is_open = refusal(text).find("not closed") != std::string::npos || text.back() == '\\';
      CHECK(is_open);
    }
  }
  REQUIRE(accepted.size() > 1000);
  CHECK(words_of_shell(accepted) == expected);
}

TEST_CASE("no bytes make the splitter fail in another way", "[tools][property]") {
  std::mt19937 random(11);
  for (int k = 0; k < 20000; ++k) {
    std::string text;
    for (int n = static_cast<int>(random() % 12); n > 0; --n) text += static_cast<char>(random());
    const std::string message = refusal(text);
    if (message.empty()) CHECK_FALSE(split_step(text).empty());
  }
}
