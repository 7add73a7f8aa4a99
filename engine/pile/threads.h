// Work split into parts that do not depend on the number of threads.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>

#ifdef __SANITIZE_THREAD__
extern "C" {
void __tsan_acquire(void*);  // of ThreadSanitizer's library
void __tsan_release(void*);
}
#endif

namespace cylon::engine::pile {

/// What a thread did before tell() has happened for one that has called hear(), for ThreadSanitizer alone: oneTBB's
/// library, which sees to it, is not compiled with it.
struct Order {
#ifdef __SANITIZE_THREAD__
  void tell() { __tsan_release(this); }
  void hear() { __tsan_acquire(this); }
#else
  void tell() {}
  void hear() {}
#endif
};

/// Runs parts of work that touch nothing in common: their order, and so the number of threads, cannot matter.
class Threads {
 public:
  /// 0: as many as the machine has.
  explicit Threads(int count)
      : arena_(count == 1 ? nullptr
                          : std::make_unique<tbb::task_arena>(count == 0 ? int{tbb::task_arena::automatic}
                                                                         : count)) {}

  template <class Part>
  void for_each(std::size_t parts, std::size_t grain, const Part& part) {
    if (!arena_ || parts <= grain) {
      for (std::size_t i = 0; i < parts; ++i) part(i);
      return;
    }
    Order begin, end;
    begin.tell();
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts, grain), [&](const auto& range) {
        begin.hear();
        for (std::size_t i = range.begin(); i != range.end(); ++i) part(i);
        end.tell();
      });
    });
    end.hear();
  }

 private:
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace cylon::engine::pile
