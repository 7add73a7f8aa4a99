// An engine's table of C functions as a Simulator.
#pragma once

#include "cylon/c_scene.h"
#include "cylon/engine.h"
#include "harness/core/simulator.h"

#include <optional>
#include <string>

namespace cylon::worker {

/// What is wrong with a table: another version, a text or a function that is missing, a value that cannot be.
std::optional<std::string> fault(const cylon_engine*);

class CEngine final : public core::Simulator {
 public:
  /// Requires a table without fault, which must live as long.
  explicit CEngine(const cylon_engine&);

  const core::Engine& engine() const override { return about_; }
  /// What the table says; the engine's own reasons come with load_if_supported.
  std::optional<std::string> unsupported(const core::Scene&, const core::Setup&) const override;
  core::Terms load(const core::Scene&, const core::Setup&) override;
  core::Loaded load_if_supported(const core::Scene&, const core::Setup&) override;
  void step() override { table_.step(table_.self); }
  void read(core::State&) const override;

 private:
  const cylon_engine& table_;
  core::Engine about_;
  core::Scene copy_;  // the engine may keep the scene, names and all
  CScene scene_;
  cylon_scene view_{};
};

}  // namespace cylon::worker
