// Features that no shipped scenario puts into one scene, on the in-house engine: every force beside every
// other, a rotating frame, compounds of meshes and hulls on a joint.  Each scene goes through all that is
// derived from the tables of fields: reading, the worker's JSON, restatements.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

namespace cylon::cli {
namespace {

class Mix : public CommandLine, public testing::WithParamInterface<const char*> {
 protected:
  std::string file() const { return std::string(source_dir) + "/tests/data/mixes/" + GetParam() + ".toml"; }
};

TEST_P(Mix, PassesItsClaimsByErrorControlAndByFixedSteps) {
  const Ran ran = shell("cylon run " + file() + " --engine in-house --engine in-house/integrator=rk4 -v");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
}

TEST_P(Mix, IsSeenByItsClaimsWhenAStepIsTooCoarse) {
  const Ran ran = shell("cylon run " + file() + " --engine in-house/integrator=lie-trotter --dt 1/100");
  EXPECT_EQ(ran.code, 1) << ran.out << ran.err;
  EXPECT_NE(ran.out.find(" fail)"), std::string::npos) << ran.out;
}

TEST_P(Mix, KeepsTheSymmetriesOfMechanics) {
  const Ran ran = shell("cylon run " + file() + " --metamorphic --engine in-house");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
}

INSTANTIATE_TEST_SUITE_P(Features, Mix,
                         testing::Values("every_force", "turning_frame", "uneven_frame", "joints_in_a_frame",
                                         "locked_in_a_frame", "compound_on_hinge"),
                         [](const auto& mix) { return std::string(mix.param); });

}  // namespace
}  // namespace cylon::cli
