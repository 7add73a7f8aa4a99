// The certified solution against every smooth reference solution, and those with blows one at a time: their
// difference is no more than both radii.
#include "reference/certified/solve.h"
#include "tests/reference/certified/reference_numbers.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <chrono>

namespace cylon::certified {
namespace {

using nlohmann::json;

// Half a unit of the last of 21 digits, and what the file says of its two computations.
double radius_of(const json& file, const json& number) {
  const auto& text = number.get_ref<const std::string&>();
  const double size = std::abs(accuracy::number(number));
  const double difference = accuracy::number(file["agreement"]["max_abs_diff"]);
  return difference + (text.size() < 15 ? 0 : 0.51 * std::pow(10.0, std::floor(std::log10(size)) - 20));
}

// |ours - file's| / (sum of radii): at most one.
double excess(const json& file, const Ball& ours, const json& number, double sign) {
  Ball difference(number.get<std::string>(), 256);
  if (sign < 0) arb_neg(difference.get(), difference.get());
  arb_sub(difference.get(), difference.get(), ours.get(), 256);
  arf_t middle;
  arf_init(middle);
  arf_abs(middle, arb_midref(difference.get()));
  const double distance = arf_get_d(middle, ARF_RND_DOWN);
  arf_clear(middle);
  const double allowed = difference.radius() + radius_of(file, number);
  return distance == 0 ? 0 : distance / allowed;
}

class ReferenceFiles : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceFiles, AreEnclosed) {
  const json file = accuracy::read_truth(GetParam());
  const core::Scene scene = accuracy::regular_scene(file);
  const ReferenceNumbers numbers(file);
  std::vector<double> times;
  for (const json& t : file["t"]) times.push_back(accuracy::number(t));
  const auto start = std::chrono::steady_clock::now();
  const Certificate found = certify(scene, times, {}, [&](double x) { return numbers(x); });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  double worst = 0;
  int compared = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    // A time that is no double is another time.
    if (!Ball(file["t"][k].get<std::string>(), 256).is(times[k])) continue;
    ++compared;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const json& track = file["trajectory"][scene.bodies[b].name];
      const BodyBalls& body = found.samples[k].bodies[b];
      const auto compare = [&](const auto& balls, const char* key, double sign) {
        if (!track.contains(key)) return;
        for (std::size_t i = 0; i < balls.size(); ++i)
          worst = std::max(worst, excess(file, balls[i], track[key][k][i], sign));
      };
      compare(body.position, "position", 1), compare(body.velocity, "velocity", 1);
      compare(body.angular_velocity, "angular_velocity", 1);
      double product = 0;
      if (track.contains("orientation"))
        for (std::size_t i = 0; i < 4; ++i)
          product += body.orientation[i].middle() * accuracy::number(track["orientation"][k][i]);
      compare(body.orientation, "orientation", product);
    }
  }
  fmt::print("{:28} radius {:8.1e} bits {:4} steps {:5}  {:6.2f} s  difference/radii {:.3f} cond {:.2g}\n",
             GetParam(), found.radius, found.bits, found.steps, spent.count(), worst,
             found.samples.back().conditioning);
  EXPECT_LE(worst, 1);
  EXPECT_GE(compared, 4);
}

INSTANTIATE_TEST_SUITE_P(Blows, ReferenceFiles,
                         testing::Values("bouncing_sphere", "sphere_two_walls", "two_sphere_oblique"),
                         [](const auto& parameter) { return parameter.param; });

INSTANTIATE_TEST_SUITE_P(
    Smooth, ReferenceFiles,
    testing::Values("accretion", "constant_spin", "damped_free_top", "damped_spring_critical",
                    "damped_spring_over", "damped_spring_under", "double_pendulum", "driven_spring",
                    "dzhanibekov", "free_asymmetric_top", "free_symmetric_top", "heavy_top_cusp",
                    "heavy_top_damped", "heavy_top_loops", "heavy_top_nutating", "heavy_top_sleeping_stable",
                    "heavy_top_sleeping_unstable", "heavy_top_slow_spin", "heavy_top_steady_fast",
                    "heavy_top_steady_slow", "kovalevskaya", "physical_pendulum", "projectile",
                    "projectile_drag", "rocket", "spherical_pendulum", "spring_chain", "spring_orbit",
                    "spring_pendulum", "spring_zero_length", "two_body_spring"),
    [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace cylon::certified
