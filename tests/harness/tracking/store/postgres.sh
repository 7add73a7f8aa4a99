#!/usr/bin/env bash
# Starts a PostgreSQL server of its own in a folder, on a socket there alone, as a user that is not root; it ends with the
# process that is named, and takes the folder with it.  Its order of texts is English, so that a store which relies on the
# server's order is found out.
#   tests/harness/tracking/store/postgres.sh FOLDER PROCESS
# Exits 77 where there is no PostgreSQL.
set -euo pipefail
folder=$1 process=$2
bin=$(ls -d /usr/lib/postgresql/*/bin 2>/dev/null | sort -V | tail -n 1)
[ -x "$bin/postgres" ] || { echo "there is no PostgreSQL here: apt-get install postgresql" >&2; exit 77; }
as=()
if [ "$(id -u)" = 0 ]; then
  user=$(id -un postgres 2>/dev/null || echo nobody)
  chown "$user" "$folder"
  as=(setpriv "--reuid=$user" "--regid=$(id -gn "$user")" --clear-groups)
fi
chmod 755 "$folder"
cd "$folder"
"${as[@]}" "$bin/initdb" -D "$folder/data" -U cylon -A trust -E UTF8 --locale=C.UTF-8 --locale-provider=icu --icu-locale=en --no-sync >initdb.log
"${as[@]}" "$bin/pg_ctl" -D "$folder/data" -s -w -t 120 -l "$folder/server.log" \
  -o "-c listen_addresses='' -c unix_socket_directories='$folder' -c fsync=off" start >/dev/null
# In a session of its own, so that a signal to the test's processes leaves it to do this.
setsid bash -c 'while kill -0 "$1" 2>/dev/null; do sleep 0.5; done; "${@:4}" "$3/pg_ctl" -D "$2/data" -s -m immediate stop; rm -rf "$2"' \
  watcher "$process" "$folder" "$bin" "${as[@]}" </dev/null >/dev/null 2>&1 &
