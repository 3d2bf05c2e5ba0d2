// tools/completion/completion.h: shell completion, made from the options of a tool as they are defined.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pliant {

/// Adds --completion bash|zsh, which prints the script and ends the tool as --help does.
void add_completion(CLI::App& app);

/// The options of the tool that --help shows, in its order, without the positional ones.
std::vector<const CLI::Option*> shown_options(const CLI::App& app);
/// All its names, "-o" before "--output".
std::vector<std::string> names_of(const CLI::Option& option);
bool takes_value(const CLI::Option& option);
bool is_repeatable(const CLI::Option& option);

/// What a value may be, told by the name of its type: `keep|refine`, `FILE`, `FACE=AREA`, `field:FIELD|METRIC`.
struct ValueForm {
  std::vector<std::string> choices;     ///< words that are written as they are
  bool has_names = false;               ///< names of the input or of the library, which `value_candidates` lists
  bool is_file = false;                 ///< a file, perhaps beside the others
  std::vector<std::string> extensions;  ///< of the files that are meant; none: any
};
ValueForm form_of(const CLI::App& app, const CLI::Option& option);

/// Puts `with` into a script for each `place`, a word between signs @.
void fill_in(std::string& script, const std::string& place, const std::string& with);

/// The script for a shell.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

/// What `TOOL --complete-value OPTION TYPED WORDS...` prints for the scripts: "files EXTENSION..." if the value may be
/// a file, else nothing; then each candidate for the whole value. Each part ends with a zero byte, since names may
/// hold all others. OPTION is empty for the word that belongs to no option; WORDS are those behind the
/// tool, in which INPUT is looked for: all, or for an empty OPTION those in front of this one.
std::string value_candidates(const CLI::App& app, const std::vector<std::string>& words);

/// Answers `TOOL --complete-value ...`; false for any other command line. It takes two seconds at most.
bool answer_completion(const CLI::App& app, int argc, char** argv);

}  // namespace pliant
