// The same as in ./test, over 10^5 scenes.
#include "tests/engine/mixed_scenes_check.h"

namespace cylon::engine {
namespace {

TEST(MixedScenes, MoveTheSameOnEveryPathInManyMixes) { expect_same_on_every_path(1000, 100000); }

}  // namespace
}  // namespace cylon::engine
