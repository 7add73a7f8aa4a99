// `track import /dev/zero` read until the memory was gone, and `report` and `track import` of a named pipe into which nobody
// writes, or of a file under /proc that never comes, waited for ever.
#include "tests/harness/cli/fixture.h"

#include <string>

namespace cylon::cli {
namespace {

using FilesThatNeverEnd = CommandLine;

TEST_F(FilesThatNeverEnd, AreRefused) {
  shell("mkfifo pipe");
  const std::pair<const char*, const char*> files[] = {{"/dev/zero", "/dev/zero: more than "},
                                                       {"pipe", "pipe: a pipe into which nobody writes"},
                                                       {".", ".: cannot be read"}};
  for (const auto& [file, why] : files)
    for (const std::string& command : {"report " + std::string(file) + " --html r.html",
                                       "track import " + std::string(file) + " --store s.db"}) {
      const Ran ran = cylon(command);
      EXPECT_EQ(ran.code, 2) << command;
      EXPECT_NE(ran.err.find(why), std::string::npos) << command << ": " << ran.err;
    }
}

// Pipes with a writer are read to their end: stdin, /dev/stdin, a named pipe whose writer is slow.
TEST_F(FilesThatNeverEnd, PipesAreRead) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --repetitions 0 --store s.db").code, 0);
  ASSERT_EQ(cylon("track export --store s.db e.jsonl").code, 0);
  for (const char* line :
       {"cat e.jsonl | cylon track import - --store a.db",
        "cat e.jsonl | cylon track import /dev/stdin --store b.db",
        "mkfifo slow; (sleep 0.3; cat e.jsonl) > slow & cylon track import slow --store c.db"}) {
    const Ran ran = shell(line);
    EXPECT_EQ(ran.code, 0) << line << ran.err;
    EXPECT_NE(ran.out.find("1 runs and "), std::string::npos) << line << ran.out;
  }
}

}  // namespace
}  // namespace cylon::cli
