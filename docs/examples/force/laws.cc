// Three forces of one's own (docs/in-house.md#forces-of-your-own).  Compiled by CMakeLists.txt here, or by
//   g++ -std=c++17 -O2 -shared -fPIC -I PREFIX/include laws.cc -o laws.so
#include <cylon/force.h>

#include <cmath>
#include <limits>

namespace {

constexpr double stated = std::numeric_limits<double>::quiet_NaN();  // no value by default
constexpr double infinite = std::numeric_limits<double>::infinity();

// Duffing's spring to the origin:  F = -(linear + cubic |x|^2) x.
const cylon_law_parameter stiffnesses[] = {{"linear", 0, infinite, 0}, {"cubic", 0, infinite, stated}};
void hold(const double* k, double, const cylon_seen_body* body, size_t, cylon_load* load) {
  const double* x = body->position;
  const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  for (int i = 0; i < 3; ++i) load->force[i] -= (k[0] + k[1] * square) * x[i];
}

// Drag of fast flow:  F = -c |v| v.
const cylon_law_parameter resistance[] = {{"c", 0, infinite, stated}};
void resist(const double* c, double, const cylon_seen_body* body, size_t, cylon_load* load) {
  const double* v = body->velocity;
  const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int i = 0; i < 3; ++i) load->force[i] -= c[0] * speed * v[i];
}

// A magnet in a field B that turns about y: with m = R moment z the torque is  m x B,  B = field (cos wt, 0, sin wt).
const cylon_law_parameter field[] = {{"moment", -infinite, infinite, stated},
                                     {"field", -infinite, infinite, stated},
                                     {"frequency", 0, infinite, 0}};
void turn(const double* p, double time, const cylon_seen_body* body, size_t, cylon_load* load) {
  const double* q = body->orientation;  // w, x, y, z; its z axis is
  const double m[3] = {p[0] * 2 * (q[1] * q[3] + q[0] * q[2]), p[0] * 2 * (q[2] * q[3] - q[0] * q[1]),
                       p[0] * (1 - 2 * (q[1] * q[1] + q[2] * q[2]))};
  const double b[3] = {p[1] * std::cos(p[2] * time), 0, p[1] * std::sin(p[2] * time)};
  load->torque[0] += m[1] * b[2] - m[2] * b[1];
  load->torque[1] += m[2] * b[0] - m[0] * b[2];
  load->torque[2] += m[0] * b[1] - m[1] * b[0];
}

const cylon_law laws[] = {{"duffing", 1, 1, 0, 0, 2, stiffnesses, nullptr, hold},
                          {"fast_drag", 1, 1, 1, 0, 1, resistance, nullptr, resist},
                          {"magnet", 1, 1, 0, 1, 3, field, nullptr, turn}};
const cylon_plugin_table table = {CYLON_FORCE_VERSION, 3, laws};

}  // namespace

const cylon_plugin_table* cylon_plugin(void) { return &table; }
