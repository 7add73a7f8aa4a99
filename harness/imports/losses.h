// What foreign models have and a scene has not: what of it is left out, and what is refused, with the reason.
//
// A thing that changes the motion and cannot be said is refused.  What only shows, measures, or acts when somebody
// commands it is left out.
#pragma once

#include "harness/imports/model/model.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::imports {

enum class Decision { left_out, refused };

struct LossKind {
  std::string_view what;  ///< The word of foreign::Loss::what, and of --leave-out.
  Decision decision;
  std::string_view why;
};

std::span<const LossKind> loss_kinds();

/// The row of a word; throws std::invalid_argument, with the nearest word, where there is none.
const LossKind& loss_kind(std::string_view what);

/// A rotor that a scene has no coordinate for, of `inertia`, where `whole` moves with it [kg, kg m^2]: small up to a tenth.
foreign::Loss lost_armature(double inertia, double whole, const foreign::Place&);

/// "robot.urdf:12: joint 'hip': limit: …": place, what, detail and reason.
std::string text_of(const foreign::Loss&, const std::string& file);

/// The same for all, equal ones of one kind joined: "sensor 'a' and 12 more".
std::vector<std::string> texts_of(std::span<const foreign::Loss>, const std::string& file);

}  // namespace cylon::imports
