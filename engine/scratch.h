// Room for values that a function needs while it runs, kept from call to call: a step allocates nothing.
#pragma once

#include <utility>
#include <vector>

namespace cylon::engine {

/// An empty vector that has the room of the last one of its type in this thread.  Functions that call each other get one each.
template <class T>
class Scratch {
 public:
  Scratch() : values_(std::exchange(kept(), {})) { values_.clear(); }
  ~Scratch() { kept() = std::move(values_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::vector<T>& operator*() { return values_; }
  std::vector<T>* operator->() { return &values_; }

 private:
  static std::vector<T>& kept() {
    thread_local std::vector<T> room;
    return room;
  }
  std::vector<T> values_;
};

}  // namespace cylon::engine
