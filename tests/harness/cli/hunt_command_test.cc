// `cylon hunt` as a command: counts, resuming, scenarios to start from, replay, the history and the report.
#include "reports/gzip.h"
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

// Faults at once: Bullet without its gyroscopic term.
const std::string faulty = "hunt --engine bullet/gyro=none --scenes free_symmetric_top --seed 1 -j 2 ";

// Lines of a journal that hold an answer: each start adds one that says what is asked.
std::size_t answers_in(const std::string& journal) {
  std::istringstream lines(journal);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.find("\"hunt\":") != std::string::npos;
  return count;
}

class HuntCommand : public CommandLine {
 protected:
  std::set<std::string> endings(const fs::path& cards) const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder / cards))
      found.insert(entry.path().extension().string());
    return found;
  }
};

TEST_F(HuntCommand, GoesOnWhereItWasStopped) {
  const Ran first = cylon(faulty + "--count 1 --cards a");
  ASSERT_EQ(first.code, 1) << first.err;
  const std::size_t asked = answers_in(read(".cylon/hunt.jsonl"));
  ASSERT_GE(asked, 2u);  // a scene, and a least one
  const Ran again = cylon(faulty + "--count 1 --cards a --resume");
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(answers_in(read(".cylon/hunt.jsonl")), asked);  // nothing was asked again
  const Ran more = cylon(faulty + "--count 2 --cards b --resume"),
            whole = cylon(faulty + "--count 2 --cards b");
  EXPECT_EQ(more.out, whole.out);
  // Another seed asks another question.
  EXPECT_NE(read(".cylon/hunt.jsonl").find("seed 1 from 1 scenarios"), std::string::npos);
}

// Two units, of at most 8 scenes.
TEST_F(HuntCommand, OfPartsIsThatOfOneProcess) {
  const std::string command = faulty + "--count 9 ";
  const Ran one = shell("mkdir one; cd one; exec cylon " + command + "--json ../one.json");
  ASSERT_EQ(one.code, 1) << one.err;
  for (const char* part : {"1/3", "3/3", "2/3"}) {
    const Ran ran = cylon(command + "--shard " + part);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, "") << part;  // cards are made of all parts
  }
  // Each unit is missing without exactly one of the parts.
  int missing = 0;
  for (const char* two : {"1 3", "1 2", "2 3"}) {
    std::filesystem::remove(folder / ".cylon/hunt.jsonl");  // what the folder has is kept
    const Ran ran = cylon("merge " + std::string() + ".cylon/hunt-" + two[0] + "-of-3.jsonl .cylon/hunt-" +
                          two[2] + "-of-3.jsonl");
    const int there = std::atoi(ran.err.c_str());
    EXPECT_NE(ran.err.find(" of 2 are there"), std::string::npos) << ran.err;
    EXPECT_EQ(ran.code, there < 2 ? 6 : 0) << ran.err;
    missing += 2 - there;
  }
  EXPECT_EQ(missing, 2);
  const Ran whole = cylon("merge .cylon/hunt-1-of-3.jsonl .cylon/hunt-2-of-3.jsonl .cylon/hunt-3-of-3.jsonl");
  EXPECT_EQ(whole.code, 0) << whole.err;
  const std::size_t asked = answers_in(read(".cylon/hunt.jsonl"));
  EXPECT_EQ(asked, 9u);
  const Ran all = cylon(command + "--resume --json all.json");
  EXPECT_EQ(all.code, 1) << all.err;
  EXPECT_EQ(all.out, one.out);
  EXPECT_EQ(read("all.json"), read("one.json"));
  EXPECT_EQ(answers_in(read(".cylon/hunt.jsonl")), answers_in(read("one/.cylon/hunt.jsonl")));
}

TEST_F(HuntCommand, WritesCardsThatReplayAndAReport) {
  const Ran ran = cylon(faulty + "--count 1 --json hunt.json");
  ASSERT_EQ(ran.code, 1) << ran.err;
  EXPECT_EQ(endings("cards"), (std::set<std::string>{".toml", ".md", ".svg", ".cc"}));
  const Ran replayed = cylon("hunt --replay cards");
  EXPECT_EQ(replayed.code, 1);
  EXPECT_EQ(replayed.out.find("fixed"), std::string::npos) << replayed.out;
  EXPECT_NE(replayed.out.find("still there"), std::string::npos) << replayed.out;
  const Ran other = cylon("hunt --replay cards --engine in-house");
  EXPECT_EQ(other.code, 0) << other.out;

  const nlohmann::json document = nlohmann::json::parse(read("hunt.json"));
  ASSERT_FALSE(document["cards"].empty());
  ASSERT_EQ(cylon("report hunt.json --html hunt.html").code, 0);
  const std::string page = read("hunt.html"), open = "id=\"block-0\">";
  const std::size_t begin = page.find(open) + open.size(), end = page.find("</script>", begin);
  const auto index =
      nlohmann::json::parse(reports::gunzip(reports::from_base64(page.substr(begin, end - begin)), 1 << 28));
  EXPECT_EQ(index["hunts"], nlohmann::json::array({document}));
}

TEST_F(HuntCommand, TracksWhatBecomesOfCards) {
  ASSERT_EQ(cylon(faulty + "--count 1").code, 1);
  ASSERT_EQ(cylon("track cards cards --revision a").code, 0);
  const Ran other = cylon("track cards cards --engine in-house --revision b");
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_NE(other.out.find("fixed"), std::string::npos) << other.out;
  const Ran listed = cylon("track list");
  EXPECT_EQ(listed.code, 0) << listed.err;
  const Ran history = cylon("track history");
  EXPECT_NE(history.out.find("bullet/gyro=none"), std::string::npos) << history.out << history.err;
}

TEST_F(HuntCommand, StartsFromScenarios) {
  const Ran ran = cylon("hunt --engine in-house --scenes projectile --scenes 'spring_o*' --count 4");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("from 3 scenarios"), std::string::npos) << ran.out;
  const Ran large = cylon("hunt --engine in-house --scenes gas --count 1");
  EXPECT_EQ(large.code, 4);
  EXPECT_NE(large.err.find("left out: gas: "), std::string::npos) << large.err;
  EXPECT_EQ(cylon("hunt --engine in-house --scenes projectil --count 1").code, 2);
}

TEST_F(HuntCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(cylon("hunt --engine in-house").code, 2);
  EXPECT_EQ(cylon("hunt --engine in-house --count 1 --minutes 1").code, 2);
  EXPECT_EQ(cylon("hunt --count 1").code, 2);
  // Numbers that wrapped: a search without end, and two seeds that were one.
  for (const char* option : {"--first -5", "--first 18446744073709551614", "--first 1e3", "--seed -1",
                             "--seed 99999999999999999999999", "--seed ''"}) {
    const Ran ran = cylon("hunt --engine in-house --count 1 " + std::string(option));
    EXPECT_EQ(ran.code, 2) << option;
    EXPECT_NE(ran.err.find("must be a whole number"), std::string::npos) << option << ran.err;
  }
  const Ran timed = cylon("hunt --engine in-house --minutes 1 --shard 1/2");
  EXPECT_EQ(timed.code, 2);
  EXPECT_NE(timed.err.find("depends on the machine"), std::string::npos) << timed.err;
  write("none.toml", shipped("projectile"));
  const Ran none = cylon("hunt --replay .");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("no card of `cylon hunt`"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace cylon::cli
