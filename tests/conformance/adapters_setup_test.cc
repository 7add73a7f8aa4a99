// An invalid setup is an input error whose message names the mistake and the nearest valid value.
#include "harness/core/input_error.h"
#include "tests/conformance/adapters_fixture.h"
#include "tests/paths.h"

#include <cmath>

namespace cylon::conformance {
namespace {

struct Mistake {
  const char* engine;
  std::vector<const char*> says;  // fragments of the message
};

const Mistake mistakes[] = {
    {"in-house/path=event", {"path 'event'", "did you mean 'events'?"}},
    {"in-house/integrator=rk5", {"integrator 'rk5'", "did you mean 'rk4'?", "lie-trotter"}},
    {"in-house/integrator=velocity-verlt", {"did you mean 'velocity-verlet'?"}},
    {"in-house/erp=0", {"option 'erp'", "valid: model"}},
    {"in-house/threads=0", {"threads = '0' is not a whole number in [1, 64]"}},
    {"in-house/threads=65", {"threads = '65' is not a whole number in [1, 64]"}},
    {"in-house/threads=2.5", {"threads = '2.5' is not a whole number"}},
    {"in-house-float/threads=all", {"threads = 'all' is not a whole number"}},
    {"in-house/thread=4", {"option 'thread'", "did you mean 'threads'?"}},
    {"in-house/sweeps=0", {"sweeps = '0' is not a whole number in [1, 1000]"}},
    {"in-house/sleeping=yes", {"sleeping 'yes'", "valid: on, off"}},
    {"in-house-float/model=ful", {"model 'ful'", "did you mean 'full'?"}},
    {"bullet/path=multi-body", {"path 'multi-body'", "did you mean 'multibody'?"}},
    {"bullet/integrator=semi-implicit-eular", {"integrator", "did you mean 'semi-implicit-euler'?"}},
    {"bullet/gyroo=none", {"option 'gyroo'", "did you mean 'gyro'?"}},
    {"bullet/gyro=non", {"'non'", "did you mean 'none'?"}},
    {"bullet/solver=dantsig", {"'dantsig'", "did you mean 'dantzig'?"}},
    {"bullet/erp=two", {"erp = 'two'", "[0, 1]"}},
    {"bullet/erp=1.5", {"erp = '1.5'", "[0, 1]"}},
    {"bullet/erp=nan", {"erp = 'nan'", "[0, 1]"}},
    {"bullet/iterations=2.5", {"iterations = '2.5'", "whole"}},
    {"bullet-float/gyro=expliict", {"did you mean 'explicit'?"}},
    {"bullet-multibody/gyro=implicit-body", {"on path multibody", "explicit, none"}},
    {"bullet-multibody/solver=nncg", {"on path multibody", "sequential-impulse, dantzig"}},
    {"bullet/damping=0.1", {"option damping belongs to btMultiBody"}},
    {"bullet/cfm=inf", {"cfm = 'inf'", "finite"}},
    {"bullet/cfm=1e39", {"cfm = '1e39'", "finite"}},
    {"bullet/slop=-inf", {"slop = '-inf'", "finite"}},
    {"bullet/relaxation=0", {"relaxation = '0'", "(0, 2)"}},
    {"bullet/relaxation=2", {"relaxation = '2'", "(0, 2)"}},
    {"bullet-multibody/max-coordinate-velocity=0", {"max-coordinate-velocity = '0'", "above 0"}},
    // What would do nothing is refused.
    {"bullet/speculative-restitution=on", {"speculative-restitution does nothing without ccd"}},
    {"bullet/max-gyroscopic-force=9", {"max-gyroscopic-force does nothing without gyro=explicit"}},
    {"bullet/split-impulse=off,split-threshold=0", {"does nothing without split-impulse=on"}},
    {"bullet-multibody/stop-erp=0", {"option stop-erp belongs to btRigidBody"}},
    {"bullet-multibody/stops-ahead=on", {"option stops-ahead belongs to btRigidBody"}},
    {"bullet/stop-erp=2", {"stop-erp = '2' is not a number in [0, 1]"}},
    {"bullet-multibody/max-gyroscopic-force=9", {"max-gyroscopic-force belongs to btRigidBody"}},
    {"bullet-multibody/warm-starting=0", {"option warm-starting belongs to btRigidBody"}},
    {"bullet-multibody/random-order=on", {"option random-order belongs to btRigidBody"}},
    {"bullet-multibody/ccd=0.9", {"option ccd belongs to btRigidBody"}},
    {"bullet/sleeping=yes", {"value of option sleeping 'yes'", "off, on"}},
    {"bullet/plane-queries=1.5", {"plane-queries = '1.5'", "whole"}},
    {"bullet-multibody-float/erpp2=0", {"option 'erpp2'", "did you mean 'erp2'?"}},
    {"ode/path=stepp", {"path 'stepp'", "did you mean 'step'?"}},
    {"ode/integrator=semi-implicit-euller", {"did you mean 'semi-implicit-euler'?"}},
    {"ode/gyro=offf", {"'offf'", "did you mean 'off'?"}},
    {"ode/rotation=infinite", {"'infinite'", "did you mean 'finite'?"}},
    {"ode/efp=0", {"option 'efp'", "did you mean 'erp'?"}},
    {"ode/erp=-0.1", {"erp = '-0.1'", "[0, 1]"}},
    {"ode/cfm=1e-3x", {"cfm = '1e-3x'"}},
    {"ode/contacts=9", {"contacts = '9'", "[1, 8]"}},
    {"ode/iterations=30", {"option iterations belongs to dWorldQuickStep"}},
    {"ode/cfm=inf", {"cfm = 'inf'"}},
    {"ode-quick/over-relaxation=0", {"over-relaxation = '0'", "(0, 2)"}},
    {"ode-quick/over-relaxation=2", {"over-relaxation = '2'", "(0, 2)"}},
    {"ode-quick/iterations=2.5", {"iterations = '2.5'", "whole"}},
    {"ode/springs=stif", {"'stif'", "did you mean 'stiff'?"}},
    {"ode/contact-erp=2", {"contact-erp = '2'", "[0, 1]"}},
    {"ode-quick/iterations=0", {"iterations = '0'"}},
    {"simbody/integrator=runge-kutta-fehlberg", {"did you mean 'runge-kutta-feldberg'?"}},
    {"simbody/path=as-shiped", {"path 'as-shiped'", "did you mean 'as-shipped'?"}},
    {"simbody/acuracy=1", {"option 'acuracy'", "did you mean 'accuracy'?"}},
    {"simbody/accuracy=0", {"accuracy = '0'", "(0, 1]"}},
    {"simbody/constraint-tolerance=nan", {"constraint-tolerance = 'nan'", "finite number"}},
    {"simbody/project=always", {"'always'", "where-needed, every-step"}},
    {"simbody/interpolation=disable", {"option interpolation does nothing with runge-kutta-merson"}},
    {"dart/path=as-shiped", {"path 'as-shiped'", "did you mean 'as-shipped'?"}},
    {"dart/solver=danzig", {"'danzig'", "did you mean 'dantzig'?"}},
    {"dart/contact-cfm=1e-10", {"contact-cfm = '1e-10'", "[1e-09, 1]"}},
    {"dart/sweeps=2.5", {"sweeps = '2.5'", "whole"}},
    {"dart/solver=dantzig-alone,sweeps=5", {"option sweeps does nothing with solver=dantzig-alone"}},
    {"siconos/integrator=moreau-jan", {"integrator 'moreau-jan'", "did you mean 'moreau-jean'?"}},
    {"siconos/newton-tolerance=0", {"newton-tolerance = '0'", "(0, 1]"}},
    {"siconos/solver-iterations=0", {"solver-iterations = '0'", "whole"}},
    {"siconos/solver=admn", {"value of option solver 'admn'", "did you mean 'admm'?"}},
    {"siconos/solver=soclcp", {"value of option solver 'soclcp'", "valid: nsgs, "}},
    {"cannon-es/path=stand_in", {"path 'stand_in'", "did you mean 'stand-in'?"}},
    {"cannon-es/friction=times_dt", {"value of option friction 'times_dt'", "did you mean 'times-dt'?"}},
    {"cannon-es/angular-damping=2", {"angular-damping = '2'", "[0, 1]"}},
    {"jolt/path=as-shiped", {"path 'as-shiped'", "did you mean 'as-shipped'?"}},
    {"jolt/integrator=rk4", {"integrator 'rk4'", "valid: semi-implicit-euler"}},
    {"jolt/gyroo=off", {"option 'gyroo'", "did you mean 'gyro'?"}},
    {"jolt/inertia=principle", {"value of option inertia 'principle'", "did you mean 'principal'?"}},
    {"jolt/velocity-steps=1", {"velocity-steps = '1'", "whole number in [2, 255]"}},
    {"jolt/velocity-steps=2.5", {"velocity-steps = '2.5'", "whole"}},
    {"jolt/max-spin=0", {"max-spin = '0'", "(0, 1000000000000000000]"}},
    {"jolt/slop=nan", {"slop = 'nan'", "finite number from 0"}},
    {"jolt/baumgarte=1.5", {"baumgarte = '1.5'", "[0, 1]"}},
    {"rapier/gyro=off", {"option 'gyro'"}},
    {"rapier/solver-iterations=0", {"solver-iterations = '0'", "whole number in [1, 1000]"}},
    {"rapier/contact-frequency=0", {"contact-frequency = '0'", "(0, 1000000000]"}},
    {"rapier/sleeping=yes", {"value of option sleeping 'yes'", "off, on"}},
    {"rapier-deterministic/gyro=off", {"rapier-deterministic: no option 'gyro'"}},
    {"rapier-deterministic/solver-iterations=0", {"rapier-deterministic: option solver-iterations = '0'"}},
    {"rapier-simd/gyro=off", {"rapier-simd: no option 'gyro'"}},
    {"havok/path=standin", {"path 'standin'", "did you mean 'stand-in'?"}},
    {"havok/forces=impulse", {"value of option forces 'impulse'", "did you mean 'impulses'?"}},
    {"havok/gyroscopic-torque=on", {"value of option gyroscopic-torque 'on'", "refused, left-out"}},
    {"havok/max-spin=0", {"max-spin = '0'", "(0, 1000000000000000000]"}},
    {"crashcat/gyroo=off", {"option 'gyroo'", "did you mean 'gyro'?"}},
    {"crashcat/baumgarte=1.5", {"baumgarte = '1.5'", "[0, 1]"}},
    {"crashcat/max-spin=0", {"max-spin = '0'", "(0, "}},
    {"physx/gyroo=off", {"option 'gyroo'", "did you mean 'gyro'?"}},
    {"physx/solver=tsg", {"value of option solver 'tsg'", "did you mean 'tgs'?"}},
    {"physx/restitution-threshold=0", {"restitution-threshold = '0'", "(0, 1000000]"}},
    {"physx/position-iterations=256", {"position-iterations = '256'", "whole number in [1, 255]"}},
    {"mujoco3/path=as-expert", {"path 'as-expert'", "valid: as-shipped"}},
    {"mujoco3/integrator=rk5", {"integrator 'rk5'", "did you mean 'rk4'?"}},
    {"mujoco3/cone=eliptic", {"value of option cone 'eliptic'", "did you mean 'elliptic'?"}},
    {"mujoco3/impratio=0", {"impratio = '0'", "(0, "}},
    {"mujoco3/solimp-most=1", {"solimp-most = '1'", "[0.0001, 0.9999]"}},
    {"mujoco/path=as-shiped", {"path 'as-shiped'", "did you mean 'as-shipped'?"}},
    {"mujoco/integrator=rk5", {"integrator 'rk5'", "did you mean 'rk4'?"}},
    {"mujoco/cone=eliptic", {"value of option cone 'eliptic'", "did you mean 'elliptic'?"}},
    {"mujoco/noslip-iteration=3", {"option 'noslip-iteration'", "did you mean 'noslip-iterations'?"}},
    {"mujoco/iterations=0", {"iterations = '0'", "whole", "[1, 1000000]"}},
    {"mujoco/noslip-iterations=1.5", {"noslip-iterations = '1.5'", "whole"}},
    {"mujoco/impratio=0", {"impratio = '0'", "above 0"}},
    {"mujoco/tolerance=nan", {"tolerance = 'nan'", "finite number from 0"}},
    {"mujoco/solimp-most=1", {"solimp-most = '1'", "[0.0001, 0.9999]"}},
};

TEST(Setup, EveryMistakeIsNamed) {
  const core::Scene scene = three_bodies(71);
  for (const Mistake& mistake : mistakes) {
    const auto engine = process::parse_engine(mistake.engine, process::default_engines(binary_dir));
    if (process::missing(engine.row)) continue;
    try {
      last(engine, scene, 1e-3, 1);
      ADD_FAILURE() << mistake.engine << " was taken";
    } catch (const core::InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(fmt::format("engine '{}'", mistake.engine)), std::string::npos) << message;
      for (const char* fragment : mistake.says)
        EXPECT_NE(message.find(fragment), std::string::npos)
            << mistake.engine << ": '" << fragment << "' is not in '" << message << "'";
    }
  }
}

TEST(Setup, TimeRunsForward) {
  const core::Scene scene = three_bodies(73);
  for (const Subject& subject : subjects_here())
    for (const double dt : {0.0, -1e-3, std::nan("")})
      EXPECT_THROW(last(subject.choice(), scene, dt, 1), core::InputError) << subject.id << ", dt = " << dt;
}

// What an engine offers it also takes: every path, integrator and option of every worker, with each of its
// values; and a worker that has had them all keeps none of them.
TEST(Setup, EverythingOfferedIsTaken) {
  const core::Scene scene = three_bodies(72);
  const process::KeptWorkers kept;  // those in Node take longer to start than to answer
  for (const Subject& subject : subjects_here()) {
    const process::EngineChoice plain = subject.choice();
    const core::Engine engine = process::describe(plain, limits);
    EXPECT_EQ(engine.precision, subject.single ? "float" : "double") << subject.id;
    const core::State before = last(plain, scene, 1e-3, 1);
    const auto takes = [&](const process::EngineChoice& choice, const std::string& what) {
      EXPECT_NO_THROW(last(choice, scene, 1e-3, 1)) << subject.id << ": " << what;
    };
    for (const core::Path& path : engine.paths) {
      process::EngineChoice choice = plain;
      choice.path = path.name;
      takes(choice, path.name);
    }
    for (const core::Integrator& integrator : engine.integrators) {
      process::EngineChoice choice = plain;
      choice.integrator = integrator.name;
      if (engine.name == "bullet" && integrator.order > 1) choice.path = "multibody";
      takes(choice, integrator.name);
    }
    for (const core::Option& option : engine.options)
      for (const std::string& value : option.values) {
        process::EngineChoice choice = plain;
        if (engine.name == "bullet") choice.path = "rigid";  // which has every word, and multibody fewer
        choice.options[option.name] = value;
        if (option.name == "speculative-restitution") choice.options["ccd"] = "0.9";
        if (option.name == "interpolation") choice.integrator = "verlet-adaptive";  // of error control alone
        takes(choice, option.name + "=" + value);
      }
    EXPECT_EQ(difference(last(plain, scene, 1e-3, 1), before), 0) << subject.id;
  }
}

}  // namespace
}  // namespace cylon::conformance
