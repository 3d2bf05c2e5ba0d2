// tools/completion/zsh_completion.cpp: the script that completes a tool's options in zsh.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "completion/completion.h"

namespace pliant {
namespace {

constexpr const char* zsh_script = R"--(#compdef @TOOL@
# Completion of @TOOL@ in zsh: what `@TOOL@ --completion zsh` prints.

# Asks the tool itself, which is $tool behind an alias, for the names that the option $1 may have: some are in the input.
_pliant_ask() {
  local asked=${(Q)words[1]} typed=${(Q)PREFIX} name
  local -a others answer whole begun
  others=("${(@Q)words[2,CURRENT-1]}")
  if [[ -n $1 ]]; then others=("${(@Q)words[2,-1]}"); fi
  (( $+commands[$asked] )) || [[ -x $asked ]] || asked=$tool
  answer=("${(@0)"$("$asked" --complete-value "$1" "$typed" "${others[@]}" 2>/dev/null)"}")
  for name in "${(@)answer[2,-1]}"; do
    case $name in
      '') ;;
      *[=:]) begun+=("$name") ;;
      *) whole+=("$name") ;;
    esac
  done
  local found=1
  compadd -S '' -a begun && found=0
  compadd -a whole && found=0
  if [[ $answer[1] == files* ]]; then _pliant_files ${=answer[1]#files} && found=0; fi
  return found
}

# Files whose names end in one of these, or all files if no name does.
_pliant_files() {
  if (( $# )); then _files -g "(#i)*.(${(j:|:)@})" || _files; else _files; fi
}

_@FUNCTION@() {
  local tool=@TOOL@
  _arguments -s -S \
@SPECIFICATIONS@}

if [[ $funcstack[1] == _@TOOL@ ]]; then  # called by the name of its file
  _@FUNCTION@ "$@"
else
  compdef _@FUNCTION@ @TOOL@
fi
)--";

/// Within single quotes, in a specification of _arguments, where `special` characters mean something.
std::string quoted(const std::string& words, const char* special) {
  std::string result;
  for (const char c : words) {
    if (c == '\'')
      result += "'\\''";
    else
      (std::string_view(special).find(c) != std::string_view::npos ? result += '\\' : result) += c;
  }
  return result;
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// How a value of this form is completed; `name` is one of the option's, or empty. The space in front keeps _arguments
/// from adding arguments of its own.
std::string action(const ValueForm& form, const std::string& name, bool asks) {
  if (form.has_names || asks) return " _pliant_ask \"" + name + "\"";
  if (form.is_file) return " _pliant_files " + joined(form.extensions);
  if (form.choices.empty()) return " ";
  return "(" + joined(form.choices) + ")";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string specifications;
  for (const CLI::Option* option : shown_options(app)) {
    std::vector<std::string> names = names_of(*option), excluded = names;
    for (const CLI::Option* other : option->get_excludes())
      for (const std::string& name : names_of(*other)) excluded.push_back(name);
    const bool has_value = takes_value(*option);
    std::string value;
    if (has_value) {
      const std::string type = option->get_type_name();
      value = ":" + quoted(type.substr(0, type.find(":{")), ":\\") + ":" +
              quoted(action(form_of(app, *option), names.back(), false), "");
    }
    for (const std::string& name : names) {
      const std::string joins = !has_value ? "" : name.starts_with("--") ? "=" : "+";
      specifications += "    '" + (is_repeatable(*option) ? "*" : "(" + joined(excluded) + ")") + name + joins + "[" +
                        quoted(option->get_description(), "[]:\\") + "]" + value + "' \\\n";
    }
  }
  std::size_t count = 0;
  std::vector<const CLI::Option*> positionals;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) positionals.push_back(option);
  for (const CLI::Option* option : positionals) {
    ++count;
    specifications += "    '" + std::to_string(count) + "::" + option->get_name() + ":" +
                      action(form_of(app, *option), "", true) + "'" + (count < positionals.size() ? " \\\n" : "\n");
  }
  std::string function = "pliant_" + app.get_name();
  std::replace(function.begin(), function.end(), '-', '_');
  std::string script = zsh_script;
  fill_in(script, "@TOOL@", app.get_name());
  fill_in(script, "@FUNCTION@", function);
  fill_in(script, "@SPECIFICATIONS@", specifications);
  return script;
}

}  // namespace pliant
