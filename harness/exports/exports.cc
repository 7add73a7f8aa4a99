#include "harness/exports/exports.h"

#include "harness/exports/mjcf.h"
#include "harness/exports/sdformat.h"
#include "harness/exports/unsayable.h"

namespace cylon::exports {

Exported export_scenario(const scenario::Scenario& scenario, std::string_view text, std::string_view format) {
  try {
    return format == "MJCF" ? to_mjcf(scenario) : to_sdformat(scenario);
  } catch (const Unsayable& what) {
    throw located(what, text, scenario.file, format);
  }
}

}  // namespace cylon::exports
