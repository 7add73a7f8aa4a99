// The table of what a scene cannot say.
#include "harness/imports/losses.h"

#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace cylon::imports {
namespace {

TEST(Losses, HaveOneRowEachWithAReason) {
  std::set<std::string_view> words;
  for (const LossKind& kind : loss_kinds()) {
    EXPECT_TRUE(words.insert(kind.what).second) << kind.what;
    EXPECT_FALSE(kind.why.empty()) << kind.what;
    EXPECT_EQ(&loss_kind(kind.what), &kind);
  }
}

// docs/import.md lists them, in this order.
TEST(LossesPage, ListsEveryKind) {
  std::string table = "| kind | becomes | why |\n|---|---|---|\n";
  for (const LossKind& kind : loss_kinds()) {
    std::string why(kind.why);
    if (const std::size_t star = why.find('*'); star != std::string::npos) why.insert(star, "\\");
    table += "| `" + std::string(kind.what) + "` | " +
             (kind.decision == Decision::refused ? "refused" : "left out") + " | " + why + " |\n";
  }
  std::ifstream in(std::filesystem::path(source_dir) / "docs/import.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  EXPECT_NE(page.find("<!-- kinds -->\n" + table + "<!-- /kinds -->"), std::string::npos) << table;
}

TEST(Losses, RefuseAWordThatIsNoneAndSayTheNearest) {
  try {
    loss_kind("armatur");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "'armatur' is no kind of loss, did you mean 'armature'?");
  }
}

TEST(Losses, NameFileLineAndElement) {
  EXPECT_EQ(text_of({"sensor", {"sensor 'imu'", "part.sdf", 12}, ""}, "whole.sdf"),
            "part.sdf:12: sensor 'imu': sensor: a sensor moves nothing");
  EXPECT_EQ(text_of({"mimic", {"joint 'hip'", "", 0}, "joint 'knee'"}, "robot.xml"),
            "robot.xml: joint 'hip': mimic (joint 'knee'): a scene couples no joints");
}

TEST(Losses, JoinThoseOfOneKindAndDetail) {
  const std::vector<foreign::Loss> losses = {{"sensor", {"sensor 'a'", "", 3}, ""},
                                             {"mimic", {"joint 'b'", "", 0}, "2"},
                                             {"sensor", {"sensor 'c'", "", 5}, ""}};
  EXPECT_EQ(texts_of(losses, "f"),
            (std::vector<std::string>{"f:3: sensor 'a' and 1 more: sensor: a sensor moves nothing",
                                      "f: joint 'b': mimic (2): a scene couples no joints"}));
}

}  // namespace
}  // namespace cylon::imports
