// The command line as a user meets it: exit codes, messages, files, and commands that give a row again.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::cli {
namespace {

using nlohmann::json;

const std::string foreign =
    "--worker 'mine=python3 " + std::string(source_dir) + "/docs/examples/foreign_engine.py'";

struct Case {
  const char* arguments;
  int code;
  const char* says;  // on stdout or stderr
};

TEST_F(CommandLine, ExitCodesAndMessages) {
  const Case cases[] = {
      {"--version", 0, "cylon 0."},
      {"run --help", 0, "--rerun-failed"},
      {"truth --help", 0, "a bound not reached (truth)"},
      {"", 2, "Subcommands"},
      {"rnu", 2, "unknown command 'rnu', did you mean 'run'?"},
      {"help run", 2, "`cylon COMMAND --help`"},
      {"diff projectile ode", 2, "cylon diff: b is missing: The second run, in the same form"},
      {"trade", 2, "cylon trade: patterns is missing: Scenario names"},
      {"track", 2, "cylon track: a command is missing (commands: record, "},
      {"run --hlep", 2, "unexpected '--hlep', did you mean '--help'?"},
      {"run -j 0", 2, "--jobs: '0' must be a number > 0"},
      {"run --timeout nan", 2, "--timeout: 'nan' must be a number > 0"},
      {"run --resume --rerun-failed", 2, "excludes"},
      {"list --names 'heavy*'", 0, "heavy_top\n"},
      {"list 'zzz*'", 4, "no scenario 'zzz*'"},
      {"list --tag spin", 4, "did you mean 'spring'?"},
      {"engines --names 'ode*'", 0, "ode\node-quick\n"},
      {"engines ode", 0, "path as-expert: "},
      {"engines bulet", 4, "did you mean 'bullet'?"},
      {"validate projectile", 0, "ok: 1 body, 4 claims"},
      {"validate missing.toml", 2, "missing.toml: no such file"},
      {"run projectle", 2, "no scenario 'projectle'"},
      {"run bouncing", 2, "did you mean 'bouncing_sphere'?"},
      {"run 'zzz*'", 4, "nothing selected"},
      {"run projectile --engine bulet", 2, "did you mean 'bullet'?"},
      {"run projectile --engine in-house ode", 2, "'ode' is an engine, not a scenario"},
      {"run projectile --integrator rk44", 2, "did you mean 'rk4'?"},
      {"run --suite simbenchmar", 2, "did you mean 'simbenchmark'?"},
      {"run projectile --dt 0.3", 2, "nearest: 0.9 s, or steps of 0.26666666666666666 s"},
      {"run projectile --dt 10", 2, "nearest: 10 s, or steps of 0.8 s"},
      {"run projectile --dt 1ms", 2, "--dt: '1ms' is no step"},
      {"run projectile --dt '0.5 ms'", 2, "or a fraction like 1/60; write 0.0005\n"},
      {"run projectile --dt '1/240 s'", 2, "; write 1/240\n"},
      {"run projectile --dt 41µs", 2, "; write 4.1e-05\n"},
      {"run projectile --dt xs", 2, "or a fraction like 1/60\n"},
      {"simulate projectile --dt 1ms", 2, "--dt: '1ms' is no step"},
      {"matrix projectile --at 1ms", 2, "--at: '1ms' is no step"},
      {"diff projectile in-house ode@1ms", 2, "ode@1ms: '1ms' is no step"},
      {"run projectile --plots /dev/null/nowhere", 2, "--plots /dev/null/nowhere: Not a directory"},
      {"report v.json --baseline v.json", 2, "--baseline: only a page compares with it"},
      {"run projectile --plots /dev/null", 2, "--plots /dev/null: is no folder"},
      {"plan --help", 0, "Only in-house and in-house-float have a plan"},
      {"simulate --help", 0, "bullet/gyro=none"},
      {"advise --help", 0, "1048576"},
      {"run projectile --worker mine=/no/such", 2, "there is no program '/no/such'"},
      {"run projectile --engine mine --worker mine=/bin/false", 5, "exited 1"},
      {"run projectile --engine in-house", 0, "4 pass"},
      {"run projectile --engine ode --dt 0.1", 1, "without a matching row in expected.toml"},
      {"run projectile --engine in-house --json - --csv -", 2, "'-' is given twice"},
      {"simulate projectile --at 0.0005", 2, "the nearest is 0.001 s (or use --nearest)"},
      {"simulate projectile --every 0.0015", 2, "--every 0.0015: is not a multiple"},
      {"simulate projectile --at 9", 2, "must lie in [0, 0.8] s"},
      {"simulate projectile --at x", 2, "--at x: 'x' must be a number of seconds"},
      {"truth heavy_top --at 0,x", 2, "--at 0,x: 'x' must be a number of seconds"},
      {"run ''", 2, "patterns: an empty word"},
      {"run projectile --json ''", 2, "--json: an empty word"},
      {"simulate projectile --integrator rk5", 2, "did you mean 'rk4'?"},
  };
  for (const Case& c : cases) {
    const Ran ran = cylon(c.arguments);
    EXPECT_EQ(ran.code, c.code) << "cylon " << c.arguments << "\n" << ran.err;
    EXPECT_NE((ran.out + ran.err).find(c.says), std::string::npos) << "cylon " << c.arguments << "\n"
                                                                   << ran.out << ran.err;
    EXPECT_EQ((ran.out + ran.err).find('\x1b'), std::string::npos)
        << "colour in a pipe: cylon " << c.arguments;
  }
}

// validate ended with 0, and said nothing.
TEST_F(CommandLine, FolderWithoutScenariosSelectsNothing) {
  std::filesystem::create_directory(folder / "none");
  for (const char* command : {"validate", "list"}) {
    const Ran ran = shell(std::string("CYLON_SCENARIOS=none exec cylon ") + command);
    EXPECT_EQ(ran.code, 4) << command << ran.out << ran.err;
    EXPECT_NE((ran.out + ran.err).find("nothing selected"), std::string::npos)
        << command << ran.out << ran.err;
  }
}

// An option takes the one word behind it, wherever it stands, and no scenario after that.
TEST_F(CommandLine, OptionsTakeOneValueEach) {
  const auto commands = [&](const std::string& arguments) {
    const Ran ran = cylon("run " + arguments + " --json -");
    EXPECT_TRUE(ran.code == 0 || ran.code == 1) << arguments << ran.err;
    const json report = json::parse(ran.out);
    std::vector<std::string> rows;
    for (const json& row : report.at("verdicts")) rows.push_back(row.at("reproduce"));
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  };
  const std::vector<std::string> expected = {"cylon run free_symmetric_top --engine in-house --dt 1/60",
                                             "cylon run free_symmetric_top --engine ode --dt 1/60",
                                             "cylon run projectile --engine in-house --dt 1/60",
                                             "cylon run projectile --engine ode --dt 1/60"};
  for (const char* arguments : {"projectile free_symmetric_top --engine in-house --engine ode --dt 1/60",
                                "--engine in-house --engine ode --dt 1/60 projectile free_symmetric_top",
                                "--engine in-house projectile --engine ode free_symmetric_top --dt 1/60",
                                "--dt 1/60 projectile 'free_symm*' --engine 'in-house' --engine od?"})
    EXPECT_EQ(commands(arguments), expected) << arguments;
  const Ran listed = cylon("list --names --tag spring --tag chaos 'spring*'");
  EXPECT_EQ(listed.out, "spring_pendulum\n") << listed.err;
}

// An empty word among the times was taken for t = 0.
TEST_F(CommandLine, EmptyTimesAreRefused) {
  for (const std::string command : {"simulate projectile", "truth heavy_top"}) {
    const Ran none = cylon(command + " --at ''");
    EXPECT_EQ(none.code, 2) << none.out;
    EXPECT_NE(none.err.find("--at: an empty word"), std::string::npos) << none.err;
    for (const std::string times : {"0,,0.1", ",0.1", "0.1,", ","}) {
      const Ran ran = cylon(fmt::format("{} --at {}", command, times));
      EXPECT_EQ(ran.code, 2) << times << ran.out;
      EXPECT_NE(ran.err.find(fmt::format("--at {}: '' must be a number of seconds", times)),
                std::string::npos)
          << ran.err;
    }
  }
}

// simulate printed the end of a scenario that is no multiple of S, truth did not.
TEST_F(CommandLine, EveryEndsWithTheScenario) {
  for (const std::string command : {"simulate projectile --engine in-house", "truth projectile"}) {
    const Ran ran = cylon(command + " --every 0.3");  // 0.8 s long
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 5) << ran.out;  // head, 0, 0.3, 0.6, 0.8
    EXPECT_NE(ran.out.find("\n0.8"), std::string::npos) << ran.out;
    const Ran whole = cylon(command + " --every 0.1");
    EXPECT_EQ(std::count(whole.out.begin(), whole.out.end(), '\n'), 10) << whole.out;
  }
}

// Each pair printed what one of the two asks for, or both into one stream, and exited with 0.
TEST_F(CommandLine, OptionsWithoutEffectAreRefused) {
  ASSERT_EQ(cylon("track record projectile --engine in-house").code, 0);
  const struct {
    const char* words;
    const char* says;
  } cases[] = {
      {"engines --names --json", "--json excludes --names"},
      {"engines --fingerprint --names ode", "--fingerprint excludes --names"},
      {"engines --here --json", "--here excludes --json"},
      {"list --names --json", "--json excludes --names"},
      {"validate --schema projectile", "excludes"},
      {"track list 1 --json", "excludes"},
      {"trade projectile --dt 0.01 --steps 3", "--dt excludes --steps"},
      {"trade projectile --dt 0.01 --work 1000", "--dt excludes --work"},
      {"predict swings.toml --curves 2", "--curves: nothing holds curves; give --json or --html"},
      {"run projectile --trajectories none", "--trajectories: nothing holds trajectories; give --html"},
      {"truth heavy_top --conditioning --digits 5", "--digits: --conditioning prints none of these"},
      {"import world.sdf --kinds", "excludes"},
      {"diff projectile in-house bullet --json --csv -", "--csv -: stdout has the JSON of --json"},
  };
  for (const auto& c : cases) {
    const Ran ran = cylon(c.words);
    EXPECT_EQ(ran.code, 2) << c.words << '\n' << ran.out << ran.err;
    EXPECT_EQ(ran.out, "") << c.words;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.words << '\n' << ran.err;
  }
}

TEST_F(CommandLine, BadInputKeepsOldReport) {
  const std::string good = shipped("projectile");
  const struct {
    const char *from, *to, *says;
  } cases[] = {
      {"mass     = 1.0", "mas      = 1.0",
       "bad.toml:12:1: unknown key 'mas' in [[body]], did you mean 'mass'?"},
      {"mass     = 1.0", "mass     = '1'", "bad.toml:12:12: mass must be a number"},
      {"mass     = 1.0", "mass     = -1.0", "bad.toml:12:12: mass = -1, but must be > 0 kg"},
      {"mass     = 1.0", "mass     = nan", "must be finite"},
      {"mass     = 1.0", "mass = 1.0\ninertia = [1, 1, 3]", "1 + 1 < 3"},
      {"title ", "\"\\u001b[31m\" = 1\ntitle ", "unknown key"},
  };
  write("report.json", "old");
  for (const auto& c : cases) {
    write("bad.toml", replaced(good, c.from, c.to));
    for (const char* command :
         {"run bad.toml --json report.json", "validate bad.toml", "simulate bad.toml --out report.json"}) {
      const Ran ran = cylon(command);
      EXPECT_EQ(ran.code, 2) << command << ran.err;
      EXPECT_NE(ran.err.find(c.says), std::string::npos) << ran.err;
      EXPECT_NE(ran.err.find("^\n"), std::string::npos) << "no caret: " << ran.err;
      EXPECT_EQ(ran.err.find('\x1b'), std::string::npos) << "the file commands the terminal";
      EXPECT_EQ(read("report.json"), "old");
    }
  }
  write("empty.toml", "");
  std::filesystem::create_directory(folder / "folder.toml");
  for (const char* file : {"empty.toml", "folder.toml"}) EXPECT_EQ(cylon(std::string("run ") + file).code, 2);
}

TEST_F(CommandLine, OutputKeepsLinksAndDevices) {
  write("target.csv", "");
  std::filesystem::create_symlink("target.csv", folder / "link.csv");
  EXPECT_EQ(cylon("run projectile --engine in-house --csv link.csv --json /dev/null").code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_NE(read("target.csv").find("projectile"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

// p = p0 + v0 t + g t^2/2
TEST_F(CommandLine, SimulateFollowsTheParabola) {
  const Ran ran = cylon("simulate projectile --dt 1/50 --at 0,0.4,0.8");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::istringstream lines(ran.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    double t = 0, x = 0, y = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,ball,%lf,%lf,", &t, &x, &y), 3) << line;
    EXPECT_NEAR(t, 0.4 * rows, 1e-15);
    EXPECT_NEAR(x, 3 * t, 1e-14);
    EXPECT_NEAR(y, 1 + 4 * t - 0.5 * 9.81 * t * t, 1e-14);
  }
  EXPECT_EQ(rows, 3);
}

// Claims of recorded truths and of events said "every N steps", the stride of other claims.
TEST_F(CommandLine, RowsSayWhereTheirClaimsLook) {
  ASSERT_EQ(cylon("truth projectile --every 0.1 --out d.json").code, 0);
  write("mine.toml", shipped("projectile") +
                         "\n[[claim]]\nfollows = { file = \"d.json\" }\nobservable = \"position\"\n"
                         "tolerance = { absolute = 1e-9, reason = \"r\" }\n");
  const Ran ran = cylon("run mine.toml bouncing_sphere --engine in-house --json -");
  ASSERT_EQ(ran.code, 0) << ran.err;
  int of_files = 0, of_events = 0;
  const json report = json::parse(ran.out);
  for (const json& row : report.at("verdicts")) {
    const std::string sampling = row.at("sampling");
    if (row.at("claim") == "position follows d.json") {
      ++of_files;
      EXPECT_EQ(sampling, "the times of the file");
    }
    if (row.at("observable") == "event") {
      ++of_events;
      EXPECT_EQ(sampling, "every step");
    }
  }
  EXPECT_EQ(of_files, 1);
  EXPECT_GT(of_events, 0);
}

// The command beside a row, run as it stands in the same folder, gives the same number.
TEST_F(CommandLine, CommandOfRowReproducesIt) {
  write("mine.toml", shipped("projectile"));
  write("projectile.toml",
        replaced(shipped("projectile"), "velocity = [3, 4, 0.5]", "velocity = [3, 5, 0.5]"));
  const std::string cases[] = {
      "projectile --engine ode --engine bullet/gyro=none --dt 0.1", "mine.toml --engine ode --dt 1/50",
      "./projectile.toml projectile --engine ode", "projectile --engine mine " + foreign,
      "projectile --integrator 'lie*' --engine in-house"};
  for (const std::string& arguments : cases) {
    const Ran first = cylon("run " + arguments + " --json -");
    ASSERT_TRUE(first.code == 0 || first.code == 1) << arguments << first.err;
    const json verdicts = json::parse(first.out).at("verdicts");
    for (const json& row : verdicts) {
      if (row.at("claim") != "position follows projectile") continue;
      const Ran again = shell(row.at("reproduce").get<std::string>() + " --json -");
      ASSERT_TRUE(again.code == 0 || again.code == 1) << row.at("reproduce") << again.err;
      EXPECT_EQ(json::parse(again.out).at("verdicts").at(0).at("measured"), row.at("measured"))
          << row.at("reproduce");
    }
  }
}

// Somebody's own projectile.toml is not judged by what expected.toml says of the shipped one.
TEST_F(CommandLine, ForeignFileHasNoExpectations) {
  write("projectile.toml",
        replaced(shipped("projectile"), "velocity = [3, 4, 0.5]", "velocity = [3, 5, 0.5]"));
  EXPECT_EQ(cylon("run projectile --engine ode").code, 0);
  EXPECT_EQ(cylon("run ./projectile.toml --engine ode").code, 1);
  write("projectile.toml", shipped("projectile"));  // an exact copy is the same scenario
  EXPECT_EQ(cylon("run ./projectile.toml --engine ode").code, 0);
}

// What an engine calls impossible was a refusal of each scene, after all the others had run.
TEST_F(CommandLine, MistakesInAnEnginesSettingsAreFoundBeforeAnythingRuns) {
  const char* mistakes[][2] = {{"bullet/sover=nncg", "no option 'sover', did you mean 'solver'?"},
                               {"bullet/solver=nncq", "did you mean 'nncg'?"},
                               {"bullet/path=as-expret", "did you mean 'as-expert'?"},
                               {"ode/integrator=semi-implicit-eular", "did you mean 'semi-implicit-euler'?"}};
  for (const auto& [engine, says] : mistakes)
    for (const char* command : {"run projectile", "trade projectile --rounds 0", "limits mass-ratio",
                                "hunt --count 1", "engines --fingerprint"}) {
      const std::string line = fmt::format(
          "{} {} in-house {} {}", command, std::string(command).starts_with("engines") ? "" : "--engine",
          std::string(command).starts_with("engines") ? "" : "--engine", engine);
      const Ran ran = cylon(line);
      EXPECT_EQ(ran.code, 2) << line << ran.err;
      EXPECT_EQ(ran.out, "") << line;
      EXPECT_NE(ran.err.find(says), std::string::npos) << line << ran.err;
      EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << line << ran.err;
    }
  EXPECT_FALSE(std::filesystem::exists(folder / ".cylon/journal.jsonl"));
  EXPECT_EQ(cylon("run projectile --engine in-house --engine bullet/solver=nncg --brief").code, 1);
  EXPECT_TRUE(std::filesystem::exists(folder / ".cylon/journal.jsonl"));
}

TEST_F(CommandLine, ResumeSaysWhereThereWasNothing) {
  const char* commands[] = {"run projectile --engine in-house --brief",
                            "trade projectile --engine in-house --rounds 0 --steps 1 --tolerance 1e-3"};
  for (const std::string command : commands) {
    const Ran first = cylon(command + " --resume"), second = cylon(command + " --resume");
    EXPECT_NE(first.err.find("nothing to resume"), std::string::npos) << command << first.err;
    EXPECT_EQ(first.err.find("resumed:"), std::string::npos) << command << first.err;
    EXPECT_NE(second.err.find("resumed:"), std::string::npos) << command << second.err;
    EXPECT_EQ(second.err.find("nothing to resume"), std::string::npos) << command << second.err;
  }
}

TEST_F(CommandLine, RerunFailedAndResumeRememberTheRequest) {
  EXPECT_EQ(cylon("run --rerun-failed").code, 4);
  EXPECT_EQ(cylon("run projectile --engine ode --engine in-house --dt 0.1").code, 1);
  const Ran again = cylon("run --rerun-failed --json -");
  EXPECT_EQ(again.code, 1) << again.err;
  const json verdicts = json::parse(again.out).at("verdicts");
  EXPECT_FALSE(verdicts.empty());
  for (const json& row : verdicts) EXPECT_EQ(row.at("engine"), "ode");
  EXPECT_NE(cylon("run --resume").err.find("resumed: 1 of 2 cells"), std::string::npos);
}

TEST_F(CommandLine, ResumesInterruptedRun) {
  const auto one_cell_is_done = [&] {  // three lines: what was asked for, of which part, and the cell
    const std::string journal = read(".cylon/journal.jsonl");
    return std::count(journal.begin(), journal.end(), '\n') >= 3;
  };
  // The second cell's engine hangs as long as a file stands there, so that the signal always finds the run
  // going; not where it is asked for its version.
  write("engine.sh", "[ -e asked ] && [ -e hang ] && exec sleep 100\ntouch asked\nexec " +
                         std::string(binary_dir) + "/cylon-worker-in-house\n");
  write("hang", "");
  const Ran cut =
      shell("exec cylon run projectile -j 1 --worker 'slow=sh engine.sh' --engine in-house --engine slow",
            one_cell_is_done);
  EXPECT_EQ(cut.code, 130) << cut.err;
  ASSERT_EQ(shell("rm hang").code, 0);
  EXPECT_NE(cut.err.find("cylon run --resume"), std::string::npos);
  const Ran on = cylon("run --resume");
  EXPECT_NE(on.err.find("resumed: 1 of 2 cells"), std::string::npos) << on.err;
  EXPECT_NE(on.out.find(" verdicts: "), std::string::npos);
}

TEST_F(CommandLine, ANewScenarioRuns) {
  EXPECT_EQ(cylon("new mine").code, 0);
  EXPECT_EQ(cylon("run mine.toml --engine in-house").code, 0);
  EXPECT_EQ(cylon("new mine").code, 2);
  EXPECT_EQ(cylon("new '../x'").code, 2);
}

}  // namespace
}  // namespace cylon::cli
