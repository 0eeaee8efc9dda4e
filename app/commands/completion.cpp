// SPDX-License-Identifier: MIT
// flipbook completion bash|zsh|fish: the script that completes the program's command lines in that shell. A script only
// translates: what there is to offer, `flipbook complete` says at the moment (see complete.h).
#include "app/commands/command.h"
#include "sim/frame/errors.h"

#include <array>
#include <iostream>

namespace flipbook::app {

namespace {

// The word as we mean it may be several words of bash, which splits at '=' and ':' too; what is offered must then lack
// the part that bash has behind it.
constexpr const char* bash = R"sh(# flipbook: completion for bash. Load it with:  source <(flipbook completion bash)
_flipbook() {
  local rest=$COMP_LINE words=() word i
  for ((i = 0; i <= COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if ((i > 0)) && [[ -n $rest && $rest != [[:space:]]* ]]; then
      words[${#words[@]} - 1]+=$word
    else
      words+=("$word")
      rest=${rest#"${rest%%[![:space:]]*}"}
    fi
    rest=${rest#"$word"}
  done
  word=${words[${#words[@]} - 1]}
  local behind=
  [[ $COMP_WORDBREAKS == *=* && $word == *=* ]] && behind=${word%"${word##*=}"}
  [[ $COMP_WORDBREAKS == *:* && ${word#"$behind"} == *:* ]] && behind=${word%"${word##*:}"}
  local line paths=
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
    :files | :folders) paths=${line#:} ;;
    :nospace) compopt -o nospace 2>/dev/null ;;
    *)
      line=${line%%$'\t'*}
      COMPREPLY+=("${line#"$behind"}")
      ;;
    esac
  done < <("${words[0]/#\~/$HOME}" complete "${words[@]:1}" 2>/dev/null)
  if [[ $paths == folders ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "${word#"$behind"}")
  elif [[ $paths == files ]]; then
    if ((${#COMPREPLY[@]} == 0)); then
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "${word#"$behind"}")
    else # names and, beside them, the user's own scenes and studies
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X '!*.toml' -- "${word#"$behind"}")
    fi
  fi
}
complete -F _flipbook flipbook
)sh";

constexpr const char* zsh = R"sh(#compdef flipbook
# flipbook: completion for zsh. Put it into a folder of $fpath as _flipbook, or load it with:
#   source <(flipbook completion zsh)
_flipbook() {
  local line paths= space=' '
  local -a texts shown
  for line in "${(@f)$("${(Q)words[1]/#\~/$HOME}" complete "${(@Q)words[2,CURRENT]}" 2>/dev/null)}"; do
    case $line in
      :files|:folders) paths=${line#:} ;;
      :nospace) space= ;;
      ?*)
        texts+=("${line%%$'\t'*}")
        if [[ $line == *$'\t'* ]]; then
          shown+=("${line%%$'\t'*}  -- ${line#*$'\t'}")
        else
          shown+=("$line")
        fi
        ;;
    esac
  done
  (( $#texts )) && compadd -l -S "$space" -d shown -- "${texts[@]}"
  case $paths in
    files) _files ;;
    folders) _files -/ ;;
  esac
}
if [[ $funcstack[1] == _flipbook ]]; then
  _flipbook "$@"
else
  compdef _flipbook flipbook
fi
)sh";

constexpr const char* fish = R"sh(# flipbook: completion for fish. Load it with:  flipbook completion fish | source
function __flipbook_complete
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    for line in ($words[1] complete $words[2..-1] "$word" 2>/dev/null)
        switch $line
            case ':files'
                __fish_complete_path "$word"
            case ':folders'
                __fish_complete_directories "$word" ''
            case ':nospace'
            case '*'
                echo $line
        end
    end
end
complete -c flipbook -f -a '(__flipbook_complete)'
)sh";

struct Shell {
  const char *name, *script;
};
constexpr std::array<Shell, 3> shells{{{"bash", bash}, {"zsh", zsh}, {"fish", fish}}};

class Completion final : public Command {
public:
  void options(OptionVisitor& v) override {
    std::vector<std::string> names;
    for (const Shell& s : shells) names.emplace_back(s.name);
    v.positional({"SHELL", Argument::Kind::choice, names}, shell_, "bash, zsh or fish");
  }

  int run() override {
    std::vector<std::string> names;
    for (const Shell& s : shells) {
      if (shell_ == s.name) return std::cout << s.script, 0;
      names.emplace_back(s.name);
    }
    throw UserError("there is no completion for \"" + shell_ + "\": it is bash, zsh or fish", {},
                    nearest_name(shell_, names));
  }

private:
  std::string shell_;
};

} // namespace

std::unique_ptr<Command> make_completion() {
  return std::make_unique<Completion>();
}

} // namespace flipbook::app
