// What the tests of process/ share: workers in Python, a small scene, and a look for leftover children.
#pragma once

#include "harness/process/client.h"
#include "tests/paths.h"

#include <sys/wait.h>

#include <cerrno>
#include <string>

namespace cylon::process {

inline EngineChoice python(const std::string& script, const std::string& mode = {}) {
  EngineRow row{"test", {"python3", std::string(source_dir) + "/" + script}, ""};
  if (!mode.empty()) row.command.push_back(mode);
  return {"test", row, "", "", {}};
}

inline EngineChoice scripted(const std::string& mode) {
  return python("tests/harness/process/scripted_worker.py", mode);
}

inline core::Body point(const std::string& name, const core::Vector3& position,
                        const core::Vector3& velocity) {
  core::Body body;
  body.name = name;
  body.initial.position = position;
  body.initial.velocity = velocity;
  return body;
}

/// Two bodies in uniform motion.
inline core::Scene two_bodies() {
  core::Scene scene;
  scene.bodies = {point("a", {0.3, -0.2, 0.7}, {1.25, -0.5, 0.125}),
                  point("b", {5, 6, 7}, {-0.1, 0.2, -0.3})};
  return scene;
}

inline RunRequest request_of(const core::Scene& scene, std::int64_t steps, std::int64_t every = 1) {
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 0.01;
  request.steps = steps;
  request.every = every;
  return request;
}

/// Whether this process has a child, alive or a zombie.
inline bool has_children() {
  siginfo_t info = {};
  return !(::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) < 0 && errno == ECHILD);
}

}  // namespace cylon::process
