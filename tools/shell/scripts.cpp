#include "shell/scripts.hpp"

namespace sbgc::tools {

namespace {

// `sbgc __complete WORD...` prints a candidate per line: the word, a tab, a description.

constexpr std::string_view bash = R"(# Completion of sbgc for bash.
_sbgc() {
  local line=${COMP_LINE:0:COMP_POINT} word words
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  local current=${words[-1]}
  # bash replaces only what follows the last ':' or '='.
  local before=${current%"${current##*[:=]}"}
  COMPREPLY=()
  while IFS=$'\t' read -r word _; do
    if [[ $word == :files ]]; then
      compopt -o filenames
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$current")
    else
      [[ $word == *[=:] ]] && compopt -o nospace
      COMPREPLY+=("${word#"$before"}")
    fi
  done < <("${words[0]}" __complete -- "${words[@]:1}" 2>/dev/null)
}
complete -F _sbgc sbgc
)";

constexpr std::string_view zsh = R"(#compdef sbgc
# Completion of sbgc for zsh.
_sbgc() {
  local word description
  local -a names descriptions open
  while IFS=$'\t' read -r word description; do
    if [[ $word == :files ]]; then
      _files
    elif [[ $word == *[=:] ]]; then
      open+=("$word")
    else
      names+=("$word")
      descriptions+=("${word}${description:+  -- $description}")
    fi
  done < <("${words[1]}" __complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)
  (( $#names )) && compadd -l -d descriptions -- "${names[@]}"
  (( $#open )) && compadd -S '' -- "${open[@]}"
  return 0
}
if [[ $funcstack[1] == _sbgc ]]; then _sbgc "$@"; else compdef _sbgc sbgc; fi
)";

constexpr std::string_view fish = R"(# Completion of sbgc for fish.
function __sbgc_complete
  set -l tokens (commandline -opc) (commandline -ct)
  for line in ($tokens[1] __complete -- $tokens[2..-1] 2>/dev/null)
    if string match -q ':files*' -- $line
      __fish_complete_path (commandline -ct)
    else
      echo $line
    end
  end
end
complete -c sbgc -f -a '(__sbgc_complete)'
)";

}  // namespace

std::string_view completion_script(std::string_view shell) {
  if (shell == "bash") return bash;
  return shell == "zsh" ? zsh : fish;
}

}  // namespace sbgc::tools
