// What a program measures, in words that C++ and JavaScript share after a translation: `let` declares, `fn` begins a
// function.  s is a list of states {x, q, v, w}, body a list of {m, I} with principal moments I in body axes.
#pragma once

#include <span>
#include <string_view>

namespace cylon::hunt::program {

/// How the numbers of all samples become the one that is printed.
enum class Reduce {
  change,  ///< The largest change of the value since the start.
  rise,    ///< The largest rise above the least value so far that lasts more than one step.
  sample,  ///< At sample ${sample} alone.
  course,  ///< The formula takes them all.
  pair     ///< Between the paths of the scene and of its restatement.
};

struct Formula {
  std::string_view oracle;
  std::string_view unit;
  bool vector;  ///< Of its value.
  Reduce reduce;
  std::string_view text;  ///< fn value(s), fn worst_of(path), or fn apart(one, other) of two states.
};

std::span<const Formula> formulas();

/// fn spring, fn drag, …: what each force of the scene calls, by the name of its element.
std::string_view law(std::string_view force);

/// fn run(take), which gives the list of states at all samples.
extern const std::string_view run;

/// The statements that print `worst`.
std::string_view reduction(const Formula&);

}  // namespace cylon::hunt::program
