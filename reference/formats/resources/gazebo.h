// What of Gazebo moves bodies, by its name.
#pragma once

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>

namespace cylon::formats {

/// Elements that move bodies wherever they stand: of a newer format, in a wrong place, or below <gazebo>.
inline constexpr std::string_view moving_elements[] = {
    "model",
    "link",
    "joint",
    "inertial",
    "collision",
    "include",
    "actor",
    "mass",
    "inertia",
    "pose",
    "static",
    "gravity",
    "physics",
    "wind",
    "axis",
    "axis2",
    "limit",
    "dynamics",
    "damping",
    "friction",
    "kinematic",
    "surface",
    "geometry",
    "spring_stiffness",
    "spring_reference",
    "velocity_decay",
};

/// Whether a plugin shows, measures or records, or waits for a command, by the name of its library, or by its own name
/// where the library holds several.  Every other one may push bodies: by a medium, a coupling of joints, or a
/// drive that holds them where no command comes, as those of wheels and ros_control (SetPosition in each step) do.
inline bool leaves_bodies_alone(std::string_view library, std::string_view name) {
  constexpr std::string_view harmless[] = {
      "simphysics",
      "systemsphysics",
      "usercommands",
      "scenebroadcaster",
      "publisher",
      "sensor",
      "simimu",
      "systemsimu",
      "rosimu",
      "libimu",
      "contact",
      "altimeter",
      "magnetometer",
      "airpressure",
      "airspeed",
      "navsat",
      "gps",
      "forcetorque",
      "camera",
      "audio",
      "label",
      "breadcrumbs",
      "performerdetector",
      "logrecord",
      "battery",
      "videorecorder",
      "particle",
      "shaderparam",
      "thermal",
      "comms",
      "dvl",
      "tactile",
      "kineticenergymonitor",
      "lidar",
      "laser",
      "range",
      "kinect",
      "bumper",
      "sonar",
      "p3d",
      "rosinit",
      "rosfactory",
      "rosapi",
      "rospaths",
      "applyjointforce",
      "touchplugin",
      "colladaworldexporter",
      "environmentpreload",
  };
  constexpr std::string_view driving[] = {"controller", "motor", "gimbal"};
  std::string letters;  // "gz-sim-user-commands-system" and "gz::sim::systems::UserCommands" alike
  constexpr std::string_view several[] = {"", "gz-sim", "libgz-sim.so",
                                          "gz-sim-log-system"};  // a library of more than one
  const bool holds_all = std::ranges::find(several, library) != std::end(several);
  for (const char c : holds_all ? name : library)
    if (std::isalnum(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto has = [&](std::string_view word) { return letters.find(word) != std::string::npos; };
  return std::ranges::any_of(harmless, has) && std::ranges::none_of(driving, has);
}

}  // namespace cylon::formats
