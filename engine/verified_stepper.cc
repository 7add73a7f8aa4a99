#include "engine/verified_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine {

namespace {

// Below this a local tolerance is rounding.
constexpr Real least = epsilon / 2;
// What runs that ran out of operations start again with, and how much of it they may spend beside their steps.
constexpr Real far = Real(1e5), largest = Real(1e-4);
constexpr std::int64_t second_operations = 12'000'000;
constexpr Real first_share = Real(0.1);  // of the bound: errors of single steps add up

// The angle between two orientations.
Real angle(const Quaternion& a, const Quaternion& b) {
  const Real minus = (a.coeffs() - b.coeffs()).norm(), plus = (a.coeffs() + b.coeffs()).norm();
  return 4 * std::asin(std::min(Real(1), std::min(minus, plus) / 2));
}

// The larger; not a number where one of them is not, which std::max() would lose.
Real worse(Real a, Real b) { return b > a || std::isnan(b) ? b : a; }

Real share(Real difference, Real scale) { return difference == 0 ? 0 : difference / scale; }

// A run that ended has no numbers any more: no step was small enough for its tolerance, or a rate was none.
bool ended(const Stepper& run) {
  std::vector<Motion> motions;
  run.read(motions);
  return !std::ranges::all_of(motions, [](const Motion& m) { return m.position.allFinite(); });
}

}  // namespace

VerifiedStepper::VerifiedStepper(MakeRun make, Real bound, Time dt, std::vector<Body> bodies,
                                 std::int64_t first, std::shared_ptr<std::int64_t> reserve)
    : make_(std::move(make)),
      bound_(bound),
      dt_(dt),
      tolerance_(std::max(bound * first_share / 10, least)),
      bodies_(std::move(bodies)),
      first_(first),
      reserve_(std::move(reserve)) {
  coarse_ = make_(10 * tolerance_);
  fine_ = make_(tolerance_);
  fine_->read(fine_motion_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].locked)
      length_ = std::max(length_, fine_motion_[i].position.norm());
    else
      movable_.push_back(i);
  }
}

void VerifiedStepper::step() {
  ++steps_;
  fine_->step();
  if (unknown_at_ >= 0) return;
  coarse_->step();
  if (fine_->ran_out() && loosen_far()) {
    if (missed_at_ < 0) missed_at_ = steps_;
    worst_ = std::max(worst_, parted());
    return;
  }
  for (;;) {
    Real error = parted();
    if (compare(error)) return;
    // Where both runs ended, a finer one ends, too, after many more steps.
    const bool finest = tolerance_ <= least || missed_at_ >= 0 || (ended(*coarse_) && ended(*fine_));
    if (finest || !tighten()) {
      if (ended(*fine_) && !ended(*coarse_)) {
        loosen();
        error = parted();
      }
      if (missed_at_ < 0) missed_at_ = steps_;
      worst_ = std::max(worst_, error);
      return;
    }
  }
}

bool VerifiedStepper::compare(Real error) {
  const bool agree = error <= bound_, struck = coarse_->struck() || fine_->struck();
  if (fine_->gave_up()) {
    unknown_at_ = steps_;
    waiting_ = false;
    return true;
  }
  if (!agree && (!struck || waiting_)) return false;
  waiting_ = !agree;
  last_ = error;
  return true;
}

// The largest difference between both runs, in parts of the scales of the motion so far; NaN counts as
// infinite.
Real VerifiedStepper::parted() {
  coarse_->read(coarse_motion_);
  fine_->read(fine_motion_);
  Real position = 0, turn = 0, speed = 0, spin = 0;
  for (const std::size_t i : movable_) {
    const Motion &a = fine_motion_[i], &b = coarse_motion_[i];
    const Vector3 v_a = velocity(bodies_[i], a), v_b = velocity(bodies_[i], b);
    const Vector3 w_a = angular_velocity(bodies_[i], a), w_b = angular_velocity(bodies_[i], b);
    length_ = std::max(length_, a.position.norm());
    speed_ = std::max(speed_, v_a.norm());
    turn_ = std::max(turn_, w_a.norm());
    position = worse(position, (a.position - b.position).norm());
    turn = worse(turn, angle(a.orientation, b.orientation));
    speed = worse(speed, (v_a - v_b).norm());
    spin = worse(spin, (w_a - w_b).norm());
  }
  // What hardly moves is measured by what would take it across its own size in the time so far.
  const Real span = static_cast<Real>(static_cast<Time>(steps_) * dt_);
  Real error = worse(share(position, length_), turn);
  error = worse(error, share(speed, std::max(speed_, length_ / span)));
  error = worse(error, share(spin, std::max(turn_, 1 / span)));
  return std::isfinite(error) ? error : std::numeric_limits<Real>::infinity();
}

// A run from the start up to the present sample, or until it gives up.
std::unique_ptr<Stepper> VerifiedStepper::replay(Real tolerance) const {
  auto run = make_(tolerance);
  run->keep_contacts(keep_);
  for (std::int64_t i = 0; i < steps_ && !run->gave_up(); ++i) run->step();
  return run;
}

// The finer run becomes the coarser one; another starts from the start at a tenth of its tolerance.  Where that one
// ends before the sample, or gives up, the two stay as they are.
bool VerifiedStepper::tighten() {
  const Real tolerance = std::max(tolerance_ / 10, least);
  auto finer = replay(tolerance);
  if (finer->gave_up() || (ended(*finer) && !ended(*fine_))) {
    spent_ += finer->operations();
    return false;
  }
  tolerance_ = tolerance;
  spent_ += coarse_->operations();
  coarse_ = std::move(fine_);
  fine_ = std::move(finer);
  return true;
}

// The coarser run takes the place of the finer one, which ended, and one at ten times its tolerance its own.
void VerifiedStepper::loosen() {
  tolerance_ *= 10;
  spent_ += fine_->operations();
  fine_ = std::move(coarse_);
  coarse_ = replay(10 * tolerance_);
}

// Two coarser runs take the place of both, unless they give up as well.
bool VerifiedStepper::loosen_far() {
  if (!reserve_ || 10 * far * tolerance_ > largest) return false;
  *std::exchange(reserve_, nullptr) = second_operations;
  auto fine = replay(far * tolerance_), coarse = replay(10 * far * tolerance_);
  const bool goes_on = !fine->gave_up() && !coarse->gave_up() && !ended(*fine);
  if (goes_on) {
    std::swap(fine, fine_);
    std::swap(coarse, coarse_);
    tolerance_ *= far;
    loosened_ = true;
  }
  spent_ += fine->operations() + coarse->operations();
  return goes_on;
}

std::vector<Diagnostic> VerifiedStepper::diagnostics() const {
  const auto at = [this](std::int64_t step) { return static_cast<Time>(first_ + step) * dt_; };
  DiagnosticLog log;
  const auto bound = static_cast<double>(bound_);
  if (missed_at_ >= 0)
    log.note(DiagnosticKind::tolerance_missed, at(missed_at_), bound, static_cast<double>(worst_),
             loosened_ ? "larger local tolerances, taken where operations came to an end,"
                       : "the two finest local tolerances");
  if (unknown_at_ >= 0)
    log.note(DiagnosticKind::tolerance_unknown, at(unknown_at_), bound);
  else if (missed_at_ < 0 && waiting_)
    log.note(DiagnosticKind::last_not_compared, at(steps_), bound, static_cast<double>(last_));
  std::vector<Diagnostic> all = log.all();
  for (Diagnostic& d : fine_->diagnostics()) {
    // Rounding above a local tolerance matters where the two runs part for it.
    if (d.kind == DiagnosticKind::rounding_exceeds && missed_at_ < 0 && unknown_at_ < 0) continue;
    all.push_back(std::move(d));
  }
  return all;
}

}  // namespace cylon::engine
