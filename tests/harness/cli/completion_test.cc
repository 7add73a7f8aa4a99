// The completion script of each shell, in that shell; a shell that is not here is skipped.
#include "tests/harness/cli/fixture.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace cylon::cli {
namespace {

struct Shell {
  const char* name;
  const char*
      offers;  ///< Prints the words offered for the last of the words "$@", one a line; reads ./script.
};

void PrintTo(const Shell& shell, std::ostream* out) { *out << shell.name; }

// bash and zsh have what the shell itself provides replaced by the least that stands in for it.
const Shell shells[] = {
    {"bash",
     ". ./script; COMP_WORDS=(\"$@\") COMP_CWORD=$(($# - 1)); _cylon; printf '%s\\n' \"${COMPREPLY[@]}\""},
    {"zsh",
     "compdef() { [[ $1 == _cylon && $2 == cylon ]] || print wrong; }; _files() { }; "
     "compadd() { for one in \"${(@P)2}\"; do [[ $one == ${words[CURRENT]}* ]] && print -r -- $one; done; "
     "true; }; "
     "source ./script; words=(\"$@\") CURRENT=$#; _cylon"},
    {"fish", "source ./script; complete -C \"$argv\" | string replace -r '\\t.*' ''; true"},
};

struct Case {
  const char* words;  ///< Typed so far.
  const char* offered;
  const char* never;
};

const Case cases[] = {
    {"cylon ru", "run", "track"},
    {"cylon run dzh", "dzhanibekov", "heavy_top"},
    {"cylon run --the", "--theory", "--theories"},
    {"cylon run --engine od", "ode-quick", "double_pendulum_rods"},
    {"cylon track ga", "gate", "run"},
    {"cylon completion fi", "fish", "bash"},
    {"cylon engines simb", "simbody", "ode"},
};

class Completion : public CommandLine, public testing::WithParamInterface<Shell> {};

bool has_line(const std::string& text, const std::string& line) {
  return ('\n' + text).find('\n' + line + '\n') != std::string::npos;
}

TEST_P(Completion, OffersWhatTheProgramHas) {
  const std::string name = GetParam().name;
  if (shell("command -v " + name).code != 0) GTEST_SKIP() << "there is no " << name << " here";
  ASSERT_EQ(cylon("completion " + name + " >script").code, 0);
  EXPECT_EQ(shell(name + " -n ./script").code, 0);
  write("offers", GetParam().offers);
  for (const Case& c : cases) {
    const Ran ran = shell(name + (name == "zsh" ? " -f" : "") + " ./offers " + c.words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(has_line(ran.out, c.offered)) << c.words << "\n" << ran.out << ran.err;
    EXPECT_FALSE(has_line(ran.out, c.never)) << c.words << "\n" << ran.out;
  }
}

// A script that is installed outlives the program: the shell then offers options, and prints no error between the keys.
TEST_P(Completion, IsSilentWithoutTheProgram) {
  const std::string name = GetParam().name;
  if (shell("command -v " + name).code != 0) GTEST_SKIP() << "there is no " << name << " here";
  ASSERT_EQ(cylon("completion " + name + " >script").code, 0);
  write("offers", GetParam().offers);
  const std::string types =
      "PATH=/usr/bin:/bin exec " + name + (name == "zsh" ? " -f" : "") + " ./offers absent/cylon run ";
  const Ran scene = shell(types + "dzh"), option = shell(types + "--the");
  EXPECT_EQ(scene.err + option.err, "");
  EXPECT_TRUE(has_line(option.out, "--theory")) << option.out;
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::ValuesIn(shells),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace cylon::cli
