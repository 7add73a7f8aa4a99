// What strangers' bytes reach, each as one function of bytes.  libFuzzer feeds them (tests/fuzz/libfuzzer.cc,
// tests/fuzz/campaign.py); an ordinary test replays the seeds and some mutants (tests/fuzz/replay_test.cc).
// tests/fuzz/targets.txt lists them.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cylon::fuzz {

/// What a target promises does not hold: the rule, and what was seen.
struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};

struct Target {
  const char* name;
  /// Returns where the bytes are taken or refused as documented; every exception is a finding.
  void (*feed)(std::string_view bytes);
  const char* seeds;  ///< Glob of shipped files that are seeds; "-": none.
};

/// The rows of targets.txt.
std::span<const Target> targets();

void cache(std::string_view);     ///< The body of a cached certified truth.
void command(std::string_view);   ///< A command of the viewer's page.
void history(std::string_view);   ///< `cylon track import`, all three formats.
void http(std::string_view);      ///< What a client sends to the viewer.
void journal(std::string_view);   ///< The lines of a journal, without their seals.
void mesh(std::string_view);      ///< A Wavefront file of a scenario.
void protocol(std::string_view);  ///< All that a worker writes.
void report(std::string_view);    ///< A file of `cylon report`.
void scene(std::string_view);     ///< A scenario; what is taken, a worker takes too.
void states(std::string_view);    ///< States that `cylon diff` reads.
void suite(std::string_view);     ///< A suite.
void truth(std::string_view);     ///< Recorded data of a scenario.

}  // namespace cylon::fuzz
