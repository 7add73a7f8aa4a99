// Random scenes, each asked of every part that gets what the reader accepts: accepted FROM COUNT.  Prints what is refused,
// and in the end "tried accepted failed"; with COUNT 0 the scene alone.  tests/fuzz/accepted.py calls it.
#include "harness/core/input_error.h"
#include "harness/core/simulator.h"
#include "harness/scenario/scenario.h"
#include "tests/fuzz/targets/objection.h"
#include "tests/fuzz/targets/random_scene.h"
#include "tests/paths.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace cylon::fuzz {
namespace {

constexpr std::size_t most_bodies = 100;  // that the in-house engine gets here

// The in-house engine takes a scene or says why not.  How long its steps take is no matter of acceptance.
std::string objection_of_engine(const scenario::Scenario& scenario) try {
  if (scenario.scene.bodies.size() > most_bodies) return "";
  static const std::unique_ptr<core::Simulator> simulator = core::make_simulator();
  core::Setup setup;
  setup.dt = scenario.step;
  if (simulator->load_if_supported(scenario.scene, setup).unsupported) return "";
  core::State state(scenario.scene.bodies.size());
  simulator->read(state);
  return "";
} catch (const std::exception& error) {
  return std::string("in-house: ") + error.what();
}

std::string fault(const SceneFile& scene, bool& accepted) {
  std::optional<scenario::Scenario> read;
  try {
    read = scenario::parse(scene.text, scene.file);
  } catch (const core::InputError& error) {
    return error.line > 0 && error.column > 0 ? ""
                                              : std::string("a refusal without a place: ") + error.what();
  } catch (const std::exception& error) {
    return std::string("the reader: ") + error.what();
  }
  accepted = true;
  const std::string said = objection(*read);
  return said.empty() ? objection_of_engine(*read) : said;
}

}  // namespace
}  // namespace cylon::fuzz

int main(int argc, char** argv) {
  using namespace cylon::fuzz;
  if (argc != 3) return 2;
  const auto shipped = shipped_scenes(cylon::source_dir);
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10),
                      count = std::strtoull(argv[2], nullptr, 10);
  if (count == 0) std::printf("%s", random_scene(shipped, first).text.c_str());
  std::uint64_t all = 0, failed = 0;
  for (std::uint64_t n = first; n < first + count; ++n) {
    const SceneFile scene = random_scene(shipped, n);
    bool accepted = false;
    const std::string said = fault(scene, accepted);
    all += accepted;
    if (said.empty()) continue;
    ++failed;
    std::printf("%llu, from %s: %s\n%s\n", static_cast<unsigned long long>(n), scene.file.c_str(),
                said.c_str(), scene.text.c_str());
  }
  std::printf("%llu %llu %llu\n", static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(all), static_cast<unsigned long long>(failed));
}
