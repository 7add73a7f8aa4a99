// cylon import
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/output.h"

#include "harness/core/input_error.h"
#include "harness/imports/imports.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <stdexcept>

namespace cylon::cli {
namespace {

void print_kinds() {
  for (const imports::LossKind& kind : imports::loss_kinds())
    std::cout << fmt::format("{:<22} {:<9} {}\n", kind.what,
                             kind.decision == imports::Decision::refused ? "refused" : "left out", kind.why);
}

}  // namespace

Command add_import(App& app, const Context& context) {
  struct Options {
    std::string file, out = "-";
    imports::Options imports;
    bool kinds = false;
  };
  const auto options = std::make_shared<Options>();
  const Option file =
      app.add_option("file", options->file, "FILE.xml or .mjcf (MJCF), .sdf or .world (SDFormat), .urdf")
          ->type_name("FILE");
  app.add_option("-o,--out", options->out, "Scenario file to write; - is stdout")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_flag("--strict", options->imports.strict, "Refuse a file of which anything is left out");
  app.add_option(
         "--leave-out", options->imports.leave_out,
         "Leave out what would be refused, of this kind (see --kinds); the motion is then another one")
      ->type_name("KIND")
      ->allow_extra_args(false);
  app.add_flag("--kinds", options->kinds, "Print what a scene cannot say, and what becomes of it")
      ->excludes(file);
  app.add_flag("--keep-axes", options->imports.keep_axes,
               "Leave all axes as they are; otherwise z up becomes y up");
  app.add_option("--root", options->imports.roots,
                 "Folder in which package:// and model:// of a URDF or an SDFormat file are looked for")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
  app.add_option("--keyframe", options->imports.keyframe,
                 "Start of an MJCF file in place of its initial pose")
      ->type_name("NAME");
  app.add_flag("--fixed-base", options->imports.fixed_base, "Hold the root link of a URDF file where it is");
  app.add_option("--duration", options->imports.duration, "Of the scenario [s], rounded up to whole steps")
      ->type_name("S")
      ->check(positive(1e6))
      ->capture_default_str();
  return [=, &context] {
    if (options->kinds) {
      print_kinds();
      return ok;
    }
    if (options->file.empty()) throw core::InputError("cylon import needs a file");
    for (const std::string& kind : options->imports.leave_out) try {
        imports::loss_kind(kind);
      } catch (const std::invalid_argument& error) {
        throw core::InputError(fmt::format("--leave-out: {}", error.what()));
      }
    require_writable(options->out);
    const imports::Imported imported = imports::import_file(options->file, options->imports, context.workers);
    for (const std::string& text : imported.left_out)
      std::cerr << plain_line(fmt::format("left out: {}", text)) << '\n';
    // What is written can be read; the lines of an error are not those of the file.
    scenario::parse(imported.toml, options->file + ", the imported scenario");
    write_whole(options->out, imported.toml);
    return ok;
  };
}

}  // namespace cylon::cli
