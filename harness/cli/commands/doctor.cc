// cylon doctor
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"

#include "harness/core/input_error.h"
#include "harness/process/client.h"
#include "harness/scenario/expected.h"

#include <fmt/format.h>

#include <functional>
#include <iostream>
#include <thread>

namespace cylon::cli {

Command add_doctor(App&, const Context& context) {
  return [&context] {
    bool sound = true;
    const auto check = [&](const std::string& what, const std::function<std::string()>& test) {
      try {
        std::cout << plain_line(fmt::format("ok    {}: {}", what, test())) << '\n';
      } catch (const std::exception& error) {
        sound = false;
        std::cout << plain_line(fmt::format("FAIL  {}: {}", what, error.what())) << '\n';
      }
    };
    check("version", [] { return std::string("cylon " CYLON_VERSION); });
    check("processors", [] { return fmt::format("{}", std::thread::hardware_concurrency()); });
    check("scenarios", [&] {
      const auto files = scenario_files(context);
      for (const auto& file : files) scenario::read(file);
      return fmt::format("{} valid in {}; `cylon validate` also checks their certified truths", files.size(),
                         context.scenarios.string());
    });
    std::optional<scenario::Expectations> expectations;
    check("expected.toml", [&] {
      expectations = scenario::Expectations::load(context.scenarios / "expected.toml");
      return std::string("valid");
    });
    for (const process::EngineRow& row : context.engines) {
      if (const auto reason = process::missing(row)) {
        std::cout << plain_line(fmt::format("-     engine {}: {}", row.id, *reason)) << '\n';
        continue;
      }
      check("engine " + row.id, [&] {
        const core::Engine engine = process::describe(process::parse_engine(row.id, context.engines), {});
        const bool listed = expectations && expectations->version_listed(engine.name, engine.version);
        return fmt::format("{} {}, {}{}", engine.name, engine.version, engine.precision,
                           listed ? ""
                           : row.optional()
                               ? " (expected.toml has no row of it: a pass is expected)"
                               : " (expected.toml has no row for this version, so verdicts may differ)");
      });
    }
    std::cout
        << (sound ? "Everything needed is installed.\n"
                  : "Something is missing; see FAIL above. In a checkout, ./run builds what is needed.\n");
    return sound ? ok : harness_failure;
  };
}

}  // namespace cylon::cli
