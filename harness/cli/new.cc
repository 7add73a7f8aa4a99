// cylon new
#include "harness/cli/app.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

namespace cylon::cli {

Command add_new(CLI::App& app, const Context&) {
  struct Options {
    std::string name, folder = ".";
  };
  const auto options = std::make_shared<Options>();
  app.add_option("name", options->name, "Name of the scenario: letters, digits, '_' and '-'")->required();
  app.add_option("--dir", options->folder, "Where to write NAME.toml")->capture_default_str();
  return [=] {
    if (options->name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") != std::string::npos || options->name.empty())
      throw core::InputError(fmt::format("'{}' is no name for a scenario: use letters, digits, '_' and '-'", options->name));
    const std::filesystem::path file = std::filesystem::path(options->folder) / (options->name + ".toml");
    if (std::filesystem::exists(file)) throw core::InputError(fmt::format("{} exists already; it is left as it is", file.string()));
    std::ofstream out(file);
    out << scenarios::template_toml(options->name);
    if (!out.flush()) throw core::InputError(fmt::format("{} cannot be written", file.string()));
    std::cout << fmt::format("{}: written. Next:\n  cylon validate {}\n  cylon run {}\n", file.string(), file.string(), file.string());
    return ok;
  };
}

}  // namespace cylon::cli
