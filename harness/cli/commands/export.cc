// cylon export
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/output.h"

#include "harness/core/input_error.h"
#include "harness/exports/exports.h"
#include "harness/scenario/foreign.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace cylon::cli {

Command add_export(App& app, const Context& context) {
  struct Options {
    std::string file, out;
  };
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Scenario file, or the name of a shipped scenario")
      ->type_name("FILE")
      ->required();
  app.add_option("-o,--out", options->out, "File to write: .xml or .mjcf (MJCF), .sdf or .world (SDFormat)")
      ->type_name("FILE")
      ->required();
  return [=, &context] {
    const std::string_view format = scenario::foreign_format(options->out);
    if (format != "MJCF" && format != "SDFormat")
      throw core::InputError(
          options->out, 0, 0,
          "no format that is written has this ending; known: .xml and .mjcf (MJCF), .sdf and "
          ".world (SDFormat)");
    require_writable(options->out);
    const std::filesystem::path file = find_scenario(context, options->file);
    const std::string text = scenario::foreign_format(file).empty() ? scenario::read_file(file) : "";
    const exports::Exported exported = exports::export_scenario(scenario::read(file), text, format);
    for (const std::string& note : exported.notes) std::cerr << plain_line(note) << '\n';
    write_whole(options->out, exported.xml);
    return ok;
  };
}

}  // namespace cylon::cli
