// DART's solvers of a step's linear complementarity problem, and what they leave unsolved.
#include "reference/simulators/dart/border/dart_parts.h"

#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/DantzigBoxedLcpSolver.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::simulators::dart_border {
namespace {

using namespace dart::constraint;

// One of DART's solvers, whose answer is looked at: DART itself tells nobody.
class Watched : public BoxedLcpSolver {
 public:
  Watched(BoxedLcpSolverPtr solver, std::function<void(bool finite)> failed)
      : solver_(std::move(solver)), failed_(std::move(failed)) {}

  const std::string& getType() const override { return solver_->getType(); }

  bool solve(int n, double* A, double* x, double* b, int nub, double* lo, double* hi, int* findex,
             bool earlyTermination) override {
    const bool solved = solver_->solve(n, A, x, b, nub, lo, hi, findex, earlyTermination);
    const bool finite = std::all_of(x, x + n, [](double one) { return std::isfinite(one); });
    if (!solved || !finite) failed_(finite);
    return solved;
  }

#ifndef NDEBUG
  bool canSolve(int n, const double* A) override { return solver_->canSolve(n, A); }
#endif

 private:
  BoxedLcpSolverPtr solver_;
  std::function<void(bool)> failed_;
};

}  // namespace

void World::Parts::set_solver(const Settings& settings) {
  const auto given_up = [count = unsolved](bool) { ++count->given_up; };
  const auto left = [count = unsolved](bool finite) { ++count->left, count->not_finite += finite ? 0 : 1; };
  const auto dantzig = std::make_shared<DantzigBoxedLcpSolver>();
  const auto sweeps = std::make_shared<PgsBoxedLcpSolver>();
  PgsBoxedLcpSolver::Option option = sweeps->getOption();
  option.mMaxIteration = settings.sweeps;
  option.mDeltaXThreshold = settings.change;
  option.mRelativeDeltaXTolerance = settings.relative_change;
  sweeps->setOption(option);
  BoxedLcpSolverPtr first, second;
  switch (settings.solver) {
    case Solver::dantzig:
      first = std::make_shared<Watched>(dantzig, given_up), second = std::make_shared<Watched>(sweeps, left);
      break;
    case Solver::dantzig_alone:
      first = std::make_shared<Watched>(dantzig, left);
      break;
    case Solver::pgs:
      first = std::make_shared<Watched>(sweeps, left);
      break;
  }
  world->setConstraintSolver(std::make_unique<BoxedLcpConstraintSolver>(settings.dt, first, second));
}

}  // namespace cylon::simulators::dart_border
