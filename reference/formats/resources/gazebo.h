// What of Gazebo moves bodies, by its name.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// Whether a plugin is one of Gazebo's own, or of gazebo_ros_pkgs, that shows, measures or records, or waits for a command:
/// by its library, or by its class where the library holds several.  Every other one may push bodies: by a medium, a coupling
/// of joints, or a drive that holds them where no command comes, as those of wheels and ros_control (SetPosition in
/// each step) do.  Names are compared whole: "libArrangeForces.so" is not a range finder.
inline bool leaves_bodies_alone(std::string_view library, std::string_view name) {
  // Of gz-sim and ignition-gazebo: "X" of gz-sim-X-system, and gz::sim::systems::Y.
  constexpr std::pair<std::string_view, std::string_view> systems[] = {
      {"physics", "Physics"},
      {"user-commands", "UserCommands"},
      {"scene-broadcaster", "SceneBroadcaster"},
      {"websocket-server", "WebsocketServer"},
      {"log-record", "LogRecord"},
      {"log-video-recorder", "LogVideoRecorder"},
      {"camera-video-recorder", "CameraVideoRecorder"},
      {"collada-world-exporter", "ColladaWorldExporter"},
      {"pose-publisher", "PosePublisher"},
      {"joint-state-publisher", "JointStatePublisher"},
      {"odometry-publisher", "OdometryPublisher"},
      {"sensors", "Sensors"},
      {"imu", "Imu"},
      {"contact", "Contact"},
      {"altimeter", "Altimeter"},
      {"magnetometer", "Magnetometer"},
      {"air-pressure", "AirPressure"},
      {"air-speed", "AirSpeed"},
      {"navsat", "NavSat"},
      {"forcetorque", "ForceTorque"},
      {"dvl", "DopplerVelocityLogSystem"},
      {"cpu-lidar", "CpuLidar"},
      {"logical-camera", "LogicalCamera"},
      {"logicalaudiosensorplugin", "LogicalAudioSensorPlugin"},
      {"environmental-sensor", "EnvironmentalSystem"},
      {"environment-preload", "EnvironmentPreload"},
      {"thermal", "Thermal"},
      {"thermal-sensor", "ThermalSensor"},
      {"opticaltactileplugin", "OpticalTactilePlugin"},
      {"touchplugin", "TouchPlugin"},
      {"performer-detector", "PerformerDetector"},
      {"kinetic-energy-monitor", "KineticEnergyMonitor"},
      {"linearbatteryplugin", "LinearBatteryPlugin"},
      {"label", "Label"},
      {"entity-semantics", "EntitySemantics"},
      {"particle-emitter", "ParticleEmitter"},
      {"particle-emitter2", "ParticleEmitter2"},
      {"shader-param", "ShaderParam"},
      {"led-plugin", "LedPlugin"},
      {"lens-flare", "LensFlare"},
      {"comms-endpoint", "CommsEndpoint"},
      {"perfect-comms", "PerfectComms"},
      {"rf-comms", "RFComms"},
      {"acoustic-comms", "AcousticComms"},
      {"apply-joint-force", "ApplyJointForce"},  // waits for a command
      {"breadcrumbs", "Breadcrumbs"},            // the same
  };
  // Of gazebo-classic, and of the packages gazebo_ros and gazebo_plugins.
  constexpr std::string_view libraries[] = {
      "CameraPlugin",
      "DepthCameraPlugin",
      "GpuRayPlugin",
      "RayPlugin",
      "RaySensorNoisePlugin",
      "SonarPlugin",
      "ContactPlugin",
      "PressurePlugin",
      "TouchPlugin",
      "ForceTorquePlugin",
      "ImuSensorPlugin",
      "FiducialCameraPlugin",
      "LensFlareSensorPlugin",
      "LinearBatteryPlugin",
      "FlashLightPlugin",
      "LedPlugin",
      "BlinkVisualPlugin",
      "gazebo_ros_api_plugin",
      "gazebo_ros_paths_plugin",
      "gazebo_ros_init",
      "gazebo_ros_factory",
      "gazebo_ros_camera",
      "gazebo_ros_triggered_camera",
      "gazebo_ros_multicamera",
      "gazebo_ros_triggered_multicamera",
      "gazebo_ros_depth_camera",
      "gazebo_ros_openni_kinect",
      "gazebo_ros_prosilica",
      "gazebo_ros_laser",
      "gazebo_ros_block_laser",
      "gazebo_ros_gpu_laser",
      "gazebo_ros_ray_sensor",
      "gazebo_ros_range",
      "gazebo_ros_imu",
      "gazebo_ros_imu_sensor",
      "gazebo_ros_gps_sensor",
      "gazebo_ros_bumper",
      "gazebo_ros_ft_sensor",
      "gazebo_ros_f3d",
      "gazebo_ros_p3d",
      "gazebo_ros_joint_state_publisher",
  };
  // gz-sim, ignition-gazebo and their libraries of one release, as gz-sim7.
  constexpr std::string_view projects[] = {"gz-sim", "ignition-gazebo"};
  constexpr std::string_view spaces[] = {"gz::sim::systems::", "ignition::gazebo::systems::"};

  if (library.starts_with("lib")) library.remove_prefix(3);
  if (library.ends_with(".so")) library.remove_suffix(3);
  if (std::ranges::find(libraries, library) != std::end(libraries)) return true;
  // Without the project and its release "-X-system", or "" of a library that holds all; none of another project.
  std::optional<std::string_view> rest;
  if (library.empty()) rest = "";
  for (const std::string_view project : projects)
    if (library.starts_with(project)) {
      rest = library.substr(project.size());
      while (!rest->empty() && rest->front() >= '0' && rest->front() <= '9') rest->remove_prefix(1);
    }
  if (!rest) return false;
  const bool holds_several = rest->empty() || *rest == "-log-system";
  return std::ranges::any_of(systems, [&](const auto& system) {
    if (!holds_several) return *rest == "-" + std::string(system.first) + "-system";
    return std::ranges::any_of(spaces, [&](std::string_view space) {
      return name.starts_with(space) && name.substr(space.size()) == system.second;
    });
  });
}

}  // namespace cylon::formats
