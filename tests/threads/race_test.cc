// ThreadSanitizer's part in `./test threads`: what it is told, and that it sees a race.
#include <gtest/gtest.h>

#include <thread>

#ifdef __SANITIZE_THREAD__
extern "C" const char* __tsan_default_suppressions();

// oneTBB's scheduler is not compiled with ThreadSanitizer, which therefore does not see how it hands work to its
// threads; engine/pile/threads.h tells it what parallel_for promises.  What remains are the scheduler's own headers.
extern "C" const char* __tsan_default_suppressions() { return "race:tbb::detail\n"; }
#endif

namespace cylon {
namespace {

// Negative control: two threads count in one number.
TEST(ThreadSanitizer, SeesARace) {
#ifdef __SANITIZE_THREAD__
  const auto race = [] {
    int count = 0;
    std::thread other([&] { ++count; });
    ++count;
    other.join();
    std::exit(count > 2 ? 1 : 0);
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // in a process of its own
  EXPECT_EXIT(race(), testing::ExitedWithCode(66), "data race");
#else
  GTEST_SKIP() << "not compiled with ThreadSanitizer: ./test threads";
#endif
}

}  // namespace
}  // namespace cylon
