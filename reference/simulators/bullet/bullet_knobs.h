// The numbers and flags that Bullet lets its user set, by our names and by Bullet's.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace cylon::simulators {

/// A contact threshold [m] at or beyond this is no limit; Bullet's BT_LARGE_FLOAT in single precision.
inline constexpr double no_limit = 1e18;

/// At this margin [m] a shape keeps Bullet's own, CONVEX_DISTANCE_MARGIN or less where the shape is small.
inline constexpr double default_margin = 0.04;

/// A stop that has no ERP of its own takes that of the joint, m_erp.
inline constexpr double as_the_joint = std::numeric_limits<double>::quiet_NaN();

/// A number, a number strictly between its bounds, a whole number, or a flag: 0 or 1.
enum class KnobKind { number, open, whole, flag };

/// Whose code reads a setting.
enum class KnobOf { every_path, rigid, multibody };

struct Knob {
  const char* option;
  const char* setting;  ///< Bullet's own name.
  double engine_default;
  double least, most;
  const char* meaning;
  KnobKind kind = KnobKind::number;
  KnobOf of = KnobOf::every_path;
};

std::span<const Knob> knobs();

/// Throws std::logic_error for an option that is none of them.
const Knob& knob(std::string_view option);

/// A value as a report shows it.
std::string text(const Knob&, double value);

/// What was given for it.  Throws std::invalid_argument, with the range, for what is no such value.
double parse(const Knob&, const std::string& given);

}  // namespace cylon::simulators
