// Two processes that measure times on the same cores: a shard waits for the other, any other command says so.
#include "harness/cli/cores.h"
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>

namespace cylon::cli {
namespace {

class TimedCoresOfTwo : public CommandLine {
 protected:
  /// With a temporary folder of its own, in which `$lock` is that of the first core.
  Ran timed(const std::string& script) const {
    const Cores own = own_cores();
    return shell(fmt::format("export TMPDIR=\"$PWD/tmp\"; lock=$TMPDIR/cylon-core-{}-{}.lock; mkdir -p tmp; ",
                             own.host, *own.cores.begin()) +
                 script);
  }
};

TEST_F(TimedCoresOfTwo, AreHeldWhileTimesAreMeasured) {
  write("engine.sh", "flock --shared --nonblock tmp/cylon-core-*-" +
                         std::to_string(*own_cores().cores.begin()) + ".lock true || touch held\nexec " +
                         std::string(binary_dir) + "/cylon-worker-in-house\n");
  const std::string asked =
      "cylon trade projectile --steps 2 --worker 'mine=sh engine.sh' --engine mine --shard 1/1 ";
  const Ran errors = timed("touch $lock; " + asked + "--rounds 0; [ ! -e held ] || echo lock-is-taken");
  EXPECT_EQ(errors.out.find("lock-is-taken"), std::string::npos) << errors.err;
  const Ran times = timed(asked + "--rounds 1; [ ! -e held ] || echo lock-is-taken");
  EXPECT_NE(times.out.find("lock-is-taken"), std::string::npos) << times.err;
  EXPECT_EQ(times.err.find("another cylon"), std::string::npos) << times.err;
}

TEST_F(TimedCoresOfTwo, AreNotMeasuredAtOnce) {
  const Ran ran = timed(R"sh(
    mkdir shard command
    (exec 9>$lock; flock 9; touch taken; for i in $(seq 3000); do [ -e free ] && exit; sleep 0.02; done) &
    while [ ! -e taken ]; do sleep 0.02; done
    timed() { cd $1; exec cylon trade projectile --steps 2 --engine ode "${@:2}" >out 2>err; }
    (timed command --rounds 1) || echo "the command failed: $(cat command/err)"
    (timed shard --rounds 1 --shard 1/1) & second=$!
    for i in $(seq 1500); do grep -q waits shard/err && break; sleep 0.02; done
    [ ! -e shard/.cylon ] || echo "the shard did not wait"
    touch free
    wait $second || echo "the shard failed: $(cat shard/err)")sh");
  EXPECT_EQ(ran.out, "") << ran.err;
  EXPECT_NE(read("shard/err").find("this one waits for its end"), std::string::npos) << read("shard/err");
  EXPECT_NE(read("shard/.cylon/trade-1-of-1.jsonl").find("cell"), std::string::npos);
  EXPECT_NE(read("command/err").find("times are those of two at once"), std::string::npos)
      << read("command/err");
}

}  // namespace
}  // namespace cylon::cli
