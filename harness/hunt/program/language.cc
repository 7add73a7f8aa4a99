#include "harness/hunt/program/dialect.h"

#include <algorithm>
#include <array>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace cylon::hunt::program {
namespace {

std::string to_cpp(std::string_view formulas) {
  std::string text(formulas);
  // fn name(a, b) {  ->  auto name(const auto& a, const auto& b) {
  const std::regex function(R"(\bfn (\w+)\(([^)]*)\))"), argument(R"((\w+))"), declaration(R"(\blet\b)");
  std::string out;
  for (std::smatch m; std::regex_search(text, m, function); text = m.suffix())
    out += m.prefix().str() + "auto " + m[1].str() + "(" +
           std::regex_replace(m[2].str(), argument, "const auto& $1") + ")";
  return std::regex_replace(out + text, declaration, "auto");
}

std::string to_javascript(std::string_view formulas) {
  return std::regex_replace(std::string(formulas), std::regex(R"(\bfn )"), "function ");
}

}  // namespace

const Language cpp = {"cc",
                      "// ",
                      "V{",
                      "}",
                      "{",
                      "}",
                      R"(#include <algorithm>
#include <cmath>
#include <cstdio>
#include <valarray>
#include <vector>

using std::abs, std::asin, std::ceil, std::cos, std::max, std::min, std::sin, std::sqrt;
using V = std::valarray<double>;  // vectors (x, y, z) in world axes, quaternions (w, x, y, z) from body to world axes
V add(const V& a, const V& b) { return a + b; }
V sub(const V& a, const V& b) { return a - b; }
V mul(double s, const V& a) { return s * a; }
V each(const V& a, const V& b) { return a * b; }
V cross(const V& a, const V& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
double dot(const V& a, const V& b) { return (a * b).sum(); }
double norm(const V& a) { return sqrt(dot(a, a)); }
double square(double x) { return x * x; }
V quaternion(double w, const V& v) { return {w, v[0], v[1], v[2]}; }
V product(const V& p, const V& q) { return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2], p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3], p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]}; }
V turn(const V& q, const V& v) { V u = {q[1], q[2], q[3]}, t = mul(2, cross(u, v)); return v + q[0] * t + cross(u, t); }
V back(const V& q, const V& v) { return turn({q[0], -q[1], -q[2], -q[3]}, v); }
)",
                      R"(
struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = ${bodies};
const Path start = ${starts};
const std::vector<V> gravity = ${gravities};
const double dt = ${dt};
const int steps = ${steps}, count = ${count};
)",
                      R"(
void act(double t, const std::vector<State>& s) {
${forces}}
)",
                      R"(
int main() {
${main}  std::printf("%.9g ${unit}\n", worst);
}
)",
                      to_cpp};

const Language javascript = {"mjs",
                             "// ",
                             "[",
                             "]",
                             "[",
                             "]",
                             R"(const {abs, asin, ceil, cos, max, min, sin, sqrt} = Math;
// Vectors [x, y, z] in world axes, quaternions [w, x, y, z] from body to world axes.
const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (s, a) => a.map((x) => s * x);
const each = (a, b) => a.map((x, i) => x * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const norm = (a) => sqrt(dot(a, a));
const square = (x) => x * x;
const across = (a) => { const k = a.map(abs).indexOf(min(...a.map(abs))), c = cross(a, [0, 1, 2].map((i) => (i === k ? 1 : 0))); return mul(1 / norm(c), c); };
const quaternion = (w, v) => [w, ...v];
const product = (p, q) => [p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2], p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3], p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]];
const turn = (q, v) => { const u = q.slice(1), t = mul(2, cross(u, v)); return add(add(v, mul(q[0], t)), cross(u, t)); };
const back = (q, v) => turn([q[0], -q[1], -q[2], -q[3]], v);
const record = (s) => [s], append = (path, s) => path.push(s);
)",
                             R"(
const named = ([m, I]) => ({m, I}), moving = ([x, q, v, w]) => ({x, q, v, w});
const body = ${bodies}.map(named);  // mass [kg], moments about the axes of the body [kg m^2]
const start = ${starts}.map((all) => all.map(moving));  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
const gravity = ${gravities};
const dt = ${dt}, steps = ${steps}, count = ${count};
)",
                             R"(
function act(t, s) {
${forces}}
)",
                             R"(
${main}console.log(worst.toPrecision(9), '${unit}');
)",
                             to_javascript};

std::string filled(std::string_view text, const Words& words) {
  std::string out;
  for (std::size_t at = 0; (at = text.find("${")) != std::string_view::npos;) {
    const std::size_t end = text.find('}', at);
    out += text.substr(0, at);
    const auto word = words.find(text.substr(at + 2, end - at - 2));
    out += word == words.end() ? std::string(text.substr(at, end + 1 - at)) : word->second;
    text.remove_prefix(end + 1);
  }
  return out + std::string(text);
}

std::string without_unused(std::string text, std::string_view helpers) {
  // "V add(const V& a, …" or "const add = (a, b) => …": the name, and then a parenthesis.
  const std::regex definition(R"(^(?:const (\w+) = \(|(?:V|double) (\w+)\())");
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = helpers.find('\n')) != std::string_view::npos;
       helpers.remove_prefix(end + 1))
    lines.emplace_back(helpers.substr(0, end + 1));
  std::reverse(lines.begin(), lines.end());  // later ones call earlier ones
  for (const std::string& line : lines) {
    std::smatch m;
    if (!std::regex_search(line, m, definition)) continue;
    const std::size_t at = text.find(line);
    std::string rest = text.substr(0, at) + text.substr(at + line.size());
    const std::regex call(R"(\b)" + m[1].str() + m[2].str() + R"(\()");
    if (!std::regex_search(rest, call)) text = std::move(rest);
  }
  return text;
}

extern const Dialect bullet, bullet_multibody, ode, mujoco, simbody, dart, siconos, jolt, rapier,
    rapier_deterministic, rapier_simd, mujoco3, havok, physx, crashcat, cannon;

std::span<const Dialect* const> dialects() {
  static constexpr std::array all = {
      &bullet, &bullet_multibody,     &ode,         &mujoco,  &simbody, &dart,  &siconos,  &jolt,
      &rapier, &rapier_deterministic, &rapier_simd, &mujoco3, &havok,   &physx, &crashcat, &cannon};
  return all;
}

}  // namespace cylon::hunt::program
