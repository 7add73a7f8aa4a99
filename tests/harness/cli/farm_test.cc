// Ranks that share a question: what is handed out, who owns a core, and the program under a real mpirun.
#include "harness/cli/farm.h"

#include "tests/harness/cli/fixture.h"
#include "tests/harness/cli/without_times.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

namespace cylon::cli {
namespace {

using nlohmann::json;

TEST(Farm, HandsOutFewUnitsAtOnceAndOneInTheEnd) {
  for (const std::size_t ranks : {1, 2, 7, 10'000}) {
    std::size_t left = 100'000, answers = 0;
    while (left > 0) {
      const std::size_t units = units_at_once(left, ranks);
      ASSERT_GE(units, 1u);
      ASSERT_LE(units, 16u);
      // No rank gets more than a 64th of what each has to do still, but one.
      if (units > 1) {
        ASSERT_LE(units * 64 * ranks, left);
      }
      left -= units, ++answers;
    }
    EXPECT_EQ(units_at_once(1, ranks), 1u);
    EXPECT_EQ(units_at_once(128 * ranks - 1, ranks), 1u);
    if (ranks == 2) {
      EXPECT_LT(answers, 7'000u);
    }
  }
}

struct Owners {
  std::vector<Cores> ranks;
  std::vector<std::size_t> shares;
  std::string shared;
};

class CoresOfRanks : public testing::TestWithParam<Owners> {};

TEST_P(CoresOfRanks, AreCounted) {
  const auto& [ranks, shares, shared] = GetParam();
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    EXPECT_EQ(share_of_cores(ranks, i), shares[i]) << i;
    EXPECT_EQ(cores_from(to_text(ranks[i])), ranks[i]);
  }
  EXPECT_EQ(shared_core(ranks), shared);
}

const Owners owners[] = {
    {{{"a", {0, 1, 2, 3}}}, {4}, ""},
    {{{"a", {0, 1}}, {"a", {2, 3}}}, {2, 2}, ""},
    {{{"a", {0, 1, 2, 3}}, {"a", {0, 1, 2, 3}}}, {2, 2}, "ranks 0 and 1 share core 0 of a"},
    {{{"a", {5}}, {"b", {5}}, {"a", {6}}}, {1, 1, 1}, ""},
    {{{"a", {1}}, {"b", {3}}, {"b", {3, 4}}}, {1, 1, 1}, "ranks 1 and 2 share core 3 of b"},
    {{{"a", {0, 1}}, {"a", {0, 1}}, {"a", {0, 1}}}, {1, 1, 1}, "ranks 0 and 1 share core 0 of a"},
    {{{"a", {}}}, {1}, ""}};
INSTANTIATE_TEST_SUITE_P(All, CoresOfRanks, testing::ValuesIn(owners));

TEST(Cores, OfThisProcessAreThere) {
  const Cores own = own_cores();
  EXPECT_FALSE(own.host.empty());
  EXPECT_FALSE(own.cores.empty());
}

// ---- The program ----------------------------------------------------------------------------------------

bool mpi_is_here() {
  return std::filesystem::exists(std::filesystem::path(binary_dir) / "libcylon-mpi.so") &&
         std::system("command -v mpirun >/dev/null") == 0;  // NOLINT(concurrency-mt-unsafe)
}

class FarmOfRanks : public CommandLine {
 protected:
  void SetUp() override {
    if (!mpi_is_here()) GTEST_SKIP() << "no MPI here: apt-get install libopenmpi-dev openmpi-bin";
  }

  static constexpr const char* cells =
      "'heavy_top:projectile:bouncing_sphere:spring_chain' --engine in-house --engine bullet --engine ode ";
  // On two cores, as root, in a container.
  static constexpr const char* mpi =
      "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_btl_vader_single_copy_mechanism=none; ";

  Ran mpirun(const std::string& arguments) const {
    return shell(std::string(mpi) + "exec mpirun --oversubscribe " + arguments);
  }
};

TEST_F(FarmOfRanks, IsTheRunOfOneProcessByteForByte) {
  for (const auto& [asked, ranks] :
       {std::pair("", 2), std::pair("--metamorphic ", 3), std::pair("--theory ", 2)}) {
    shell("rm -rf .cylon one *.json *.csv *.xml");
    const std::string command = "run " + std::string(cells) + asked;
    const Ran one =
        shell("mkdir one; cd one; exec cylon " + command + "--json ../one.json --csv ../one.csv -j1");
    const Ran all =
        mpirun("-n " + std::to_string(ranks) + " cylon farm " + command + "--json all.json --csv all.csv");
    EXPECT_EQ(all.code, one.code) << all.err;
    EXPECT_EQ(without_times(read("all.json")), without_times(read("one.json"))) << all.err;
    EXPECT_EQ(all.out, one.out);
    EXPECT_NE(all.err.find("12 of 12 to do"), std::string::npos) << all.err;
    // One journal is left, which holds all.
    EXPECT_EQ(shell("ls .cylon").out, "journal.jsonl\n");
    const Ran again = mpirun("-n 2 cylon farm " + command + "--resume --json again.json");
    EXPECT_NE(again.err.find("0 of 12 to do"), std::string::npos) << again.err;
    EXPECT_EQ(without_times(read("again.json")), without_times(read("one.json")));
  }
}

TEST_F(FarmOfRanks, SharesSweepsAndSearches) {
  const std::tuple<const char*, const char*, int> rows[] = {
      {"trade",
       "'heavy_top:projectile:spring_orbit' --engine in-house/integrator=rk4 --engine ode --steps 4 --rounds "
       "0",
       0},
      {"limits", "'spring' turn --engine bullet --engine ode", 0},
      {"hunt", "--engine in-house --engine ode --scenes projectile --count 9", 0}};
  for (const auto& [command, asked, code] : rows) {
    shell("rm -rf .cylon one; mkdir one");
    const std::string line = std::string(command) + " " + asked;
    shell("cd one; exec cylon " + line + " --json ../one.json");
    const Ran ran = mpirun("-n 2 cylon farm " + line + " --json all.json");
    EXPECT_EQ(ran.code, code) << ran.err;
    json one = json::parse(read("one.json")), all = json::parse(read("all.json"));
    for (json* whole : {&one, &all}) whole->erase("provenance"), whole->erase("times");
    EXPECT_EQ(all, one) << command;
  }
}

// A rank that dies ends the job; the next start, with another number of ranks, loses and repeats no cell.
TEST_F(FarmOfRanks, GoesOnWhereARankDied) {
  const std::string command = "run " + std::string(cells) + "--dt 1/240 --dt 1/480 --dt 1/960 ";
  const Ran one = shell("mkdir one; cd one; exec cylon " + command + "--json ../one.json");
  const Ran died = shell(std::string(mpi) + R"sh(
    mpirun --oversubscribe -n 2 cylon farm )sh" +
                         command + R"sh( & job=$!
    while ! grep -q '"cell"' .cylon/journal-rank-2-of-2.jsonl 2>/dev/null; do
      kill -0 $job || exit 3
      sleep 0.01
    done
    for rank in $(pgrep -x cylon); do
      [ "$(readlink /proc/$rank/cwd)" = "$PWD" ] && tr '\0' '\n' </proc/$rank/environ | grep -q '^OMPI_COMM_WORLD_RANK=1$' &&
        kill -9 $rank
    done
    wait $job)sh");
  EXPECT_NE(died.code, 3) << "the farm ended before its rank was killed";
  EXPECT_NE(died.code, one.code) << died.err;
  const auto done = [&] {
    std::multiset<std::string> names;
    std::istringstream lines(shell("cat .cylon/journal*.jsonl").out);
    for (std::string line; std::getline(lines, line);)
      if (const json object = json::parse(line, nullptr, false);
          object.is_object() && object.contains("cell"))
        names.insert(object.at("cell").get<std::string>());
    return names;
  };
  const auto before = done();
  EXPECT_FALSE(before.empty());
  const Ran rest = mpirun("-n 3 cylon farm " + command + "--resume --json all.json");
  EXPECT_EQ(rest.code, one.code) << rest.err;
  EXPECT_NE(rest.err.find(std::to_string(36 - before.size()) + " of 36 to do"), std::string::npos)
      << rest.err;
  EXPECT_EQ(without_times(read("all.json")), without_times(read("one.json")));
  const auto after = done();
  EXPECT_EQ(after.size(), 36u);
  EXPECT_EQ(std::set<std::string>(after.begin(), after.end()).size(), 36u);
}

TEST_F(FarmOfRanks, RefusesWhatItCannotShare) {
  shell("mkdir a b");
  const std::pair<const char*, const char*> rows[] = {
      {"-n 2 cylon farm list", "cylon farm shares out"},
      {"-n 2 cylon farm", "cylon farm shares out"},
      {"-n 2 cylon farm run projectile --engin ode", "did you mean '--engine'"},
      {"-n 2 cylon farm run projectile --shard 1/2", "hands out the work itself"},
      {"-n 2 cylon farm run projectile --html page.html", "a farm keeps verdicts and no motions"},
      {"-n 2 cylon farm run nothing_like_it", "nothing_like_it"},
      {"-n 2 cylon farm advise projectile", "of `cylon advise --verify` alone"},
      {"-n 2 -x SLURM_ARRAY_TASK_ID=1 -x SLURM_ARRAY_TASK_COUNT=2 -x SLURM_ARRAY_TASK_MIN=1 cylon farm run "
       "projectile",
       "a farm is one job"},
      {"-n 1 cylon farm run projectile : -n 1 cylon farm run heavy_top", "has other scenarios"},
      {"-n 1 -wdir a cylon farm run projectile : -n 1 -wdir b cylon farm run projectile", "another folder"},
      {"--bind-to none -n 2 cylon farm trade projectile --engine ode --steps 3", "share core"},
      {"--bind-to none -n 2 cylon farm matrix projectile --engine ode", "`cylon matrix` measures times"},
      {"--bind-to none -n 2 cylon farm advise --verify projectile",
       "`cylon advise --verify` measures times"}};
  for (const auto& [arguments, why] : rows) {
    const Ran ran = mpirun(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << ran.err;
    EXPECT_NE(ran.err.find(why), std::string::npos) << arguments << ran.err;
  }
}

// Ranks with a core each may be timed; the times are those of `trade`.
TEST_F(FarmOfRanks, TimesRanksThatOwnACore) {
  if (own_cores().cores.size() < 2) GTEST_SKIP() << "one core is here";
  const Ran ran = mpirun(
      "--bind-to core -n 2 cylon farm trade 'projectile:spring_orbit' --engine ode --steps 2 --rounds 1 "
      "--json all.json");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(json::parse(read("all.json")).contains("times"));
}

using FarmWithoutMpi = CommandLine;

TEST_F(FarmWithoutMpi, SaysWhatBringsIt) {
  shell("mkdir bin; cp \"$(command -v cylon)\" bin/cylon");  // beside which no library lies
  const Ran ran = shell("exec bin/cylon farm run projectile");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("apt-get install libopenmpi-dev openmpi-bin"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace cylon::cli
