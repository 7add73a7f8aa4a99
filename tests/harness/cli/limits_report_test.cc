// What `cylon limits` prints of a search, by its direction and what it found.
#include "harness/cli/commands/limits_report.h"

#include <gtest/gtest.h>

#include <string>

namespace cylon::cli {
namespace {

using Kind = study::Limit::Kind;

TEST(LimitsReport, SaysInWhichDirectionThereIsNoLimit) {
  const struct {
    Kind kind;
    bool downward;
    const char* says;
  } rows[] = {{Kind::none, false, " no limit up to 1e-09 "},
              {Kind::none, true, " no limit down to 1e-09 "},
              {Kind::nowhere, true, " fails at 3 "},
              {Kind::found, true, " 2.5 "}};
  for (const auto& [kind, downward, says] : rows) {
    LimitRow row;
    row.family = "slow-bounce", row.engine = "ode", row.integrator = "semi-implicit-euler";
    row.limit.kind = kind, row.limit.holds = 1e-9, row.limit.breaks = 3;
    row.value = 2.5, row.downward = downward;
    const std::string text = limits_text({row}, 100);
    EXPECT_NE(text.find(says), std::string::npos) << says << '\n' << text;
  }
}

}  // namespace
}  // namespace cylon::cli
