#include "harness/imports/imports.h"

#include "harness/core/input_error.h"
#include "harness/imports/mjcf/mjcf.h"
#include "harness/imports/model/model_json.h"
#include "harness/imports/program.h"
#include "harness/imports/scenario_text.h"
#include "harness/imports/steps.h"
#include "harness/imports/xml_check.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cylon::imports {
namespace {

namespace fs = std::filesystem;

foreign::Model model_of(const Format& format, const nlohmann::json& said, const Options& options,
                        const fs::path& file) {
  try {
    return format.name == "MJCF" ? model_of_mjcf(Compiled(said), options.keyframe) : foreign::from_json(said);
  } catch (const NotFinite& error) {
    throw core::InputError(file.string(), 0, 0, error.what());
  } catch (const nlohmann::json::exception& error) {  // a NaN, or a release that is unlike the others
    throw core::InputError(file.string(), 0, 0,
                           fmt::format("{} says what is no model: {}", format.program, error.what()));
  }
}

// An option that the file's format has no use for would be ignored.
void refuse_other_options(const Format& format, const Options& options, const std::string& file) {
  const struct {
    const char *option, *formats;
    bool is_given;
  } rows[] = {{"--keyframe", "MJCF", !options.keyframe.empty()},
              {"--fixed-base", "URDF", options.fixed_base},
              {"--root", "SDFormat and URDF", !options.roots.empty()}};
  for (const auto& row : rows)
    if (row.is_given && std::string_view(row.formats).find(format.name) == std::string_view::npos)
      throw core::InputError(
          file, 0, 0,
          fmt::format("{} is for {} files, and this is {}", row.option, row.formats, format.name));
}

// All that is refused in one error; what is left out, as texts.
std::vector<std::string> judge(const foreign::Model& model, const Options& options, const std::string& file) {
  std::vector<foreign::Loss> refused, left_out;
  for (const foreign::Loss& loss : model.losses) {
    const bool is_left = loss_kind(loss.what).decision == Decision::left_out ||
                         std::ranges::find(options.leave_out, loss.what) != options.leave_out.end();
    (is_left && !options.strict ? left_out : refused).push_back(loss);
  }
  if (refused.empty()) return texts_of(left_out, file);
  std::vector<std::string> texts = texts_of(refused, file);
  constexpr std::size_t most = 12;
  const std::size_t all = texts.size();
  if (all > most) texts.resize(most);
  throw core::InputError(fmt::format("{}: a scene cannot say what this file says{}:\n  {}{}", file,
                                     options.strict ? ", and nothing may be left out (--strict)" : "",
                                     fmt::join(texts, "\n  "),
                                     all > most ? fmt::format("\n  and {} more kinds", all - most) : ""));
}

}  // namespace

Imported import_file(const fs::path& file, const Options& options, const fs::path& programs) {
  const Format* format = format_of(file);
  if (!format)
    throw core::InputError(
        file.string(), 0, 0,
        "no format has this ending; known: .xml and .mjcf (MJCF), .sdf and .world (SDFormat), .urdf");
  refuse_other_options(*format, options, file.string());
  const nlohmann::json said = read_by(*format, file, options, programs);
  foreign::Model model = model_of(*format, said, options, file);
  if (options.fixed_base && format->name == "URDF" && !model.bodies.empty())
    model.bodies.front().locked = true;
  if (model.bodies.size() > most_bodies)
    throw core::InputError(
        file.string(), 0, 0,
        fmt::format("{} bodies, but at most {} are imported; the first beyond: {}", model.bodies.size(),
                    most_bodies, model.bodies[most_bodies].place.element));
  check_limits(model, file.string());
  turn_up(model, options.keep_axes);
  merge_fixed(model, file.string());
  name_bodies(model);
  if (std::ranges::find(options.leave_out, "armature") != options.leave_out.end()) leave_rotors_out(model);
  const core::Scene scene = scene_of(model);
  const std::vector<std::string> left_out = judge(model, options, file.string());
  check_starts(model, file.string());
  return {scenario_text(model, scene, file, options.duration, left_out), left_out};
}

void serve_scenarios(const fs::path& programs, const std::function<void(const std::string&)>& left_out) {
  scenario::foreign_reader() = [programs, left_out](const fs::path& file) {
    const Imported imported = import_file(file, {}, programs);
    for (const std::string& text : imported.left_out) left_out(text);
    return imported.toml;
  };
}

}  // namespace cylon::imports
