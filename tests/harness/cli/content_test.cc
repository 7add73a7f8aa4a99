// What a stored answer is known by: a worker with all that belongs to it, wherever it lies.
#include "harness/cli/content_of.h"
#include "harness/process/engines.h"
#include "harness/study/modules.h"
#include "harness/study/side.h"
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>

#include <map>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

class Content : public CommandLine {
 protected:
  using Files = std::map<std::string, std::string>;  // text by name

  // The content of a command whose last word is one of the files, in a folder of their own.
  std::string of(const Files& files, const std::string& worker) {
    const fs::path place = put(files);
    return content_of({"node", (place / worker).string()});
  }
  fs::path put(const Files& files) {
    const fs::path place = folder / std::to_string(++places_);
    for (const auto& [name, text] : files) {
      fs::create_directories((place / name).parent_path());
      std::ofstream(place / name, std::ios::binary) << text;
    }
    return place;
  }

 private:
  int places_ = 0;
};

struct Change {
  const char *file, *text;
  bool counts;
};

TEST_F(Content, CountsTheLibrariesOfItsOwnThatAProgramNames) {
  const Files whole = {{"worker",
                        "\x7f"
                        "ELF libcylon-border-a.so \x01"},
                       {"libcylon-border-a.so", "one"},
                       {"libcylon-border-b.so", "two"},
                       {"notes.txt", "three"}};
  const std::string before = of(whole, "worker");
  EXPECT_EQ(of(whole, "worker"), before) << "the place counts";
  const Change changes[] = {{"worker",
                             "\x7f"
                             "ELF libcylon-border-a.so \x02",
                             true},
                            {"libcylon-border-a.so", "One", true},
                            {"libcylon-border-b.so", "Two", false},
                            {"notes.txt", "Three", false}};
  for (const Change& change : changes) {
    Files other = whole;
    other[change.file] = change.text;
    EXPECT_EQ(of(other, "worker") != before, change.counts) << change.file;
  }
}

TEST_F(Content, CountsTheModulesBesideAScript) {
  const Files whole = {{"worker.mjs", "import './engine.mjs'"},
                       {"engine.mjs", "one"},
                       {"engine.py", "two"},
                       {"package-lock.json", "1.0.0"},
                       {"node_modules/.package-lock.json", "1.0.0"}};
  const std::string before = of(whole, "worker.mjs");
  const auto hash = [&](const Files& files) {
    return study::content_hash({"node", (put(files) / "worker.mjs").string()});
  };
  EXPECT_EQ(of(whole, "worker.mjs"), before) << "the place counts";
  EXPECT_EQ(hash(whole), hash(whole));
  const Change changes[] = {{"worker.mjs", "import './engine.mjs';", true},
                            {"engine.mjs", "One", true},
                            {"another.mjs", "", true},
                            {"engine.py", "Two", false},
                            {"package-lock.json", "1.0.1", true},
                            {"node_modules/.package-lock.json", "1.0.1", true}};
  for (const Change& change : changes) {
    Files other = whole;
    other[change.file] = change.text;
    EXPECT_EQ(of(other, "worker.mjs") != before, change.counts) << change.file;
    EXPECT_EQ(hash(other) != hash(whole), change.counts) << change.file;
  }
}

TEST_F(Content, FollowsALinkToTheScript) {
  const fs::path place = put({{"worker.mjs", "one"}, {"engine.mjs", "two"}});
  fs::create_symlink(place / "worker.mjs", folder / "cylon-worker-x");
  EXPECT_EQ(content_of({(folder / "cylon-worker-x").string()}),
            content_of({(place / "worker.mjs").string()}));
  EXPECT_EQ(study::modules_beside(folder / "cylon-worker-x").size(), 1);
}

// The workers of this build: a changed byte of a border, or of a module, is another engine.
TEST_F(Content, TellsBuildsOfTheEnginesHereApart) {
  int changed = 0;
  for (const process::EngineRow& row : process::default_engines(binary_dir)) {
    const fs::path worker = row.command.front();
    if (!fs::exists(worker)) continue;
    const fs::path home = fs::canonical(worker).parent_path();
    for (const char* part : {"libcylon-border-dart.so", "libcylon-border-siconos.so", "settings.mjs"}) {
      if (!fs::exists(home / part)) continue;
      const fs::path place = folder / fmt::format("{} {}", row.id, part);
      fs::create_directories(place);
      const auto copy = [&](const char* name) {
        fs::create_directories(place / name);
        fs::copy_file(fs::canonical(worker), place / name / fs::canonical(worker).filename());
        fs::copy_file(home / part, place / name / part);
        return place / name / part;
      };
      copy("as it is");
      std::ofstream(copy("other"), std::ios::app | std::ios::binary) << ' ';
      const auto content = [&](const char* name) {
        return content_of({(place / name / fs::canonical(worker).filename()).string()});
      };
      const bool belongs =
          part == "libcylon-border-" + row.id + ".so" || fs::path(part).extension() == ".mjs";
      EXPECT_EQ(content("as it is") != content("other"), belongs) << row.id << ", " << part;
      changed += belongs;
    }
  }
  if (changed == 0) GTEST_SKIP() << "no engine here has a border or modules";
}

}  // namespace
}  // namespace cylon::cli
