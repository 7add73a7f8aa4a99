// The sandbox showed the folder of each file that an engine's command names: with `python3 ~/engine.py` all of the home
// folder with ~/.ssh, with a file above it more, with /etc/x.conf all of /etc.  Of a file in such a folder the file alone
// is shown now.
#include "harness/process/sandbox.h"

#include "tests/harness/process/fixture.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cylon::process {
namespace {

namespace fs = std::filesystem;

class SandboxShowsHomeFolder : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v bwrap >/dev/null") != 0) GTEST_SKIP() << "bubblewrap is not installed";
    for (const fs::path& folder : {home_ / ".ssh", home_ / ".config", home_ / "engines", real_ / "other"})
      fs::create_directories(folder);
    for (const fs::path& file :
         {home_ / "engine.py", home_ / "secret", home_ / ".ssh/id", home_ / ".config/x.toml",
          home_ / ".config/token", home_ / "engines/a.py", home_ / "engines/module.py", real_ / "above.py"})
      std::ofstream(file) << "x";
    ::setenv("HOME", home_.c_str(), 1);
    ::unsetenv("SPY_SECRET");
    sandboxing() = true;
  }
  void TearDown() override {
    sandboxing() = false;
    hidden_in_sandboxes().clear();
    ::setenv("HOME", before_.c_str(), 1);
  }

  // Which of the files an engine can read whose command names `word`.
  static std::string seen(const fs::path& word, const std::vector<fs::path>& files) {
    std::string list;
    for (const fs::path& file : files) list += (list.empty() ? "" : ":") + file.string();
    EngineChoice choice = scripted("spies_in_load");
    const std::vector<std::string> words = {"env", "SPY_FILES=" + list, "SPY_PORT=1"};
    choice.row.command.insert(choice.row.command.begin(), words.begin(), words.end());
    choice.row.command.push_back(word);
    const core::Scene scene = two_bodies();
    const RunOutcome outcome = run(choice, request_of(scene, 100, 10), {30, 30, std::size_t{1} << 30});
    EXPECT_EQ(outcome.status, results::Status::pass) << outcome.reason << outcome.stderr_tail;
    return outcome.stderr_tail;
  }
  static std::string reads(const std::vector<fs::path>& files) {
    std::string list;
    for (const fs::path& file : files) list += (list.empty() ? "reads " : ", reads ") + file.string();
    return "found: " + list + "\n";
  }

  const TemporaryFolder own_;
  const fs::path real_ = fs::canonical(own_.path()), home_ = real_ / "home";
  const std::string before_ = std::getenv("HOME") ? std::getenv("HOME") : "";
};

TEST_F(SandboxShowsHomeFolder, OfAFileThereTheFileAlone) {
  const fs::path engine = home_ / "engine.py";
  EXPECT_EQ(seen(engine, {engine, home_ / "secret", home_ / ".ssh/id"}), reads({engine}));
}

TEST_F(SandboxShowsHomeFolder, OfAFileAboveTheFileAlone) {
  const fs::path engine = real_ / "above.py";
  EXPECT_EQ(seen(engine, {engine, home_ / "secret", home_ / ".ssh/id"}), reads({engine}));
}

TEST_F(SandboxShowsHomeFolder, OfSettingsTheFileAlone) {
  const fs::path file = home_ / ".config/x.toml";
  EXPECT_EQ(seen(file, {file, home_ / ".config/token", home_ / "secret"}), reads({file}));
  EXPECT_EQ(seen("/etc/passwd", {"/etc/passwd", "/etc/group"}), reads({"/etc/passwd"}));
}

TEST_F(SandboxShowsHomeFolder, ThroughALinkTheFileAlone) {
  const fs::path link = real_ / "other/link.py", folder = real_ / "other/folder";
  fs::create_symlink(home_ / "engine.py", link);
  fs::create_directory_symlink(home_, folder);
  EXPECT_EQ(seen(link, {link, home_ / "engine.py", home_ / "secret"}), reads({link, home_ / "engine.py"}));
  EXPECT_EQ(seen(folder / "engine.py", {folder / "engine.py", folder / "secret", home_ / "secret"}),
            reads({folder / "engine.py"}));
}

// As before: an engine of several files finds its modules.
TEST_F(SandboxShowsHomeFolder, OfAFolderInItTheFolder) {
  const fs::path engine = home_ / "engines/a.py", module = home_ / "engines/module.py";
  EXPECT_EQ(seen(engine, {engine, module, home_ / "secret", home_ / ".ssh/id"}), reads({engine, module}));
}

TEST_F(SandboxShowsHomeFolder, WithoutTheKeyEvenIfNamed) {
  const fs::path key = home_ / ".config/token";
  EXPECT_EQ(seen(key, {key}), reads({key}));
  hidden_in_sandboxes() = {key};
  EXPECT_EQ(seen(key, {key}), "found: \n");
  hidden_in_sandboxes() = {home_ / ".config"};
  EXPECT_EQ(seen(key, {key}), "found: \n");
}

}  // namespace
}  // namespace cylon::process
