// Line ends in the names of an imported file began lines of their own on stderr, which looked like Cylon's messages; where
// a command read such a file by itself, its control characters reached the terminal, too.
#include "tests/harness/cli/fixture.h"

#include <filesystem>
#include <sstream>
#include <string>

namespace cylon::cli {
namespace {

using NamesForgeLines = CommandLine;

constexpr const char* robot =
    "<robot name=\"r&#27;[31m&#10;error: all is lost\"><link name=\"a&#10;error: all is lost\"><inertial>"
    "<mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial></link>"
    "</robot>";

// No control character, and no line that begins as the name wants it to.
void expect_harmless(const std::string& command, const std::string& told) {
  std::istringstream lines(told);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.starts_with("error: all is lost")) << command << told;
    for (const char c : line) EXPECT_FALSE(static_cast<unsigned char>(c) < ' ') << command << told;
  }
}

TEST_F(NamesForgeLines, OfImportedFiles) {
  if (!std::filesystem::exists(std::filesystem::path(binary_dir) / "cylon-import-urdf"))
    GTEST_SKIP() << "no library for .urdf";
  write("nam.urdf", robot);
  for (const std::string command : {"import nam.urdf --out o.toml", "validate nam.urdf", "plan nam.urdf",
                                    "simulate nam.urdf --out s.csv"}) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, 0) << command << ran.err;
    EXPECT_NE(ran.err.find("left out: "), std::string::npos) << command << ran.err;
    EXPECT_NE(ran.err.find("\\nerror: all is lost"), std::string::npos) << command << ran.err;
    expect_harmless(command, ran.err);
  }
  const Ran refused = cylon("import nam.urdf --strict");
  EXPECT_EQ(refused.code, 2) << refused.err;
  expect_harmless("import --strict", refused.err);
}

// A scene's own texts, in an error that quotes them.
TEST_F(NamesForgeLines, OfKeysOfScenes) {
  write("key.toml", shipped("projectile") + "\n\"k\\nerror: all is lost\" = 1\n");
  const Ran ran = cylon("validate key.toml");
  EXPECT_EQ(ran.code, 2) << ran.err;
  expect_harmless("validate", ran.err);
}

// What an engine gives as its reason.
TEST_F(NamesForgeLines, OfEngines) {
  write("worker.py",
        "import sys\n"
        "for line in sys.stdin:\n"
        "    if 'hello' in line:\n"
        "        "
        "print('{\"ok\":\"hello\",\"protocol\":1,\"engine\":\"e\",\"version\":\"1\",\"precision\":\"double\","
        "\"events\":false}', flush=True)\n"
        "    elif 'load' in line:\n"
        "        print(r'{\"unsupported\":\"no\\nerror: all is lost\"}', flush=True)\n");
  const Ran one = cylon("simulate projectile --engine e --worker 'e=python3 worker.py'");
  EXPECT_EQ(one.code, 2);
  EXPECT_NE(one.err.find("no\\nerror: all is lost"), std::string::npos) << one.err;
  expect_harmless("simulate", one.err);
  const Ran rows = cylon("run projectile --engine e --worker 'e=python3 worker.py'");
  expect_harmless("run", rows.out + rows.err);
}

}  // namespace
}  // namespace cylon::cli
