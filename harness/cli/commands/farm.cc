// cylon farm
#include "harness/cli/farm.h"

#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/folders.h"
#include "harness/process/interruption.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <streambuf>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

// What a rank prints that is not the leader, and the leader before it has all results.
class Mute {
 public:
  explicit Mute(std::ostream& stream, bool on) : stream_(stream), before_(stream.rdbuf()) {
    if (on) stream_.rdbuf(&nothing_);
  }
  ~Mute() { stream_.rdbuf(before_); }
  Mute(const Mute&) = delete;
  Mute& operator=(const Mute&) = delete;

 private:
  struct Nothing : std::streambuf {
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  } nothing_;
  std::ostream& stream_;
  std::streambuf* before_;
};

std::unique_ptr<crew::Crew> crew_here() {
  std::error_code ignored;
  const Folders own = folders_of(fs::read_symlink("/proc/self/exe", ignored));
  return crew::load(own.workers.string(), own.installed
                                              ? "apt-get install ./cylon-mpi_*.deb openmpi-bin"
                                              : "apt-get install libopenmpi-dev openmpi-bin && ./run");
}

void require_shared(const std::vector<std::string>& words) {
  const bool known = !words.empty() && std::ranges::any_of(questions, [&](const Question& question) {
    return words.front() == question.command;
  });
  if (!known)
    throw core::InputError(
        fmt::format("cylon farm shares out {}; give one of these with its options", sharing_commands()));
  if (const auto shard = shard_asked({}))
    throw core::InputError(
        fmt::format("{} is set, as for shard {} of {}: a farm is one job and does all; unset it",
                    shard->said_by, shard->index, shard->count));
}

// What one rank does; the leader then has all results in the folder's journal.  The exit code; 0: go on.
int work(const Context& context, Farm& farm, const std::vector<std::string>& words) {
  Context inner = context;
  inner.farm = &farm;
  inner.progress = context.progress && farm.leads();
  std::string why;
  int code = ok;
  try {
    const Mute results(std::cout, true), remarks(std::cerr, !farm.leads());
    code = run_words(inner, words);
  } catch (const core::InputError& error) {
    why = error.what();
    code = bad_input;
  } catch (const process::Interrupted&) {
    code = interrupted;
  } catch (const std::exception& error) {  // no memory, no disk
    std::cerr << fmt::format("internal error: {}: {}\n", farm.name(farm.shard().index - 1),
                             plain_line(error.what()));
    farm.abort(harness_failure);
  }
  if (!farm.is_shared_out()) {  // all ranks end alike
    const std::string first = farm.leave(why);
    if (farm.leads() && !first.empty()) std::cerr << "error: " << plain_line(first) << '\n';
    return code == ok ? bad_input : code;
  }
  if (why.empty() && (code == ok || code == bad_input)) return farm.finish(code);
  std::cerr << fmt::format("error: {}: {}\n", farm.name(farm.shard().index - 1),
                           why.empty() ? fmt::format("ended with exit code {}", code) : plain_line(why));
  farm.abort(code);
}

int farm(const Context& given, std::vector<std::string> words) {
  Context context = given;  // mpirun gives rank 0 a terminal of its own, which is not the user's
  context.colour = false, context.width = width_without_terminal;
  if (std::ranges::find(words, "--help") != words.end()) return run_words(context, words);
  require_shared(words);
  const std::unique_ptr<crew::Crew> crew = crew_here();
  Farm farm(*crew);
  const int code = work(context, farm, words);
  if (!farm.leads() || !farm.is_shared_out()) return farm.leads() ? code : ok;
  if (std::ranges::find(words, "--resume") == words.end()) words.emplace_back("--resume");
  const int end = run_words(context, words);
  return code == bad_input || end == ok ? code : end;
}

}  // namespace

Command add_farm(App& app, const Context& context) {
  const auto words = std::make_shared<std::vector<std::string>>();
  app.take_rest(*words);
  app.footer(
      fmt::format("mpirun -n 16 cylon farm run '*' --json all.json\n"
                  "\n"
                  "The words are one of {} with its options. Rank 0 hands out the cells and computes\n"
                  "too; each rank writes a journal (.cylon/journal-rank-1-of-16.jsonl), and rank 0 joins "
                  "them in the end. All ranks\n"
                  "work in one folder. A rank that dies ends the job; the same line with --resume goes on, "
                  "with any number of\n"
                  "ranks. -j is per rank; default: the cores that the launcher gave it.",
                  sharing_commands()));
  return [=, &context] { return farm(context, *words); };
}

}  // namespace cylon::cli
