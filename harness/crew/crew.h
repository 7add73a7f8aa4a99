// Processes that a launcher started together and that hear of each other: an interface, so that the program needs no MPI.
// libcylon-mpi.so (harness/mpi) implements it, where MPI is here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cylon::crew {

/// The ranks 0 … size() - 1.  One thread at a time calls a member, but for serve(), beside which others may be called.
class Crew {
 public:
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  virtual ~Crew() = default;

  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;

  /// What each rank says, by rank.  Every rank calls it, and none returns before all have.
  virtual std::vector<std::string> all_say(const std::string& mine) = 0;

  /// Units of work from rank 0, which must serve; empty: there are none left.  Not on rank 0.
  virtual std::vector<std::int64_t> ask() = 0;

  /// On rank 0: answers what the others ask by take(), until each was told that there is nothing left.
  virtual void serve(const std::function<std::vector<std::int64_t>()>& take) = 0;

  /// Ends every rank's process, this one's with the code.
  [[noreturn]] virtual void abort(int code) = 0;
};

/// The crew of this process from the library libcylon-mpi.so of a folder.  Throws core::InputError where it or MPI is not
/// here; `brought_by` is the command that brings it.
std::unique_ptr<Crew> load(const std::string& folder, const std::string& brought_by);

}  // namespace cylon::crew
