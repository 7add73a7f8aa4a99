#include "reference/simulators/bullet/bullet_knobs.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace cylon::simulators {
namespace {

using Kind = KnobKind;
using Of = KnobOf;

constexpr double largest = std::numeric_limits<float>::max();  // in both of Bullet's precisions

constexpr Knob table[] = {
    {"erp", "m_erp", 0.2, 0, 1, "fraction of a joint's position error removed per step"},
    {"stop-erp", "m_stopERP", as_the_joint, 0, 1,
     "fraction of the way past a stop of a joint removed per step; limits of btMultiBody have erp",
     Kind::number, Of::rigid},
    {"stops-ahead", "stops by btGeneric6DofSpring2Constraint", 0, 0, 1,
     "stops of hinges, and of sliders between two moving bodies, are rows that act before they are passed",
     Kind::flag, Of::rigid},
    {"erp2", "m_erp2", 0.2, 0, 1, "fraction of a penetration removed per step"},
    {"cfm", "m_globalCfm", 0, 0, largest, "constraint force mixing of contacts and joints"},
    {"iterations", "m_numIterations", 10, 1, 1e6, "sweeps of the constraint solver per step", Kind::whole},
    {"warm-starting", "m_warmstartingFactor", 0.85, 0, 1,
     "fraction of the last impulses used as the initial guess", Kind::number, Of::rigid},
    {"restitution-threshold", "m_restitutionVelocityThreshold", 0.2, 0, largest,
     "approach speed below which there is no restitution [m/s]"},
    {"split-threshold", "m_splitImpulsePenetrationThreshold", -0.04, -largest, largest,
     "gap above which penetration is corrected through the velocity [m]; of a multibody, the way past a "
     "stop"},
    {"contact-threshold", "contactProcessingThreshold", no_limit, 0, largest,
     "gap up to which a contact is solved before it touches [m]"},
    {"max-gyroscopic-force", "m_maxGyroscopicForce", 100, 0, largest,
     "limit of the explicit gyroscopic torque [N m]", Kind::number, Of::rigid},
    {"ccd", "setCcdSweptSphereRadius, setCcdMotionThreshold", 0, 0, 1,
     "continuous collision detection: a swept sphere, as a fraction of the largest one in the shape; it "
     "sweeps motions beyond half of that one's radius per step, of single convex shapes; 0: none",
     Kind::number, Of::rigid},
    {"speculative-restitution", "setApplySpeculativeContactRestitution", 0, 0, 1,
     "the contacts that ccd foresees bounce", Kind::flag, Of::rigid},
    {"plane-queries", "setPlaneConvexMultipointIterations", 0, 0, 64,
     "queries of a polyhedral shape, tilted a little, against a plane while fewer than 3 points are known",
     Kind::whole},
    {"convex-queries", "setConvexConvexMultipointIterations", 0, 0, 64,
     "contact queries, tilted a little, between two convex shapes while fewer than 3 points are known; box "
     "against box has an algorithm of its own",
     Kind::whole},
    {"breaking-threshold", "gContactBreakingThreshold", 0.02, 0, largest,
     "distance at which a contact point is created or given up, as a fraction of the smaller shape's size"},
    {"slop", "m_linearSlop", 0, -largest, largest, "gap that penetration is measured from [m]"},
    {"relaxation", "m_sor", 1, 0, 2, "over-relaxation of the solver's sweeps", Kind::open},
    {"split-impulse", "m_splitImpulse", 1, 0, 1,
     "deep penetration is corrected without changing the velocity; of a multibody, what is deep past a stop "
     "not at all",
     Kind::flag},
    {"two-friction-directions", "SOLVER_USE_2_FRICTION_DIRECTIONS", 0, 0, 1,
     "friction along two directions per contact; multibody always has two", Kind::flag, Of::rigid},
    {"random-order", "SOLVER_RANDMIZE_ORDER", 0, 0, 1, "constraints are solved in a random order", Kind::flag,
     Of::rigid},
    {"interleave", "SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS", 0, 0, 1,
     "each contact is followed by its friction", Kind::flag, Of::rigid},
    {"sleeping", "activation state, canSleep", 1, 0, 1, "slow bodies fall asleep; off on our paths",
     Kind::flag},
    {"margin", "setMargin", default_margin, 0, largest,
     "margin of all but spheres and capsules, 0.04: at most that, by the shape's size; 0 on our paths [m]"},
    {"damping", "setLinearDamping, setAngularDamping", 0.04, 0, largest,
     "of a multibody; 0 on our paths [1/s]", Kind::number, Of::multibody},
    {"max-coordinate-velocity", "setMaxCoordinateVelocity", 100, 0, largest,
     "limit of a multibody's velocities; none on our paths [m/s, rad/s]", Kind::open, Of::multibody},
};

// A range in interval notation.
std::string range(const Knob& k) {
  if (k.least == -largest) return "any finite number";
  if (k.most == largest)
    return fmt::format("a finite number {} {}", k.kind == Kind::open ? "above" : "from", k.least);
  return fmt::format("a {}number in {}{}, {}{}", k.kind == Kind::whole ? "whole " : "",
                     k.kind == Kind::open ? '(' : '[', k.least, k.most, k.kind == Kind::open ? ')' : ']');
}

bool within(const Knob& k, double value) {
  if (k.kind == Kind::open) return value > k.least && value < k.most;
  return value >= k.least && value <= k.most && (k.kind != Kind::whole || value == std::floor(value));
}

}  // namespace

std::span<const Knob> knobs() { return table; }

const Knob& knob(std::string_view option) {
  for (const Knob& k : table)
    if (k.option == option) return k;
  throw std::logic_error(fmt::format("unknown setting '{}'", option));
}

std::string text(const Knob& k, double value) {
  if (k.kind == Kind::flag) return value != 0 ? "on" : "off";
  if (std::isnan(value)) return "erp";
  return value >= no_limit ? "no limit" : fmt::format("{}", value);
}

double parse(const Knob& k, const std::string& given) {
  if (k.kind == Kind::flag) {
    const std::vector<std::string> valid = {"off", "on"};
    if (given == valid[1]) return 1;
    if (given == valid[0]) return 0;
    throw std::invalid_argument(fmt::format("bullet: no value of option {} '{}'{} (valid: off, on)", k.option,
                                            given, core::did_you_mean(given, valid)));
  }
  double value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  if (error != std::errc() || end != given.data() + given.size() || !within(k, value))
    throw std::invalid_argument(
        fmt::format("bullet: {} = '{}' is not {} ({})", k.option, given, range(k), k.meaning));
  return value;
}

}  // namespace cylon::simulators
