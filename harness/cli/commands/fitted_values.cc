#include "harness/cli/commands/fitted_values.h"

#include "harness/cli/read_whole.h"
#include "harness/core/input_error.h"
#include "harness/input/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace cylon::cli {
namespace {

using nlohmann::json;

constexpr std::size_t longest_file = std::size_t{64} << 20;  // [bytes]

const measured::Parameter& parameter_of(const measured::Experiment& e, const std::string& file,
                                        const std::string& name) {
  const auto found = std::ranges::find(e.parameters, name, &measured::Parameter::name);
  if (found != e.parameters.end()) return *found;
  std::vector<std::string> names;
  for (const measured::Parameter& p : e.parameters) names.push_back(p.name);
  throw core::InputError(fmt::format("{}: it fits '{}', which {} has not{}", file, name, e.file,
                                     core::did_you_mean(name, names)));
}

Eigen::MatrixXd matrix(const json& rows, std::size_t size) {
  Eigen::MatrixXd made(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  if (rows.size() != size) throw std::invalid_argument("it is of another size than the parameters");
  for (std::size_t i = 0; i < size; ++i) {
    if (rows[i].size() != size) throw std::invalid_argument("it is of another size than the parameters");
    for (std::size_t j = 0; j < size; ++j)
      made(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j].get<double>();
  }
  return made;
}

FoundFit read_fit(const json& one, const std::string& file, const measured::Experiment& e, bool covariance) {
  FoundFit made;
  made.engine = one.at("engine").get<std::string>(), made.failure = one.at("failure").get<std::string>();
  for (const json& run : one.at("fitted_data")) made.seen.insert(run.get<std::string>());
  if (!made.failure.empty()) return made;
  std::vector<std::string> unknown;
  for (const json& p : one.at("parameters")) {
    const auto name = p.at("name").get<std::string>();
    const measured::Parameter& parameter = parameter_of(e, file, name);
    const auto value = p.at("value").get<double>();
    if (!(parameter.low <= value && value <= parameter.high))
      throw core::InputError(fmt::format("{}: '{}' is {:g}, outside [{:g}, {:g}] of {}", file, name, value,
                                         parameter.low, parameter.high, e.file));
    if (p.at("error").is_null()) unknown.push_back("'" + name + "'");
    made.fitted.parameters.push_back(parameter), made.fitted.values.push_back(value);
  }
  if (!covariance) return made;
  if (!unknown.empty())
    throw core::InputError(fmt::format(
        "{}: the fit of {} cannot tell apart {}, so that a band of them is not known; fit fewer (cylon fit "
        "--parameters), or leave the band out (--members 0)",
        file, made.engine, fmt::join(unknown, ", ")));
  try {
    made.fitted.factor = validation::factor_of(matrix(one.at("covariance"), made.fitted.values.size()));
  } catch (const std::invalid_argument& error) {
    throw core::InputError(fmt::format("{}: covariance of {}: {}", file, made.engine, error.what()));
  }
  return made;
}

}  // namespace

std::vector<FoundFit> read_fits(const std::string& file, const measured::Experiment& e, bool covariance) {
  std::vector<FoundFit> all;
  try {
    const json document = input::parse_json<json>(read_whole(file, longest_file));
    if (!document.is_object() || document.value("format", "") != "cylon-fit/1")
      throw core::InputError(fmt::format("{}: not a file of cylon fit --json", file));
    for (const json& one : document.at("fits")) all.push_back(read_fit(one, file, e, covariance));
  } catch (const input::BadJson& error) {
    throw core::InputError(fmt::format("{}: {}", file, error.what()));
  } catch (const json::exception& error) {
    throw core::InputError(fmt::format("{}: not as cylon fit --json writes it: {}", file, error.what()));
  }
  if (all.empty()) throw core::InputError(fmt::format("{}: it has no fit", file));
  return all;
}

std::vector<std::string> engines_of(const std::vector<FoundFit>& fits) {
  std::vector<std::string> engines;
  for (const FoundFit& fit : fits)
    if (std::ranges::find(engines, fit.engine) == engines.end()) engines.push_back(fit.engine);
  return engines;
}

const FoundFit* unseen(const std::vector<FoundFit>& fits, const std::string& engine,
                       const measured::Run& run) {
  const auto found = std::ranges::find_if(
      fits, [&](const FoundFit& fit) { return fit.engine == engine && !fit.seen.contains(run.hash); });
  return found == fits.end() ? nullptr : &*found;
}

}  // namespace cylon::cli
