// `cylon merge` beside the run of one process: what counts as another result, what is kept, and what is listed.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

namespace cylon::cli {
namespace {

using nlohmann::json;

class MergeOfParts : public CommandLine {
 protected:
  void SetUp() override { shell("mkdir a b"); }
  Ran in(const std::string& place, const std::string& arguments) const {
    return shell("cd " + place + "; exec cylon " + arguments);
  }
  std::vector<json> lines_of(const std::string& journal) const {
    std::vector<json> all;
    std::istringstream lines(read(journal));
    for (std::string line; std::getline(lines, line);) all.push_back(json::parse(line));
    return all;
  }
};

// The command for a row names the file as the user did.
TEST_F(MergeOfParts, TakesOneFileUnderTwoPathsForOne) {
  write("mine.toml", shipped("projectile"));
  write("b/mine.toml", shipped("projectile"));
  ASSERT_EQ(in("a", "run ../mine.toml --engine in-house --shard 1/1").code, 0);
  ASSERT_EQ(in("b", "run mine.toml --engine in-house --shard 1/1").code, 0);
  const Ran ran = cylon("merge a/.cylon/*.jsonl b/.cylon/*.jsonl");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err.find("other results"), std::string::npos) << ran.err;
}

// What a worker says on stderr holds its process id; how it ended is what must come out again.
TEST_F(MergeOfParts, LooksAtHowAWorkerEndedAndNotAtItsLastWords) {
  const auto merged = [&](const std::string& first, const std::string& second) {
    const std::string asked = "run projectile --engine mine --worker 'mine=sh ../engine.sh' --shard 1/1";
    write("engine.sh", "echo \"process $$ gives up\" >&2; . ./how.sh\n");
    write("a/how.sh", first);
    write("b/how.sh", second);
    for (const char* place : {"a", "b"}) EXPECT_EQ(in(place, asked).code, 5);
    EXPECT_NE(read("a/.cylon/journal-1-of-1.jsonl").find(" gives up"), std::string::npos);
    return cylon("merge a/.cylon/*.jsonl b/.cylon/*.jsonl");
  };
  const Ran same = merged("exit 3", "exit 3");
  EXPECT_EQ(same.code, 5) << same.err;
  EXPECT_EQ(same.err.find("other results"), std::string::npos) << same.err;
  shell("rm -r .cylon");
  const Ran other = merged("exit 3", "exit 4");
  EXPECT_NE(other.err.find("other results"), std::string::npos) << other.err;
  EXPECT_NE(other.err.find("exited 4"), std::string::npos) << other.err;
}

TEST_F(MergeOfParts, HoldsScenesThatClaimNothing) {
  const std::string text = shipped("projectile");
  write("bare.toml", text.substr(0, text.find("[[claim]]")));
  const std::string asked = "run bare.toml projectile --engine in-house ";
  for (const char* part : {"1/2", "2/2"}) EXPECT_EQ(cylon(asked + "--shard " + part).code, 0);
  const Ran ran = cylon("merge .cylon/journal-*-of-2.jsonl");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("2 of 2 are there"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("nothing is judged of:\n  bare in-house"), std::string::npos) << ran.err;
  EXPECT_NE(cylon(asked + "--resume").err.find("resumed: 2 of 2"), std::string::npos);
  // Alone it is no success, as in one process.
  ASSERT_EQ(in("a", "run ../bare.toml --engine in-house --shard 1/1").code, 0);
  EXPECT_EQ(in("a", "merge .cylon/journal-1-of-1.jsonl").code, 4);
}

// An empty list stands for a cell whose scenario claims nothing, and for no other.
TEST_F(MergeOfParts, AClaimThatHasNoVerdictIsRunAgain) {
  ASSERT_EQ(cylon("run projectile --engine in-house --shard 1/1").code, 0);
  const std::string journal = ".cylon/journal-1-of-1.jsonl";
  std::string stripped;
  for (json line : lines_of(journal)) {
    if (line.contains("verdicts")) line["verdicts"] = json::array();
    stripped += line.dump() + "\n";
  }
  write(journal, stripped);
  EXPECT_EQ(cylon("merge " + journal).code, 4);
  const Ran again = cylon("run projectile --engine in-house --resume");
  EXPECT_NE(again.err.find("resumed: 0 of 1"), std::string::npos) << again.err;
  EXPECT_NE(again.out.find(" verdicts: "), std::string::npos) << again.out;
}

TEST_F(MergeOfParts, HoldsPublishedNumbersAgainstTheWhole) {
  shell("cp -r '" + std::string(source_dir) +
        "/scenarios' changed; sed -i 's/\"185.027\"/\"186.027\"/' changed/suites/simbenchmark.toml");
  const auto with_changed = [&](const std::string& arguments) {
    return shell("export CYLON_SCENARIOS=\"$PWD/changed\"; exec cylon " + arguments);
  };
  const std::string asked = "run --suite simbenchmark ";
  for (const char* part : {"1/2", "2/2"}) with_changed(asked + "--shard " + part);
  const Ran half = with_changed("merge .cylon/journal-1-of-2.jsonl");
  EXPECT_EQ(half.code, 6) << half.err;
  EXPECT_EQ(half.out.find("published numbers"), std::string::npos) << half.out;
  const Ran all = with_changed("merge .cylon/journal-*-of-2.jsonl");
  EXPECT_EQ(all.code, 1) << all.err;
  EXPECT_NE(all.out.find("DIFFERS"), std::string::npos) << all.out;
  const Ran again = with_changed("merge .cylon/journal.jsonl");  // the union knows the suite
  EXPECT_EQ(again.code, all.code) << again.err;
  EXPECT_EQ(again.out, all.out);
  const Ran one = with_changed(asked + "--resume");
  EXPECT_EQ(one.code, all.code) << one.err;
  EXPECT_EQ(one.out, all.out);
  shell(R"(sed 's|"suite":"simbenchmark"|"suite":"../elsewhere"|' .cylon/journal.jsonl > suite.jsonl)");
  const Ran unknown = cylon("merge suite.jsonl");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("no such suite"), std::string::npos) << unknown.err;
}

// Missing cells are data: all of them are told, and their exit code is that of no verdict.
TEST_F(MergeOfParts, ListsAllThatIsMissingWhateverDiffers) {
  std::string asked = "run projectile --engine in-house --tolerance-scale 0 ";
  for (int n = 20; n < 80; ++n) asked += "--dt 1/" + std::to_string(5 * n) + " ";  // of 0.8 s
  const Ran part = cylon(asked + "--shard 1/2");
  ASSERT_NE(part.code, 0);
  const Ran ran = cylon("merge .cylon/journal-1-of-2.jsonl");
  EXPECT_EQ(ran.code, 6) << ran.err;
  std::vector<std::string> units, there;
  for (const json& line : lines_of(".cylon/journal-1-of-2.jsonl")) {
    if (line.contains("units"))
      for (const json& unit : line.at("units")) units.push_back(unit.at(1));
    if (line.contains("cell")) there.push_back(line.at("cell"));
  }
  ASSERT_FALSE(there.empty());
  ASSERT_GT(units.size(), there.size() + 20);
  for (const std::string& unit : units)
    EXPECT_EQ(ran.err.find("\n  " + unit + "\n") == std::string::npos, std::ranges::count(there, unit) == 1)
        << unit;
}

TEST_F(MergeOfParts, KeepsWhatTheFolderHasAlready) {
  const std::string asked = "run 'projectile:spring_orbit' --engine in-house --engine ode ";
  for (const char* part : {"1/2", "2/2"}) cylon(asked + "--shard " + part);
  EXPECT_EQ(cylon("merge .cylon/journal-*-of-2.jsonl").code, 0);
  const std::string whole = read(".cylon/journal.jsonl");
  for (const char* part : {"1", "2"}) {
    const Ran again = cylon("merge .cylon/journal-" + std::string(part) + "-of-2.jsonl");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(read(".cylon/journal.jsonl"), whole);
  }
  // Cells of another question stay, too; a union is of what its files ask.
  ASSERT_EQ(in("a", "run heavy_top --engine ode").code, 0);
  ASSERT_EQ(in("a", "merge ../.cylon/journal-*-of-2.jsonl").code, 0);
  const Ran other = in("a", "run heavy_top --engine ode --resume");
  EXPECT_NE(other.err.find("resumed: 1 of 1"), std::string::npos) << other.err;
  const Ran question = in("a", asked + "--resume");
  EXPECT_NE(question.err.find("resumed: 4 of 4"), std::string::npos) << question.err;
  // Somebody else's file in the journal's place is not taken: it does not fill in what one part lacks.  The
  // build decides which part has what, and one may have all.
  const auto cells_of = [&](const std::string& part) {
    return std::ranges::count_if(lines_of(".cylon/journal-" + part + "-of-2.jsonl"),
                                 [](const json& line) { return line.contains("cell"); });
  };
  const std::string lesser = cells_of("1") < cells_of("2") ? "1" : "2";
  shell("mkdir c; cp -r a/.cylon c");
  const Ran copied = in("c", "merge ../.cylon/journal-" + lesser + "-of-2.jsonl");
  EXPECT_EQ(copied.code, 6) << copied.err;
  EXPECT_NE(copied.err.find("not written by you in this folder"), std::string::npos) << copied.err;
}

}  // namespace
}  // namespace cylon::cli
