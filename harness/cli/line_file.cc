#include "harness/cli/line_file.h"

#include "harness/cli/command_line.h"
#include "harness/cli/patience.h"
#include "harness/cli/read_whole.h"
#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/process/sandbox.h"
#include "harness/seal/seal.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t largest_journal = std::uintmax_t{1} << 30;        // [bytes]
constexpr std::size_t largest_journal_of_others = std::size_t{256} << 20;  // held whole [bytes]

std::string text_of(const json& value) { return value.dump(-1, ' ', true, json::error_handler_t::replace); }

// Calls take(object) for a line; how many are none, or are refused by an exception.
template <class Take>
std::size_t strange_line(std::string_view line, const Take& take) {
  if (line.empty()) return 0;
  try {
    take(input::parse_json(line));
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

LineFile::~LineFile() {
  if (fd_ >= 0) ::close(fd_);
}

// The folder belongs to it: a journal that was copied from another folder is not this one's.
std::string LineFile::purpose() const {
  std::error_code ignored;
  return "journal " + fs::weakly_canonical(fs::absolute(place_, ignored), ignored).string();
}

json LineFile::sandbox_mark() { return {{"sandbox", true}}; }
bool LineFile::is_sandbox_mark(const json& line) { return line == sandbox_mark(); }

std::size_t LineFile::read(const std::function<void(const json&)>& take) const {
  bool sandboxed = false;
  const std::size_t strange = read_as_data([&](const json& line) {
    if (is_sandbox_mark(line))
      sandboxed = true;
    else
      take(line);
  });
  if (sandboxed) process::require_sandbox_again(fmt::format("{} was written", file_.string()));
  return strange;
}

std::size_t LineFile::read_as_data(const std::function<void(const json&)>& take) const {
  std::error_code error;
  if (!fs::is_regular_file(file_, error)) return 0;
  if (const auto size = fs::file_size(file_, error); !error && size > largest_journal)
    throw core::InputError(fmt::format("{}: {} bytes, but at most 1 GiB are read", file_.string(), size));
  const std::string place = purpose();
  const auto take_own = [&](json&& object) {
    const std::string mac = object.at("seal").get<std::string>();
    object.erase("seal");
    if (!seal::holds(mac, place, text_of(object))) throw input::BadJson(0, "the seal does not hold");
    take(object);
  };
  std::ifstream in(file_, std::ios::binary);
  std::size_t strange = 0;
  for (std::string line; std::getline(in, line);) strange += strange_line(line, take_own);
  return strange;
}

std::size_t LineFile::read_of_others(const fs::path& file, Room& room,
                                     const std::function<void(const json&)>& take) {
  const std::string text = read_whole(file.string(), largest_journal_of_others);
  const std::size_t memory = input::memory_of(text);
  if (memory > room.memory)
    throw core::InputError(
        fmt::format("{}: values that take {} MB of memory, but {} MB are left of {} MB for all files",
                    file.string(), memory / 1'000'000, room.memory / 1'000'000, Room{}.memory / 1'000'000));
  room.memory -= memory;
  const auto take_any = [&](json&& object) {
    object.erase("seal");
    take(object);
  };
  std::size_t strange = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    strange += strange_line(rest.substr(0, end), take_any);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return strange;
}

void LineFile::open(bool append) {
  std::error_code ignored;
  fs::create_directories(file_.parent_path(), ignored);
  fd_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (fd_ < 0) return give_up(errno);
  // Where the file system has no locks there is none to wait for.
  if (!locks_in_a_moment([&] { return ::flock(fd_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }))
    throw core::InputError(
        fmt::format("{}: another cylon is at work in this folder; wait for its end, or use another folder",
                    file_.string()));
  struct stat status = {};
  if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) return give_up(EINVAL);
  char last = '\n';
  if (!append) {
    if (::ftruncate(fd_, 0) != 0) return give_up(errno);
  } else if (status.st_size > 0 && ::pread(fd_, &last, 1, status.st_size - 1) != 1) {
    return give_up(errno);
  }
  if (last != '\n' && !write_all(fd_, "\n")) return give_up(errno);  // ends a line that a crash has cut off
  if (process::sandboxing()) add(sandbox_mark());                    // before what is to be gone on with
}

void LineFile::add(const json& object, Disk disk) {
  if (fd_ < 0) return;
  std::string line =
      text_of(object);  // once: what is sealed, and, with the seal as its last key, what is written
  const std::string mac = text_of(seal::seal(purpose(), line));
  line.insert(line.size() - 1, (line.size() > 2 ? ",\"seal\":" : "\"seal\":") + mac);
  if (!write_all(fd_, line + '\n'))
    give_up(errno);
  else if (disk == Disk::now)
    synchronise();
}

// A pipe or a file system that cannot synchronise has done what it can.
void LineFile::synchronise() {
  if (fd_ >= 0 && ::fdatasync(fd_) != 0 && errno != EINVAL && errno != ENOSYS) give_up(errno);
}

void LineFile::give_up(int error) {
  std::cerr << plain_line(fmt::format("warning: {} cannot be written ({}); what follows cannot be resumed",
                                      file_.string(), std::generic_category().message(error)))
            << '\n';
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

}  // namespace cylon::cli
