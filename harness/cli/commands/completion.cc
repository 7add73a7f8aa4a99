// cylon completion: reads the program's own tree of commands, so that it is always complete.
#include "harness/cli/commands/app.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <memory>

namespace cylon::cli {
namespace {

using Words = App::Words;

// What an argument that is no option may be: a command of cylon that prints it, or words.
struct Arguments {
  std::string query, words;
};

Arguments arguments(const Words& row) {
  const std::string& command = row.command;
  if (!row.commands.empty()) return {"", fmt::format("{}", fmt::join(row.commands, " "))};
  if (command == "engines") return {"engines --names", ""};
  if (command == "completion") return {"", "bash zsh fish"};
  if (command == "new" || command == "doctor" || command == "merge") return {"", ""};  // files at most
  return {"list --names", ""};
}

std::string bash(const std::vector<Words>& words) {
  std::string names, cases;
  for (const Words& row : words) {
    const auto [query, fixed] = arguments(row);
    names += row.command + ' ';
    cases += fmt::format("    {}) words=\"{} {}{}\" ;;\n", row.command, fmt::join(row.options, " "), fixed,
                         query.empty() ? "" : fmt::format("$(\"$cylon\" {} 2>/dev/null)", query));
  }
  return fmt::format(R"sh(_cylon() {{
  local cylon=${{COMP_WORDS[0]}} word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{}--help --version" -- "$word"))
    return
  fi
  if [ "$previous" = --engine ]; then
    COMPREPLY=($(compgen -W "$("$cylon" engines --names 2>/dev/null)" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  COMPREPLY=($(compgen -f -W "$words" -- "$word"))
}}
complete -F _cylon cylon
)sh",
                     names, cases);
}

// Lies in $fpath as _cylon, where the first line registers it, or is sourced, where `compdef` does.
std::string zsh(const std::vector<Words>& words) {
  std::string names, cases;
  for (const Words& row : words) {
    const auto [query, fixed] = arguments(row);
    names += row.command + ' ';
    cases +=
        fmt::format("      {}) candidates=({} {} {}) ;;\n", row.command, fmt::join(row.options, " "), fixed,
                    query.empty() ? "" : fmt::format("${{(f)\"$($cylon {} 2>/dev/null)\"}}", query));
  }
  return fmt::format(R"sh(#compdef cylon
compdef _cylon cylon
_cylon() {{
  local cylon=$words[1]
  local -a candidates
  if (( CURRENT == 2 )); then
    candidates=({}--help --version)
  elif [[ $words[CURRENT-1] == --engine ]]; then
    candidates=(${{(f)"$($cylon engines --names 2>/dev/null)"}})
  else
    case $words[2] in
{}    esac
    _files
  fi
  compadd -a candidates
}}
[[ $funcstack[1] == _cylon ]] && _cylon "$@"
)sh",
                     names, cases);
}

// Asks the program that is typed, as bash and zsh do.  Where there is none, a bare `cylon` would make fish print an error.
std::string fish(const std::vector<Words>& words) {
  std::string text = R"sh(function __cylon_says
  set -l cylon (string match -r '^(?:.*/)?cylon$' -- (commandline -opc) | string replace -r '^~/' ~/)[1]
  test -n "$cylon"; and type -q $cylon; and $cylon $argv 2>/dev/null
end
)sh";
  for (const Words& row : words) {
    text += fmt::format("complete -c cylon -n __fish_use_subcommand -f -a {}\n", row.command);
    for (const std::string& option : row.options)
      text +=
          fmt::format("complete -c cylon -n '__fish_seen_subcommand_from {}' {} {}{}\n", row.command,
                      option.starts_with("--") ? "-l" : "-s", option.substr(option.starts_with("--") ? 2 : 1),
                      option == "--engine" ? " -x -a '(__cylon_says engines --names)'" : "");
    const auto [query, fixed] = arguments(row);
    const std::string values = query.empty() ? fixed : fmt::format("(__cylon_says {})", query);
    if (!values.empty())
      text +=
          fmt::format("complete -c cylon -n '__fish_seen_subcommand_from {}' -a '{}'\n", row.command, values);
  }
  return text;
}

}  // namespace

Command add_completion(App& app, const Context&) {
  const auto shell = std::make_shared<std::string>();
  app.add_option("shell", *shell, "bash, zsh or fish")->required()->check(one_of({"bash", "zsh", "fish"}));
  app.footer("bash: source <(cylon completion bash)");
  return [shell, app] {
    static const std::map<std::string, std::string (*)(const std::vector<Words>&)> scripts = {
        {"bash", bash}, {"zsh", zsh}, {"fish", fish}};
    std::cout << scripts.at(*shell)(app.parent().words());
    return ok;
  };
}

}  // namespace cylon::cli
