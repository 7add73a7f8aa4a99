// A worker's ending without its last line of stderr.
#include "harness/process/last_words.h"

#include <gtest/gtest.h>

namespace cylon::process {
namespace {

TEST(LastWords, AreLeftOutBehindAnEnding) {
  const struct {
    const char *reason, *kept;
  } rows[] = {
      {"exited 3 before done: process 4711: no memory", "exited 3 before done"},
      {"exited 3 before done", "exited 3 before done"},
      {"killed by SIGABRT: Assertion 'mass > 0' failed", "killed by SIGABRT"},
      {"killed by signal 34: x", "killed by signal 34"},
      {"cannot start './engine: new': sh: 17: not found", "cannot start './engine: new'"},
      {"turned: crash: exited 1 before done: killed by 0x7f", "turned: crash: exited 1 before done"},
      {"stopped after step 7: the solver gave up", "stopped after step 7: the solver gave up"},
      {"no answer to hello within 10 s", "no answer to hello within 10 s"},
      {"", ""},
  };
  for (const auto& [reason, kept] : rows) EXPECT_EQ(without_last_words(reason), kept);
}

}  // namespace
}  // namespace cylon::process
