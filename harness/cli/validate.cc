// cylon validate
#include "harness/cli/app.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <iostream>

namespace cylon::cli {

Command add_validate(CLI::App& app, const Context& context) {
  struct Options {
    std::vector<std::string> files;
    bool schema = false;
  };
  const auto options = std::make_shared<Options>();
  app.add_option("files", options->files, "Scenario files, or names of shipped scenarios; none: all shipped ones")->type_name("FILE");
  app.add_flag("--schema", options->schema, "Print the JSON Schema of the format instead");
  return [=, &context] {
    if (options->schema) {
      std::cout << scenarios::schema_json();
      return ok;
    }
    std::vector<std::filesystem::path> files;
    for (const std::string& name : options->files) files.push_back(find_scenario(context, name));
    if (options->files.empty()) files = scenario_files(context);
    bool good = true;
    std::optional<core::InputError> last;
    for (const auto& file : files) {
      try {
        const scenarios::Scenario scenario = scenarios::load(file);
        std::cout << fmt::format("{}: ok: {} bodies, {} claims\n", file.string(), scenario.scene.bodies.size(), scenario.claims.size());
      } catch (const core::InputError& error) {
        if (last) std::cerr << "error: " << last->what() << '\n';
        last = error;
        good = false;
      }
    }
    if (last) throw *last;  // the program shows it with its place, and ends with 2
    return good ? ok : bad_input;
  };
}

}  // namespace cylon::cli
