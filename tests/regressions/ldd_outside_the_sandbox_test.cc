// `cylon --sandbox track …` asked ldd of a stranger's program outside of the sandbox, and ldd starts the loader that the
// program names: the stranger's code ran with the user's rights.  What it printed had no end either.
#include "harness/process/sandbox.h"
#include "harness/study/side.h"
#include "tests/harness/cli/fixture.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

class LddOutsideTheSandbox : public CommandLine {
 protected:
  void SetUp() override {
    if (std::system("command -v bwrap >/dev/null") != 0) GTEST_SKIP() << "bubblewrap is not installed";
  }
  void TearDown() override { process::sandboxing() = false; }

  // An anchor's content is that of its program and its libraries, which ldd names.
  Ran pin(const std::string& ldd, const std::string& option) const {
    fs::create_directory(folder / "bin");
    write("bin/ldd", "#!/bin/sh\n" + ldd);
    return shell("chmod +x bin/ldd; export PATH=\"$PWD/bin:$PATH\"; exec cylon " + option +
                 " track pin v1 --engine in-house --store h.db");
  }
};

TEST_F(LddOutsideTheSandbox, CanTouchNothing) {
  const std::string ldd = "touch ldd_was_here 2>/dev/null\nls /proc/*/cmdline | wc -l >&2\n";
  const Ran confined = pin(ldd, "--sandbox");
  EXPECT_EQ(confined.code, 0) << confined.err;
  EXPECT_FALSE(fs::exists(folder / "ldd_was_here"));
  const Ran open = pin(ldd, "");  // the same without: the test would see it
  EXPECT_EQ(open.code, 0) << open.err;
  EXPECT_TRUE(fs::exists(folder / "ldd_was_here"));
}

TEST_F(LddOutsideTheSandbox, IsNotHeardForEver) {
  const auto start = std::chrono::steady_clock::now();
  const Ran ran = pin("exec yes /usr/lib/nothing.so\n", "--sandbox");
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 9);  // ldd may take 10 s, and would print gigabytes in that time
}

TEST_F(LddOutsideTheSandbox, FindsTheSameLibraries) {
  const std::string program = fs::canonical("/bin/bash");
  const std::string open = study::content_hash({program});
  process::sandboxing() = true;
  EXPECT_EQ(study::content_hash({program}), open);
}

}  // namespace
}  // namespace cylon::cli
