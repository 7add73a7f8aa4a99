// cylon-import-mjcf FILE [KEYFRAME]: lets MuJoCo compile a file (MJCF, or URDF by its own rules) and prints the compiled
// model as JSON: the arrays of mjModel and, of mjData, the poses at the start.  Says nothing of what they mean:
// harness/imports/mjcf does, for every release of MuJoCo alike.
#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace {

using Json = nlohmann::json;

// What no motion follows from, and what is large.
bool is_needed(std::string_view array) {
  for (const std::string_view kind :
       {"body_", "jnt_", "dof_", "geom_", "mesh_", "pair_", "exclude_", "eq_", "site_bodyid", "site_pos",
        "site_quat", "tendon_", "actuator_", "qpos", "key_"})
    if (array.starts_with(kind)) return !array.ends_with("_user") && array != "geom_rgba";
  return false;
}

template <class Number>
Json list(const Number* numbers, std::size_t count) {
  Json json = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (std::is_floating_point_v<Number>)
      json.push_back(numbers[i]);
    else
      json.push_back(static_cast<int>(numbers[i]));
  }
  return json;
}

Json arrays_of(const mjModel* m) {
  Json json = Json::object();
  MJMODEL_POINTERS_PREAMBLE(m)
#define MJ_M(n) n
#define X(type, name, rows, columns) \
  if (is_needed(#name))              \
    json[#name] = list(m->name, static_cast<std::size_t>(m->rows) * static_cast<std::size_t>(columns));
  MJMODEL_POINTERS
#undef X
#undef MJ_M
  return json;
}

Json sizes_of(const mjModel* m) {
  Json json = Json::object();
#define X(name) json[#name] = m->name;
  MJMODEL_INTS
#undef X
  return json;
}

Json names_of(const mjModel* m) {
  Json json = Json::object();
  for (const auto& [kind, type, count] : {std::tuple("body", mjOBJ_BODY, m->nbody),
                                          {"joint", mjOBJ_JOINT, m->njnt},
                                          {"geom", mjOBJ_GEOM, m->ngeom},
                                          {"mesh", mjOBJ_MESH, m->nmesh},
                                          {"pair", mjOBJ_PAIR, m->npair},
                                          {"equality", mjOBJ_EQUALITY, m->neq},
                                          {"tendon", mjOBJ_TENDON, m->ntendon},
                                          {"actuator", mjOBJ_ACTUATOR, m->nu},
                                          {"sensor", mjOBJ_SENSOR, m->nsensor},
                                          {"site", mjOBJ_SITE, m->nsite},
                                          {"camera", mjOBJ_CAMERA, m->ncam},
                                          {"light", mjOBJ_LIGHT, m->nlight},
                                          {"key", mjOBJ_KEY, m->nkey},
                                          {"skin", mjOBJ_SKIN, m->nskin}}) {
    Json& names = json[kind] = Json::array();
    for (int i = 0; i < count; ++i) {
      const char* name = mj_id2name(m, type, i);
      names.push_back(name ? name : "");
    }
  }
  return json;
}

// By their names, since their bits differ between releases.
Json disabled(const mjModel* m) {
  Json json = Json::array();
  for (const auto& [name, bit] : {std::pair("constraint", mjDSBL_CONSTRAINT),
                                  {"equality", mjDSBL_EQUALITY},
                                  {"frictionloss", mjDSBL_FRICTIONLOSS},
                                  {"limit", mjDSBL_LIMIT},
                                  {"contact", mjDSBL_CONTACT},
                                  {"spring", mjDSBL_PASSIVE},
                                  {"damper", mjDSBL_PASSIVE},
                                  {"gravity", mjDSBL_GRAVITY},
                                  {"filterparent", mjDSBL_FILTERPARENT},
                                  {"actuation", mjDSBL_ACTUATION},
                                  {"clampctrl", mjDSBL_CLAMPCTRL}})
    if (m->opt.disableflags & bit) json.push_back(name);
  return json;
}

// Which pairs of geoms touch: those of the masks, <pair>, or both.
const char* collision(const mjModel* m) {
  return m->opt.collision == mjCOL_PAIR      ? "predefined"
         : m->opt.collision == mjCOL_DYNAMIC ? "dynamic"
                                             : "all";
}

// Options of the solver that are not the library's own; the rest is read, or acts on nothing here.
Json solver(const mjOption& own) {
  mjOption usual;
  mj_defaultOption(&usual);
  const std::array<std::string_view, 6> others = {"timestep", "density",   "viscosity",
                                                  "o_margin", "collision", "apirate"};
  const int read_of_disabled = mjDSBL_CONSTRAINT | mjDSBL_EQUALITY | mjDSBL_FRICTIONLOSS | mjDSBL_LIMIT |
                               mjDSBL_CONTACT | mjDSBL_PASSIVE | mjDSBL_GRAVITY | mjDSBL_FILTERPARENT |
                               mjDSBL_ACTUATION | mjDSBL_CLAMPCTRL | mjDSBL_SENSOR;
  const int read_of_enabled = mjENBL_OVERRIDE | mjENBL_ENERGY | mjENBL_FWDINV | mjENBL_SENSORNOISE;
  mjOption kept = own;
  kept.disableflags &= ~read_of_disabled, kept.enableflags &= ~read_of_enabled;
  Json json = Json::array();
#define X(type, name) \
  if (kept.name != usual.name && std::ranges::find(others, #name) == others.end()) json.push_back(#name);
  MJOPTION_SCALARS
#undef X
  return json;
}

// What MuJoCo warns of, for which it has a function without an argument of ours.
Json& warnings() {
  static Json all = Json::array();
  return all;
}

int fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return fail("usage: cylon-import-mjcf FILE [KEYFRAME]");
  mju_user_error = [](const char* text) { std::exit(fail(text)); };
  mju_user_warning = [](const char* text) {
    std::fprintf(stderr, "MuJoCo: %s\n", text);
    warnings().push_back(text);
  };
  std::array<char, 1000> error{};
  mjModel* m = mj_loadXML(argv[1], nullptr, error.data(), static_cast<int>(error.size()));
  if (!m) return fail(error.data());
  if (error[0] != '\0') warnings().push_back(error.data());
  mjData* d = mj_makeData(m);
  const int key = argc > 2 ? mj_name2id(m, mjOBJ_KEY, argv[2]) : -1;
  if (argc > 2 && key < 0) return fail("no keyframe is called '" + std::string(argv[2]) + "'");
  if (key >= 0) mj_resetDataKeyframe(m, d, key);
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_comVel(m, d);
  mj_tendon(m, d);
  Json velocities = Json::array();  // angular, then of the centre of mass; world axes
  for (int i = 0; i < m->nbody; ++i) {
    std::array<mjtNum, 6> v{};
    mj_objectVelocity(m, d, mjOBJ_BODY, i, v.data(), 0);
    for (const mjtNum x : v) velocities.push_back(x);
  }
  const auto count = [](int n, std::size_t columns) { return static_cast<std::size_t>(n) * columns; };
  Json json = {
      {"library", "MuJoCo " + std::string(mj_versionString())},
      {"version", mj_version()},
      {"sizes", sizes_of(m)},
      {"names", names_of(m)},
      {"arrays", arrays_of(m)},
      {"option",
       {{"timestep", m->opt.timestep},
        {"gravity", list(m->opt.gravity, 3)},
        {"density", m->opt.density},
        {"viscosity", m->opt.viscosity},
        {"collision", collision(m)},
        {"solver", solver(m->opt)},
        {"disabled", disabled(m)}}},
      {"start",
       {{"qpos", list(d->qpos, count(m->nq, 1))},
        {"ctrl", list(d->ctrl, count(m->nu, 1))},
        {"act", list(d->act, count(m->na, 1))},
        {"xpos", list(d->xpos, count(m->nbody, 3))},
        {"xquat", list(d->xquat, count(m->nbody, 4))},
        {"xipos", list(d->xipos, count(m->nbody, 3))},
        {"xanchor", list(d->xanchor, count(m->njnt, 3))},
        {"xaxis", list(d->xaxis, count(m->njnt, 3))},
        {"ten_length", list(d->ten_length, count(m->ntendon, 1))},
        {"velocities", velocities}}},
  };
  json["warnings"] = warnings();
  if (m->opt.enableflags & mjENBL_OVERRIDE)  // of friction this release overrides none
    json["option"]["contact_override"] = {{"margin", m->opt.o_margin}};
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return std::fflush(stdout) == 0 ? 0 : fail("stdout cannot be written");
}
