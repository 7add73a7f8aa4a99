// EXPECT_CONFORMS(my_engine, "heavy_top"): the judge in GoogleTest.
#pragma once

#include "harness/judge/conform.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

namespace cylon::judge {

/// The scenarios that come with Cylon; $CYLON_SCENARIOS replaces them.
inline std::filesystem::path scenarios() {
  const char* chosen = std::getenv("CYLON_SCENARIOS");
  return chosen && *chosen ? chosen : CYLON_SCENARIOS_FOLDER;  // defined by the target cylon::judge
}

inline testing::AssertionResult conforms(const Engine& engine, const std::string& scenario,
                                         const Asked& asked = {}) {
  try {
    const Conformity found = conform(engine, scenario, scenarios(), asked);
    return (found.conforms() ? testing::AssertionSuccess() : testing::AssertionFailure()) << found.text();
  } catch (const std::exception& error) {
    return testing::AssertionFailure() << error.what();
  }
}

}  // namespace cylon::judge

/// EXPECT_CONFORMS(engine, scenario) and EXPECT_CONFORMS(engine, scenario, asked): every claim of the scenario passes.
#define EXPECT_CONFORMS(engine, ...) EXPECT_TRUE(::cylon::judge::conforms(engine, __VA_ARGS__))
#define ASSERT_CONFORMS(engine, ...) ASSERT_TRUE(::cylon::judge::conforms(engine, __VA_ARGS__))
