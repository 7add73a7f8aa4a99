// A worker around a simulator of yours, for `cylon run --worker` (docs/library.md):
//   int main() { return cylon::worker::run<MyEngine>(); }
#pragma once

#include "harness/core/simulator.h"

#include <array>
#include <cstddef>
#include <memory>

namespace cylon::worker {

/// How the compiler lays out what crosses the interface [bytes].  Vector extensions, EIGEN_MAX_STATIC_ALIGN_BYTES and
/// checked containers (_GLIBCXX_DEBUG) change it, and no linker sees that.
using Layout = std::array<std::size_t, 7>;

/// As it is in the source that includes this.  Not inline, for that would be the layout of one source for all.
static constexpr Layout layout_here = {sizeof(core::Scene),     sizeof(core::Body),  sizeof(core::Joint),
                                       sizeof(core::BodyState), sizeof(core::Setup), alignof(core::BodyState),
                                       sizeof(core::Loaded)};

/// Makes the simulator, serves the protocol (docs/protocol.md) on stdin and stdout until quit or the end of input, and
/// returns what main returns: 0; 1 when nobody listens any more; 2, with a sentence on stderr, where the layouts of
/// library and caller differ.  What the engine prints on stdout goes to stderr.  What the simulator throws while it steps
/// escapes on purpose: the process dies of it, and the judge sees a crash.
int run(std::unique_ptr<core::Simulator> (*make)(), const Layout& layout = layout_here);

template <class Engine>
int run() {
  return run([]() -> std::unique_ptr<core::Simulator> { return std::make_unique<Engine>(); });
}

}  // namespace cylon::worker
