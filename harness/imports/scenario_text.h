// An imported scene as a scenario file, with the claims that hold for every such scene.
#pragma once

#include "harness/core/scene.h"
#include "harness/imports/model/model.h"

#include <filesystem>
#include <span>
#include <string>

namespace cylon::imports {

std::string scenario_text(const foreign::Model&, const core::Scene&, const std::filesystem::path& file,
                          double duration, std::span<const std::string> left_out);

}  // namespace cylon::imports
