#include "shell/scripts.hpp"

namespace sbgc::tools {

namespace {

// `sbgc __complete WORD...` prints a candidate per line: the word, a tab, a description.

constexpr std::string_view bash = R"(# Completion of sbgc for bash.

# Sets `quoted` to the text as it stands behind an open quote, or none.
_sbgc_quote() {
  local text=$1 quote=$2 special=' !"#$&'\''()*;<>?[\]`{|}~' character i
  [[ $quote == \' ]] && special=\'
  [[ $quote == \" ]] && special='!"$\`'
  quoted=
  for ((i = 0; i < ${#text}; i++)); do
    character=${text:i:1}
    [[ $special == *"$character"* ]] && character=$quote\\$character$quote
    quoted+=$character
  done
  # bash closes the quote, except behind another one.
  [[ $quote && ${quoted:-$quote} == *"$quote" ]] && quoted+=$quote
}

_sbgc() {
  local line=${COMP_LINE:0:COMP_POINT} words=() word= quote= is_word= character i
  # bash replaces $2, the end of the last word. `kept` is what precedes it, without quotes.
  local begin=$((${#line} - ${#2})) kept= open=none quoted
  for ((i = 0; i <= ${#line}; i++)); do
    ((i == begin)) && kept=$word open=$quote
    character=${line:i:1}
    if [[ $quote && $character == "$quote" ]]; then
      quote=
    elif [[ $quote == \' ]]; then
      word+=$character
    elif [[ $character == \\ ]]; then
      is_word=1
      [[ $quote && ${line:i+1:1} != [\"\$\\\`] ]] && word+=\\
      word+=${line: ++i:1}
    elif [[ $quote ]]; then
      word+=$character
    elif [[ $character == [\'\"] ]]; then
      [[ ${line: i - 1:2} == \$\' ]] && return  # $'...' has other rules
      quote=$character is_word=1
    elif [[ $character == [[:space:]] ]]; then
      [[ $is_word ]] && words+=("$word")
      word= is_word=
    else
      word+=$character is_word=1
    fi
  done
  COMPREPLY=()
  [[ $line == *"$2" && $open != none ]] || return
  while IFS=$'\t' read -r word _; do
    if [[ $word == :files ]]; then
      compopt -o default
    elif [[ $word == "$kept"* ]]; then
      [[ $word == *[=:] ]] && compopt -o nospace
      _sbgc_quote "${word#"$kept"}" "$open"
      COMPREPLY+=("$quoted")
    fi
  done < <("${words[0]}" __complete -- "${words[@]:1}" "$word" 2>/dev/null)
}
complete -F _sbgc sbgc
)";

constexpr std::string_view zsh = R"(#compdef sbgc
# Completion of sbgc for zsh.
_sbgc() {
  local word description
  local -a names descriptions open
  # The word up to the cursor without its quotes.
  local current=${(Q)${:-$QIPREFIX$PREFIX$compstate[quote]}}
  while IFS=$'\t' read -r word description; do
    if [[ $word == :files ]]; then
      _files
    elif [[ $word == *[=:] ]]; then
      open+=("$word")
    else
      names+=("$word")
      descriptions+=("${word}${description:+  -- $description}")
    fi
  done < <("${(Q)words[1]}" __complete -- "${(@Q)words[2,CURRENT - 1]}" "$current" 2>/dev/null)
  (( $#names )) && compadd -l -d descriptions -- "${names[@]}"
  (( $#open )) && compadd -S '' -- "${open[@]}"
  return 0
}
if [[ $funcstack[1] == _sbgc ]]; then _sbgc "$@"; else compdef _sbgc sbgc; fi
)";

constexpr std::string_view fish = R"(# Completion of sbgc for fish.
function __sbgc_complete
  set -l tokens (commandline -opc)
  set -l current (commandline -oct)
  $tokens[1] __complete -- $tokens[2..-1] "$current" 2>/dev/null
end
complete -c sbgc -f -a '(__sbgc_complete | string match -v :files\t)'
complete -c sbgc -F -n '__sbgc_complete | string match -q :files\t'
)";

}  // namespace

std::string_view completion_script(std::string_view shell) {
  if (shell == "bash") return bash;
  return shell == "zsh" ? zsh : fish;
}

}  // namespace sbgc::tools
