// Laws for tests: copies of what the engine has itself, and laws that no one should write.
#include "cylon/force.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// F = m g on every body.
const cylon_law_parameter field[] = {
    {"x", -infinite, infinite, 0}, {"y", -infinite, infinite, -9.81}, {"z", -infinite, infinite, 0}};
void fall(const double* g, double, const cylon_seen_body* bodies, size_t count, cylon_load* loads) {
  for (size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) loads[i].force[k] += bodies[i].mass * g[k];
}

// torque = -c R I R^T w:  a drag of the spin angular momentum, which reads the inertia.
const cylon_law_parameter rate[] = {{"c", 0, 10, std::nan("")}};
void slow_down(const double* c, double, const cylon_seen_body* body, size_t, cylon_load* load) {
  const double w0 = body->orientation[0], x = body->orientation[1], y = body->orientation[2],
               z = body->orientation[3];
  const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w0 * z), 2 * (x * z + w0 * y)},
                          {2 * (x * y + w0 * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w0 * x)},
                          {2 * (x * z - w0 * y), 2 * (y * z + w0 * x), 1 - 2 * (x * x + y * y)}};
  double in_body[3] = {}, momentum[3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) in_body[i] += r[j][i] * body->angular_velocity[j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) momentum[i] += body->inertia[3 * i + j] * in_body[j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) load->torque[i] -= c[0] * r[i][j] * momentum[j];
}

void break_down(const double* when, double time, const cylon_seen_body*, size_t, cylon_load* load) {
  if (time > when[0]) load->force[1] = std::nan("");
}
void crash(const double*, double, const cylon_seen_body*, size_t, cylon_load*) { std::abort(); }
void nothing(const double*, double, const cylon_seen_body*, size_t, cylon_load*) {}
const char* never(const double*, const cylon_seen_body*, size_t) { return "it never acts"; }

const cylon_law_parameter when[] = {{"when", 0, infinite, 0}};
const cylon_law laws[] = {{"fall", 1, 0, 0, 0, 3, field, nullptr, fall},
                          {"slow_down", 1, 1, 1, 0, 1, rate, nullptr, slow_down},
                          {"break_down", 1, 1, 0, 1, 1, when, nullptr, break_down},
                          {"crash", 1, 1, 0, 0, 0, nullptr, nullptr, crash},
                          {"never", 1, 1, 0, 0, 0, nullptr, never, nothing},
                          {"three", 2, 3, 0, 0, 0, nullptr, nullptr, nothing}};
const cylon_plugin_table table = {CYLON_FORCE_VERSION, 6, laws};

}  // namespace

const cylon_plugin_table* cylon_plugin(void) { return &table; }
