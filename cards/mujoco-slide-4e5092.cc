// MuJoCo 2.2.2, slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.0404 m.
// apt-get install g++ libmujoco-dev && c++ -std=c++20 mujoco-slide-4e5092.cc -o fault -lmujoco && ./fault
#include <mujoco/mujoco.h>
#include <cstdlib>
#include <cstring>
#include <string>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <valarray>
#include <vector>

using std::abs, std::asin, std::ceil, std::cos, std::max, std::min, std::sin, std::sqrt;
using V = std::valarray<double>;  // vectors (x, y, z) in world axes, quaternions (w, x, y, z) from body to world axes
V add(const V& a, const V& b) { return a + b; }
V sub(const V& a, const V& b) { return a - b; }
V mul(double s, const V& a) { return s * a; }
V cross(const V& a, const V& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
double dot(const V& a, const V& b) { return (a * b).sum(); }
double norm(const V& a) { return sqrt(dot(a, a)); }
V turn(const V& q, const V& v) { V u = {q[1], q[2], q[3]}, t = mul(2, cross(u, v)); return v + q[0] * t + cross(u, t); }
V back(const V& q, const V& v) { return turn({q[0], -q[1], -q[2], -q[3]}, v); }

struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = {{1.0, V{0.0028080066666666664, 0.0028080066666666664, 0.0028080066666666664}}};
const Path start = {{{V{0.0, 0.0649, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{1.0, 0.0, 1.0}, V{0.0, 0.0, 0.0}}}};
const std::vector<V> gravity = {V{0.0, -10.0, 0.0}};
const double dt = 0.01;
const int steps = 25, count = 1;

mjModel* m;
mjData* d;
std::string mjcf;
std::vector<int> id;
std::vector<std::vector<double>> speeds;  // in MuJoCo's coordinates

std::string text(const V& numbers) {
  std::string all;
  char one[32];
  for (double x : numbers) all.append(one, std::snprintf(one, sizeof one, "%.17g ", x));
  return all;
}

// At the end of a body, whose mark is its number in MuJoCo.
void put(int i, const std::string& element) { mjcf.insert(mjcf.find("<!--" + std::to_string(i + 1) + "-->"), element); }

void add(int i, int to, const V& x, const V& q, const std::string& joint, const std::vector<V>& parts) {
  put(to, "<body name='b" + std::to_string(i) + "' pos='" + text(x) + "' quat='" + text(q) + "'><inertial pos='0 0 0' mass='" +
              text({body[i].m}) + "' diaginertia='" + text(body[i].I) + "'/>" + joint + "<!--" + std::to_string(i + 1) + "--></body>");
  for (const V& part : parts) speeds[i].insert(speeds[i].end(), begin(part), end(part));
}

void act(double t, const std::vector<State>& s);
std::vector<State> states() {
  const V kept(d->qpos, m->nq);
  mj_kinematics(m, d), mj_comPos(m, d), mj_comVel(m, d);  // the first normalises turns
  std::copy(begin(kept), end(kept), d->qpos);
  std::vector<State> all;
  for (int b : id) {
    mjtNum speed[6];  // spin first
    mj_objectVelocity(m, d, mjOBJ_BODY, b, speed, 0);
    all.push_back({V(d->xipos + 3 * b, 3), V(d->xquat + 4 * b, 4), V(speed + 3, 3), V(speed, 3)});
  }
  return all;
}

void build(int take) {
  const double mu = 0.5;
  const int room = 100 + 20 * count;  // for contacts
  std::string excluded;
  mjcf = "<mujoco><compiler angle='radian' inertiafromgeom='false'/><size njmax='" + std::to_string(4 * room) + "' nconmax='" + std::to_string(room) + "'/>"
         "<option timestep='" + text({dt}) + "' gravity='" + text(gravity[take]) + "'><flag filterparent='disable'/></option>"
         "<default><geom condim='" + (mu > 0 ? "3" : "1") + "' friction='" + text({mu, 0, 0}) + "'/></default><worldbody><!--0--></worldbody>";
  speeds.assign(count, {});
  add(0, -1, start[take][0].x, start[take][0].q, "<freejoint/>", {start[take][0].v, back(start[take][0].q, start[take][0].w)});
  put(0, "<geom type='box' size='0.0649 0.0649 0.0649'/>");
  put(-1, "<geom type='plane' size='0 0 1' pos='" + text(V{0.0, 0.0, 0.0}) + "' quat='" + text(V{1.0, -1.0, 0.0, 0.0}) + "'/>");
  mjcf += "<contact>" + excluded + "</contact></mujoco>";
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "scene.xml", mjcf.size());
  std::memcpy(files.filedata[0], mjcf.data(), mjcf.size());
  char error[1000];
  m = mj_loadXML("scene.xml", &files, error, sizeof error);
  if (!m) std::puts(error), std::exit(1);
  d = mj_makeData(m);
  id.clear();
  for (int i = 0; i < count; ++i) {
    id.push_back(mj_name2id(m, mjOBJ_BODY, ("b" + std::to_string(i)).c_str()));
    std::copy(speeds[i].begin(), speeds[i].end(), d->qvel + m->body_dofadr[id[i]]);
  }
  mjcb_passive = [](const mjModel*, mjData* d) { act(d->time, states()); };
}

void push(int i, const V& F, const V& T) { mj_applyFT(m, d, &F[0], &T[0], d->xipos + 3 * id[i], id[i], d->qfrc_passive); }
void step() { mj_step(m, d); }

void act(double t, const std::vector<State>& s) {
}

auto run(const auto& take) {
  build(take);
  auto path = record(states());
  for (auto k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

auto worst_of(const auto& path) {
  auto v = start[0][0].v;
  auto slowed = 0.5 * norm(gravity[0]) / norm(v);
  auto worst = 0.0;
  for (auto k = 0; k <= steps; ++k) {
    auto t = min(k * dt, 1 / slowed);
    auto must = add(start[0][0].x, mul(t - 0.5 * slowed * t * t, v));
    worst = max(worst, norm(sub(path[k][0].x, must)));
  }
  return worst;
}

int main() {
  auto path = run(0);
  auto worst = worst_of(path);
  std::printf("%.9g m\n", worst);
}
