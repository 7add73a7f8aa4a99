// `--plugin NAME=FILE`: without it no scene loads code; with it a plug-in that fails is a verdict.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

namespace cylon::cli {
namespace {

const std::string duffing = std::string(source_dir) + "/docs/examples/force/duffing.toml";
const std::string laws = " --plugin laws=" + std::string(binary_dir) + "/example_laws.so";
const std::string odd = " --plugin odd=" + std::string(binary_dir) + "/odd_laws.so";

std::string scene(const std::string& law) {
  return "duration = 1\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1\nvelocity = [1, 0, 0]\n"
         "[[plugin_force]]\nplugin = \"odd\"\nlaw = \"" +
         law +
         "\"\nbodies = [\"a\"]\n"
         "[[claim]]\nconserves = \"linear_momentum\"\ntolerance = { absolute = 1e-9, reason = \"r\" }\n";
}

TEST_F(CommandLine, PluginsTakePartOnlyWhereTheCommandSaysSo) {
  const Ran without = cylon("simulate " + duffing + " --at 1");
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.err.find("--plugin laws=FILE"), std::string::npos) << without.err;
  const Ran with = cylon("simulate " + duffing + " --at 1" + laws);
  EXPECT_EQ(with.code, 0) << with.err;
  const Ran full = cylon("simulate " + duffing + " --at 1 --model full" + laws);
  EXPECT_EQ(full.code, 0) << full.err;
  const Ran plan = cylon("plan " + duffing + laws);
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_NE(plan.out.find("forces of plug-ins"), std::string::npos) << plan.out;
  // In single precision too; no other engine gets it.
  EXPECT_EQ(cylon("simulate " + duffing + " --at 1 --engine in-house-float" + laws).code, 0);
  const Ran other = cylon("simulate " + duffing + " --engine ode" + laws);
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("forces of plug-ins"), std::string::npos) << other.err;
}

TEST_F(CommandLine, PluginRefusals) {
  const struct {
    std::string option;
    const char* says;
  } rows[] = {{" --plugin laws", "must be NAME=FILE"},
              {" --plugin =laws.so", "must be NAME=FILE"},
              {" --plugin laws=nowhere.so", "there is no file 'nowhere.so'"},
              {laws + laws, "'laws' is given twice"}};
  for (const auto& row : rows) {
    const Ran ran = cylon("simulate " + duffing + row.option);
    EXPECT_EQ(ran.code, 2) << row.option;
    EXPECT_NE(ran.err.find(row.says), std::string::npos) << ran.err;
  }
}

// The engine's process dies, or ends the run; the command reports it and goes on.
TEST_F(CommandLine, PluginsThatFailAreVerdicts) {
  for (const char* law : {"crash", "break_down", "fall"}) write(std::string(law) + ".toml", scene(law));
  const Ran crash = cylon("run crash.toml --engine in-house -v" + odd);
  EXPECT_EQ(crash.code, 5) << crash.out << crash.err;
  EXPECT_NE(crash.out.find("crash"), std::string::npos) << crash.out;
  const Ran broken = cylon("run break_down.toml --engine in-house -v" + odd);
  EXPECT_EQ(broken.code, 5) << broken.out << broken.err;
  EXPECT_NE(broken.out.find("gives no finite force on body 'a'"), std::string::npos) << broken.out;
  const Ran falls = cylon("run fall.toml --engine in-house" + odd);
  EXPECT_EQ(falls.code, 1) << falls.out << falls.err;  // momentum is not conserved
  EXPECT_NE(falls.out.find("1 fail"), std::string::npos) << falls.out;
}

// The command that a verdict gives runs the same cell again.
TEST_F(CommandLine, PluginsStandInTheCommandThatRepeatsACell) {
  write("fall.toml", scene("fall"));
  const Ran ran = cylon("run fall.toml --engine in-house --json report.json" + odd);
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_NE(read("report.json").find("--plugin odd="), std::string::npos);
}

}  // namespace
}  // namespace cylon::cli
