// Stored answers are those of one version of an engine, also where its worker's own files are the same.
#include "harness/cli/identity_of.h"

#include "tests/harness/cli/fixture.h"

#include <algorithm>

namespace cylon::cli {
namespace {

// A wrapper, and the engine that it starts elsewhere.
class Identity : public CommandLine {
 protected:
  static constexpr const char* asked = "run projectile --engine mine --worker 'mine=sh engine.sh' ";

  void SetUp() override {
    std::filesystem::create_directories(folder / "elsewhere");
    write("engine.sh", "echo started >> '" + (folder / "starts").string() + "'\nexec python3 '" +
                           (folder / "elsewhere/engine.py").string() + "'\n");
    install("1.0");
  }
  void install(const std::string& version) const {
    const std::string engine = read(std::filesystem::path(source_dir) / "docs/examples/foreign_engine.py");
    write("elsewhere/engine.py",
          replaced(engine, "\"version\": \"1.0\"", "\"version\": \"" + version + "\""));
  }
  process::EngineRow mine() const { return {"mine", {"sh", (folder / "engine.sh").string()}, ""}; }
};

TEST_F(Identity, AnotherVersionIsAnotherEngine) {
  ASSERT_EQ(cylon(std::string(asked) + "--shard 1/1").code, 0);
  ASSERT_EQ(cylon(asked).code, 0);
  EXPECT_NE(cylon(std::string(asked) + "--resume").err.find("resumed: 1 of 1"), std::string::npos);
  install("1.1");
  EXPECT_NE(cylon(std::string(asked) + "--resume").err.find("resumed: 0 of 1"), std::string::npos);
  shell("mkdir old; mv .cylon/journal-1-of-1.jsonl old");
  ASSERT_EQ(cylon(std::string(asked) + "--shard 1/1").code, 0);
  const Ran merged = cylon("merge old/journal-1-of-1.jsonl .cylon/journal-1-of-1.jsonl");
  EXPECT_EQ(merged.code, 2) << merged.err;
  EXPECT_NE(merged.err.find("is another scenario, engine"), std::string::npos) << merged.err;
}

TEST_F(Identity, AnEngineIsAskedOnce) {
  ASSERT_EQ(cylon(std::string(asked) + "--dt 1/500 --dt 1/1000").code, 0);
  const std::string starts = read("starts");
  EXPECT_EQ(std::ranges::count(starts, '\n'), 3);  // and once for each cell
  const std::string one = identity_of(mine());
  const std::string asked_here = read("starts");
  identify(std::vector{mine(), mine()});
  EXPECT_EQ(identity_of(mine()), one);
  EXPECT_EQ(read("starts"), asked_here);
}

// It fails, and that is a result; it is known again.
TEST_F(Identity, AnEngineThatSaysNothingIsKnownAgain) {
  write("engine.sh", "echo $$ >&2; exit 3\n");
  ASSERT_EQ(cylon(asked).code, 5);
  const Ran again = cylon(std::string(asked) + "--resume");
  EXPECT_EQ(again.code, 5) << again.err;
  EXPECT_NE(again.err.find("resumed: 1 of 1"), std::string::npos) << again.err;
}

}  // namespace
}  // namespace cylon::cli
