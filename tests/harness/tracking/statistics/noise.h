// Made-up process times of a loaded machine, from a fixed seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace cylon::statistics {

/// How the logarithm of a process's time strays; deviations are of ln(time).
struct Noise {
  const char* name;
  double spread = 0.03;  ///< Of one process from the next, Student's t.
  double freedom = 30;   ///< Of that t: 2 has no variance.
  double drift = 0;      ///< Over a comparison of 80 processes, linear.
  double swing = 0;      ///< A level that wanders: AR(1), its deviation
  double memory = 0;     ///< and how much of it one process leaves to the next.
  double burst = 0;  ///< Slower by this while a neighbour computes: begins every 20 processes or so, lasts 5.
};

/// Unlike each other, and unlike a normal distribution.  A process's minimum of its repetitions on the
/// machine on which the rule was chosen strayed by 3 %.
inline const std::vector<Noise>& noises() {
  static const std::vector<Noise> all = {
      {.name = "3 %, nearly normal"},
      {.name = "heavy tails", .spread = 0.03, .freedom = 2},
      {.name = "drift of 30 %", .spread = 0.02, .freedom = 5, .drift = 0.30},
      {.name = "wandering", .spread = 0.01, .freedom = 5, .swing = 0.08, .memory = 0.9},
      {.name = "bursts of 25 %", .spread = 0.02, .freedom = 5, .burst = 0.25},
  };
  return all;
}

/// ln(time) of `count` processes, one after the other.
inline std::vector<double> log_times(const Noise& noise, std::size_t count, std::mt19937_64& random) {
  std::student_t_distribution<double> t(noise.freedom);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<double> times;
  double level = noise.swing * normal(random);
  bool busy = false;
  for (std::size_t i = 0; i < count; ++i) {
    busy = uniform(random) < (busy ? 0.8 : 0.05);
    times.push_back(level + (busy ? noise.burst : 0) + noise.spread * t(random) +
                    noise.drift * static_cast<double>(i) / 80);
    level = noise.memory * level + noise.swing * std::sqrt(1 - noise.memory * noise.memory) * normal(random);
  }
  return times;
}

/// ln(B/A) of pairs run as ABBA BAAB…, where B is slower by a factor.
inline std::vector<double> interleaved(const Noise& noise, std::size_t pairs, double factor,
                                       std::mt19937_64& random) {
  const std::vector<double> times = log_times(noise, 2 * pairs, random);
  std::vector<double> d;
  for (std::size_t i = 0; i < pairs; ++i) {
    const bool a_first = i % 4 == 0 || i % 4 == 3;  // AB BA | BA AB
    d.push_back((a_first ? 1 : -1) * (times[2 * i + 1] - times[2 * i]) + std::log(factor));
  }
  return d;
}

}  // namespace cylon::statistics
