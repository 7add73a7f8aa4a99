// The ranks of an MPI job.  A shared library of its own, which `cylon farm` alone loads.
#include "harness/crew/crew.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

namespace cylon::crew {
namespace {

constexpr int question = 1, answer = 2;  // tags of messages

// MPI waits by trying again and again, on a core that an engine could have.  Here each try that finds nothing is followed
// by a nap, twice as long as the one before.
class Nap {
 public:
  void take() {
    std::this_thread::sleep_for(length_);
    length_ = std::min(2 * length_, longest);
  }

 private:
  static constexpr std::chrono::microseconds longest{1000};
  std::chrono::microseconds length_{30};
};

class MpiCrew final : public Crew {
 public:
  MpiCrew() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  MpiCrew(const MpiCrew&) = delete;
  MpiCrew& operator=(const MpiCrew&) = delete;
  ~MpiCrew() override { MPI_Finalize(); }

  std::size_t rank() const override { return static_cast<std::size_t>(rank_); }
  std::size_t size() const override { return static_cast<std::size_t>(size_); }

  std::vector<std::string> all_say(const std::string& mine) override {
    const std::scoped_lock lock(calling_);
    const int length = static_cast<int>(mine.size());
    std::vector<int> lengths(size()), starts(size());
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
    wait(request);
    int total = 0;
    for (std::size_t i = 0; i < size(); ++i) starts[i] = std::exchange(total, total + lengths[i]);
    std::string text(static_cast<std::size_t>(total), '\0');
    MPI_Iallgatherv(mine.data(), length, MPI_CHAR, text.data(), lengths.data(), starts.data(), MPI_CHAR,
                    MPI_COMM_WORLD, &request);
    wait(request);
    std::vector<std::string> all;
    for (std::size_t i = 0; i < size(); ++i)
      all.push_back(text.substr(static_cast<std::size_t>(starts[i]), static_cast<std::size_t>(lengths[i])));
    return all;
  }

  std::vector<std::int64_t> ask() override {
    const std::scoped_lock lock(calling_);
    MPI_Send(nullptr, 0, MPI_INT64_T, 0, question, MPI_COMM_WORLD);
    MPI_Status status;
    int there = 0;
    for (Nap nap;;) {
      MPI_Iprobe(0, answer, MPI_COMM_WORLD, &there, &status);
      if (there) break;
      nap.take();
    }
    int count = 0;
    MPI_Get_count(&status, MPI_INT64_T, &count);
    std::vector<std::int64_t> units(static_cast<std::size_t>(count));
    MPI_Recv(units.data(), count, MPI_INT64_T, 0, answer, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return units;
  }

  void serve(const std::function<std::vector<std::int64_t>()>& take) override {
    Nap nap;
    for (int told = 0; told + 1 < size_;) {
      if (const int asked_by = asked(); asked_by >= 0) {
        const std::vector<std::int64_t> units = take();
        const std::scoped_lock lock(calling_);
        MPI_Send(units.data(), static_cast<int>(units.size()), MPI_INT64_T, asked_by, answer, MPI_COMM_WORLD);
        told += units.empty();
        nap = {};
      } else {
        nap.take();
      }
    }
  }

  [[noreturn]] void abort(int code) override {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::_Exit(code);
  }

 private:
  // Which rank has asked; -1: none.
  int asked() {
    const std::scoped_lock lock(calling_);
    MPI_Status status;
    int there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, question, MPI_COMM_WORLD, &there, &status);
    if (!there) return -1;
    MPI_Recv(nullptr, 0, MPI_INT64_T, status.MPI_SOURCE, question, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return status.MPI_SOURCE;
  }

  static void wait(MPI_Request& request) {
    int done = 0;
    for (Nap nap;;) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done) return;
      nap.take();
    }
  }

  std::mutex calling_;  // MPI is asked by one thread at a time
  int rank_ = 0, size_ = 1;
};

}  // namespace
}  // namespace cylon::crew

// Null where this MPI cannot be called from several threads.
extern "C" cylon::crew::Crew* cylon_crew() {
  int level = MPI_THREAD_SINGLE;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
  if (level >= MPI_THREAD_SERIALIZED) return new cylon::crew::MpiCrew;
  MPI_Finalize();
  return nullptr;
}
