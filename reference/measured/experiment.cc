#include "reference/measured/experiment.h"

#include "harness/core/content_hash.h"
#include "harness/core/recording.h"
#include "harness/scenario/input.h"
#include "harness/scenario/reader.h"
#include "reference/measured/coordinates.h"
#include "reference/measured/experiment_keys.h"
#include "reference/measured/table.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

namespace cylon::measured {
namespace {

using core::Quaternion, core::Vector3;

constexpr std::size_t longest_name = 100;  // of a run [characters]

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
    if (std::ranges::count(words, word) > 1) names.fail(key, fmt::format("{} has '{}' twice", key, word));
  }
  return found;
}

// How a row of the table becomes a state.
struct Conversion {
  const Experiment* experiment;
  std::vector<std::size_t> position = {}, orientation = {}, velocity = {}, angular_velocity = {};  // free
  std::vector<std::size_t> angles = {}, rates = {};                                                // chain
  double length = 1, angle = 1;            // to metres, to radians
  Quaternion up = Quaternion::Identity();  // from the axes of the data to y up
  bool left_handed = false;
  bool body_axes = false;
  double zero = 0;

  core::State state(const std::vector<double>& row) const {
    if (experiment->coordinates == Coordinates::chain) return chain(row);
    // A mirror of x makes right-handed axes of left-handed ones; of what turns it keeps x and mirrors y and z.
    const double mirror = left_handed ? -1 : 1;
    const auto vector = [&](const std::vector<std::size_t>& at) {
      return Vector3(mirror * row[at[0]], row[at[1]], row[at[2]]);
    };
    const auto turning = [&](const std::size_t* at) {
      return Vector3(row[at[0]], mirror * row[at[1]], mirror * row[at[2]]);
    };
    const Vector3 axis = turning(&orientation[1]), spin = angle * turning(angular_velocity.data());
    const Quaternion turn = Quaternion(row[orientation[0]], axis.x(), axis.y(), axis.z()).normalized();
    return {{.position = up * (length * vector(position)),
             .orientation = up * turn,
             .velocity = up * (length * vector(velocity)),
             .angular_velocity = up * (body_axes ? Vector3(turn * spin) : spin)}};
  }

  core::State chain(const std::vector<double>& row) const {
    const auto numbers = [&](const std::vector<std::size_t>& at, double less) {
      Eigen::VectorXd all(static_cast<Eigen::Index>(at.size()));
      for (std::size_t i = 0; i < at.size(); ++i)
        all[static_cast<Eigen::Index>(i)] = angle * (row[at[i]] - less);
      return all;
    };
    return chain_state(experiment->model.scene, experiment->bodies, numbers(angles, zero), numbers(rates, 0));
  }

  // The columns that are numbers of a state.
  std::vector<std::size_t> columns() const {
    std::vector<std::size_t> all;
    for (const auto* some : {&position, &orientation, &velocity, &angular_velocity, &angles, &rates})
      all.insert(all.end(), some->begin(), some->end());
    return all;
  }

  double norm(const std::vector<double>& row) const {
    if (orientation.empty()) return 1;
    double sum = 0;
    for (const std::size_t i : orientation) sum += row[i] * row[i];
    return std::sqrt(sum);
  }
};

Conversion conversion(const Experiment& e, const scenario::Table& root, const scenario::Table& names,
                      const Table& table) {
  Conversion made{&e};
  const bool chain = e.coordinates == Coordinates::chain;
  using Columns = std::vector<std::size_t> Conversion::*;
  const std::tuple<const char*, Columns, std::size_t, bool> rows[] = {
      {"position", &Conversion::position, 3, false},
      {"orientation", &Conversion::orientation, 4, false},
      {"velocity", &Conversion::velocity, 3, false},
      {"angular_velocity", &Conversion::angular_velocity, 3, false},
      {"angles", &Conversion::angles, e.bodies.size(), true},
      {"rates", &Conversion::rates, e.bodies.size(), true}};
  for (const auto& [key, columns, count, of_chain] : rows) {
    if (of_chain == chain)
      made.*columns = columns_of(names, key, count, table);
    else if (names.has(key))
      names.fail(key, fmt::format("{} is of {}", key,
                                  chain ? "a free body, not of a chain" : "a chain (bodies = […])"));
  }
  const auto units = root.table("units");
  if (!units) return made;
  made.length = std::array{1.0, 0.01, 0.001}.at(units->choice("length", {"m", "cm", "mm"}, std::size_t{0}));
  made.angle =
      std::array{1.0, std::numbers::pi / 180}.at(units->choice("angle", {"rad", "deg"}, std::size_t{0}));
  made.body_axes = units->text("angular_velocity", "world") == "body";
  made.zero = units->number("zero");
  made.left_handed = units->text("hand", "right") == "left";
  if (chain && made.left_handed) units->fail("hand", "a chain has angles, and no axes");
  if (units->text("up", "y") == "z")
    made.up = Quaternion(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2, 0, 0);  // (x, y, z) -> (x, z, -y)
  return made;
}

// Columns of a run beside its states, and how often it was seen.
struct Clock {
  std::size_t run = 0;
  std::optional<std::size_t> frame, time;
  double rate = 0;  // of rows [1/s]
  std::size_t every = 1;
};

// As a number where it is one: "7.0" is run 7.
std::string name_of(const Table& table, std::size_t row, std::size_t column) {
  const std::string_view word = table.word(row, column);
  double x = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), x);
  if (error == std::errc() && stop == word.data() + word.size())
    return fmt::format("{}", table.number(row, column));
  if (word.empty() || word.size() > longest_name)
    throw table.refuse(row, fmt::format("the name of a run has 1 to {} characters", longest_name));
  return std::string(word);
}

std::vector<Run> runs(const Table& table, const Conversion& conversion, const Clock& clock) {
  std::vector<Run> all;
  std::set<std::string> seen;
  const std::vector<std::size_t> columns = conversion.columns();
  std::vector<double> values(table.columns());
  std::size_t in_run = 0;
  double first_frame = 0, first_time = 0;
  core::ContentHash content;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string name = name_of(table, i, clock.run);
    const auto number = [&](std::optional<std::size_t> column) {
      return column ? table.number(i, *column) : 0;
    };
    const double frame = number(clock.frame), time = number(clock.time);
    if (all.empty() || name != all.back().name) {
      if (!seen.insert(name).second)
        throw table.refuse(i, fmt::format("run {} goes on after another one began", name));
      all.push_back({.name = name});
      content = {}, in_run = 0, first_frame = frame, first_time = time;
    }
    const auto k = static_cast<double>(in_run);
    if (clock.frame && frame != first_frame + k)
      throw table.refuse(
          i, fmt::format("frame {} of run {} follows where {} is missing", frame, name, first_frame + k));
    if (clock.time && !(std::abs(time - first_time - k / clock.rate) <= 0.1 / clock.rate))
      throw table.refuse(i, fmt::format("run {} is at {} s, where {} frames a second make it {:.9g} s", name,
                                        time, clock.rate, first_time + k / clock.rate));
    for (const std::size_t column : columns) {
      values[column] = table.number(i, column);
      content.add(fmt::format("{},", values[column]));
    }
    if (!(std::abs(conversion.norm(values) - 1) <= 1e-3))
      throw table.refuse(i,
                         fmt::format("the quaternion has the length {:.6g}, not 1", conversion.norm(values)));
    if (in_run++ % clock.every == 0) all.back().states.push_back(conversion.state(values));
    all.back().hash = content.hex();
  }
  for (const Run& one : all)
    if (one.states.size() < 2)
      throw core::InputError(fmt::format("{}: run {} has fewer than two frames", table.file(), one.name));
  return all;
}

std::size_t body_of(const scenario::Table& root, const char* key, const std::string& name,
                    const core::Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == name) return i;
    names.push_back(scene.bodies[i].name);
  }
  root.fail(key, fmt::format("the scene has no body '{}'{}", name, core::did_you_mean(name, names)));
}

void read_bodies(const scenario::Table& root, Experiment& e) {
  if (root.has("body") == root.has("bodies")) root.fail("either body or bodies says what was measured");
  if (root.has("body")) {
    e.bodies = {body_of(root, "body", root.text("body"), e.model.scene)};
    return;
  }
  for (const std::string& name : root.texts("bodies"))
    e.bodies.push_back(body_of(root, "bodies", name, e.model.scene));
  if (e.bodies.empty()) root.fail("bodies", "a chain has one body or more");
  if (const std::string why = no_chain(e.model.scene, e.bodies); !why.empty())
    root.fail("bodies", fmt::format("no chain of hinges with parallel axes: {}", why));
  e.coordinates = Coordinates::chain;
}

std::vector<std::string> coordinate_names(const Experiment& e) {
  std::vector<std::string> names;
  if (e.coordinates == Coordinates::chain) {
    for (const char* what : {"angle", "rate"})
      for (std::size_t i = 1; i <= e.bodies.size(); ++i) names.push_back(fmt::format("{} {}", what, i));
    return names;
  }
  for (const char* what : {"position", "orientation", "velocity", "angular_velocity"})
    for (const char* axis : {"x", "y", "z"}) names.push_back(fmt::format("{} {}", what, axis));
  return names;
}

// L of the covariance: deviations on the diagonal times the Cholesky factor of the correlations.
Eigen::MatrixXd start_factor(const Experiment& e, const scenario::Table& sd) {
  const std::vector<std::string> names = coordinate_names(e);
  const auto n = static_cast<Eigen::Index>(names.size());
  Eigen::VectorXd deviation(n);
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    deviation[i] = sd.number(name.substr(0, name.find(' ')));
  }
  for (const scenario::Table& row : sd.tables("correlation")) {
    const std::vector<std::string> pair = row.texts("between");
    Eigen::Index at[2];
    for (int k = 0; k < 2; ++k) {
      const auto found = std::ranges::find(names, pair[static_cast<std::size_t>(k)]);
      if (found == names.end())
        row.fail("between", fmt::format("no coordinate '{}'{}", pair[static_cast<std::size_t>(k)],
                                        core::did_you_mean(pair[static_cast<std::size_t>(k)], names)));
      at[k] = found - names.begin();
    }
    if (at[0] == at[1]) row.fail("between", "a coordinate with itself");
    correlation(at[0], at[1]) = correlation(at[1], at[0]) = row.number("value");
  }
  const Eigen::LLT<Eigen::MatrixXd> root(correlation);
  if (root.info() != Eigen::Success)
    sd.fail("correlation", "no errors have these correlations: not positive definite");
  return deviation.asDiagonal() * Eigen::MatrixXd(root.matrixL());
}

Parameter parameter(const scenario::Table& row, const Experiment& e) {
  Parameter p{row.text("name"),  row.text("kind"),    row.text("body"),
              row.number("low"), row.number("start"), row.number("high")};
  if (row.has("body")) {
    const std::size_t body = body_of(row, "body", p.body, e.model.scene);
    if (std::ranges::find(e.bodies, body) == e.bodies.end())
      row.fail("body", fmt::format("'{}' was not measured", p.body));
  }
  if (!(p.low < p.high)) row.fail("high", fmt::format("{} is not above low = {}", p.high, p.low));
  if (!(p.low <= p.start && p.start <= p.high))
    row.fail("start", fmt::format("{} is outside [{}, {}]", p.start, p.low, p.high));
  const auto kind = std::ranges::find(parameter_kinds(), p.kind, &ParameterKind::name);
  if (p.low < kind->least)
    row.fail("low", fmt::format("{} is below {:g}, the least of {}", p.low, kind->least, p.kind));
  if (p.high > kind->most)
    row.fail("high", fmt::format("{} is above {:g}, the most of {}", p.high, kind->most, p.kind));
  for (const Parameter& other : e.parameters)
    if (other.name == p.name) row.fail("name", fmt::format("two parameters are named '{}'", p.name));
  try {
    Experiment tried = e;
    kind->apply(tried, p, p.start);
  } catch (const core::InputError& error) {
    row.fail("kind", error.what());
  }
  return p;
}

}  // namespace

std::size_t Experiment::longest() const {
  std::size_t most = 0;
  for (const Run& run : runs) most = std::max(most, run.states.size());
  return most;
}

Experiment read(const std::filesystem::path& path) {
  const std::string text = scenario::read_file(path);
  const scenario::Document document(text, path.string(), experiment_keys());
  const scenario::Table root = document.root(), names = *root.table("columns");
  Experiment made{{.file = path.string(),
                   .title = root.text("title"),
                   .source = root.text("source"),
                   .licence = root.text("licence"),
                   .instrument = root.text("instrument"),
                   .known = root.texts("known"),
                   .model = scenario::read(path.parent_path() / root.text("model")),
                   .rate = root.number("rate") / static_cast<double>(root.whole("every", 1))},
                  {}};
  read_bodies(root, made);
  try {
    core::whole_steps(1 / made.rate, made.model.step);
  } catch (const std::invalid_argument& error) {
    root.fail("rate", fmt::format("a frame is no whole number of the scene's steps: {}", error.what()));
  }
  made.start = Eigen::MatrixXd::Zero(coordinates(made), coordinates(made));
  if (const auto sd = root.table("uncertainty")) {
    made.noise = sd->number("noise"), made.angle_noise = sd->number("angle_noise");
    made.start = start_factor(made, *sd);
    made.material = {sd->number("friction"), sd->number("restitution")};
  }
  if (const auto fit = root.table("fit")) {
    made.fit.horizon = fit->number("horizon");
    if (fit->has("degrees")) made.fit.degrees = fit->number("degrees");
    if (!(made.fit.horizon * made.rate >= 2)) fit->fail("horizon", "a window has three frames or more");
  }
  for (const scenario::Table& row : root.tables("parameter")) made.parameters.push_back(parameter(row, made));
  const Table table(path.parent_path() / root.text("data"));
  core::ContentHash content;
  for (const std::string& part : {text, table.hash(), made.model.hash}) content.add(part);
  made.hash = content.hex();
  const auto one = [&](const char* key) {
    try {
      return table.column(names.text(key));
    } catch (const core::InputError& error) {
      names.fail(key, error.what());
    }
  };
  Clock clock{.run = one("run"), .rate = root.number("rate")};
  clock.every = static_cast<std::size_t>(root.whole("every", 1));
  if (names.has("frame")) clock.frame = one("frame");
  if (names.has("time")) clock.time = one("time");
  made.runs = runs(table, conversion(made, root, names, table), clock);
  return made;
}

}  // namespace cylon::measured
