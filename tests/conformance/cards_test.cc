// The faults kept in cards/: each is still in its engine, its program shows it, and the in-house engine has none of them.
#include "harness/core/scene.h"
#include "harness/hunt/card.h"
#include "harness/process/client.h"
#include "harness/process/engines.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace cylon::hunt {
namespace {

namespace fs = std::filesystem;

const process::Limits limits{.run_seconds = 60};

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path folder() { return fs::path(source_dir) / "cards"; }

Kept kept(const std::string& stem) { return read_card((folder() / (stem + ".toml")).string()); }

class KeptCard : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    card_ = kept(GetParam());
    engine_ = process::parse_engine(card_.engine, process::default_engines(binary_dir));
  }
  std::optional<std::string> missing() const { return process::missing(engine_.row); }
  fs::path beside(const char* ending) const { return folder() / (GetParam() + ending); }
  scenario::Scenario said() const { return scenario::read(beside(".toml").string()); }

  Kept card_;
  process::EngineChoice engine_;
};

TEST_P(KeptCard, SaysWhatItIsAndWhatTracesIt) {
  const scenario::Scenario read = said();
  EXPECT_NE(read.title, read.name);
  EXPECT_GT(read.story.size(), 40u);
  EXPECT_LE(read.scene.bodies.size(), 4u);
  const std::string page = text_of(beside(".md")),
                    row = fmt::format("| [{}](../cards/{}.md) | {} | {} |\n", read.title, GetParam(),
                                      card_.engine, read.story);
  EXPECT_NE(page.find(read.story), std::string::npos) << beside(".md") << " lacks the story";
  EXPECT_NE(text_of(fs::path(source_dir) / "docs/hunt.md").find(row), std::string::npos)
      << "docs/hunt.md lacks\n"
      << row;
}

TEST_P(KeptCard, IsStillThere) {
  if (missing()) GTEST_SKIP() << *missing();
  const Replayed now = replay(card_, engine_, limits);
  EXPECT_EQ(name(now.what), "still there") << now.measured << ", was " << card_.measured;
}

TEST_P(KeptCard, IsNoFaultOfTheInHouseEngine) {
  const process::EngineChoice own = process::parse_engine("in-house", process::default_engines(binary_dir));
  const Replayed now = replay(card_, own, limits);
  if (now.what == Replayed::What::refused) GTEST_SKIP() << first_step(card_.trial, own, limits).reason;
  EXPECT_EQ(name(now.what), "fixed") << now.measured;
}

// Where the engine has a setting without the cause, the card says which.
TEST_P(KeptCard, IsGoneWithItsCause) {
  const std::string key = "gone with: ";
  const std::vector<std::string> tags = said().tags;
  const auto tag = std::ranges::find_if(tags, [&](const std::string& t) { return t.starts_with(key); });
  if (tag == tags.end()) GTEST_SKIP() << "no setting is without the cause";
  const process::EngineChoice other =
      process::parse_engine(tag->substr(key.size()), process::default_engines(binary_dir));
  EXPECT_EQ(other.row.id, engine_.row.id);
  if (missing()) GTEST_SKIP() << *missing();
  EXPECT_EQ(name(replay(card_, other, limits).what), "fixed");
}

// What the page says that its program prints.
TEST_P(KeptCard, IsShownByItsProgram) {
  const std::string page = text_of(beside(".md"));
  std::smatch told;
  const std::regex command("It must print ([-+.e0-9]+) ([^:\n]+):\n\n```sh\n.* && (.*&& ./fault|node .*)\n");
  if (!std::regex_search(page, told, command)) {
    const std::size_t at = page.find("There is no program");
    ASSERT_NE(at, std::string::npos);
    GTEST_SKIP() << page.substr(at, page.find('\n', at) - at);
  }
  if (missing()) GTEST_SKIP() << *missing();
  const TemporaryFolder own;
  for (const char* ending : {".cc", ".mjs"})
    if (fs::exists(beside(ending))) fs::copy(beside(ending), own.path());
  const fs::path modules = fs::path(source_dir) / "reference/simulators/js/node_modules";
  if (fs::exists(modules)) fs::create_directory_symlink(modules, own.path() / "node_modules");
  std::string out;
  const std::string line =
      fmt::format("PATH={}/tests/cached:$PATH; cd {} && {}", source_dir, own.path().string(), told[3].str());
  FILE* pipe = popen(line.c_str(), "r");
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe)) out += part.data();
  ASSERT_EQ(pclose(pipe), 0) << out;
  const double prints = std::stod(told[1]);
  EXPECT_NEAR(std::strtod(out.c_str(), nullptr), prints, 1e-3 * prints) << out;
  EXPECT_TRUE(out.ends_with(told[2].str() + "\n")) << out;
}

std::vector<std::string> stems() {
  std::vector<std::string> all;
  for (const fs::path& file : card_files(folder())) all.push_back(file.stem().string());
  return all;
}

std::string test_name_of(const testing::TestParamInfo<std::string>& card) {
  std::string name = card.param;
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, KeptCard, testing::ValuesIn(stems()), test_name_of);

double time_of(const Kept& card) { return card.trial.step * static_cast<double>(card.trial.steps); }

// The velocity of the first body at the end, in steps of a 64th; nothing where the engine is not here.
std::optional<core::Vector3> end_of(const Kept& card) {
  const process::EngineChoice engine =
      process::parse_engine(card.engine, process::default_engines(binary_dir));
  if (process::missing(engine.row)) return std::nullopt;
  process::RunRequest request;
  request.scene = &card.trial.scene;
  request.setup.dt = card.trial.step / 64, request.steps = 64 * card.trial.steps;
  const process::RunOutcome outcome = process::run(engine, request, limits);
  EXPECT_TRUE(outcome.recording) << outcome.reason;
  if (!outcome.recording) return std::nullopt;
  return outcome.recording->states.back()[0].velocity;
}

// Of a box that slides on the plane y = 0 on the corners of its lower face, without turning: the velocity where friction
// points along D v, and not along v.  D_x and D_z are the masses that a force along x or z at a point (x, -h, z) from the
// middle moves: 1/D_x = 1/m + h^2/I_z + z^2/I_y, 1/D_z = 1/m + h^2/I_x + x^2/I_y.
core::Vector3 slid(const core::Scene& scene, bool at_corners, double time) {
  const core::Body& body = scene.bodies[0];
  const core::Vector3 half = std::get<core::Box>(body.shape).half_extents, I = body.inertia.diagonal();
  const double x = at_corners ? half.x() : 0, h = half.y(), z = at_corners ? half.z() : 0;
  const core::Vector3 D(1 / (1 / body.mass + h * h / I.z() + z * z / I.y()), 0,
                        1 / (1 / body.mass + h * h / I.x() + x * x / I.y()));
  const double deceleration = scene.materials[0].friction * core::gravity(scene).norm();
  core::Vector3 v = body.initial.velocity;
  constexpr int steps = 100000;
  for (int k = 0; k < steps; ++k) v -= deceleration * time / steps * D.cwiseProduct(v).normalized();
  return v;
}

TEST(KeptCards, SlideAlongEffectiveMasses) {
  struct Row {
    const char* card;
    bool at_corners;
    double within;  // [m/s]
  };
  for (const Row& row :
       {Row{"bullet-multibody-slide-ee1cf4", true, 1e-4}, Row{"jolt-slide-52fcf9", false, 1e-4},
        Row{"rapier-slide-eb2874", false, 3e-4}, Row{"crashcat-slide-8cb9c1", false, 5e-5}}) {
    const Kept card = kept(row.card);
    const std::optional<core::Vector3> end = end_of(card);
    if (!end) continue;
    const core::Vector3 start = card.trial.scene.bodies[0].initial.velocity;
    const core::Vector3 told = slid(card.trial.scene, row.at_corners, time_of(card));
    EXPECT_LT((*end - told).norm(), row.within) << row.card << ' ' << end->transpose();
    // Coulomb's law keeps the direction.
    EXPECT_GT(end->cross(start).norm() / start.norm(), 10 * row.within) << row.card;
  }
}

// Of a pyramid whose edges are the axes of the world: each component falls by mu g t.
TEST(KeptCards, SlideByPyramids) {
  for (const char* name : {"ode-slide-22b433", "dart-slide-ec90ab"}) {
    const Kept card = kept(name);
    const std::optional<core::Vector3> end = end_of(card);
    if (!end) continue;
    const core::Scene& scene = card.trial.scene;
    const double loss = scene.materials[0].friction * core::gravity(scene).norm() * time_of(card);
    core::Vector3 told = scene.bodies[0].initial.velocity;
    for (double& v : told) v -= std::copysign(std::min(loss, std::abs(v)), v);
    EXPECT_LT((*end - told).norm(), 1e-5) << name << ' ' << end->transpose();
  }
}

// What the stories say, computed.  That engines still have these numbers is asked above.
TEST(KeptCards, NumbersFollowFromTheirCauses) {
  using std::numbers::pi;
  const double turn = 0.01 * std::hypot(20, 80);  // [rad] of a step
  const double inverse = 0.333984375;             // 1/3 in eight bits [1/kg]
  struct Row {
    const char* card;
    double told, relative;
  };
  for (const Row& row :
       {Row{"bullet-spin-5006ac", 3 * (turn - 2 * std::atan(turn * std::tan(pi / 8) / (pi / 4))), 1e-9},
        Row{"rapier-energy-e2d450", 0.0327184 / 2 * (80 * 80 - std::pow(pi / 4 / 0.01, 2)), 1e-4},
        Row{"havok-path-stand-in-angular-momentum-560350",
            2 * std::sin(0.05 * std::numbers::sqrt2) * (0.040524333333333336 - 0.022512666666666663) /
                std::numbers::sqrt2,
            1e-4},
        Row{"havok-linear-momentum-75c536", 6 / (1 + inverse) * (3 * inverse - 1), 1e-3}}) {
    const Kept card = kept(row.card);
    EXPECT_NEAR(card.measured, row.told, row.relative * row.told) << row.card;
  }
}

// A file that belongs to no card would be checked by nothing.
TEST(KeptCards, HaveNoFilesBesides) {
  const std::vector<std::string> all = stems();
  EXPECT_GE(all.size(), 10u);
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_TRUE(std::ranges::count(all, entry.path().stem().string()) ||
                entry.path().filename() == ".clang-format")
        << entry.path();
}

}  // namespace
}  // namespace cylon::hunt
