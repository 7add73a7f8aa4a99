#include "reference/simulators/bullet/bullet_rules.h"

namespace cylon::simulators {
namespace {

bool bounces(const BulletKind& kind) { return kind.bounces; }
bool touches(const BulletKind& kind) { return kind.touches; }
bool presses(const BulletKind& kind) { return kind.touches || kind.stops; }
bool stops(const BulletKind& kind) { return kind.stops; }
bool stops_alone(const BulletKind& kind) { return kind.stops && !kind.loops; }
bool stops_in_loops(const BulletKind& kind) { return kind.stops && kind.loops; }
bool stops_untouched(const BulletKind& kind) { return kind.stops && !kind.touches; }
bool wide(const BulletKind& kind) { return kind.wide(); }
constexpr const char* a_pair_bounces = "where a pair bounces";
constexpr const char* may_touch = "where bodies may touch";

const std::vector<std::string_view> ours_and_expert = {"rigid", "rigid-bounce", "multibody", "as-expert"};

constexpr const char* no_sleep = "no body falls asleep";
constexpr const char* sharp = "edges must be as sharp as in the scene";
constexpr const char* no_damping = "the scene has no damping of its own";
constexpr const char* no_hidden_limit = "no hidden limit of the speed";
constexpr const char* all_bounce = "slow impacts must bounce too";
constexpr const char* no_early_contact =
    "a contact solved before it touches reduces or removes the rebound speed, by gap/dt";
constexpr const char* no_push =
    "penetration correction adds energy to every bounce, as speed (Baumgarte) or as height (split impulse)";
constexpr const char* no_split_push = "if a run sets erp2, the correction must not change the velocity";

constexpr const char* where_stops = "where joints have stops";
constexpr const char* untouched = "where joints have stops and nothing touches";
constexpr const char* ahead =
    "a stop that acts once it is passed adds to the rate what takes back the way past it";
constexpr const char* whole_way = "with less, such a stop brakes over many steps, and nothing bounces";
constexpr const char* to_the_end =
    "what sweeps leave of a load on several stops lets bodies through, or comes back as a bounce";
constexpr const char* more_sweeps = "10 sweeps leave too much of it";

const BulletRule rules[] = {
    {ours_and_expert, "sleeping", "off", nullptr, "", no_sleep},
    {ours_and_expert, "margin", "0", nullptr, "", sharp},

    {{"rigid-bounce"}, "restitution-threshold", "0", nullptr, "", all_bounce},
    {{"rigid-bounce"}, "contact-threshold", "0", nullptr, "", no_early_contact},
    {{"rigid-bounce"}, "erp2", "0", nullptr, "", no_push},
    {{"rigid-bounce"}, "split-threshold", "0", nullptr, "", no_split_push},

    {{"rigid", "rigid-bounce"}, "stops-ahead", "on", stops, where_stops, ahead},
    {{"rigid", "rigid-bounce"}, "stop-erp", "1", stops, where_stops, whole_way},
    {{"rigid", "rigid-bounce", "multibody"}, "solver", "dantzig", stops_untouched, untouched, to_the_end},
    {{"rigid", "rigid-bounce", "multibody"}, "iterations", "200", stops, where_stops, more_sweeps},

    {{"multibody"}, "damping", "0", nullptr, "", no_damping},
    {{"multibody"}, "max-coordinate-velocity", "1e18", nullptr, "", no_hidden_limit},
    {{"multibody"}, "restitution-threshold", "0", bounces, a_pair_bounces, all_bounce},
    {{"multibody"}, "contact-threshold", "0", bounces, a_pair_bounces, no_early_contact},
    {{"multibody"},
     "erp2",
     "0",
     bounces,
     a_pair_bounces,
     "multibody contacts have no split impulse, so any correction adds energy to a bounce"},

    {{"multibody"},
     "erp",
     "0",
     stops_alone,
     "where joints have stops and close no loops",
     "the correction of what goes past a stop is a rate that nothing takes back"},
    {{"multibody"},
     "split-impulse",
     "off",
     stops_in_loops,
     "where joints have stops and close loops",
     "what is further past a stop than the split threshold would not be corrected"},

    {{"as-expert"}, "damping", "0", expert_takes_multibody, "with btMultiBody", no_damping},
    {{"as-expert"},
     "max-coordinate-velocity",
     "1e18",
     expert_takes_multibody,
     "with btMultiBody",
     no_hidden_limit},
    {{"as-expert"},
     "integrator",
     "runge-kutta-4",
     expert_takes_multibody,
     "with btMultiBody",
     "order 4 with hinges, 2 with ball joints; nothing needs a contact"},
    {{"as-expert"}, "stops-ahead", "on", stops, where_stops, ahead},
    {{"as-expert"}, "stop-erp", "1", stops, where_stops, whole_way},
    {{"as-expert"}, "solver", "dantzig", stops_untouched, untouched, to_the_end},
    {{"as-expert"},
     "ccd",
     "0.9",
     touches,
     may_touch,
     "fast bodies must not tunnel; a slow body's bits are the same"},
    {{"as-expert"},
     "plane-queries",
     "3",
     touches,
     may_touch,
     "a box on a plane needs its corners in the first step"},
    {{"as-expert"},
     "iterations",
     "200",
     presses,
     "where bodies may touch or joints have stops",
     "10 sweeps leave stacks, friction and stops unsolved"},
    {{"as-expert"},
     "breaking-threshold",
     "0.1",
     touches,
     may_touch,
     "points at rest must not be given up and found again"},
    {{"as-expert"},
     "solver",
     "dantzig",
     wide,
     "where masses differ by a factor of 1000",
     "sweeps carry a share of an impulse from body to body, and 200 are too few"},
    {{"as-expert"},
     "warm-starting",
     "0",
     wide,
     "where masses differ by a factor of 1000",
     "Dantzig's solver rejects a step whose last impulses reach 1000 N s, and sweeps solve it"},
    {{"as-expert"}, "restitution-threshold", "0", bounces, a_pair_bounces, all_bounce},
    {{"as-expert"}, "contact-threshold", "0", bounces, a_pair_bounces, no_early_contact},
    {{"as-expert"}, "erp2", "0", bounces, a_pair_bounces, no_push},
    {{"as-expert"}, "split-threshold", "0", bounces, a_pair_bounces, no_split_push},
};

}  // namespace

std::span<const BulletRule> bullet_rules() { return rules; }

bool expert_takes_multibody(const BulletKind& kind) { return kind.tree && !kind.wide(); }

}  // namespace cylon::simulators
