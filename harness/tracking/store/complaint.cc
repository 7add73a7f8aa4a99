#include "harness/tracking/store/complaint.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cerrno>
#include <cstring>

namespace cylon::store {
namespace {

constexpr const char* no_room =
    "there is no room to write: the disk is full or a limit is reached; what was stored before is kept, so "
    "make "
    "room and go on with `cylon track record --resume`";

struct Row {
  int code;  // an extended code, or a primary one, which stands for all of its extended ones
  const char* sentence;
};

// The first row that fits; {} is SQLite's own message.
constexpr Row rows[] = {
    {SQLITE_NOTADB,
     "is not a store: not an SQLite database, or its first page is damaged; it was not changed: name another "
     "with --store, or restore a backup"},
    {SQLITE_CORRUPT,
     "is damaged ({}); it was not changed: restore a backup, or save what can be read with `sqlite3 FILE "
     ".recover`"},
    {SQLITE_FULL, no_room},
    {SQLITE_IOERR_WRITE, no_room},
    {SQLITE_BUSY,
     "another process is writing to it and did not end in 10 s; wait for it, or name another store with "
     "--store"},
    {SQLITE_LOCKED, "is in use elsewhere in this process; name another store with --store"},
    {SQLITE_READONLY_DIRECTORY,
     "its folder cannot be written, which SQLite needs for its write-ahead log; allow it, or copy the store "
     "to "
     "a folder that can be written and name it with --store"},
    {SQLITE_READONLY,
     "cannot be written: the file or its folder is read-only; allow it, or copy the store to a folder that "
     "can "
     "be written and name it with --store"},
    {SQLITE_PERM, "may not be opened; allow it, or name another store with --store"},
    {SQLITE_CANTOPEN,
     "cannot be opened: the file or its folder is missing, or this user may not read and write both; allow "
     "it, "
     "or copy the store to a folder that can be written and name it with --store"},
    {SQLITE_NOMEM, "there is not enough memory to read it"},
    {SQLITE_IOERR_SHORT_READ, "is cut off; it was not changed: restore a backup"},
    {SQLITE_IOERR,
     "could not be read or written ({}); what was stored before is kept: look after the disk, then try "
     "again"},
    {SQLITE_TOOBIG, "a value is too long to be stored"},
};

}  // namespace

std::string complaint(int code, std::string_view message, int error_number) {
  if ((code & 0xff) == SQLITE_IOERR &&
      (error_number == ENOSPC || error_number == EFBIG || error_number == EDQUOT))
    return no_room;
  for (const Row& row : rows) {
    if (row.code != code && row.code != (code & 0xff)) continue;
    const std::string_view why =
        (code & 0xff) == SQLITE_IOERR && error_number ? std::strerror(error_number) : message;
    return fmt::format(fmt::runtime(row.sentence), why);
  }
  return fmt::format("SQLite refuses: {}", message);
}

}  // namespace cylon::store
