// A journal on disk: JSON objects, one a line, each sealed, flushed as it is written, by one program at a
// time.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>

namespace cylon::cli {

/// What may still be read of files that anybody may have written.
struct Room {
  std::size_t memory = 600'000'000;  ///< Of values, as input::memory_of() counts it [bytes].
};

class LineFile {
 public:
  explicit LineFile(const std::filesystem::path& file) : LineFile(file, file) {}
  /// A file that is to be renamed to `place` once it is whole.
  LineFile(std::filesystem::path file, std::filesystem::path place)
      : file_(std::move(file)), place_(std::move(place)) {}
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Every object that this user sealed for this file, in order, to go on with it.  Throws core::InputError where it was
  /// written with --sandbox and this program runs engines without: what it names is a stranger's.  Lines that were cut off by a crash, or that
  /// somebody else wrote or moved here, are left out; how many is returned.  `take` may throw std::exception:
  /// that line is left out, too.
  std::size_t read(const std::function<void(const nlohmann::json&)>& take) const;

  /// The same for who runs nothing of it, with the lines for which is_sandbox_mark().
  std::size_t read_as_data(const std::function<void(const nlohmann::json&)>& take) const;

  /// The line of a journal whose engines ran in a sandbox; open() writes it where they do now.
  static nlohmann::json sandbox_mark();
  static bool is_sandbox_mark(const nlohmann::json&);

  /// The same of a file that anybody may have written anywhere: their word is taken for it.  Throws
  /// core::InputError where it cannot be read, has more than 256 MB, or there is no room for what it holds, which is taken
  /// from the room.
  static std::size_t read_of_others(const std::filesystem::path&, Room&,
                                    const std::function<void(const nlohmann::json&)>& take);

  /// Opens it to write, afresh or after what is there, and locks it until the end.  Throws core::InputError
  /// where another program has it locked.  Where it cannot be written, stderr says so and add() does nothing.
  void open(bool append);

  enum class Disk { now, later };

  /// Appends a line, on the disk when it returns, or once synchronise() has.  Where that fails (a full disk), stderr says
  /// so once.
  void add(const nlohmann::json& object, Disk = Disk::now);
  void synchronise();

  /// Whether all of it could be written so far.
  bool is_open() const { return fd_ >= 0; }

 private:
  void give_up(int error);
  std::string purpose() const;

  std::filesystem::path file_, place_;
  int fd_ = -1;
};

}  // namespace cylon::cli
