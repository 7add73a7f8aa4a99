// One run of an engine, by its worker in the bench's folder.
#pragma once

#include "harness/process/client.h"
#include "harness/process/engines.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace cylon::bench {

/// `steps` of `dt` [s], each `every`-th kept; where the run does not end, nothing, and a line says why.
inline std::optional<core::Recording> run_engine(const std::string& id, const core::Scene& scene, double dt,
                                                 std::int64_t steps, std::int64_t every,
                                                 const std::string& directory) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = steps, request.every = every;
  process::Limits limits;
  limits.run_seconds = 3600;
  auto outcome =
      process::run(process::parse_engine(id, process::default_engines(directory)), request, limits);
  if (!outcome.recording) fmt::print("{:>7}  {:<30} {}\n", scene.bodies.size(), id, outcome.reason);
  return std::move(outcome.recording);
}

}  // namespace cylon::bench
