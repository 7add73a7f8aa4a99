// A file that cannot be used gets one sentence that names it and says what to do, and stays as it is to the
// byte; a damaged one never passes for a sound one.
#include "harness/core/input_error.h"
#include "harness/tracking/store/json_lines.h"
#include "tests/harness/tracking/store/fixture.h"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

namespace cylon::store {
namespace {

namespace fs = std::filesystem;

class Damage : public Folder {
 protected:
  // Eighty results in two runs, an anchor and a change point.
  void fill(const fs::path& path) const {
    Store store = Store::open(path, Mode::write);
    for (const char* revision : {"r1", "r2"}) {
      const std::int64_t id = store.begin_run(run(revision));
      for (int i = 0; i < 40; ++i)
        store.add(id, result("scene" + std::to_string(i), 0.0125, {0.1 + i, 0.3 + i, 0.7 + i}));
      store.finish_run(id);
    }
    store.pin({"v1", "in-house=anchors/v1", "aa", "2024-05-01T00:00:00Z", "first", ""});
    store.set({"s/cpu_seconds", "r2", "ignored", "2024-05-02T00:00:00Z", "the machine was moved"});
  }
  std::string exported(const fs::path& path) const {
    std::ostringstream out;
    write_json_lines(Store::open(path, Mode::read), out);
    return out.str();
  }
  void write(const fs::path& path, const std::string& bytes) const {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  // What a raw statement does that no store would.
  void raw(const char* sql) const {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &handle), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(handle);
  }
  // Does `work` in a process that then dies without closing anything, as kill -9 would leave it.
  template <class Work>
  void in_a_process_that_dies(Work work) const {
    const pid_t pid = ::fork();
    if (pid == 0) {
      work();
      ::_exit(0);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(pid, &status, 0), pid);
    ASSERT_EQ(status, 0);
  }
  // Opens it in either mode and expects the sentence and the same bytes.
  void expect_refused(const std::string& part) const {
    const std::string before = bytes_of(file), log = bytes_of(file.string() + "-wal");
    for (const Mode mode : {Mode::read, Mode::write}) try {
        Store::open(file, mode).runs();
        ADD_FAILURE() << "was taken: " << part;
      } catch (const core::InputError& error) {
        const std::string said = error.what();
        EXPECT_TRUE(said.starts_with(file.string() + ": ")) << said;
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      }
    EXPECT_TRUE(bytes_of(file) == before) << part;
    EXPECT_TRUE(bytes_of(file.string() + "-wal") == log) << part;
  }
};

TEST_F(Damage, RejectsNewerSchema) {
  fill(file);
  raw("PRAGMA user_version = 99");
  expect_refused("written by a newer Cylon (schema 99");
}

TEST_F(Damage, RejectsNewerSchemaInWriteAheadLog) {
  fill(file);
  in_a_process_that_dies([&] {
    sqlite3* handle = nullptr;
    sqlite3_open(file.c_str(), &handle);
    sqlite3_exec(handle, "PRAGMA user_version = 98", nullptr, nullptr, nullptr);
  });
  ASSERT_GT(fs::file_size(file.string() + "-wal"), 0u);
  expect_refused("written by a newer Cylon (schema 98");
}

TEST_F(Damage, RejectsFilesThatAreNotStores) {
  write(file, "run,revision\n1,2\n");
  expect_refused("is not a store");
  write(file, std::string(100'000, '\x5a'));
  expect_refused("is not a store");
  fs::remove(file);
  raw("CREATE TABLE of_somebody_else (x); INSERT INTO of_somebody_else VALUES (1)");
  expect_refused("is a database, but not a store of Cylon");
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_THROW(Store::open(file, Mode::write), core::InputError);
}

TEST_F(Damage, ReadingCreatesNoStore) {
  EXPECT_THROW(Store::open(file, Mode::read), core::InputError);
  EXPECT_FALSE(fs::exists(file));
  write(file, "");
  EXPECT_THROW(Store::open(file, Mode::read), core::InputError);
  EXPECT_EQ(fs::file_size(file), 0u);
}

TEST_F(Damage, DetectsTruncationAnywhere) {
  fill(file);
  const std::string whole = bytes_of(file);
  for (const double share : {0.001, 0.03, 0.31, 0.62, 0.97, 0.9999}) {
    write(file, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    const std::string before = bytes_of(file);
    for (const Mode mode : {Mode::read, Mode::write})
      EXPECT_THROW(
          {
            const Store store = Store::open(file, mode);
            if (!store.check().empty()) throw core::InputError("found");
          },
          core::InputError)
          << share;
    EXPECT_TRUE(bytes_of(file) == before) << share;
  }
}

// One to four bits of one byte, anywhere: either it is found out, or it was of no consequence.  Both happen.
TEST_F(Damage, DetectsFlippedByte) {
  fill(file);
  const std::string whole = bytes_of(file), truth = exported(file);
  std::mt19937 random(20240501);
  int found = 0, harmless = 0;
  for (int i = 0; i < 300; ++i) {
    std::string broken = whole;
    const std::size_t at = random() % broken.size();
    broken[at] = static_cast<char>(broken[at] ^ static_cast<char>(1 + random() % 15));
    write(file, broken);
    try {
      bool sound = false;
      {
        const Store store = Store::open(file, Mode::read);
        sound = store.check().empty();
        store.series("*", "*");
        for (const RunInfo& r : store.runs()) store.results(r.id);
      }
      if (sound) {
        EXPECT_TRUE(exported(file) == truth) << "byte " << at;
        ++harmless;
      } else {
        ++found;
      }
    } catch (const core::InputError&) {
      ++found;
    }
    EXPECT_TRUE(bytes_of(file) == broken) << "reading changed it, byte " << at;
    for (const char* beside : {"-wal", "-shm"}) fs::remove(file.string() + beside);
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(harmless, 30);
}

TEST_F(Damage, DamagedPagesPreventWriting) {
  fill(file);
  std::string bytes = bytes_of(file);
  for (std::size_t page = 4; page < 8; ++page) bytes.replace(page * 4096, 64, std::string(64, '\x01'));
  write(file, bytes);
  EXPECT_THROW(Store::open(file, Mode::write).begin_run(run("r3")), core::InputError);
}

TEST_F(Damage, KilledProcessLosesNoCommittedData) {
  fill(file);
  in_a_process_that_dies([&] {
    auto* store = new Store(Store::open(file, Mode::write));  // which nobody closes
    store->add(store->begin_run(run("r3")), result("late", 0.0125, {1}));
  });
  ASSERT_GT(fs::file_size(file.string() + "-wal"), 0u);
  EXPECT_EQ(Store::open(file, Mode::read).series("late/*", "cpu_seconds").size(), 1u);
  Store store = Store::open(file, Mode::write);
  EXPECT_TRUE(store.check().empty());
  EXPECT_FALSE(store.find_run("r3").value().complete);
}

}  // namespace
}  // namespace cylon::store
