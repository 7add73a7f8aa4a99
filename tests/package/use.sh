#!/usr/bin/env bash
# What a user does with an installed cylon, the one in PATH, in the empty folder where this starts.
#   tests/package/use.sh PREFIX
# Also runs in a root that has nothing but bash and what cylon depends on.
set -euo pipefail
prefix=$1
fail() { echo "FAILED: $*" >&2; exit 1; }
says() { # text, command…: the command succeeds and prints the text
  local text=$1 output
  shift
  output=$("$@" 2>&1) || fail "$* ended with $?: $output"
  [[ $output == *"$text"* ]] || fail "$* does not print '$text': $output"
}

[ "$(type -P cylon)" = "$prefix/bin/cylon" ] || fail "cylon in PATH is $(type -P cylon), not $prefix/bin/cylon"
says 'Everything needed is installed' cylon doctor
says 'ode: here: ode' cylon engines --here
# Scenes of ours: an exact solution, a stored one (scenarios/data), a mesh (scenarios/extremes/data).
says ', 0 differ' cylon run projectile heavy_top --engine in-house --engine bullet --engine ode
says ', 0 differ' cylon run floating_sphere --suite catalogue --engine in-house --engine bullet
says ', 0 differ' cylon run slab_on_large_triangles --suite extremes --engine in-house

# A scene of the user's own, to the report.
begin=$SECONDS
says 'mine.toml: written' cylon new mine
says 'mine.toml' cylon validate mine.toml
says '0 differ' cylon run mine.toml --engine in-house --html report.html
grep -q '</html>' report.html || fail "report.html is not whole"
[ $((SECONDS - begin)) -lt 60 ] || fail "the report of a first scene took $((SECONDS - begin)) s, more than 60"
[ -s .cylon/journal.jsonl ] || fail "the run left no journal in the folder of the user"

# What stands beside the program is of this very program.
cmp <(cylon validate --schema) "$prefix/share/cylon/scenario.schema.json" || fail "another schema"
cmp <(cylon completion bash) "$prefix/share/bash-completion/completions/cylon" || fail "another completion for bash"
cmp <(cylon completion fish) "$prefix/share/fish/vendor_completions.d/cylon.fish" || fail "another completion for fish"
cmp <(cylon completion zsh) "$prefix"/share/zsh/*/_cylon || fail "another completion for zsh"
commands=$(cylon --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -gt 15 ] || fail "no commands in cylon --help"
for command in $commands; do
  page=$prefix/share/man/man1/cylon-$command.1.gz
  [ -s "$page" ] || fail "no man page of cylon $command"
  for option in $(cylon "$command" --help | sed -n '/^Options:/,/^$/s/^  \(-[^ ]*\).*/\1/p' | tr , '\n'); do
    grep -qF -- "\\fB${option//-/\\-}\\fR" < <(zcat "$page") || fail "cylon-$command.1 does not have $option"
  done
done
if type -P man >/dev/null; then
  MANPATH=$prefix/share/man says 'Run scenarios on engines and check every claim' man cylon-run
else
  echo "There is no man here: the pages were compared, not shown."
fi
