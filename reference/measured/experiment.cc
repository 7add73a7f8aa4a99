#include "reference/measured/experiment.h"

#include "harness/core/recording.h"
#include "harness/scenario/input.h"
#include "harness/scenario/key_rows.h"
#include "harness/scenario/reader.h"
#include "reference/measured/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace cylon::measured {
namespace {

using core::Quaternion, core::Vector3;
using scenario::Key, scenario::Kind, scenario::Spec;

const Spec* column_spec() {
  static const Spec spec{
      .label = "[columns]",
      .keys = {
          required(scenario::word("run", "Column whose value tells the runs apart.")),
          scenario::word("frame", "Column that counts the frames of a run, one by one; absent: not checked."),
          required(scenario::plain("position", Kind::texts, "Three columns: of the centre of mass.")),
          required(scenario::plain("orientation", Kind::texts, "Four columns: w, x, y, z of body to world.")),
          required(scenario::plain("velocity", Kind::texts, "Three columns: of the centre of mass.")),
          required(scenario::plain("angular_velocity", Kind::texts, "Three columns."))}};
  return &spec;
}

const Spec* unit_spec() {
  static const Spec spec{
      .label = "[units]",
      .keys = {
          absent("\"m\"",
                 scenario::word("length", "Of positions; velocities are this a second.", {"m", "cm", "mm"})),
          absent("\"rad\"", scenario::word("angle", "Angular velocities are this a second.", {"rad", "deg"})),
          absent("\"y\"", scenario::word("up", "The axis of the data that points up.", {"y", "z"})),
          absent("\"world\"", scenario::word("angular_velocity", "Its axes.", {"world", "body"}))}};
  return &spec;
}

const Spec* uncertainty_spec() {
  static const Spec spec{
      .label = "[uncertainty]",
      .keys = {
          absent("0", scenario::real("noise", "m", "Of each coordinate of a measured position.",
                                     core::not_negative)),
          absent("0",
                 scenario::real("position", "m", "Of each coordinate of the start.", core::not_negative)),
          absent("0", scenario::real("orientation", "rad", "Of a small turn of the start about each axis.",
                                     core::not_negative)),
          absent("0",
                 scenario::real("velocity", "m/s", "Of each coordinate of the start.", core::not_negative)),
          absent("0", scenario::real("angular_velocity", "rad/s", "Of each coordinate of the start.",
                                     core::not_negative)),
          absent("0", scenario::real("friction", "", "Of every friction of the scene.", core::not_negative)),
          absent("0", scenario::real("restitution", "", "Of every restitution of the scene.",
                                     core::not_negative))}};
  return &spec;
}

const Spec& experiment_keys() {
  static const Spec spec{
      .label = "an experiment",
      .keys = {
          required(scenario::word("title", "One line.")),
          required(scenario::word("source", "Who measured it, and where it was published.")),
          required(scenario::word("licence", "Of the data.")),
          scenario::word("instrument", "What it was measured with."),
          scenario::plain("known", Kind::texts, "What is known to be wrong with the data."),
          required(
              scenario::word("data", "The table: CSV with a head line, plain or gzip; beside this file.")),
          required(scenario::word("model", "The scene, a scenario file without claims; beside this file.")),
          required(scenario::word("body", "The body of the scene that was measured.")),
          required(scenario::real("rate", "1/s", "Frames a second.", core::positive)),
          required(nested("columns", Kind::table, column_spec, "Which columns hold what.")),
          nested("units", Kind::table, unit_spec, "Units and axes of the data."),
          nested("uncertainty", Kind::table, uncertainty_spec, "Standard deviations.")}};
  return spec;
}

std::vector<std::size_t> columns_of(const scenario::Table& names, const char* key, std::size_t count,
                                    const Table& table) {
  const std::vector<std::string> words = names.texts(key);
  if (words.size() != count) names.fail(key, fmt::format("{} needs {} columns", key, count));
  std::vector<std::size_t> found;
  for (const std::string& word : words) {
    try {
      found.push_back(table.column(word));
    } catch (const core::InputError& error) {
      names.fail(key, error.what());
    }
  }
  return found;
}

// How a row of the table becomes a state.
struct Conversion {
  std::vector<std::size_t> position, orientation, velocity, angular_velocity;
  double length = 1, angle = 1;            // to metres, to radians
  Quaternion up = Quaternion::Identity();  // from the axes of the data to y up
  bool body_axes = false;

  core::BodyState state(const std::vector<double>& row) const {
    const auto vector = [&](const std::vector<std::size_t>& at) {
      return Vector3(row[at[0]], row[at[1]], row[at[2]]);
    };
    const Quaternion turn =
        Quaternion(row[orientation[0]], row[orientation[1]], row[orientation[2]], row[orientation[3]])
            .normalized();
    const Vector3 spin = angle * vector(angular_velocity);
    return {.position = up * (length * vector(position)),
            .orientation = up * turn,
            .velocity = up * (length * vector(velocity)),
            .angular_velocity = up * (body_axes ? Vector3(turn * spin) : spin)};
  }

  double norm(const std::vector<double>& row) const {
    double sum = 0;
    for (const std::size_t i : orientation) sum += row[i] * row[i];
    return std::sqrt(sum);
  }
};

Conversion conversion(const scenario::Table& root, const scenario::Table& names, const Table& table) {
  Conversion made{columns_of(names, "position", 3, table), columns_of(names, "orientation", 4, table),
                  columns_of(names, "velocity", 3, table), columns_of(names, "angular_velocity", 3, table)};
  const auto units = root.table("units");
  if (!units) return made;
  made.length = std::array{1.0, 0.01, 0.001}.at(units->choice("length", {"m", "cm", "mm"}, std::size_t{0}));
  made.angle =
      std::array{1.0, std::numbers::pi / 180}.at(units->choice("angle", {"rad", "deg"}, std::size_t{0}));
  made.body_axes = units->text("angular_velocity", "world") == "body";
  if (units->text("up", "y") == "z")
    made.up = Quaternion(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2, 0, 0);  // (x, y, z) -> (x, z, -y)
  return made;
}

std::vector<Run> runs(const Table& table, const Conversion& row, std::size_t run,
                      std::optional<std::size_t> frame) {
  std::vector<Run> all;
  std::map<double, bool> seen;
  double before = std::nan(""), count = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<double>& values = table.rows[i];
    const auto refuse = [&](const std::string& why) {
      return core::InputError(fmt::format("{}:{}: {}", table.file, i + 2, why));
    };
    if (values[run] != before) {
      if (!seen.emplace(values[run], true).second)
        throw refuse(fmt::format("run {} goes on after another one began", values[run]));
      all.push_back({fmt::format("{}", values[run]), {}});
      if (frame) count = values[*frame];
    }
    before = values[run];
    if (frame && values[*frame] != count)
      throw refuse(
          fmt::format("frame {} of run {} follows where {} is missing", values[*frame], values[run], count));
    ++count;
    if (!(std::abs(row.norm(values) - 1) <= 1e-3))
      throw refuse(fmt::format("the quaternion has the length {:.6g}, not 1", row.norm(values)));
    all.back().states.push_back(row.state(values));
  }
  for (const Run& one : all)
    if (one.states.size() < 2)
      throw core::InputError(fmt::format("{}: run {} has fewer than two frames", table.file, one.name));
  return all;
}

std::size_t body_of(const scenario::Table& root, const core::Scene& scene) {
  const std::string name = root.text("body");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == name) return i;
    names.push_back(scene.bodies[i].name);
  }
  root.fail("body", fmt::format("the scene has no body '{}'{}", name, core::did_you_mean(name, names)));
}

}  // namespace

std::size_t Experiment::longest() const {
  std::size_t most = 0;
  for (const Run& run : runs) most = std::max(most, run.states.size());
  return most;
}

Experiment read(const std::filesystem::path& path) {
  const scenario::Document document(scenario::read_file(path), path.string(), experiment_keys());
  const scenario::Table root = document.root(), names = *root.table("columns");
  Experiment made{.file = path.string(),
                  .title = root.text("title"),
                  .source = root.text("source"),
                  .licence = root.text("licence"),
                  .instrument = root.text("instrument"),
                  .known = root.texts("known"),
                  .model = scenario::read(path.parent_path() / root.text("model")),
                  .rate = root.number("rate"),
                  .runs = {}};
  made.body = body_of(root, made.model.scene);
  try {
    core::whole_steps(1 / made.rate, made.model.step);
  } catch (const std::invalid_argument& error) {
    root.fail("rate", fmt::format("a frame is no whole number of the scene's steps: {}", error.what()));
  }
  if (const auto sd = root.table("uncertainty")) {
    made.noise = sd->number("noise");
    made.start = {sd->number("position"), sd->number("orientation"), sd->number("velocity"),
                  sd->number("angular_velocity")};
    made.material = {sd->number("friction"), sd->number("restitution")};
  }
  const Table table = read_table(path.parent_path() / root.text("data"));
  const auto one = [&](const char* key) {
    try {
      return table.column(names.text(key));
    } catch (const core::InputError& error) {
      names.fail(key, error.what());
    }
  };
  std::optional<std::size_t> frame;
  if (names.has("frame")) frame = one("frame");
  made.runs = runs(table, conversion(root, names, table), one("run"), frame);
  return made;
}

}  // namespace cylon::measured
