// MuJoCo's API in Node, version 3.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using Where = SettingRow::Where;

// Free bodies in the order of the scene: the i-th has seven coordinates from 7 i and six speeds from 6 i on.
constexpr std::string_view functions = R"(
const M = await load(), text = (v) => v.join(' ');
let model, data, geom;

function build(take) {
  let option = '', flag = '', solref = [0.02, 1], solimp = [0.9, 0.95, 0.001];
${world_settings}  geom = [];
${shapes}  let xml = '<mujoco><compiler angle="radian" inertiafromgeom="false"/>' +
    '<option timestep="' + dt + '" gravity="' + text(gravity[take]) + '"' + option + '>' +
    '<flag filterparent="disable" autoreset="disable"' + flag + '/></option>' +
    '<default><geom condim="' + (${friction} > 0 ? 3 : 1) + '" friction="' + ${friction} + ' 0 0" solref="' + text(solref) +
    '" solimp="' + text(solimp) + '"/></default><worldbody>';
  const plane = (foot, turned) => { xml += '<geom type="plane" size="0 0 1" pos="' + text(foot) + '" quat="' + text(turned) + '"/>'; };
${planes}  start[take].forEach(({x, q}, i) => {
    xml += '<body pos="' + text(x) + '" quat="' + text(q) + '"><inertial pos="0 0 0" mass="' + body[i].m + '" diaginertia="' +
      text(body[i].I) + '"/><freejoint/>' + (geom[i] ? '<geom ' + geom[i] + '/>' : '') + '</body>';
  });
  model = M.MjModel.from_xml_string(xml + '</worldbody></mujoco>'), data = new M.MjData(model);
  start[take].forEach(({q, v, w}, i) => data.qvel.set([...v, ...back(q, w)], 6 * i));  // spins in the axes of the body
}

function push(i, F, T) {
  const now = [...F, ...back(states()[i].q, T)];
  data.qfrc_applied.set(now.map((f, k) => f + data.qfrc_applied[6 * i + k]), 6 * i);
}
function step() { M.mj_step(model, data), data.qfrc_applied.fill(0); }

function states() {
  return body.map((_, i) => {
    const part = (array, at, n) => Array.from(array.subarray(at, at + n)), turned = part(data.qpos, 7 * i + 3, 4);
    const q = mul(1 / Math.hypot(...turned), turned);
    return {x: part(data.qpos, 7 * i, 3), q, v: part(data.qvel, 6 * i, 3), w: turn(q, part(data.qvel, 6 * i + 3, 3))};
  });
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "'type=\"sphere\" size=\"${radius}\"'"},
    {"box", "'type=\"box\" size=\"${x} ${y} ${z}\"'"},
    {"capsule", "'type=\"capsule\" size=\"${radius} ' + ${length} / 2 + '\" zaxis=\"0 1 0\"'"},
    {"cylinder", "'type=\"cylinder\" size=\"${radius} ' + ${length} / 2 + '\" zaxis=\"0 1 0\"'"},
};

constexpr std::string_view as_option = "  option += ' ${name}=\"${value}\"';\n";
constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"inertial", "", Where::program, ""},
    {"friction, condim", "", Where::program, ""},
    {"filterparent", "", Where::program, ""},
    {"autoreset", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"integrator", "implicit", Where::world, "  option += ' integrator=\"implicit\"';\n"},
    {"integrator", "implicitfast", Where::world, "  option += ' integrator=\"implicitfast\"';\n"},
    {"integrator", "rk4", Where::world, "  option += ' integrator=\"RK4\"';\n"},
    {"cone", "", Where::world, as_option},
    {"impratio", "", Where::world, as_option},
    {"noslip_iterations", "", Where::world, as_option},
    {"solver", "", Where::world, as_option},
    {"iterations", "", Where::world, as_option},
    {"tolerance", "", Where::world, as_option},
    {"jacobian", "", Where::world, as_option},
    {"warmstart", "", Where::world, "  flag += ' warmstart=\"${value}\"';\n"},
    {"solref timeconst", "", Where::world, "  solref[0] = ${value};\n"},
    {"solref dampratio", "", Where::world, "  solref[1] = ${value};\n"},
    {"solimp dmin", "", Where::world, "  solimp[0] = ${value};\n"},
    {"solimp dmax", "", Where::world, "  solimp[1] = ${value};\n"},
    {"solimp width", "", Where::world, "  solimp[2] = ${value};\n"},
};

}  // namespace

extern const Dialect mujoco3;
const Dialect mujoco3 = {"mujoco3",
                         "MuJoCo",
                         &javascript,
                         "npm install @mujoco/mujoco",
                         "node ${file}",
                         "import load from '@mujoco/mujoco';\n",
                         functions,
                         "  geom[${i}] = ${shape};\n",
                         "",
                         "  plane(${foot}, ${turn_of_z});\n",
                         shapes,
                         {},
                         settings};

}  // namespace cylon::hunt::program
