#!/usr/bin/env bash
# What tests/package/bare_root.sh does once mmdebstrap has made the root: packages and use.sh come from a folder.
set -euo pipefail
folder=$1 root=$2
fail() { echo "FAILED: $*" >&2; exit 1; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
install() { inside apt-get install -y -qq --no-install-recommends "$@" >"$folder/apt.log" 2>&1 || { cat "$folder/apt.log" >&2; fail "apt-get install $*"; }; }
as_user() { inside su user -c "cd ~ && $*"; }

for program in cc c++ gcc g++ clang cmake python3; do
  if inside sh -c "command -v $program" >/dev/null; then fail "there is a $program in the bare root"; fi
done
mkdir "$root/packages" && cp "$folder"/packages/*.deb "$folder/use.sh" "$folder"/model.* "$root/packages"
core=$(cd "$folder/packages" && ls cylon_*.deb)
install man-db
begin=$SECONDS
install "/packages/$core"
echo "apt-get install ./$core: $((SECONDS - begin)) s"
inside useradd --create-home user
begin=$SECONDS
as_user bash /packages/use.sh /usr
echo "used as a user: $((SECONDS - begin)) s"
as_user cylon engines --here | grep -F 'mujoco: not here: `apt-get install ./cylon-mujoco_*.deb` brings it' || fail "mujoco is here without its package"

imports() { # a model of that ending, which becomes a scenario
  as_user "cylon import /packages/model.$1 -o model.toml && cylon validate model.toml" >"$folder/import.log" 2>&1 ||
    { cat "$folder/import.log" >&2; fail "no scenario of a .$1 file"; }
}

for package in "$folder"/packages/cylon-*.deb; do
  [ -e "$package" ] || continue
  id=$(basename "$package") id=${id#cylon-} id=${id%%_*}
  install "/packages/$(basename "$package")"
  case $id in
    import-mjcf) imports xml; continue ;;
    import-sdformat) imports sdf; continue ;;
    import-urdf) imports urdf; continue ;;
  esac
  as_user cylon engines --here | grep "^$id: here: " || fail "$id is not here with its package"
  states=$(as_user cylon simulate projectile --engine "$id" | wc -l) || fail "$id does not run"
  [ "$states" -gt 2 ] || fail "$id gives $states lines"
done
inside apt-get purge -y -qq cylon >/dev/null 2>&1 || fail "cylon cannot be purged"
left=$(inside find / -xdev -path /proc -prune -o -path /packages -prune -o -path /home -prune -o -iname '*cylon*' -print)
[ -z "$left" ] || fail "the purged package leaves: $left"
