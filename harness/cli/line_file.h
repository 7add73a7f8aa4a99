// A journal on disk: JSON objects, one a line, each sealed, flushed as it is written, by one program at a
// time.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>

namespace cylon::cli {

class LineFile {
 public:
  explicit LineFile(std::filesystem::path file) : file_(std::move(file)) {}
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Every object that this user sealed for this file, in order.  Lines that were cut off by a crash, or that
  /// somebody else wrote or moved here, are left out; how many is returned.  `take` may throw std::exception:
  /// that line is left out, too.
  std::size_t read(const std::function<void(const nlohmann::json&)>& take) const;

  /// Opens it to write, afresh or after what is there, and locks it until the end.  Throws core::InputError
  /// where another program has it locked.  Where it cannot be written, stderr says so and add() does nothing.
  void open(bool append);

  /// Appends a line.  Where that fails (a full disk), stderr says so once.
  void add(const nlohmann::json& object);

 private:
  void give_up(int error);
  std::string purpose() const;

  std::filesystem::path file_;
  int fd_ = -1;
};

}  // namespace cylon::cli
