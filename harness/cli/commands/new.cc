// cylon new
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/output.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace cylon::cli {

Command add_new(App& app, const Context&) {
  struct Options {
    std::string name, folder = ".";
  };
  const auto options = std::make_shared<Options>();
  app.add_option("name", options->name, "Name of the scenario: letters, digits, '_' and '-'")
      ->required()
      ->type_name("NAME");
  app.add_option("--dir", options->folder, "Folder in which to write NAME.toml")
      ->type_name("FOLDER")
      ->capture_default_str();
  return [=] {
    if (options->name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") !=
            std::string::npos ||
        options->name.empty())
      throw core::InputError(
          fmt::format("'{}' is not a valid scenario name: use letters, digits, '_' and '-'", options->name));
    const std::filesystem::path file =
        (std::filesystem::path(options->folder) / (options->name + ".toml")).lexically_normal();
    if (std::filesystem::exists(file))
      throw core::InputError(fmt::format("{} already exists; nothing was written", file.string()));
    write_whole(file.string(), scenario::template_toml(options->name));
    std::cout << fmt::format("{}: written. Next:\n  cylon validate {}\n  cylon run {}\n",
                             plain(file.string()), shell_word(file.string()), shell_word(file.string()));
    return ok;
  };
}

}  // namespace cylon::cli
