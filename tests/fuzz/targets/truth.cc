#include "harness/core/input_error.h"
#include "harness/scenario/recorded_truth.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void truth(std::string_view bytes) {
  static const core::Scene scene = [] {
    core::Scene two;
    two.bodies.resize(2);
    two.bodies[0].name = "a", two.bodies[1].name = "b";
    return two;
  }();
  static const core::Scene single = [] {
    core::Scene one;
    one.bodies.resize(1);
    one.bodies[0].name = "a";
    return one;
  }();
  // A scene of one body takes a file of one body of any name.
  for (const core::Scene* seen : {&single, &scene}) try {
      const core::Truth read = scenario::parse_truth(bytes, "t.json", *seen);
      for (const double t : read.times)
        if (read.state(t).size() != seen->bodies.size())
          throw Broken("a truth has a state of all bodies at each of its times");
    } catch (const core::InputError&) {
    }
}

}  // namespace cylon::fuzz
