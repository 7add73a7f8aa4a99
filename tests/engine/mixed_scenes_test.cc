// Every mix of features moves the same on every path of the engine, or is refused with a reason.
#include "tests/engine/mixed_scenes_check.h"

namespace cylon::engine {
namespace {

TEST(MixedScenes, MoveTheSameOnEveryPath) { expect_same_on_every_path(0, 1000); }

}  // namespace
}  // namespace cylon::engine
