// Work split into parts that do not depend on the number of threads.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>

namespace cylon::engine::pile {

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
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts, grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) part(i);
      });
    });
  }

 private:
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace cylon::engine::pile
