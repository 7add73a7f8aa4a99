// What of Gazebo moves bodies, by its name.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace cylon::formats {

/// Elements that move bodies wherever they stand: of a newer format, in a wrong place, or below <gazebo>.
inline constexpr std::array<std::string_view, 26> moving_elements = {"model",
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
                                                                     "velocity_decay"};

/// Whether a plugin shows, measures or records, or waits for a command, by the name of its library, or by its own name
/// where the library holds all of gz-sim.  Every other one may push bodies: by a medium, a coupling of joints, or a
/// drive that holds them where no command comes, as those of wheels do.
inline bool leaves_bodies_alone(std::string_view library, std::string_view name) {
  constexpr std::array harmless = {"simphysics",
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
                                   "roscontrol",
                                   "ros2control"};
  constexpr std::array driving = {"controller", "motor", "gimbal"};
  std::string letters;  // "gz-sim-user-commands-system" and "gz::sim::systems::UserCommands" alike
  const bool holds_all = library.empty() || library == "gz-sim" || library == "libgz-sim.so";
  for (const char c : holds_all ? name : library)
    if (std::isalnum(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto has = [&](const char* word) { return letters.find(word) != std::string::npos; };
  return std::ranges::any_of(harmless, has) && std::ranges::none_of(driving, has);
}

}  // namespace cylon::formats
