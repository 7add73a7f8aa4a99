// Scenes that a format can say, with general values.
#pragma once

namespace cylon::exports::scenes {

// Every joint that MJCF has, and everything that acts along one.
inline constexpr const char* machine = R"(
title    = "machine"
duration = 1.0
step     = 0.002
gravity  = [0.3, -9.7, 0.2]

[[body]]
name = "cart"
position = [0.1, 0.3, -0.2]
orientation = [0.9233805168766387, 0.10259783520851541, 0.20519567041703082, -0.3077935056255462]
mass = 1.3
inertia = [0.011, 0.001, -0.002, 0.001, 0.017, 0.0015, -0.002, 0.0015, 0.013]

[[body]]
name = "arm"
position = [0.5, 0.1, -0.3]
mass = 0.9
inertia = [0.02, 0.03, 0.025]

[[body]]
name = "hand"
position = [0.9, -0.2, 0.1]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.4
inertia = [0.003, 0.002, 0.0025]

[[body]]
name = "tip"
position = [1.3, -0.1, 0.2]
mass = 0.2
inertia = [0.001, 0.002, 0.0015]

[[body]]
name = "rod"
position = [-0.7, 0.4, 0.3]
mass = 0.6
inertia = [0.01, 0.002, 0.009]

[[body]]
name = "puck"
position = [-1.7, 0.4, 0.3]
mass = 0.7
inertia = [0.01, 0.02, 0.011]
gravity = [0.15, -4.85, 0.1]

[[joint]]
type = "slider"
name = "rail"
body = "cart"
point = [0.2, 0.3, -0.1]
axis = [0.6, 0.0, 0.8]
displacement = [{start = 0.1, lower = -1.0, upper = 1.5, stiffness = 30.0, damping = 0.4, target = 0.05, friction = 0.2, force = 1.7}]

[[joint]]
type = "hinge"
body = "arm"
to = "cart"
point = [0.2, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]
angle = [{start = 0.2, stiffness = 4.0, friction = 0.07, lower = -0.5, upper = 0.9}]

[[joint]]
type = "universal"
name = "cross"
body = "hand"
to = "arm"
point = [0.7, 0.0, -0.1]
axis = [0.6, 0.8, 0.0]
axis_2 = [0.0, 0.0, 1.0]
angle = [{stiffness = 0.3, target = 0.1}, {which = "second", damping = 0.02, force = -0.4}]

[[joint]]
type = "ball"
body = "tip"
to = "hand"
point = [1.1, -0.15, 0.2]

[[joint]]
type = "cylindrical"
name = "rod in sleeve"
body = "rod"
point = [-0.7, 0.5, 0.3]
axis = [0.0, 0.6, 0.8]
displacement = [{stiffness = 12.0, target = -0.03}]
angle = [{damping = 0.05}]

[[joint]]
type = "planar"
body = "puck"
point = [-1.6, 0.4, 0.2]
axis = [0.0, 0.6, 0.8]
axis_2 = [1.0, 0.0, 0.0]
displacement = [{which = "second", damping = 0.3}]
angle = [{friction = 0.01}]

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// Joints of several turns as humanoids have them, with rotors, on a carriage.
inline constexpr const char* hips = R"(
title    = "hips"
duration = 1.0
step     = 0.001
gravity  = [0.3, -9.7, 0.2]

[[body]]
name = "pelvis"
position = [0.1, 0.5, -0.2]
mass = 3.0
inertia = [0.2, 0.3, 0.25]

[[body]]
name = "thigh"
position = [0.3, 0.1, -0.1]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 1.3
inertia = [0.05, 0.02, 0.06]

[[body]]
name = "foot"
position = [0.5, -0.4, 0.1]
mass = 0.4
inertia = [0.002, 0.003, 0.0025]

[[joint]]
type = "rectangular"
name = "carriage"
body = "pelvis"
point = [0.0, 0.5, 0.0]
axis = [0.0, 0.6, 0.8]
axis_2 = [1.0, 0.0, 0.0]
displacement = [{start = 0.1, stiffness = 30.0, armature = 0.7}, {which = "second", damping = 0.3}]

[[joint]]
type = "gimbal"
name = "hip"
body = "thigh"
to = "pelvis"
point = [0.2, 0.4, -0.2]
axis = [0.6, 0.0, 0.8]
axis_2 = [0.0, 0.8, 0.6]
angle = [{start = 0.2, lower = -0.5, upper = 0.9, armature = 0.03}, {which = "third", stiffness = 2.0, target = 0.1, force = 0.4}, {which = "second", damping = 0.02, friction = 0.1}]

[[joint]]
type = "offset_universal"
name = "ankle"
body = "foot"
to = "thigh"
point = [0.4, -0.3, 0.0]
axis = [0.6, 0.8, 0.0]
axis_2 = [0.0, 0.0, 1.0]
length = 0.04
angle = [{stiffness = 0.3, armature = 0.01}, {which = "second", damping = 0.02, force = -0.4}]

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// Velocities: of a free body, and of one that a hinge lets turn.
inline constexpr const char* moving = R"(
title    = "moving"
duration = 1.0
step     = 0.001
gravity  = [0.0, -9.81, 0.0]

[[body]]
name = "free"
position = [0.3, 1.1, -0.4]
orientation = [0.9233805168766387, 0.10259783520851541, 0.20519567041703082, -0.3077935056255462]
velocity = [0.4, -0.7, 0.9]
angular_velocity = [1.1, -0.3, 0.8]
mass = 1.3
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "crank"
position = [2.2, 0.0, 0.0]
velocity = [0.0, 0.08, -0.06]
angular_velocity = [0.0, 0.3, 0.4]
mass = 0.9
inertia = [0.02, 0.03, 0.025]

[[body]]
name = "follower"
position = [2.4, 0.0, 0.0]
velocity = [0.0, 0.16, -0.12]
angular_velocity = [0.0, 0.3, 0.4]
mass = 0.5
inertia = [0.02, 0.01, 0.015]

[[joint]]
type = "hinge"
body = "crank"
point = [2.0, 0.0, 0.0]
axis = [0.0, 0.6, 0.8]

[[joint]]
type = "ball"
body = "follower"
to = "crank"
point = [2.3, 0.0, 0.0]

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// Moments that are nearly equal about axes that are none of the body's, and a flat body.
inline constexpr const char* nearly_round = R"(
title    = "nearly round"
duration = 1.0
step     = 0.001
gravity  = [0.0, -9.81, 0.0]

[[body]]
name = "round"
position = [0.3, 1.1, -0.4]
mass = 1.3
inertia = [0.07774904, -0.0303768643, 0.0275564194, -0.0303768643, 0.0634548204, 0.0303768643, 0.0275564194, 0.0303768643, 0.077661045]

[[body]]
name = "rod"
position = [2.2, 0.0, 0.0]
mass = 0.9
inertia = [0.3, 1e-6, 0.0, 1e-6, 0.3, 0.0, 0.0, 0.0, 0.01]

[[body]]
name = "plate"
position = [4.2, 0.0, 0.0]
mass = 0.9
inertia = [0.26, 0.06, 0.0, 0.06, 0.39, 0.0, 0.0, 0.0, 0.65]

[[claim]]
conserves = "energy"
tolerance = {relative = 0.01, reason = "convention: a hundredth"}
)";

// A chain of hinges that a ball closes, and a body fixed to it.
inline constexpr const char* loop = R"(
title    = "loop"
duration = 1.0
step     = 0.004
gravity  = [0.0, -9.81, 0.1]

[[body]]
name = "first"
position = [0.25, 0.1, 0.0]
mass = 0.5
inertia = [0.002, 0.01, 0.011]

[[body]]
name = "second"
position = [0.75, 0.1, 0.0]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.6
inertia = [0.003, 0.012, 0.013]

[[body]]
name = "third"
position = [1.0, -0.2, 0.0]
mass = 0.7
inertia = [0.004, 0.014, 0.015]

[[joint]]
type = "hinge"
body = "first"
point = [0.0, 0.1, 0.0]
axis = [0.0, 0.0, 1.0]

[[joint]]
type = "hinge"
body = "second"
to = "first"
point = [0.5, 0.1, 0.0]
axis = [0.0, 0.0, 1.0]

[[joint]]
type = "ball"
name = "closes"
body = "second"
point = [1.0, 0.1, 0.0]

[[joint]]
type = "fixed"
body = "third"
to = "second"
point = [1.0, 0.0, 0.0]

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// Surfaces of each kind, a locked body, a slope, two frictions and groups.
inline constexpr const char* contacts = R"(
title    = "contacts"
duration = 1.0
step     = 0.001
gravity  = [0.0, -9.81, 0.0]

[[plane]]
name = "slope"
normal = [0.0, 0.8, 0.6]
offset = -1.5

[[body]]
name = "step"
position = [3.0, 0.5, 0.0]
orientation = [0.8, 0.0, 0.6, 0.0]
locked = true
shape = {type = "box", half_extents = [0.4, 0.1, 0.3]}

[[body]]
name = "ball"
position = [0.0, 2.0, 0.0]
mass = 1.1
shape = {type = "sphere", radius = 0.3}

[[body]]
name = "can"
position = [1.0, 2.0, 0.0]
orientation = [0.6, 0.8, 0.0, 0.0]
mass = 1.2
shape = {type = "cylinder", radius = 0.2, length = 0.5}

[[body]]
name = "pill"
position = [2.0, 2.0, 0.0]
mass = 0.4
shape = {type = "capsule", radius = 0.1, length = 0.4}
collision_groups = ["small"]
collision_mask = ["default"]

[[body]]
name = "pair"
position = [0.0, 2.0, 2.0]
mass = 2.0
inertia = [0.05, 0.03, 0.07]
shape = {type = "compound", parts = [{type = "box", half_extents = [0.1, 0.2, 0.3], mass = 1.0, position = [-0.2, 0.1, 0.05]}, {type = "sphere", radius = 0.15, mass = 1.0, position = [0.2, -0.1, -0.05]}]}

[[material]]
between = ["*", "*"]
friction = 0.4
restitution = 0.0

[[material]]
between = ["ball", "*"]
friction = 0.7
restitution = 0.0

[[claim]]
conserves = "energy"
measure   = "increase"
tolerance = {relative = 0.01, reason = "convention: a hundredth"}
)";

// Every joint that SDFormat has.
inline constexpr const char* robot = R"(
title    = "robot"
duration = 1.0
step     = 0.002
gravity  = [0.3, -9.7, 0.2]

[[body]]
name = "cart"
position = [0.1, 0.3, -0.2]
orientation = [0.9233805168766387, 0.10259783520851541, 0.20519567041703082, -0.3077935056255462]
mass = 1.3
inertia = [0.011, 0.001, -0.002, 0.001, 0.017, 0.0015, -0.002, 0.0015, 0.013]

[[body]]
name = "arm"
position = [0.5, 0.1, -0.3]
mass = 0.9
inertia = [0.02, 0.03, 0.025]

[[body]]
name = "hand"
position = [0.9, -0.2, 0.1]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.4
inertia = [0.003, 0.002, 0.0025]
gravity = [0.0, 0.0, 0.0]

[[body]]
name = "tip"
position = [1.3, -0.1, 0.2]
mass = 0.2
inertia = [0.001, 0.002, 0.0015]

[[joint]]
type = "slider"
name = "cart"
body = "cart"
point = [0.2, 0.3, -0.1]
axis = [0.6, 0.0, 0.8]
displacement = [{lower = -1.0, upper = 1.5, stiffness = 30.0, damping = 0.4, target = 0.05, friction = 0.2}]

[[joint]]
type = "hinge"
body = "arm"
to = "cart"
point = [0.2, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]
angle = [{stiffness = 4.0, friction = 0.07, lower = -0.5}]

[[joint]]
type = "universal"
body = "hand"
to = "arm"
point = [0.7, 0.0, -0.1]
axis = [0.6, 0.8, 0.0]
axis_2 = [0.0, 0.0, 1.0]
angle = [{stiffness = 0.3, target = 0.1}, {which = "second", damping = 0.02}]

[[joint]]
type = "ball"
body = "tip"
to = "hand"
point = [1.1, -0.15, 0.2]

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// Names as an import of SDFormat makes them: of one model that moves and of a static one, with models in them.
inline constexpr const char* nested = R"(
title    = "nested"
duration = 1.0
step     = 0.002
gravity  = [0.3, -9.7, 0.2]

[[body]]
name = "box::link"
position = [30.0, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
locked = true
shape = {type = "box", half_extents = [0.4, 0.1, 0.3]}

[[body]]
name = "box::hull::part"
position = [40.0, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
locked = true
shape = {type = "box", half_extents = [0.4, 0.1, 0.3]}

[[body]]
name = "m::a"
position = [0.1, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "m::inner::a"
position = [0.5, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "m::inner::deep::a"
position = [0.9, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "m::b"
position = [1.3, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[joint]]
type = "hinge"
name = "m::j"
body = "m::a"
point = [0.2, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[joint]]
type = "hinge"
name = "m::inner::j"
body = "m::inner::a"
to = "m::a"
point = [0.3, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[joint]]
type = "hinge"
name = "m::k"
body = "m::inner::deep::a"
to = "m::inner::a"
point = [0.4, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[joint]]
type = "hinge"
name = "l"
body = "m::b"
to = "m::inner::deep::a"
point = [0.5, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[material]]
between = ["*", "*"]
friction = 0.4
restitution = 0.0

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// The same of several models, and of none.
inline constexpr const char* several = R"(
title    = "several"
duration = 1.0
step     = 0.002
gravity  = [0.3, -9.7, 0.2]

[[body]]
name = "box"
position = [30.0, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
locked = true
shape = {type = "box", half_extents = [0.4, 0.1, 0.3]}

[[body]]
name = "n"
position = [0.1, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "p::n"
position = [0.5, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "m::n"
position = [0.9, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
inertia = [0.011, 0.017, 0.013]

[[body]]
name = "scene"
position = [1.3, 0.3, -0.2]
orientation = [0.8, 0.0, 0.6, 0.0]
mass = 0.7
shape = {type = "sphere", radius = 0.1}

[[joint]]
type = "hinge"
name = "m::j"
body = "n"
point = [0.2, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[joint]]
type = "hinge"
name = "n::j"
body = "p::n"
to = "n"
point = [0.3, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[joint]]
type = "hinge"
name = "k"
body = "m::n"
to = "p::n"
point = [0.4, 0.2, -0.2]
axis = [0.0, 0.8, -0.6]

[[material]]
between = ["*", "*"]
friction = 0.4
restitution = 0.0

[[claim]]
conserves = "joint_gap"
tolerance = {absolute = 0.001, reason = "convention: a millimetre"}
)";

// One restitution, two frictions, each the smaller of two numbers.
inline constexpr const char* bounces = R"(
title    = "bounces"
duration = 1.0
step     = 0.001
gravity  = [0.0, -9.81, 0.0]

[[plane]]
name = "slope"
normal = [0.0, 0.8, 0.6]
offset = -1.5

[[body]]
name = "scene"
position = [3.0, 0.5, 0.0]
orientation = [0.8, 0.0, 0.6, 0.0]
locked = true
shape = {type = "box", half_extents = [0.4, 0.1, 0.3]}

[[body]]
name = "ball"
position = [0.0, 2.0, 0.0]
mass = 1.1
shape = {type = "sphere", radius = 0.3}

[[body]]
name = "can"
position = [1.0, 2.0, 0.0]
orientation = [0.6, 0.8, 0.0, 0.0]
mass = 1.2
shape = {type = "cylinder", radius = 0.2, length = 0.5}

[[body]]
name = "pill"
position = [2.0, 2.0, 0.0]
mass = 0.4
shape = {type = "capsule", radius = 0.1, length = 0.4}

[[material]]
between = ["*", "*"]
friction = 0.7
restitution = 0.6

[[material]]
between = ["ball", "*"]
friction = 0.4
restitution = 0.6

[[claim]]
conserves = "energy"
measure   = "increase"
tolerance = {relative = 0.01, reason = "convention: a hundredth"}
)";

}  // namespace cylon::exports::scenes
