// What `cylon hunt` has asked and shrunk, so that an interrupted one goes on, and so that parts of one can be joined:
// JSON lines in .cylon/hunt.jsonl of the working folder.
#pragma once

#include "harness/cli/line_file.h"
#include "harness/cli/part.h"
#include "harness/hunt/hunt.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace cylon::cli {

class HuntJournal {
 public:
  /// Starts afresh, or reads what is there and goes on after it; a line cut off by a crash is left out.  Throws
  /// core::InputError where another hunt has the file open.
  HuntJournal(const std::filesystem::path& file, bool resume);
  HuntJournal(const HuntJournal&) = delete;
  HuntJournal& operator=(const HuntJournal&) = delete;

  /// Whether all lines so far could be written.
  bool is_open() const { return file_.is_open(); }

  /// What is to be asked, where it is known beforehand.
  void add(const cli::Part& part) { file_.add(to_json(part)); }

  /// All scenes of a unit were asked.  Called by several threads.
  void done(const Unit&, double seconds);

  /// Of one question, by its key: valid as long as the journal, and used by several threads.
  hunt::Memory& of(const std::string& question);

 private:
  class Answers;

  LineFile file_;
  std::mutex writing_;
  std::set<std::string> done_;                               // keys of units
  std::map<std::string, std::unique_ptr<Answers>> answers_;  // by the keys of questions

 public:
  ~HuntJournal();
};

/// All that decides what comes of a scene's number: the engine's and this program's content, the scenes, and what stops a
/// run.
std::string question_of(const process::EngineChoice&, const hunt::Source&, double timeout);

}  // namespace cylon::cli
