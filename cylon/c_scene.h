// A scene as the structures of cylon/engine.h, and what they or an engine do not have.
#pragma once

#include "cylon/engine.h"
#include "harness/core/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::worker {

/// The first thing in the scene that is not among `takes` (of cylon_part) or that cylon/engine.h has no structure for;
/// nothing where the scene can be handed over.
std::optional<std::string> not_taken(const core::Scene&, std::uint32_t takes);

/// Holds what a cylon_scene points to.  Requires not_taken to be empty; the scene must live as long.
class CScene {
 public:
  CScene() = default;
  explicit CScene(const core::Scene&);

  /// Valid until this is assigned or destroyed.
  cylon_scene view() const;

 private:
  std::vector<cylon_body> bodies_;
  std::vector<cylon_spring> springs_;
  std::vector<cylon_drag> drags_;
  std::vector<cylon_drive> drives_;
  std::vector<cylon_attraction> attractions_;
  std::vector<cylon_joint> joints_;
  std::vector<cylon_plane> planes_;
  std::vector<cylon_pair> pairs_;
  bool simultaneous_ = false;

  void add(const core::UniformGravity&) {}  // is in each body
  void add(const core::Spring&);
  void add(const core::Drag&);
  void add(const core::Thrust&) {}  // refused
  void add(const core::Drive&);
  void add(const core::Attraction&);
  void add(const core::Water&) {}        // refused
  void add(const core::PluginForce&) {}  // refused
};

}  // namespace cylon::worker
