// tools/completion/bash_completion.cpp: the script that completes a tool's options in bash.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "completion/completion.h"

namespace pliant {
namespace {

/// What is the same for all tools; @...@ is filled in. It needs bash alone, and does no harm beside bash-completion.
constexpr const char* bash_script = R"--(# Completion of @TOOL@ in bash: what `@TOOL@ --completion bash` prints.

# Sets REPLY to what the shell would make of a word, and quote to the quote that is left open in it.
_pliant_unquote() {
  local text=$1 c body
  REPLY='' quote=''
  if [[ $text != *[\\\'\"]* ]]; then
    REPLY=$text
    return
  fi
  while [[ $text ]]; do
    if [[ ! $quote && $text == "$'"*"'"* ]]; then
      body=${text#"$'"}
      text=${body#*"'"}
      printf -v body %b "${body%%"'"*}"
      REPLY+=$body
      continue
    fi
    c=${text:0:1} text=${text:1}
    case $quote$c in
      \' | \") quote=$c ;;
      \'\' | \"\") quote='' ;;
      \\) REPLY+=${text:0:1} text=${text:1} ;;
      \"\\) if [[ $text == [\\\"\$\`]* ]]; then REPLY+=${text:0:1} text=${text:1}; else REPLY+=$c; fi ;;
      *) REPLY+=$c ;;
    esac
  done
}

# Makes words of what bash has cut at = and : too. Sets words, at (which of them is being typed), current (it, up to the
# cursor), and head and tail: what of it bash keeps, and what it will replace.
_pliant_words() {
  local rest=${COMP_LINE-} piece start=0 i raw=() fresh=1 last='' quote
  for ((i = 0; i < ${#COMP_WORDS[@]}; ++i)); do
    piece=${COMP_WORDS[i]}
    if [[ ${COMP_LINE-} ]]; then
      if [[ $rest == [[:space:]]* ]]; then fresh=1; fi
      while [[ $piece && $rest == [[:space:]]* ]]; do rest=${rest:1}; done
      start=$((${#COMP_LINE} - ${#rest}))
      rest=${rest#"$piece"}
    else
      [[ $piece == = || ( $last == = && ${raw[-1]} == --* ) ]] || fresh=1
    fi
    last=$piece
    if ((fresh)); then raw+=(''); fi
    if ((i == COMP_CWORD)); then
      at=$((${#raw[@]} - 1)) head=${raw[at]} tail=$piece
      if [[ ${COMP_LINE-} ]] && ((COMP_POINT >= start)); then tail=${piece:0:COMP_POINT-start}; fi
    fi
    raw[-1]+=$piece
    fresh=0
    if [[ ! $piece ]]; then fresh=1; fi
  done
  if [[ $tail && ! ${tail//[=:<>@|&;]/} ]]; then head+=$tail tail=''; fi
  if [[ $head == *@ ]]; then head=${head%@} tail=@$tail; fi  # which bash replaces with what is behind it
  words=()
  for piece in "${raw[@]}"; do
    _pliant_unquote "$piece"
    if [[ $piece == '~' || $piece == '~/'* ]]; then REPLY=$HOME${piece:1}; fi
    words+=("$REPLY")
  done
  _pliant_unquote "$head$tail"
  current=$REPLY
}

# Replies with those of the candidates for the whole word that begin as it does, quoted as it is.
_pliant_reply() {
  local candidate begun rest quote REPLY
  _pliant_unquote "$head"
  begun=$REPLY
  for candidate; do
    [[ $candidate == "$current"* && $candidate == "$begun"* ]] || continue
    rest=${candidate#"$begun"}
    case $tail in
      \'*) rest=${rest//\'/\'\\\'\'} ;;
      \"*)
        rest=${rest//\\/\\\\} rest=${rest//\"/\\\"} rest=${rest//\$/\\\$}
        rest=${rest//\`/\\\`}
        ;;
      *) if [[ $rest ]]; then printf -v rest %q "$rest"; fi ;;
    esac
    if [[ $rest == *[=:\(/] ]]; then compopt -o nospace 2>/dev/null; fi
    COMPREPLY+=("$rest")
  done
}

# Replies with files whose names end in one of these, or with all files if no name does; $1 is the word's part before the name.
_pliant_files() {
  local before=$1 typed file extension found=() fit=() begun rest quote REPLY
  shift
  typed=${current#"$before"}
  _pliant_unquote "$head"
  begun=$REPLY
  compopt -o filenames 2>/dev/null
  mapfile -t found < <(compgen -f -- "$typed")
  for file in "${found[@]}"; do
    for extension; do
      if [[ ${file,,} == *."$extension" ]]; then fit+=("$file"); fi
    done
  done
  if ((${#fit[@]} == 0)); then fit=("${found[@]}"); else
    for file in "${found[@]}"; do
      if [[ -d $file ]]; then fit+=("$file"); fi
    done
  fi
  for file in "${fit[@]}"; do
    rest=$before$file
    COMPREPLY+=("${rest#"$begun"}")
  done
}

_@FUNCTION@() {
  local words at=0 head='' tail='' current='' option='' before='' pending='' i REPLY quote
  local answer=() choices=() only_inputs='' tool=@TOOL@
  COMPREPLY=()
  _pliant_words
  for ((i = 1; i < at; ++i)); do
    if [[ $pending ]]; then
      pending=''
      continue
    fi
    case ${words[i]} in
      --) only_inputs=1 && break ;;
      @TAKERS@) pending=${words[i]} ;;
    esac
  done
  if [[ $pending ]]; then
    option=$pending
  elif [[ ! $only_inputs && $current == --*=* ]]; then
    option=${current%%=*} before=${current%%=*}=
  elif [[ ! $only_inputs && $current == -o?* ]]; then
    option=-o before=-o
  elif [[ ! $only_inputs && $current == -* ]]; then
    for option in @OPTIONS@; do
      choices=" ${words[*]:1:at-1} ${words[*]:at+1} "
      [[ ${choices//=/ } == *" $option "* && ' @REPEATABLE@ ' != *" $option "* ]] || _pliant_reply "$option"
    done
    return
  fi
  case $option in
@CASES@    *) return ;;
  esac
  for i in "${!choices[@]}"; do choices[i]=$before${choices[i]}; done
  _pliant_reply "${choices[@]}"
}

# Asks the tool itself, which is $tool behind an alias, for the names that the option may have: some are in the input.
_pliant_ask() {
  local others=("${words[@]:1:at-1}") answer=() path
  if [[ $option ]]; then others=("${words[@]:1}"); fi
  path=$(type -P -- "${words[0]}") || path=$tool
  mapfile -t -d '' answer < <("$path" --complete-value "$option" "${current#"$before"}" "${others[@]}" 2>/dev/null)
  choices=("${answer[@]:1}")
  if [[ ${answer[0]-} == files* ]]; then
    # shellcheck disable=SC2086  # one word for each extension
    _pliant_files "$before" ${answer[0]#files}
  fi
}

complete -F _@FUNCTION@ @TOOL@
)--";

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : separator) + word;
  return all;
}

/// What is done for a value of this form.
std::string action(const ValueForm& form) {
  if (form.has_names) return "_pliant_ask";
  if (form.is_file) return "_pliant_files \"$before\" " + joined(form.extensions, " ");
  return "choices=(" + joined(form.choices, " ") + ")";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> all, takers, repeatable;
  std::string cases;
  for (const CLI::Option* option : shown_options(app)) {
    const std::vector<std::string> names = names_of(*option);
    all.insert(all.end(), names.begin(), names.end());
    if (is_repeatable(*option)) repeatable.insert(repeatable.end(), names.begin(), names.end());
    if (!takes_value(*option)) continue;
    takers.insert(takers.end(), names.begin(), names.end());
    const ValueForm form = form_of(app, *option);
    if (form.has_names || form.is_file || !form.choices.empty())
      cases += "    " + joined(names, " | ") + ") " + action(form) + " ;;\n";
  }
  cases += "    '') _pliant_ask ;;\n";
  std::string function = "pliant_" + app.get_name();
  std::replace(function.begin(), function.end(), '-', '_');
  std::string script = bash_script;
  fill_in(script, "@TOOL@", app.get_name());
  fill_in(script, "@FUNCTION@", function);
  fill_in(script, "@TAKERS@", joined(takers, " | "));
  fill_in(script, "@OPTIONS@", joined(all, " "));
  fill_in(script, "@REPEATABLE@", joined(repeatable, " "));
  fill_in(script, "@CASES@", cases);
  return script;
}

}  // namespace pliant
