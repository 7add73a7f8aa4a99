// MuJoCo's API of 2.2, its model as MJCF.  Joints are those of its tree.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
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
  const double mu = ${friction};
  const int room = 100 + 20 * count;  // for contacts
  std::string excluded;
  mjcf = "<mujoco><compiler angle='radian' inertiafromgeom='false'/><size njmax='" + std::to_string(4 * room) + "' nconmax='" + std::to_string(room) + "'/>"
         "<option timestep='" + text({dt}) + "' gravity='" + text(gravity[take]) + "'><flag filterparent='disable'/></option>"
         "<default><geom condim='" + (mu > 0 ? "3" : "1") + "' friction='" + text({mu, 0, 0}) + "'/></default><worldbody><!--0--></worldbody>";
  speeds.assign(count, {});
${joints}${shapes}${planes}  mjcf += "<contact>" + excluded + "</contact></mujoco>";
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "scene.xml", mjcf.size());
  std::memcpy(files.filedata[0], mjcf.data(), mjcf.size());
  char error[1000];
  m = mj_loadXML("scene.xml", &files, error, sizeof error);
  if (!m) std::puts(error), std::exit(1);
${world_settings}  d = mj_makeData(m);
  id.clear();
  for (int i = 0; i < count; ++i) {
    id.push_back(mj_name2id(m, mjOBJ_BODY, ("b" + std::to_string(i)).c_str()));
    std::copy(speeds[i].begin(), speeds[i].end(), d->qvel + m->body_dofadr[id[i]]);
  }
  mjcb_passive = [](const mjModel*, mjData* d) { act(d->time, states()); };
}

void push(int i, const V& F, const V& T) { mj_applyFT(m, d, &F[0], &T[0], d->xipos + 3 * id[i], id[i], d->qfrc_passive); }
void step() { mj_step(m, d); }
)";

// An axis of revolution is z in MuJoCo.
constexpr ShapeRow shapes[] = {
    {"sphere", "type='sphere' size='${radius}'"},
    {"box", "type='box' size='${x} ${y} ${z}'"},
    {"capsule",
     "type='capsule' quat='0.7071067811865476 -0.7071067811865476 0 0' size='\" + text({${radius}, ${length} "
     "/ 2}) + \"'"},
    {"cylinder",
     "type='cylinder' quat='0.7071067811865476 -0.7071067811865476 0 0' size='\" + text({${radius}, "
     "${length} / 2}) + \"'"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  add(${a}, -1, start[take][${a}].x, start[take][${a}].q, \"<joint type='ball' pos='\" + "
     "text(${local_a}) + \"'/>\",\n      {back(start[take][${a}].q, start[take][${a}].w)});\n",
     "  add(${a}, ${b}, ${place}, ${turn}, \"<joint type='ball' pos='\" + text(${local_a}) + \"'/>\",\n"
     "      {back(start[take][${a}].q, sub(start[take][${a}].w, start[take][${b}].w))});\n"
     "  excluded += \"<exclude body1='b${a}' body2='b${b}'/>\";\n"},
    {JointType::hinge,
     "  add(${a}, -1, start[take][${a}].x, start[take][${a}].q, \"<joint type='hinge' pos='\" + "
     "text(${local_a}) + \"' axis='\" + text(${axis_a}) + \"'/>\",\n"
     "      {V{dot(${axis_vector}, start[take][${a}].w)}});\n",
     "  add(${a}, ${b}, ${place}, ${turn}, \"<joint type='hinge' pos='\" + text(${local_a}) + \"' axis='\" + "
     "text(${axis_a}) + \"'/>\",\n"
     "      {V{dot(${axis_vector}, sub(start[take][${a}].w, start[take][${b}].w))}});\n"
     "  excluded += \"<exclude body1='b${a}' body2='b${b}'/>\";\n"},
    {JointType::fixed, "  add(${a}, -1, start[take][${a}].x, start[take][${a}].q, \"\", {});\n",
     "  add(${a}, ${b}, ${place}, ${turn}, \"\", {});\n"
     "  excluded += \"<exclude body1='b${a}' body2='b${b}'/>\";\n"},
};

constexpr SettingRow settings[] = {
    {"timestep", "dt", Where::program, ""},
    {"inertial", "", Where::program, ""},
    {"friction, condim", "", Where::program, ""},
    {"filterparent", "disable", Where::program, ""},
    {"njmax, nconmax, nstack", "", Where::program, ""},
    {"after a bad state", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"integrator", "implicit", Where::world, "  m->opt.integrator = mjINT_IMPLICIT;\n"},
    {"integrator", "rk4", Where::world, "  m->opt.integrator = mjINT_RK4;\n"},
    {"cone", "elliptic", Where::world, "  m->opt.cone = mjCONE_ELLIPTIC;\n"},
    {"solver", "PGS", Where::world, "  m->opt.solver = mjSOL_PGS;\n"},
    {"solver", "CG", Where::world, "  m->opt.solver = mjSOL_CG;\n"},
    {"jacobian", "dense", Where::world, "  m->opt.jacobian = mjJAC_DENSE;\n"},
    {"jacobian", "sparse", Where::world, "  m->opt.jacobian = mjJAC_SPARSE;\n"},
    {"impratio", "", Where::world, "  m->opt.${name} = ${value};\n"},
    {"noslip_*", "", Where::world, "  m->opt.${name} = ${value};\n"},
    {"iterations", "", Where::world, "  m->opt.${name} = ${value};\n"},
    {"tolerance", "", Where::world, "  m->opt.${name} = ${value};\n"},
    {"mpr_*", "", Where::world, "  m->opt.${name} = ${value};\n"},
    {"warmstart", "disable", Where::world, "  m->opt.disableflags |= mjDSBL_WARMSTART;\n"},
    {"refsafe", "disable", Where::world, "  m->opt.disableflags |= mjDSBL_REFSAFE;\n"},
    {"multiccd", "enable", Where::world, "  m->opt.enableflags |= mjENBL_MULTICCD;\n"},
    {"solref timeconst", "", Where::world,
     "  for (int g = 0; g < m->ngeom; ++g) m->geom_solref[mjNREF * g] = ${value};\n"},
    {"solref dampratio", "", Where::world,
     "  for (int g = 0; g < m->ngeom; ++g) m->geom_solref[mjNREF * g + 1] = ${value};\n"},
    {"solimp dmin", "", Where::world,
     "  for (int g = 0; g < m->ngeom; ++g) m->geom_solimp[mjNIMP * g] = ${value};\n"},
    {"solimp dmax", "", Where::world,
     "  for (int g = 0; g < m->ngeom; ++g) m->geom_solimp[mjNIMP * g + 1] = ${value};\n"},
    {"solimp width", "", Where::world,
     "  for (int g = 0; g < m->ngeom; ++g) m->geom_solimp[mjNIMP * g + 2] = ${value};\n"},
};

}  // namespace

extern const Dialect mujoco;
const Dialect mujoco = {
    "mujoco",
    "MuJoCo",
    &cpp,
    "apt-get install g++ libmujoco-dev",
    "c++ -std=c++20 ${file} -o fault -lmujoco && ./fault",
    "#include <mujoco/mujoco.h>\n#include <cstdlib>\n#include <cstring>\n#include <string>\n",
    functions,
    "  put(${i}, \"<geom ${shape}/>\");\n",
    "",
    "  put(-1, \"<geom type='plane' size='0 0 1' pos='\" + text(${foot}) + \"' quat='\" + "
    "text(${long_turn_of_z}) + \"'/>\");\n",
    shapes,
    joints,
    settings,
    "  add(${a}, -1, start[take][${a}].x, start[take][${a}].q, \"<freejoint/>\", {start[take][${a}].v, "
    "back(start[take][${a}].q, start[take][${a}].w)});\n",
    true};

}  // namespace cylon::hunt::program
