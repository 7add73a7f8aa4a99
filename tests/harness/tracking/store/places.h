// Stores of both kinds: in a file, and on a PostgreSQL server of the test's own.
#pragma once

#include "tests/harness/tracking/store/fixture.h"
#include "tests/paths.h"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace cylon::store {

inline int shell(const std::string& line) {
  const int status = std::system(line.c_str());  // NOLINT(concurrency-mt-unsafe): tests have one thread
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// One server for all tests of a process; it ends with the process.
class PostgresServer {
 public:
  static const PostgresServer& only() {
    static const PostgresServer server;
    return server;
  }
  bool is_up() const { return code_ == 0; }
  bool is_missing() const { return code_ == 77; }
  std::string address(const std::string& database) const {
    return "postgresql://cylon@/" + database + "?host=" + folder_;
  }
  /// The address of a new database.
  std::string fresh() const {
    static int made = 0;
    const std::string name = "t" + std::to_string(++made);
    sql("postgres", "CREATE DATABASE " + name);
    return address(name);
  }
  void sql(const std::string& database, const std::string& text) const {
    ASSERT_EQ(shell("psql -q -v ON_ERROR_STOP=1 -c \"" + text + "\" '" + address(database) + "'"), 0) << text;
  }

 private:
  PostgresServer() {
    std::string name = (std::filesystem::temp_directory_path() / "cylon-pg-XXXXXX").string();
    if (!::mkdtemp(name.data())) return;
    folder_ = name;
    code_ = shell(std::string(source_dir) + "/tests/harness/tracking/store/postgres.sh " + folder_ + " " +
                  std::to_string(::getpid()));
    if (code_ != 0) std::filesystem::remove_all(folder_);
  }

  std::string folder_;
  int code_ = -1;
};

/// Tests of stores in a file ("sqlite") and on a server ("postgresql").
class AnyPlace : public Folder, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    Folder::SetUp();
    if (on_server() && PostgresServer::only().is_missing())
      GTEST_SKIP() << "no PostgreSQL here: apt-get install postgresql libpq-dev";
    if (on_server()) {
      ASSERT_TRUE(PostgresServer::only().is_up());
    }
    place = fresh("history.db");
  }
  bool on_server() const { return std::string(GetParam()) == "postgresql"; }
  std::string fresh(const std::string& name) const {
    return on_server() ? PostgresServer::only().fresh() : (folder / name).string();
  }
  /// SQL past the store.
  void raw(const std::string& sql) const {
    if (on_server()) {
      std::string quoted = "SET search_path = cylon; ";
      for (const char c : sql) quoted += c == '"' ? std::string("\\\"") : std::string(1, c);
      const std::size_t begin = place.find("@/") + 2;
      return PostgresServer::only().sql(place.substr(begin, place.find('?') - begin), quoted);
    }
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(place.c_str(), &handle), SQLITE_OK);
    char* said = nullptr;
    ASSERT_EQ(sqlite3_exec(handle, ("PRAGMA foreign_keys = ON; " + sql).c_str(), nullptr, nullptr, &said),
              SQLITE_OK)
        << said;
    sqlite3_close(handle);
  }

  std::string place;
};

/// The tests on a server share one process, for which one server is started (CMakeLists.txt, AS_ONE).
#define IN_ALL_PLACES(Suite)                                          \
  INSTANTIATE_TEST_SUITE_P(Sqlite, Suite, testing::Values("sqlite")); \
  INSTANTIATE_TEST_SUITE_P(Postgresql, Suite, testing::Values("postgresql"))

}  // namespace cylon::store
