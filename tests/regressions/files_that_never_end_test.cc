// `track import /dev/zero` read until the memory was gone, and `report` and `track import` of a named pipe into which nobody
// writes, or of a file under /proc that never comes, waited for ever. So did `diff` of such a file as states.
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

TEST_F(FilesThatNeverEnd, AreRefusedAsStates) {
  shell("mkfifo pipe.csv; ln -s /dev/zero zero.csv; mkdir folder.csv");
  const std::pair<const char*, const char*> files[] = {
      {"zero.csv", "zero.csv: more than 256 MB"},
      {"pipe.csv", "pipe.csv: a pipe into which nobody writes"},
      {"folder.csv", "folder.csv: cannot be read"}};
  for (const auto& [file, why] : files) {
    const Ran ran = cylon(std::string("diff projectile in-house ") + file);
    EXPECT_EQ(ran.code, 2) << file << ran.err;
    EXPECT_NE(ran.err.find(why), std::string::npos) << file << ran.err;
  }
  // What is refused is shown in part.
  const Ran ran = shell(
      "(echo time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz; head -c 1000000 /dev/zero | "
      "tr '\\0' x; echo ,projectile,0,0,0,1,0,0,0,0,0,0,0,0,0) > long.csv; "
      "exec cylon diff projectile in-house long.csv");
  EXPECT_EQ(ran.code, 2) << ran.err.substr(0, 500);
  EXPECT_NE(ran.err.find("long.csv:2:1: column 1: 'xxx"), std::string::npos) << ran.err.substr(0, 500);
  EXPECT_LT(ran.err.size(), 1000u);
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
