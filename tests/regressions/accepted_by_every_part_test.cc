// `cylon validate` said ok, and the run then died whole: a mesh index out of range behind a stated inertia,
// clouds whose places overflow.  What the reader accepts, every other part accepts: the worker's reader, the
// writer, the sampling, the truths.  Over the shipped scenes and mutants of them, 1500 unless CYLON_MUTANTS
// says more.
#include "harness/core/input_error.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/scene_json.h"
#include "harness/scenario/input.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/writer.h"
#include "harness/study/cell.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>
#include <string>
#include <vector>

namespace cylon {
namespace {

namespace fs = std::filesystem;

struct Seed {
  std::string file, text;
};

// Those whose truths are not certified, which take seconds each.
std::vector<Seed> seeds() {
  std::vector<Seed> all;
  for (const char* folder : {"scenarios", "scenarios/extremes", "tests/data/mixes"})
    for (const auto& entry : fs::directory_iterator(fs::path(source_dir) / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".toml" || path.filename() == "expected.toml") continue;
      std::ifstream in(path, std::ios::binary);
      std::string text(std::istreambuf_iterator<char>(in), {});
      if (text.find("certified") == std::string::npos && text.size() < 20'000)
        all.push_back({path.string(), text});
    }
  std::ranges::sort(all, {}, &Seed::file);
  return all;
}

// One to three values replaced by others that a stranger would try.
std::string mutated(const std::string& text, std::mt19937_64& random) {
  static const std::regex value(R"(-?\d+\.?\d*(e[-+]?\d+)?)");
  static const char* const others[] = {"0",    "-1",  "1e308", "1e-308",  "5e-324", "1e9",
                                       "1e-9", "0.1", "2",     "1000000", "-0.0",   "3"};
  const auto pick = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  std::string result = text;
  for (std::size_t i = 0, n = 1 + pick(3); i < n; ++i) {
    const std::vector<std::smatch> found(std::sregex_iterator(result.begin(), result.end(), value), {});
    if (found.empty()) break;
    const std::smatch& one = found[pick(found.size())];
    const auto at = static_cast<std::size_t>(one.position());
    const auto length = static_cast<std::size_t>(one.length());
    result.replace(at, length, others[pick(std::size(others))]);
  }
  return result;
}

// What a part says against a scene that the reader took, or "".
std::string objection(const scenario::Scenario& scenario) try {
  const nlohmann::json message = process::to_json(scenario.scene);
  const core::Scene back = process::scene_from_json(process::parse_object(process::line(message)));
  if (process::to_json(back) != message) return "the worker reads another scene";
  for (const core::Claim& claim : scenario.claims) {
    if (!claim.truth || !claim.truth->times.empty()) continue;
    const double horizon = std::min({claim.until, scenario.duration, claim.truth->horizon});
    for (const double t : {0.0, 0.37 * horizon, horizon})
      if (claim.truth->state(t).size() != scenario.scene.bodies.size()) return "a truth has other bodies";
  }
  const std::string again = scenario::to_toml(scenario.scene);
  // The viewer does not write what it cannot read back, and says so (view/record_file.h).
  if (again.size() > scenario::largest_input) return "";
  const scenario::Scenario written =
      scenario::parse("duration = 1\nstep = 0.125\n" + again, scenario.file + ".written.toml");
  if (written.scene.bodies.size() != scenario.scene.bodies.size())
    return "the written scene has other bodies";
  try {
    study::sampling(scenario, scenario.step);
  } catch (const core::InputError& error) {
    return std::string("sampling: ") + error.what();
  }
  return "";
} catch (const std::exception& error) {
  return error.what();
}

// The mean of the nine numbers with their transpose overflowed, or was nothing.
TEST(AcceptedByEveryPart, IsTheLargestAndTheLeastInertia) {
  for (const char* inertia : {"[1, 1e308, 1e308]", "[1e-323, 5e-324, 5e-324]"}) {
    const scenario::Scenario scenario = scenario::parse(
        std::string("duration = 1\nstep = 0.125\n[[body]]\nname = \"b\"\nmass = 1\ninertia = ") +
            std::string(inertia) +
            "\n[[claim]]\n"
            "conserves = \"velocity\"\ntolerance = { absolute = 1, reason = \"none\" }\n",
        "largest.toml");
    EXPECT_EQ(objection(scenario), "") << inertia;
  }
}

TEST(AcceptedByEveryPart, IsWhatTheReaderAccepts) {
  const char* asked = std::getenv("CYLON_MUTANTS");
  const int count = asked ? std::atoi(asked) : 1500;
  const std::vector<Seed> all = seeds();
  ASSERT_GT(all.size(), 50u);
  std::mt19937_64 random(20261123);
  int accepted = 0;
  for (int i = 0; i < count + static_cast<int>(all.size()); ++i) {
    const Seed& seed = all[static_cast<std::size_t>(i) % all.size()];
    const std::string text = i < static_cast<int>(all.size()) ? seed.text : mutated(seed.text, random);
    std::optional<scenario::Scenario> scenario;
    try {
      scenario = scenario::parse(text, seed.file);
    } catch (const core::InputError& error) {
      EXPECT_GT(error.line, 0u) << seed.file << ", mutant " << i << ": " << error.what();
      continue;
    }
    ++accepted;
    EXPECT_EQ(objection(*scenario), "") << seed.file << ", mutant " << i << "\n" << text;
    if (HasFailure() && i > 3 * static_cast<int>(all.size())) break;
  }
  EXPECT_GT(accepted, count / 5);
}

}  // namespace
}  // namespace cylon
