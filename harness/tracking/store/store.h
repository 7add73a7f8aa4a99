// The history of accuracy and speed: one SQLite file, or a schema on a PostgreSQL server, with every verdict and every
// raw sample of every recorded run.  docs/tracking-store.md has the tables and what is guaranteed.
#pragma once

#include "harness/tracking/store/model.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace cylon::store {

class Database;

/// read: the file must be there, and is not changed.  write: it is made where it is missing, and brought up
/// to this program's schema where it is older.
enum class Mode { read, write };

/// Who says what is stored: the user of this program, whose key seals it, or a file that is imported.
enum class Author { user, import };

/// Who stands behind the rows of a store (harness/seal).
struct Seals {
  std::size_t own = 0;      ///< Rows that bear this user's seal, which holds.
  std::size_t foreign = 0;  ///< Rows without a seal, or with that of another key: imported, or older.
  std::vector<std::string>
      broken;  ///< A sentence for each row that was changed after this user had sealed it.
};

/// One open store.  Every member throws core::InputError, in one sentence that names the file and what to do,
/// where the file cannot be read or written: it is no store, of a newer schema, damaged, read-only, locked by
/// another writer for 10 s, or the disk is full.  What was stored before stays as it was.
class Store {
 public:
  /// `place` is a file, or the address of a database: postgresql://USER@HOST/DATABASE.
  static Store open(const std::string& place, Mode);
  static bool is_on_server(const std::string& place);
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  // ---- Writing: each call is one transaction, kept even should the process be killed after it ----

  /// Opens a run and returns its id; RunInfo::id, uid and complete are the store's to give.  Refuses a file
  /// whose pages are damaged.
  std::int64_t begin_run(const RunInfo&);
  /// One cell of it.  The same cell of the same run twice is an error.
  void add(std::int64_t run, const Result&);
  void finish_run(std::int64_t run);
  /// Sets the anchor of that name.
  void pin(const Anchor&, Author = Author::user);
  /// Sets what is known of that series at that revision.
  void set(const ChangePoint&, Author = Author::user);
  /// All that `work` writes in one transaction: kept whole, or not at all where it throws.
  void in_one_transaction(const std::function<void()>& work);
  /// Whose results add() is given from now on: the user's at first.
  void set_author(Author author) { author_ = author; }
  /// Keeps other processes from recording this run as long as the store is open; false: one does.  Of a file always
  /// true, whose bytes are locked (tracking/run_lock.h).
  bool hold(std::int64_t run);
  /// A run from another store, with its uid; false where it is here already.  `id` is then its id here.
  bool import_run(const RunInfo&, std::int64_t& id);

  // ---- Reading ----

  /// In the order of revisions, then of recording.
  std::vector<RunInfo> runs() const;
  /// The latest run whose uid begins with the word (8 digits at least), or whose label, revision or id it is;
  /// in that order.
  std::optional<RunInfo> find_run(const std::string& word) const;
  /// Cells whose name matches, by name.
  std::vector<Cell> cells(const std::string& glob = "*") const;
  /// The results of a run, by cell hash.
  std::vector<Result> results(std::int64_t run) const;
  /// Every metric that matches of every cell that matches, by cell name and metric; * ? [a-z] match, '/' too.
  std::vector<Series> series(const std::string& cell_glob, const std::string& metric_glob) const;
  /// Result::asked of all results of a run.
  std::set<std::string> asked(std::int64_t run) const;
  /// digest() of a run's result of that cell; "" where it has none.
  std::string stored_digest(std::int64_t run, const std::string& cell_hash) const;
  std::vector<Anchor> anchors() const;
  std::vector<ChangePoint> change_points() const;
  /// Whether this user set the anchor, or began the run, with this program, and nobody changed it since.
  bool is_own(const Anchor&) const;
  bool is_own(const RunInfo&) const;
  /// Verifies every seal, by reading everything.
  Seals seals() const;
  /// What is damaged, a sentence each, by reading everything: the pages, the references between tables, and
  /// the digest of every result, run and cell.
  std::vector<std::string> check() const;

 private:
  explicit Store(std::unique_ptr<Database>);
  std::unique_ptr<Database> database_;
  Author author_ = Author::user;
};

}  // namespace cylon::store
