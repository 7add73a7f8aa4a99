// ODE's API, double precision.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
dWorldID world;
dSpaceID space;
dJointGroupID contacts;
std::vector<dBodyID> id;

void touch(void*, dGeomID a, dGeomID b) {
  dContact contact[8] = {};
  const int n = dCollide(a, b, ${contacts}, &contact[0].geom, sizeof(dContact));
  if (dGeomGetBody(a) && dGeomGetBody(b) && dAreConnected(dGeomGetBody(a), dGeomGetBody(b))) return;
  for (int i = 0; i < n; ++i) {
    contact[i].surface.mode = ${contact_mode};
    contact[i].surface.mu = ${friction};
    contact[i].surface.bounce = ${restitution};
    dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
  }
}

void build(int take) {
  dInitODE2(0);
  world = dWorldCreate(), space = dHashSpaceCreate(nullptr), contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, gravity[take][0], gravity[take][1], gravity[take][2]);
${world_settings}  id.clear();
  for (int i = 0; i < count; ++i) {
    const State& s = start[take][i];
    const V& I = body[i].I;
    dMass mass;
    dMassSetParameters(&mass, body[i].m, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
    id.push_back(dBodyCreate(world));
    dBodySetMass(id[i], &mass);
    dBodySetPosition(id[i], s.x[0], s.x[1], s.x[2]);
    dBodySetQuaternion(id[i], &s.q[0]);
    dBodySetLinearVel(id[i], s.v[0], s.v[1], s.v[2]);
    dBodySetAngularVel(id[i], s.w[0], s.w[1], s.w[2]);
${body_settings}  }
${shapes}${planes}${joints}}

void push(int i, const V& F, const V& T) {
  dBodyAddForce(id[i], F[0], F[1], F[2]);
  dBodyAddTorque(id[i], T[0], T[1], T[2]);
}

void step() {
  dSpaceCollide(space, nullptr, touch);
  ${solver}(world, dt);
  dJointGroupEmpty(contacts);
}

std::vector<State> states() {
  std::vector<State> all;
  for (dBodyID b : id)
    all.push_back({V(dBodyGetPosition(b), 3), V(dBodyGetQuaternion(b), 4), V(dBodyGetLinearVel(b), 3), V(dBodyGetAngularVel(b), 3)});
  return all;
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "dCreateSphere(space, ${radius})"},
    {"box", "dCreateBox(space, 2 * ${x}, 2 * ${y}, 2 * ${z})"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  dJointID ${joint} = dJointCreateBall(world, nullptr);\n  dJointAttach(${joint}, id[${a}], nullptr);\n"
     "  dJointSetBallAnchor(${joint}, ${point});\n",
     "  dJointID ${joint} = dJointCreateBall(world, nullptr);\n  dJointAttach(${joint}, id[${a}], "
     "id[${b}]);\n"
     "  dJointSetBallAnchor(${joint}, ${point});\n"},
    {JointType::hinge,
     "  dJointID ${joint} = dJointCreateHinge(world, nullptr);\n  dJointAttach(${joint}, id[${a}], "
     "nullptr);\n"
     "  dJointSetHingeAnchor(${joint}, ${point});\n  dJointSetHingeAxis(${joint}, ${axis});\n",
     "  dJointID ${joint} = dJointCreateHinge(world, nullptr);\n  dJointAttach(${joint}, id[${a}], "
     "id[${b}]);\n"
     "  dJointSetHingeAnchor(${joint}, ${point});\n  dJointSetHingeAxis(${joint}, ${axis});\n"},
    {JointType::fixed,
     "  dJointID ${joint} = dJointCreateFixed(world, nullptr);\n  dJointAttach(${joint}, id[${a}], "
     "nullptr);\n"
     "  dJointSetFixed(${joint});\n",
     "  dJointID ${joint} = dJointCreateFixed(world, nullptr);\n  dJointAttach(${joint}, id[${a}], "
     "id[${b}]);\n"
     "  dJointSetFixed(${joint});\n"},
};

constexpr SettingRow settings[] = {
    {"solver", "dWorldStep", Where::program, ""},
    {"solver", "dWorldQuickStep", Where::world, "  dRandSetSeed(0);\n"},
    {"random_seed", "", Where::program, ""},
    {"iterations", "", Where::world, "  dWorldSetQuickStepNumIterations(world, ${value});\n"},
    {"over_relaxation", "", Where::world, "  dWorldSetQuickStepW(world, ${value});\n"},
    {"rotation", "finite", Where::body, "    dBodySetFiniteRotationMode(id[i], 1);\n"},
    {"gyro", "off", Where::body, "    dBodySetGyroscopicMode(id[i], 0);\n"},
    {"erp", "", Where::world, "  dWorldSetERP(world, ${value});\n"},
    {"cfm", "", Where::world, "  dWorldSetCFM(world, ${value});\n"},
    {"contact_mode", "dContactBounce", Where::program, ""},
    {"contact_mode", "dContactApprox1 | dContactBounce", Where::program, ""},
    {"mu, bounce", "", Where::program, ""},
    {"bounce_vel", "0", Where::program, ""},
    {"contacts", "", Where::program, ""},
    {"contact_surface_layer", "", Where::world, "  dWorldSetContactSurfaceLayer(world, ${value});\n"},
    {"springs, drag*", "", Where::program, ""},
    {"stop_erp", "", Where::program, ""},  // a card with stops has no program
    {"broad_phase", "", Where::program, ""},
    {"threading", "", Where::program, ""},
};

}  // namespace

extern const Dialect ode;
const Dialect ode = {"ode",
                     "ODE",
                     &cpp,
                     "apt-get install g++ pkg-config libode-dev",
                     "c++ -std=c++20 ${file} -o fault $(pkg-config --cflags --libs ode) && ./fault",
                     "#include <ode/ode.h>\n",
                     functions,
                     "  dGeomSetBody(${shape}, id[${i}]);\n",
                     "",
                     "  dCreatePlane(space, ${normal}, ${offset});\n",
                     shapes,
                     joints,
                     settings};

}  // namespace cylon::hunt::program
