// Work that several processes share, and the union of what they did.
#include "harness/cli/part.h"
#include "harness/core/input_error.h"
#include "tests/harness/cli/fixture.h"
#include "tests/harness/cli/without_times.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <regex>

namespace cylon::cli {
namespace {

using nlohmann::json;

std::vector<Unit> some_units(std::size_t count) {
  std::vector<Unit> units;
  for (std::size_t i = 0; i < count; ++i)
    units.push_back({"key/" + std::to_string(i * i + 7), "unit " + std::to_string(i)});
  return units;
}

Durations some_durations(std::size_t count) {
  std::mt19937 bits(5);
  Durations known;
  for (std::size_t i = 0; i < count; i += 1 + (i % 7 == 3))  // some are not known
    known["unit " + std::to_string(i)] = 0.01 * std::exp(8.0 * static_cast<double>(bits()) / 4294967296.0);
  return known;
}

TEST(Shards, GiveEachUnitToOne) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 40U})
    for (const bool by_time : {false, true}) {
      const std::vector<Unit> units = some_units(200);
      std::vector<int> owners(units.size());
      for (std::size_t index = 1; index <= count; ++index) {
        const auto own = part_of({index, count, by_time, ""}, units, some_durations(200));
        for (std::size_t i = 0; i < units.size(); ++i) owners[i] += own[i];
      }
      EXPECT_EQ(std::ranges::count(owners, 1), 200) << count << by_time;
    }
}

TEST(Shards, DoNotDependOnTheOrderOfUnits) {
  std::vector<Unit> units = some_units(100);
  const Durations known = some_durations(100);
  const auto owned = [&](bool by_time) {
    std::map<std::string, bool> by_name;
    const auto own = part_of({2, 5, by_time, ""}, units, known);
    for (std::size_t i = 0; i < units.size(); ++i) by_name[units[i].name] = own[i];
    return by_name;
  };
  const auto hash = owned(false), time = owned(true);
  std::mt19937 bits(3);
  std::ranges::shuffle(units, bits);
  EXPECT_EQ(owned(false), hash);
  EXPECT_EQ(owned(true), time);
  EXPECT_NE(hash, time);
}

// Graham's bound: no part takes more than 4/3 - 1/(3n) of the best; the best is at least the mean part and the
// longest unit.
TEST(Shards, ByTimeAreOfEqualDurations) {
  const std::vector<Unit> units = some_units(60);
  Durations known;
  for (std::size_t i = 0; i < units.size(); ++i) known[units[i].name] = 1 + static_cast<double>(i * i % 41);
  double total = 0, longest = 0;
  for (const auto& [name, seconds] : known) total += seconds, longest = std::max(longest, seconds);
  for (const std::size_t count : {2U, 3U, 8U, 50U}) {
    const double best = std::max(total / static_cast<double>(count), longest);
    double most = 0;
    for (std::size_t index = 1; index <= count; ++index) {
      const auto own = part_of({index, count, true, ""}, units, known);
      double seconds = 0;
      for (std::size_t i = 0; i < units.size(); ++i)
        if (own[i]) seconds += known[units[i].name];
      most = std::max(most, seconds);
    }
    EXPECT_LE(most, best * 4 / 3) << count;
  }
}

struct Surroundings {
  std::map<std::string, std::string> variables;
  std::string option, said;  // "2/8", or part of the error
};

class ShardOfEnvironment : public testing::TestWithParam<Surroundings> {};

TEST_P(ShardOfEnvironment, IsRead) {
  constexpr const char* all[] = {"GTEST_SHARD_INDEX",    "GTEST_TOTAL_SHARDS",   "TEST_SHARD_INDEX",
                                 "TEST_TOTAL_SHARDS",    "SLURM_ARRAY_TASK_ID",  "SLURM_ARRAY_TASK_COUNT",
                                 "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP"};
  std::map<std::string, std::string> before;
  for (const char* name : all) {
    if (const char* value = std::getenv(name)) before[name] = value;
    ::unsetenv(name);
  }
  for (const auto& [name, value] : GetParam().variables) ::setenv(name.c_str(), value.c_str(), 1);
  std::string said;
  try {
    const auto shard = shard_asked({.shard = GetParam().option});
    said = shard ? std::to_string(shard->index) + "/" + std::to_string(shard->count) : "all";
  } catch (const core::InputError& error) {
    said = error.what();
  }
  EXPECT_NE(said.find(GetParam().said), std::string::npos) << said;
  for (const char* name : all) ::unsetenv(name);
  for (const auto& [name, value] : before) ::setenv(name.c_str(), value.c_str(), 1);
}

const Surroundings surroundings[] = {
    {{}, "", "all"},
    {{}, "3/8", "3/8"},
    {{}, "1/1", "1/1"},
    {{}, "0/8", "not k/n"},
    {{}, "9/8", "not k/n"},
    {{}, "3", "not k/n"},
    {{}, "3/", "not k/n"},
    {{}, "-1/3", "not k/n"},
    {{}, "1/3/5", "not k/n"},
    {{}, "1/99999999999999999999", "not k/n"},
    {{{"GTEST_SHARD_INDEX", "0"}, {"GTEST_TOTAL_SHARDS", "4"}}, "", "1/4"},
    {{{"GTEST_SHARD_INDEX", "0"}, {"GTEST_TOTAL_SHARDS", "4"}}, "2/3", "2/3"},
    {{{"GTEST_SHARD_INDEX", "4"}, {"GTEST_TOTAL_SHARDS", "4"}}, "", "is no index of GTEST_TOTAL_SHARDS = 4"},
    {{{"GTEST_SHARD_INDEX", "x"}, {"GTEST_TOTAL_SHARDS", "4"}}, "", "not a whole number"},
    {{{"TEST_SHARD_INDEX", "2"}, {"TEST_TOTAL_SHARDS", "4"}}, "", "3/4"},
    // Half of what a runner sets: each of its processes would do all, and none would say so.
    {{{"TEST_SHARD_INDEX", "2"}}, "", "TEST_SHARD_INDEX = '2', but TEST_TOTAL_SHARDS is not set"},
    {{{"GTEST_SHARD_INDEX", "1"}}, "", "GTEST_SHARD_INDEX = '1', but GTEST_TOTAL_SHARDS is not set"},
    {{{"GTEST_TOTAL_SHARDS", "4"}}, "", "GTEST_TOTAL_SHARDS = '4', but GTEST_SHARD_INDEX is not set"},
    {{{"GTEST_TOTAL_SHARDS", "4"}}, "2/3", "2/3"},
    {{{"TEST_TOTAL_SHARDS", "abc"}}, "", "TEST_TOTAL_SHARDS = 'abc', but TEST_SHARD_INDEX is not set"},
    {{{"TEST_SHARD_INDEX", ""}, {"TEST_TOTAL_SHARDS", ""}}, "", "all"},
    {{{"SLURM_ARRAY_TASK_ID", "3"}}, "", "SLURM_ARRAY_TASK_ID = '3', but SLURM_ARRAY_TASK_COUNT is not set"},
    {{{"SLURM_ARRAY_TASK_COUNT", "3"}},
     "",
     "SLURM_ARRAY_TASK_COUNT = '3', but SLURM_ARRAY_TASK_ID is not set"},
    {{{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}, {"SLURM_ARRAY_TASK_MAX", "8"}}, "", "3/8"},
    {{{"SLURM_ARRAY_TASK_ID", "6"},
      {"SLURM_ARRAY_TASK_MIN", "2"},
      {"SLURM_ARRAY_TASK_MAX", "9"},
      {"SLURM_ARRAY_TASK_STEP", "2"}},
     "",
     "3/4"},
    {{{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_MIN", "1"}, {"SLURM_ARRAY_TASK_MAX", "8"}},
     "",
     "SLURM_ARRAY_TASK_ID = 9 is no index"},
    {{{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}, {"SLURM_ARRAY_TASK_MAX", "x"}},
     "",
     "SLURM_ARRAY_TASK_MAX = 'x': not a whole number"},
    {{{"SLURM_ARRAY_TASK_ID", "1"},
      {"SLURM_ARRAY_TASK_COUNT", "3"},
      {"SLURM_ARRAY_TASK_MIN", "1"},
      {"SLURM_ARRAY_TASK_MAX", "7"}},
     "",
     "has gaps"},
    {{{"SLURM_ARRAY_TASK_ID", "7"}, {"SLURM_ARRAY_TASK_COUNT", "4"}, {"SLURM_ARRAY_TASK_MIN", "5"}},
     "",
     "3/4"},
    {{{"SLURM_ARRAY_TASK_ID", "10"},
      {"SLURM_ARRAY_TASK_COUNT", "4"},
      {"SLURM_ARRAY_TASK_MIN", "0"},
      {"SLURM_ARRAY_TASK_STEP", "5"}},
     "",
     "3/4"},
    {{{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}},
     "",
     "has gaps"},
    {{{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "2"}},
     "",
     "has gaps"},
    {{{"GTEST_SHARD_INDEX", "0"},
      {"GTEST_TOTAL_SHARDS", "4"},
      {"SLURM_ARRAY_TASK_ID", "2"},
      {"SLURM_ARRAY_TASK_COUNT", "4"}},
     "",
     "GTEST_SHARD_INDEX says shard 1 of 4, and SLURM_ARRAY_TASK_ID says 3 of 4"}};
INSTANTIATE_TEST_SUITE_P(All, ShardOfEnvironment, testing::ValuesIn(surroundings));

// ---- The program ----------------------------------------------------------------------------------------

class Merge : public CommandLine {
 protected:
  static constexpr const char* cells =
      "'heavy_top:projectile:bouncing_sphere:spring_chain' --engine in-house --engine bullet --engine ode ";

  /// Each in a folder of its own, as on machines of their own.
  void run_shards(const std::string& command, int count) const {
    for (int k = 1; k <= count; ++k) {
      const std::string line = command + " --shard " + std::to_string(k) + "/" + std::to_string(count);
      const Ran ran =
          shell("mkdir -p m" + std::to_string(k) + "; cd m" + std::to_string(k) + "; exec cylon " + line);
      EXPECT_TRUE(ran.code == 0 || ran.code == 1) << line << ran.err;
    }
  }
};

// JUnit XML without what differs each time.
std::string untimed(const std::string& xml) {
  return std::regex_replace(xml, std::regex(" time=\"[0-9.]*\""), "");
}

TEST_F(Merge, IsTheRunOfOneProcessByteForByte) {
  for (const std::string& asked : {std::string(), std::string("--metamorphic "), std::string("--theory ")}) {
    shell("rm -rf .cylon m* *.json *.xml");
    const std::string command = "run " + std::string(cells) + asked;
    const Ran one =
        shell("mkdir one; cd one; exec cylon " + command + "--json ../one.json --junit ../one.xml -j1");
    run_shards(command + "-j2", 3);
    const Ran all =
        cylon("merge m2/.cylon/*.jsonl m3/.cylon/*.jsonl m1/.cylon/*.jsonl --json all.json --junit all.xml");
    EXPECT_EQ(all.code, one.code) << all.err;
    EXPECT_EQ(without_times(read("all.json")), without_times(read("one.json")));
    EXPECT_EQ(untimed(read("all.xml")), untimed(read("one.xml")));
    EXPECT_EQ(all.out, one.out);
    // The same from the command itself, which finds nothing left to do.
    const Ran again = cylon(command + "--resume --json again.json");
    EXPECT_EQ(again.code, one.code) << again.err;
    EXPECT_NE(again.err.find("resumed: 12 of 12"), std::string::npos) << again.err;
    EXPECT_EQ(without_times(read("again.json")), without_times(read("one.json")));
    shell("rm -r one");
  }
}

TEST_F(Merge, IsAnIdempotentUnion) {
  run_shards("run " + std::string(cells), 3);
  cylon("merge m1/.cylon/*.jsonl m2/.cylon/*.jsonl m3/.cylon/*.jsonl");
  const std::string whole = read(".cylon/journal.jsonl");
  for (const char* files : {"m3/.cylon/*.jsonl m1/.cylon/*.jsonl m2/.cylon/*.jsonl", ".cylon/journal.jsonl",
                            ".cylon/journal.jsonl m2/.cylon/*.jsonl m2/.cylon/*.jsonl"}) {
    const Ran ran = cylon("merge " + std::string(files));
    EXPECT_EQ(read(".cylon/journal.jsonl"), whole) << files << ran.err;
  }
}

TEST_F(Merge, ListsWhatIsMissing) {
  run_shards("run " + std::string(cells), 3);
  const Ran part = cylon("merge m1/.cylon/*.jsonl m3/.cylon/*.jsonl");
  EXPECT_EQ(part.code, 6) << part.err;
  EXPECT_NE(part.err.find("of 12 are there"), std::string::npos) << part.err;
  EXPECT_NE(part.err.find("missing:"), std::string::npos);
  std::size_t held = 0;
  std::istringstream lines(read("m2/.cylon/journal-2-of-3.jsonl"));
  for (std::string line; std::getline(lines, line);)
    if (const json object = json::parse(line); object.contains("cell")) {
      ++held;
      EXPECT_NE(part.err.find(object.at("cell").get<std::string>()), std::string::npos) << part.err;
    }
  EXPECT_GT(held, 0u);
  // The command itself does what is missing.
  const Ran rest = cylon("run " + std::string(cells) + "--resume");
  EXPECT_EQ(rest.err.find("resumed: 12"), std::string::npos) << rest.err;
  EXPECT_EQ(cylon("merge .cylon/journal.jsonl").code, rest.code);
}

TEST_F(Merge, FindsWhatComesOutOtherwise) {
  run_shards("run " + std::string(cells), 2);
  shell(
      "cp m1/.cylon/journal-1-of-2.jsonl other.jsonl; "
      "sed -i 's/\\\\\"measured\\\\\": *[0-9.e-]*/\\\\\"measured\\\\\":3.5/' other.jsonl");
  ASSERT_NE(read("other.jsonl"), read("m1/.cylon/journal-1-of-2.jsonl"));
  const Ran ran = cylon("merge m1/.cylon/*.jsonl m2/.cylon/*.jsonl other.jsonl");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("the same input gave other results:"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("/measured is "), std::string::npos) << ran.err;
  // Times may differ.
  shell(
      "sed 's/\\\\\"cpu_seconds\\\\\": *[0-9.e-]*/\\\\\"cpu_seconds\\\\\":3.5/; "
      "s/\"seconds\":[0-9.e-]*/\"seconds\":3/' "
      "m1/.cylon/journal-1-of-2.jsonl > other.jsonl");
  const Ran same = cylon("merge m1/.cylon/*.jsonl m2/.cylon/*.jsonl other.jsonl");
  EXPECT_EQ(same.err.find("other results"), std::string::npos) << same.err;
}

TEST_F(Merge, RefusesWhatBelongsToSomethingElse) {
  run_shards("run " + std::string(cells), 2);
  shell("mkdir x y; cd x; cylon run projectile --engine in-house; cd ../y; cylon limits spring --engine ode");
  write("stranger.txt", "not a journal\n");
  write("scene.jsonl", R"({"part": {"command": "../evil", "index": 1, "count": 1}, "units": []})"
                       "\n");
  const std::pair<const char*, const char*> rows[] = {
      {"m1/.cylon/*.jsonl x/.cylon/*.jsonl", "they are not parts of one question"},
      {"m1/.cylon/*.jsonl y/.cylon/*.jsonl", "is of `cylon run`, y/.cylon/limits.jsonl of `cylon limits`"},
      {"stranger.txt", "no journal that can be merged"},
      {"scene.jsonl", "no journal that can be merged"},
      {"nowhere.jsonl", "nowhere.jsonl"},
      {"y/.cylon/limits.jsonl --json out.json", "`cylon limits … --resume`"}};
  for (const auto& [arguments, why] : rows) {
    const Ran ran = cylon("merge " + std::string(arguments));
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_NE(ran.err.find(why), std::string::npos) << arguments << ran.err;
  }
  // Another content under the same name.
  write("projectile.toml", shipped("projectile"));
  shell(
      "mkdir a b; cd a; cylon run ../projectile.toml --engine in-house; sed -i 's/^duration.*/duration = "
      "0.5/' "
      "../projectile.toml; cd ../b; cylon run ../projectile.toml --engine in-house");
  const Ran ran = cylon("merge a/.cylon/*.jsonl b/.cylon/*.jsonl");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("is another scenario, engine, build of cylon or list of expectations"),
            std::string::npos)
      << ran.err;
}

// Who judged is part of the question: another build of cylon neither goes on with a journal nor joins it.
TEST_F(Merge, RefusesWhatAnotherBuildJudged) {
  shell("mkdir one two; cp \"$(command -v cylon)\" other; echo >> other");
  const std::string places = "CYLON_WORKERS='" + std::string(binary_dir) + "' CYLON_SCENARIOS='" +
                             std::string(source_dir) + "/scenarios" + "' ";
  const std::string question = "run projectile:heavy_top --engine in-house --shard ";
  const Ran mine = shell("cd one; exec cylon " + question + "1/2");
  const Ran theirs = shell("cd two; " + places + "exec ../other " + question + "2/2");
  ASSERT_EQ(mine.code, 0) << mine.err;
  ASSERT_EQ(theirs.code, 0) << theirs.err;
  const Ran merged = cylon("merge one/.cylon/*.jsonl two/.cylon/*.jsonl");
  EXPECT_EQ(merged.code, 2) << merged.err;
  cylon("run projectile --engine in-house");
  const Ran again = shell(places + "exec ./other run projectile --engine in-house --resume");
  EXPECT_NE(again.err.find("resumed: 0 of 1"), std::string::npos) << again.err;
}

// Whatever a stranger writes into a journal is left out and counted, or refused.
TEST_F(Merge, SurvivesHostileJournals) {
  cylon("run projectile --engine in-house");
  const std::string good = read(".cylon/journal.jsonl");
  const std::string deep(1000, '[');
  const std::string lines[] = {"{}",
                               "[]",
                               "7",
                               deep,
                               R"({"key": 5, "verdicts": []})",
                               R"({"key": "a"})",
                               R"({"key": "a", "verdicts": 5})",
                               R"({"key": "a", "verdicts": [5]})",
                               R"({"key": "a", "verdicts": ["{}"]})",
                               R"({"key": "a", "verdicts": [")" + deep + R"("]})",
                               R"({"key": "a", "cell": {}, "verdicts": []})"};
  for (const std::string& line : lines) {
    write("hostile.jsonl", good + line + "\n");
    const Ran ran = cylon("merge hostile.jsonl");
    EXPECT_EQ(ran.code, 0) << line << ran.err;
    EXPECT_NE(ran.err.find("1 lines are cut off"), std::string::npos) << line << ran.err;
  }
  for (const char* part :
       {R"({"part": 1})", R"({"part": {"command": 1, "index": 1, "count": 1}, "units": []})",
        R"({"part": {"command": "run", "index": 1, "count": 1}, "units": [1]})"}) {
    write("hostile.jsonl", std::string(part) + "\n");
    EXPECT_EQ(cylon("merge hostile.jsonl").code, 2) << part;
  }
}

TEST_F(Merge, JoinsSweepsAndSearches) {
  const std::pair<const char*, const char*> rows[] = {
      {"trade",
       "'heavy_top:projectile:spring_orbit' --engine in-house/integrator=rk4 --engine ode --steps 4 --rounds "
       "0"},
      {"matrix", "'heavy_top:projectile:spring_orbit' --engine bullet --finest 1e-2 --rounds 0"},
      {"limits", "'spring' turn --engine bullet --engine ode"}};
  for (const auto& [command, asked] : rows) {
    shell("rm -rf m* .cylon one; mkdir one");
    const std::string line = std::string(command) + " " + asked;
    shell("cd one; exec cylon " + line + " --json ../one.json");
    run_shards(line, 2);
    const Ran merged = cylon("merge m2/.cylon/*.jsonl m1/.cylon/*.jsonl");
    EXPECT_EQ(merged.code, 0) << command << merged.err;
    const Ran again = cylon(line + " --resume --json all.json");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(again.err.find("resumed: 0 "), std::string::npos) << again.err;
    json one = json::parse(read("one.json")), all = json::parse(read("all.json"));
    for (json* whole : {&one, &all}) whole->erase("provenance"), whole->erase("times");
    EXPECT_EQ(all, one) << command;
  }
}

// Its answer follows from times, so that the union tells what the shard told; a hunt is in hunt_command_test.cc.
TEST_F(Merge, JoinsVerifiedAdvice) {
  const std::string asked =
      "advise --verify projectile --engine ode --tolerance 1e-1 --work 20000 --rounds 1 -j 1 ";
  std::vector<std::string> told;
  for (const char* part : {"1", "2"}) {
    const std::string place = "m" + std::string(part);  // no other cylon that measures times is waited for
    const Ran ran =
        shell(fmt::format("mkdir {0}; cd {0}; TMPDIR=. exec cylon {1}--shard {2}/2", place, asked, part));
    EXPECT_TRUE(ran.code == 0 || ran.code == 1) << ran.err;
    if (ran.out.find("projectile") != std::string::npos) told.push_back(ran.out);
  }
  ASSERT_EQ(told.size(), 1u);
  const Ran merged = cylon("merge m2/.cylon/*.jsonl m1/.cylon/*.jsonl");
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(cylon(asked + "--resume").out, told.front());
}

TEST_F(Merge, MayFollowDurations) {
  const std::string command = "run " + std::string(cells);
  const Ran unknown = cylon(command + "--shard 1/2 --shard-by time");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find(".cylon/journal.jsonl has no durations"), std::string::npos) << unknown.err;
  const Ran one = cylon(command);
  shell("for k in 1 2 3; do mkdir m$k; cp -r .cylon m$k; done");
  // A journal is bound to its folder: durations are those of a run here.
  for (const char* k : {"1", "2", "3"})
    EXPECT_NE(cylon(command + "--shard " + k + "/3 --shard-by time").code, 2);
  const Ran all = cylon("merge .cylon/journal-*-of-3.jsonl");
  EXPECT_EQ(all.code, one.code) << all.err;
  EXPECT_EQ(all.out, one.out);
}

TEST_F(Merge, AShardWithoutAJournalIsAnError) {
  shell("touch .cylon");
  const Ran ran = cylon("run projectile --engine in-house --shard 1/1");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("a shard is its journal"), std::string::npos) << ran.err;
}

TEST_F(Merge, AnEmptyShardIsNoError) {
  const Ran ran = shell(
      "GTEST_SHARD_INDEX=9 GTEST_TOTAL_SHARDS=1000 GTEST_SHARD_STATUS_FILE=told exec cylon run "
      "projectile --engine in-house");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("shard 10 of 1000 (GTEST_SHARD_INDEX): 0 of 1"), std::string::npos) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "told"));
}

}  // namespace
}  // namespace cylon::cli
