// Invalid scenarios are rejected with the place, the value and the valid range.
#include "harness/core/input_errors.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using cylon::TemporaryFolder;
using cylon::core::InputError;

// The message of the refusal; "" where the text loads.
std::string refusal(const std::string& text) {
  try {
    cylon::scenario::parse(text, "bad.toml");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string load_refusal(const fs::path& path) {
  try {
    cylon::scenario::load(path);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

struct Bad {
  std::string name, text, message;  // each of the message's lines must appear
};

// Lines 1 and 2, and a body on lines 3 to 5.
const std::string head = "duration = 1\nstep = 0.01\n";
const std::string ball = head + "[[body]]\nname = \"ball\"\nmass = 1\n";
const std::string sphere = ball + "shape = { type = \"sphere\", radius = 0.5 }\nposition = [0, 2, 0]\n";
const std::string floor_plane = "[[plane]]\nname = \"floor\"\n";
const std::string good_claim = "tolerance = { absolute = 1, reason = \"r\" }\n";
const std::string claim = "[[claim]]\nconserves = \"energy\"\n";

std::vector<Bad> bad() {
  return {
      // The document
      {"empty", "", "bad.toml:1:1: the file is empty"},
      {"comment_only", "# nothing\n", "bad.toml:1:1: the file is empty"},
      {"no_duration", "step = 0.1\n", "needs 'duration'"},
      {"syntax", "duration = \n", "bad.toml:1:12: "},
      {"key_twice", "duration = 1\nduration = 2\n", "bad.toml:2:"},
      {"unknown_top", ball + "gravityy = [0, 0, 0]\n", "bad.toml:6:1: unknown key 'gravityy' in [[body]]"},
      {"unknown_top_near", "gravty = [0, 0, 0]\n" + ball,
       "bad.toml:1:1: unknown key 'gravty' in a scenario, did you mean 'gravity'?"},
      {"no_body", head, "the scene has no body"},
      {"tags", "tags = [1]\n" + ball,
       "bad.toml:1:9: tags must be an array of strings, but an element is an integer"},
      // Time
      {"duration_negative", "duration = -1\nstep = 0.1\n", "bad.toml:1:12: duration = -1, but must be > 0 s"},
      {"duration_nan", "duration = nan\nstep = 0.1\n", "bad.toml:1:12: duration = nan, but must be finite"},
      {"duration_text", "duration = \"1\"\nstep = 0.1\n",
       "bad.toml:1:12: duration must be a number, not a string"},
      {"step_zero", "duration = 1\nstep = 0\n", "bad.toml:2:8: step = 0, but must be > 0 s"},
      {"step_fraction", "duration = 1\nstep = \"1/0\"\n", "bad.toml:2:8: step: '1/0' is no step"},
      {"step_words", "duration = 1\nstep = \"fast\"\n", "'fast' is no step"},
      {"step_array", "duration = 1\nstep = [1]\n", "step must be a number or a string like \"1/60\""},
      {"not_whole", "duration = 1\nstep = 0.3\n[[body]]\nname=\"a\"\nmass=1\n",
       "bad.toml:1:12: duration = 1: 1 s is not a whole number of steps"},
      {"nearest_step", "duration = 1\nstep = 0.3\n[[body]]\nname=\"a\"\nmass=1\n", "0.3333333333333333"},
      // Bodies
      {"unknown_body_key", ball + "masss = 1\n",
       "bad.toml:6:1: unknown key 'masss' in [[body]], did you mean 'mass'?"},
      {"no_name", head + "[[body]]\nmass = 1\n", "bad.toml:3:1: [[body]] needs 'name'"},
      {"no_mass", head + "[[body]]\nname = \"a\"\n", "bad.toml:3:1: [[body]] needs 'mass'"},
      {"mass_negative", head + "[[body]]\nname = \"a\"\nmass = -2.5\n",
       "bad.toml:5:8: mass = -2.5, but must be > 0 kg"},
      {"mass_zero", head + "[[body]]\nname = \"a\"\nmass = 0\n", "mass = 0, but must be > 0 kg"},
      {"mass_inf", head + "[[body]]\nname = \"a\"\nmass = inf\n", "mass = inf, but must be finite"},
      {"position_two", ball + "position = [0, 1]\n",
       "bad.toml:6:12: position must be three numbers [x, y, z], not an array of 2"},
      {"position_nan", ball + "position = [0, nan, 0]\n",
       "bad.toml:6:16: position = nan, but must be finite"},
      {"velocity_text", ball + "velocity = [0, \"1\", 0]\n",
       "bad.toml:6:16: velocity must be three numbers [x, y, z], but an element is a string"},
      {"velocity_no_array", ball + "velocity = \"1\"\n",
       "bad.toml:6:12: velocity must be three numbers [x, y, z], not a string"},
      {"orientation", ball + "orientation = [1, 1, 0, 0]\n",
       "bad.toml:6:15: orientation has the norm 1.414\nnormalised: [0.707106781186547"},
      {"orientation_zero", ball + "orientation = [0, 0, 0, 0]\n", "orientation has the norm 0"},
      {"inertia_triangle", ball + "inertia = [1, 1, 3]\n",
       "bad.toml:6:11: inertia: principal moments 1, 1, 3 kg m^2\nthe largest must be <= 2"},
      {"inertia_negative", ball + "inertia = [1, -1, 1]\n",
       "inertia has the principal moment -1, but must be > 0"},
      {"inertia_skew", ball + "inertia = [1, 0.5, 0, 0.4, 1, 0, 0, 0, 1]\n",
       "must be symmetric, but 0.5 against 0.4"},
      {"inertia_four", ball + "inertia = [1, 1, 1, 1]\n",
       "inertia must be three principal moments or nine numbers, not an array of 4"},
      {"name_twice", ball + "[[body]]\nname = \"ball\"\nmass = 1\n", "bad.toml:7:8: name 'ball' is taken"},
      {"name_star", head + "[[body]]\nname = \"*\"\nmass = 1\n", "bad.toml:4:8: name: "},
      {"locked_moves", ball + "locked = true\nvelocity = [1, 0, 0]\n",
       "bad.toml:7:12: velocity: a locked body does not move"},
      {"collide_bare", ball + "collide = true\n", "bad.toml:6:11: collide = true, but the body has no shape"},
      {"locked_number", ball + "locked = 1\n", "bad.toml:6:10: locked must be true or false, not an integer"},
      {"color", ball + "color = \"red\"\n", "color = 'red', valid: \"#rrggbb\""},
      // Gravity of a body
      {"own_gravity_number", ball + "gravity = 9.81\n",
       "bad.toml:6:11: gravity must be three numbers [x, y, z]"},
      {"own_gravity_nan", ball + "gravity = [0, nan, 0]\n",
       "bad.toml:6:15: gravity = nan, but must be finite"},
      {"own_gravity_locked", ball + "locked = true\ngravity = [0, 0, 0]\n",
       "bad.toml:7:11: gravity: a locked body does not fall"},
      {"own_gravity_huge", ball + "position = [0, 1e300, 0]\ngravity = [0, -1e300, 0]\n",
       "bad.toml:7:11: gravity: the body has no finite energy at the start"},
      // Collision groups
      {"groups_text", sphere + "collision_groups = \"a\"\n",
       "bad.toml:8:20: collision_groups must be an array of strings, not a string"},
      {"groups_empty", sphere + "collision_groups = []\n",
       "bad.toml:8:20: collision_groups = [], but names one group at least; without the key a thing is in "
       "\"default\""},
      {"mask_empty", sphere + "collision_mask = []\n",
       "bad.toml:8:18: collision_mask = [], but names one group at least; what touches nothing has collide = "
       "false"},
      {"group_twice", sphere + "collision_groups = [\"a\", \"b\", \"a\"]\n",
       "collision_groups: 'a' stands there twice"},
      {"group_star", sphere + "collision_mask = [\"*\"]\n", "collision_mask: '*' is no name of a group"},
      {"group_bare", sphere + "collision_groups = [\"\"]\n", "bad.toml:8:21: collision_groups is empty"},
      {"mask_unknown", sphere + "collision_groups = [\"wheels\"]\ncollision_mask = [\"wheel\"]\n",
       "bad.toml:9:18: collision_mask: nothing that may touch is in group 'wheel', did you mean 'wheels'?"},
      {"mask_of_ghosts", sphere + "collision_mask = [\"ghosts\"]\n[[body]]\nname = \"ghost\"\nmass = 1\n",
       "bad.toml:8:18: collision_mask: nothing that may touch is in group 'ghosts'"},
      {"mask_default", sphere + "collision_groups = [\"a\"]\ncollision_mask = [\"default\"]\n",
       "nothing that may touch is in group 'default'"},
      {"mask_of_plane", sphere + floor_plane + "collision_mask = [\"balls\"]\n",
       "bad.toml:10:18: collision_mask: nothing that may touch is in group 'balls'"},
      {"groups_of_a_ghost", sphere + "collide = false\ncollision_groups = [\"a\"]\n",
       "bad.toml:9:20: collision_groups: the body does not collide, so it is in no group and touches none"},
      {"mask_of_a_point", ball + "collision_mask = [\"default\"]\n",
       "bad.toml:6:18: collision_mask: the body does not collide"},
      // Shapes
      {"shape_type", ball + "shape = { type = \"spere\", radius = 1 }\n",
       "bad.toml:6:18: type = 'spere' is unknown, did you mean 'sphere'?"},
      {"shape_no_type", ball + "shape = { radius = 1 }\n", "bad.toml:6:9: shape needs 'type'"},
      {"shape_no_radius", ball + "shape = { type = \"sphere\" }\n", "shape needs 'radius'"},
      {"shape_foreign_key", ball + "shape = { type = \"sphere\", radius = 1, length = 2 }\n",
       "unknown key 'length' in shape; valid: type, radius"},
      {"radius_negative", ball + "shape = { type = \"sphere\", radius = -1 }\n",
       "bad.toml:6:37: radius = -1, but must be > 0 m"},
      {"empty_hull", ball + "shape = { type = \"hull\", vertices = [] }\ninertia = [1, 1, 1]\n",
       "a hull needs four points or more, but has 0"},
      {"flat_hull", ball + "shape = { type = \"hull\", vertices = [[0,0,0],[1,0,0],[0,0,1],[1,0,1]] }\n",
       "the points lie in one plane"},
      {"mesh_index", ball + "shape = { type = \"mesh\", vertices = [[0,0,0]], faces = [[0, 1, 2]] }\n",
       "index 1 is outside 0 … 0"},
      {"mesh_file", ball + "shape = { type = \"mesh\", file = \"none.obj\" }\n",
       "bad.toml:6:33: none.obj: no such file"},
      {"compound_mass",
       ball + "shape = { type = \"compound\", parts = [{ type = \"sphere\", radius = 1, mass = 2 }] }\n",
       "mass = 1, but the parts have 2 kg together"},
      // Generators
      {"lattice_zero", head + "[[lattice]]\nname = \"a\"\nmass = 1\ncount = [2, 0, 2]\nspacing = [1, 1, 1]\n",
       "bad.toml:6:13: count = 0, but must be >= 1"},
      {"lattice_huge",
       head + "[[lattice]]\nname = \"a\"\nmass = 1\ncount = [999999999, 999999999, 9]\nspacing = [1, 1, 1]\n",
       "at most 1000000"},
      {"cloud_full",
       head + "[[cloud]]\nname = \"a\"\nmass = 1\ncount = 100\nlow = [0,0,0]\nhigh = [1,1,1]\nshape = { type "
              "= \"sphere\", radius = 0.5 }\n",
       "bad.toml:6:9: count = 100: only "},
      {"cloud_corners",
       head + "[[cloud]]\nname = \"a\"\nmass = 1\ncount = 1\nlow = [0,2,0]\nhigh = [1,1,1]\n",
       "low = [0, 2, 0] must not exceed high"},
      // Forces
      {"spring_body", ball + "[[spring]]\nbody = \"bal\"\npin = [0, 1, 0]\nstiffness = 1\n",
       "bad.toml:7:8: body = 'bal': no body has that name, did you mean 'ball'?"},
      {"spring_both", ball + "[[spring]]\nbody = \"ball\"\nstiffness = 1\n",
       "bad.toml:6:1: [[spring]] needs either 'to' (a body) or 'pin'"},
      {"spring_negative", ball + "[[spring]]\nbody = \"ball\"\npin = [0, 1, 0]\nstiffness = -1\n",
       "bad.toml:9:13: stiffness = -1, but must be >= 0 N/m"},
      {"spring_no_direction",
       ball + "[[spring]]\nbody = \"ball\"\npin = [0, 0, 0]\nstiffness = 1\nrest_length = 1\n",
       "bad.toml:10:15: rest_length = 1: both ends start at [0, 0, 0]"},
      {"drag_nothing", ball + "[[drag]]\nbody = \"ball\"\n",
       "[[drag]] needs 'linear', 'angular' or 'momentum'"},
      {"thrust_both", ball + "[[thrust]]\nbody = \"ball\"\nforce = [1, 0, 0]\nmass_rate = -1\n",
       "[[thrust]] needs either 'force' or 'mass_rate'"},
      {"mass_used_up",
       ball + "[[thrust]]\nbody = \"ball\"\nmass_rate = -0.5\nexhaust_velocity = [1, 0, 0]\n"
              "[[thrust]]\nbody = \"ball\"\nmass_rate = -0.75\nexhaust_velocity = [0, 1, 0]\n",
       "bad.toml:8:13: mass_rate = -0.5: of 'ball' nothing is left at t = 0.8 s; valid: a mass above 0 until "
       "the end, "
       "at 1 s"},
      {"frequency_of_nothing", ball + "[frame]\nfrequency = 3\n",
       "bad.toml:7:13: frequency: how often 'acceleration' changes, of which there is none"},
      {"rocket_no_exhaust", ball + "[[thrust]]\nbody = \"ball\"\nmass_rate = -1\n",
       "mass_rate needs either 'exhaust_velocity'"},
      {"attraction_self", ball + "[[attraction]]\nbody = \"ball\"\nto = \"ball\"\nstrength = 1\n",
       "two different bodies"},
      {"water_mode", ball + "[[water]]\nbuoyancy = 1\nmode = \"wet\"\n",
       "mode = 'wet' is unknown; valid: volume, step"},
      // Joints
      {"joint_type", ball + "[[joint]]\ntype = \"bal\"\nbody = \"ball\"\npoint = [0, 0, 0]\n",
       "bad.toml:7:8: type = 'bal' is unknown, did you mean 'ball'?"},
      {"joint_velocity",
       ball + "velocity = [1, 0, 0]\nangular_velocity = [0, 0, 2]\n[[joint]]\ntype = \"ball\"\nbody = "
              "\"ball\"\npoint = [0, 1, 0]\n",
       "bad.toml:6:12: velocity = [1, 0, 0] breaks the ball joint of 'ball' by 1 m/s\nconsistent: [2, 0, 0]"},
      {"hinge_spin",
       ball + "angular_velocity = [1, 2, 0]\n[[joint]]\ntype = \"hinge\"\nbody = \"ball\"\npoint = [0, 0, "
              "0]\naxis = [0, 3, 0]\n",
       "breaks the hinge joint of 'ball' by 1 rad/s; consistent: [0, 2, 0]"},
      {"fixed_spin",
       ball +
           "angular_velocity = [0, 2, 0]\n[[joint]]\ntype = \"fixed\"\nbody = \"ball\"\npoint = [0, 0, 0]\n",
       "breaks the fixed joint of 'ball' by 2 rad/s; consistent: [0, 0, 0]"},
      {"distance_velocity",
       ball + "velocity = [1, 2, 0]\n[[joint]]\ntype = \"distance\"\nbody = \"ball\"\npoint = [0, 3, 0]\n",
       "breaks the distance joint of 'ball' by 2 m/s; consistent: [1, 0, 0]"},
      {"distance_length",
       ball + "[[joint]]\ntype = \"distance\"\nbody = \"ball\"\npoint = [0, 3, 0]\nlength = 2\n",
       "length = 2, but the ends start 3 m apart"},
      {"hinge_axis",
       ball + "[[joint]]\ntype = \"hinge\"\nbody = \"ball\"\npoint = [0, 0, 0]\naxis = [0, 0, 0]\n",
       "axis = [0, 0, 0] has no direction"},
      // Contacts
      {"no_material", sphere + floor_plane,
       "bad.toml:3:1: 'ball' and 'floor' may touch, but no [[material]] says how"},
      {"material_name",
       sphere + floor_plane + "[[material]]\nbetween = [\"ball\", \"flor\"]\nrestitution = 1\nfriction = 0\n",
       "bad.toml:11:11: between: no body, plane or generator is called 'flor', did you mean 'floor'?"},
      {"restitution",
       sphere + floor_plane + "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1.5\nfriction = 0\n",
       "bad.toml:12:15: restitution = 1.5, but must be in [0, 1]"},
      {"friction",
       sphere + floor_plane + "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = -0.1\n",
       "friction = -0.1, but must be >= 0"},
      {"material_twice",
       sphere + floor_plane +
           "[[material]]\nbetween = [\"ball\", \"floor\"]\nrestitution = 1\nfriction = "
           "0\n[[material]]\nbetween = [\"floor\", \"ball\"]\nrestitution = 1\nfriction = 0\n",
       "bad.toml:15:11: the pair 'floor', 'ball' has a material already"},
      {"two_patterns",
       sphere + floor_plane +
           "[[material]]\nbetween = [\"ball\", \"*\"]\nrestitution = 1\nfriction = "
           "0\n[[material]]\nbetween = [\"*\", \"floor\"]\nrestitution = 0\nfriction = 0\n",
       "bad.toml:15:11: between: 'ball' and 'floor' may touch, and [\"ball\", \"*\"] and [\"floor\", \"*\"] "
       "say "
       "other numbers; add between = [\"ball\", \"floor\"]"},
      {"plane_normal", sphere + floor_plane + "normal = [0, 2, 0]\n",
       "bad.toml:10:10: normal = [0, 2, 0] has the norm 2, but must be a unit vector within 1e-9; "
       "normalised: [0, 1, 0]"},
      {"in_plane",
       sphere + floor_plane +
           "offset = 1.75\n[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n",
       "bad.toml:7:12: 'ball' reaches 0.25 m into plane 'floor'"},
      {"spheres_overlap",
       sphere + "[[body]]\nname = \"b\"\nmass = 1\nposition = [0.75, 2, 0]\nshape = { type = \"sphere\", "
                "radius = 0.5 }\n[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n",
       "bad.toml:11:12: 'ball' and 'b' overlap by 0.25 m"},
      // Claims
      {"no_tolerance", ball + claim, "bad.toml:6:1: [[claim]] needs 'tolerance'"},
      {"no_reason", ball + claim + "tolerance = { absolute = 1 }\n",
       "bad.toml:8:13: tolerance needs 'reason'"},
      {"empty_reason", ball + claim + "tolerance = { absolute = 1, reason = \"\" }\n", "reason is empty"},
      {"no_bound", ball + claim + "tolerance = { reason = \"r\" }\n",
       "needs 'absolute', 'relative', 'roundings', or 'order' with 'constant'"},
      {"order_alone", ball + claim + "tolerance = { order = true, reason = \"r\" }\n",
       "order = true and constant belong together"},
      {"roundings_order",
       ball + claim + "tolerance = { order = true, constant = 1, roundings = 9, reason = \"r\" }\n",
       "order = true allows for rounding by itself"},
      {"size_alone", ball + claim + "tolerance = { absolute = 1, size = 1, reason = \"r\" }\n",
       "size: is of what is rounded, and needs 'roundings'"},
      {"roundings_of_change",
       ball + "[[claim]]\nchanges = \"position\"\nat_least = 1\ntolerance = { roundings = 9, reason = "
              "\"r\" }\n",
       "roundings do not go with 'changes'"},
      {"roundings_rate", ball + claim + "measure = \"rate\"\ntolerance = { roundings = 9, reason = \"r\" }\n",
       "roundings does not go with measure = \"rate\""},
      {"roundings_of_nothing",
       ball + "[[claim]]\nconserves = \"linear_momentum\"\ntolerance = { roundings = 9, reason = \"r\" }\n",
       "the linear_momentum claimed is 0, and of nothing there is no rounding"},
      {"roundings_loose_truth",
       ball + "velocity = [1, 2, 3]\n[[claim]]\nfollows = \"projectile\"\nobservable = "
              "\"position\"\ntolerance = { roundings = 1, reason = \"r\" }\n",
       "is itself only good to"},
      {"relative_angle",
       ball + "inertia = [1, 1, 2]\n[[claim]]\nconserves = \"orientation\"\ntolerance = { relative = 1e-6, "
              "reason = \"r\" }\n",
       "orientation is an angle and has no scale"},
      {"observable", ball + "[[claim]]\nconserves = \"enrgy\"\n" + good_claim,
       "bad.toml:7:13: conserves = 'enrgy' is unknown, did you mean 'energy'?"},
      {"truth", ball + "[[claim]]\nfollows = \"projectle\"\nobservable = \"position\"\n" + good_claim,
       "bad.toml:7:11: follows = 'projectle' is no exact solution, did you mean 'projectile'?"},
      {"truth_domain",
       ball + "[[claim]]\nfollows = \"spring_orbit\"\nobservable = \"position\"\n" + good_claim,
       "bad.toml:7:11: follows = 'spring_orbit' does not serve this scene"},
      {"truth_loose",
       ball + "velocity = [1, 2, 3]\n[[claim]]\nfollows = \"projectile\"\nobservable = "
              "\"position\"\ntolerance = { absolute = 1e-17, reason = \"r\" }\n",
       "is itself only good to"},
      {"follows_nothing", ball + "[[claim]]\nfollows = \"projectile\"\n" + good_claim, "needs 'observable'"},
      {"point_turns", ball + "[[claim]]\nconserves = \"angular_velocity\"\n" + good_claim,
       "a point (a body without shape and inertia) has none"},
      {"component_scalar", ball + claim + "component = \"x\"\n" + good_claim,
       "bad.toml:8:13: component belongs to vectors"},
      {"no_joint", ball + "[[claim]]\nconserves = \"joint_gap\"\n" + good_claim, "the scene has no joint"},
      {"until", ball + claim + "until = 2\n" + good_claim,
       "bad.toml:8:9: until = 2, but must be in (0, 1] s"},
      {"sample", ball + claim + "sample = 0.015\n" + good_claim, "bad.toml:8:10: sample: "},
      {"sample_word", ball + claim + "sample = \"stop\"\n" + good_claim,
       "sample = 'stop' is unknown, did you mean 'step'?"},
      {"twice", ball + claim + good_claim + claim + good_claim,
       "bad.toml:9:1: the claim 'energy conserved' is made twice"},
      {"data_missing",
       ball + "[[claim]]\nfollows = { file = \"none.json\" }\nobservable = \"position\"\n" + good_claim,
       "none.json: no such file"},
  };
}

class Refuses : public testing::TestWithParam<Bad> {};

TEST_P(Refuses, WithPlaceAndReason) {
  const std::string message = refusal(GetParam().text);
  EXPECT_TRUE(message.starts_with("bad.toml:")) << message;
  std::string rest = GetParam().message;
  while (!rest.empty()) {
    const auto end = rest.find('\n');
    EXPECT_NE(message.find(rest.substr(0, end)), std::string::npos)
        << "expected: " << rest << "\nmessage: " << message;
    rest = end == std::string::npos ? "" : rest.substr(end + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Loader, Refuses, testing::ValuesIn(bad()),
                         [](const auto& row) { return row.param.name; });

TEST(LoaderBase, BaseTextsAreValid) {
  EXPECT_EQ(refusal(ball), "");
  EXPECT_EQ(refusal(sphere), "");
  EXPECT_EQ(refusal(ball + claim + good_claim), "");
  EXPECT_EQ(refusal(ball + claim + "sample = 0.02\nuntil = 1\n" + good_claim), "");
}

// Of a scene as somebody writes it who knows another format.
TEST(LoaderBad, TellsAllFaultsInTheOrderOfTheFile) {
  const char* const text =
      "schema = 1\n"                                            // 1
      "duration = 10\n"                                         // 2
      "step = \"often\"\n"                                      // 3
      "[[plane]]\nname = \"floor\"\nnormal = [0, 1]\n"          // 4 to 6
      "[[body]]\nname = \"box\"\nmass = -1\n"                   // 7 to 9
      "shape = { box = [1, 1, 1] }\n"                           // 10
      "[[material]]\npair = [\"*\", \"*\"]\nfriction = 0.2\n";  // 11 to 13
  const char* const wanted[] = {"bad.toml:1:1: unknown key 'schema'",
                                "bad.toml:3:8: step",
                                "bad.toml:6:10: normal must be",
                                "bad.toml:9:8: mass = -1",
                                "bad.toml:10:9: shape needs 'type'",
                                "bad.toml:11:1: [[material]] needs 'between'",
                                "bad.toml:11:1: [[material]] needs 'restitution'",
                                "bad.toml:12:1: unknown key 'pair' in"};
  try {
    cylon::scenario::parse(text, "bad.toml");
    FAIL() << "it was taken";
  } catch (const cylon::core::InputErrors& error) {
    ASSERT_EQ(error.each.size(), std::size(wanted));
    EXPECT_STREQ(error.what(), error.each[0].what());
    for (std::size_t i = 0; i < error.each.size(); ++i)
      EXPECT_TRUE(std::string_view(error.each[i].what()).starts_with(wanted[i])) << error.each[i].what();
  }
}

TEST(LoaderBad, EndsAfterTenFaultsAndSaysSo) {
  std::string text;
  for (int i = 10; i < 60; ++i) text += "key" + std::to_string(i) + " = 1\n";
  try {
    cylon::scenario::parse(text, "bad.toml");
    FAIL() << "it was taken";
  } catch (const cylon::core::InputErrors& error) {
    ASSERT_EQ(error.each.size(), 11u);
    EXPECT_STREQ(error.each[10].what(), "bad.toml: after 10 errors no more are looked for");
  }
}

const fs::path data = fs::path(cylon::source_dir) / "tests/data";

TEST(LoaderFiles, ErrorsGiveLineAndColumn) {
  EXPECT_NE(load_refusal(data / "bad/unclosed_string.toml").find("unclosed_string.toml:1:"),
            std::string::npos);
  EXPECT_NE(load_refusal(data / "bad/binary.toml").find("binary.toml:1:"), std::string::npos);
  EXPECT_NE(load_refusal(data / "bad/empty.toml").find("empty.toml:1:1: the file is empty"),
            std::string::npos);
  EXPECT_NE(load_refusal(data / "bad/unknown_key.toml").find("unknown_key.toml:6:1: unknown key 'masss'"),
            std::string::npos);
  EXPECT_NE(load_refusal(data / "bad/nowhere.toml").find("nowhere.toml: no such file"), std::string::npos);
  EXPECT_NE(load_refusal(data / "bad").find("is a directory"), std::string::npos);
}

TEST(LoaderFiles, RejectsHugeFileWithoutReadingIt) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "garbage.toml";
  { std::ofstream(path) << "garbage"; }
  fs::resize_file(path, 100u << 20);
  const std::string message = load_refusal(path);
  EXPECT_NE(message.find("104857600 bytes, but at most 16777216 (16 MB)"), std::string::npos) << message;
}

TEST(LoaderFiles, RejectsNonRegularFiles) {
  EXPECT_NE(load_refusal("/dev/null").find("is not a regular file"), std::string::npos);
}

}  // namespace
