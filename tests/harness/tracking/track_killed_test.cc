// A recording that is killed at any moment loses the cell in flight at most, and goes on to what it would
// have been.
#include "harness/core/input_error.h"
#include "harness/tracking/store/store.h"
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

namespace cylon::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* selection =
    "'two_sphere_head_on*' --engine in-house --engine ode --repetitions 0 --orders";

// All that is the same on every run: digits of what was measured, hashes, statuses.
using Facts = std::map<std::string, std::string>;

Facts facts_of(const Store& store, std::int64_t run) {
  Facts facts;
  for (const Result& result : store.results(run)) {
    const std::string cell = result.cell.name() + " " + result.cell.hash + " ";
    for (const Sample& s : result.samples)
      if (s.metric.kind == Kind::exact || s.metric.kind == Kind::error)
        facts[cell + s.metric.name] = fmt::format("{:.17g} {}", s.value, s.text);
    for (const Judgement& j : result.judgements)
      facts[cell + "verdict " + j.claim] = fmt::format("{} {:.17g} {:.17g}", j.status, j.measured, j.allowed);
  }
  return facts;
}

class KilledRecording : public cli::CommandLine {
 protected:
  std::size_t lines_of(const std::string& file) const {
    const std::string text = read(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(KilledRecording, LosesAtMostOneCellAndResumesToSameResult) {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(cylon(fmt::format("track record {} --store whole.db", selection)).code, 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  const Facts expected = facts_of(Store::open(folder / "whole.db", Mode::read), 1);
  ASSERT_GT(expected.size(), 60u);

  std::mt19937 random(20240917);
  std::uniform_real_distribution<double> moment(0.05, 1.0);
  int in_the_middle = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const std::string name = fmt::format("killed{}.db", trial), lines = fmt::format("lines{}", trial);
    // Every other one by what it has told so far, as a moment that is a time may pass unused where the
    // machine is busy; then a little later, so that it may fall anywhere in a cell.
    const std::string wait =
        trial % 2 == 0
            ? fmt::format("sleep {:.3f}", moment(random) * whole.count())
            : fmt::format("while kill -0 $p && [ $(wc -l < {}) -lt {} ]; do sleep 0.002; done; sleep {:.3f}",
                          lines, 1 + trial / 2, moment(random) * whole.count() / 20);
    shell(
        fmt::format("{{ cylon track record {} --store {} --verbose > {} & p=$!; {}; kill -9 $p; wait $p; }}",
                    selection, name, lines, wait));
    std::int64_t runs = 0;
    if (fs::exists(folder / name) && fs::file_size(folder / name) > 0) {
      const Store store = Store::open(folder / name, Mode::write);
      EXPECT_TRUE(store.check().empty()) << name << ": " << store.check().front();
      runs = static_cast<std::int64_t>(store.runs().size());
      const std::size_t told = lines_of(lines), stored = runs == 0 ? 0 : store.results(1).size();
      const bool finished = runs == 1 && store.runs()[0].complete;
      EXPECT_GE(stored + (finished ? 1 : 0), told) << name;  // the last line tells of the run
      EXPECT_LE(stored, told + 1) << name;
      in_the_middle += stored > 0 && !finished;
      if (finished) continue;
    }
    // Before the run began there is nothing to go on with.
    const cli::Ran ran = cylon(runs == 0 ? fmt::format("track record {} --store {}", selection, name)
                                         : fmt::format("track record --resume --store {}", name));
    ASSERT_EQ(ran.code, 0) << ran.err;
    const Store store = Store::open(folder / name, Mode::read);
    ASSERT_EQ(store.runs().size(), 1u);
    EXPECT_TRUE(store.runs()[0].complete);
    EXPECT_EQ(facts_of(store, 1), expected) << name;
  }
  EXPECT_GE(in_the_middle, 3) << "the moments must fall into the recording";
}

TEST_F(KilledRecording, DoesNotResumeWithOtherBinariesOrSelection) {
  write("slow.sh", "#!/bin/sh\nexec cylon-worker-in-house\n");
  shell(
      "chmod +x slow.sh; { cylon track record 'two_sphere*' --engine mine --worker mine=./slow.sh --store "
      "h.db "
      "--repetitions 0 -v > lines & p=$!; while ! [ -s lines ]; do sleep 0.01; done; kill -9 $p; wait $p; }");
  ASSERT_FALSE(Store::open(folder / "h.db", Mode::read).runs().at(0).complete);
  cli::Ran ran = cylon("track record projectile --resume --store h.db");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("do not give a new one"), std::string::npos) << ran.err;
  write("slow.sh", "#!/bin/sh\n# another\nexec cylon-worker-in-house\n");
  ran = cylon("track record --resume --store h.db");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("binaries have changed"), std::string::npos) << ran.err;
}

TEST_F(KilledRecording, CompleteRecordingHasNothingToResume) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --repetitions 0 --store h.db").code, 0);
  const cli::Ran ran = cylon("track record --resume --store h.db");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("nothing to resume"), std::string::npos) << ran.err;
  EXPECT_EQ(cylon("track record --resume --store none.db").code, 2);
  EXPECT_FALSE(fs::exists(folder / "none.db"));
}

}  // namespace
}  // namespace cylon::store
