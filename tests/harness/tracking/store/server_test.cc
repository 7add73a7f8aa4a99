// `cylon track` with a history on a PostgreSQL server, and what it says where there is none.
#include "harness/core/input_error.h"
#include "harness/tracking/store/postgres.h"
#include "tests/harness/cli/fixture.h"
#include "tests/harness/tracking/store/places.h"

#include <string>

namespace cylon::store {
namespace {

TEST(Addresses, AreShownWithoutPassword) {
  EXPECT_EQ(without_password("postgresql://me:secret@host:5432/db?sslmode=require"),
            "postgresql://me@host:5432/db?sslmode=require");
  EXPECT_EQ(without_password("postgresql://host/db?password=secret&user=me"), "postgresql://host/db?user=me");
  EXPECT_EQ(without_password("postgresql://me@/db?host=/tmp/a:b"), "postgresql://me@/db?host=/tmp/a:b");
  EXPECT_TRUE(is_address("postgres://host/db"));
  EXPECT_FALSE(is_address("postgresql.db"));
}

class ServerStore : public cli::CommandLine {
 protected:
  void SetUp() override {
    if (PostgresServer::only().is_missing())
      GTEST_SKIP() << "no PostgreSQL here: apt-get install postgresql libpq-dev";
    ASSERT_TRUE(PostgresServer::only().is_up());
    place = PostgresServer::only().fresh();
  }
  cli::Ran track(const std::string& words) const {
    return cylon("track " + words + " --store '" + place + "'");
  }
  std::string place;
};

TEST_F(ServerStore, KeepsAHistory) {
  const cli::Ran recorded = track("record projectile --engine in-house --repetitions 2");
  EXPECT_EQ(recorded.code, 0) << recorded.err;
  const cli::Ran checked = track("check");
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_NE(checked.out.find("1 run, 1 cell, sound; 2 rows bear your seal, 0 do not"), std::string::npos)
      << checked.out;
  const cli::Ran exported = track("export a.jsonl");
  EXPECT_EQ(exported.code, 0) << exported.err;
  EXPECT_EQ(cylon("track import a.jsonl --store file.db").code, 0);
  EXPECT_EQ(cylon("track export b.jsonl --store file.db").code, 0);
  EXPECT_EQ(read("b.jsonl"), read("a.jsonl"));
}

// A kept binary lies beside its store, and a server has no such place.
TEST_F(ServerStore, KeepsNoEngines) {
  const cli::Ran pinned = track("pin v1");
  EXPECT_EQ(pinned.code, 2);
  EXPECT_NE(pinned.err.find("anchors in a file (--store FILE)"), std::string::npos) << pinned.err;
  EXPECT_THROW(Store::open(place, Mode::read), core::InputError);  // nothing was begun
}

// One recorder of a run at a time: a second that resumes it is refused while the first is alive.
TEST_F(ServerStore, HoldsARunThatIsRecorded) {
  Store first = Store::open(place, Mode::write), second = Store::open(place, Mode::write);
  const std::int64_t id = first.begin_run(run("r1"));
  EXPECT_TRUE(first.hold(id));
  EXPECT_FALSE(second.hold(id));
  EXPECT_TRUE(second.hold(id + 1));
}

TEST_F(ServerStore, RefusesWhatIsNoStore) {
  const std::size_t begin = place.find("@/") + 2;
  PostgresServer::only().sql(place.substr(begin, place.find('?') - begin),
                             "CREATE SCHEMA cylon; CREATE TABLE cylon.mine (x integer)");
  const cli::Ran ran = track("record projectile --engine in-house");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("not a store of Cylon; it was not changed"), std::string::npos) << ran.err;
}

using NoServer = cli::CommandLine;

TEST_F(NoServer, IsAClearError) {
  const cli::Ran ran = cylon("track list runs --store 'postgresql://me:secret@/db?host=/nowhere'");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("postgresql://me@/db?host=/nowhere"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("secret"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace cylon::store
