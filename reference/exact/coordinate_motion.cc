#include "reference/exact/coordinate_motion.h"

#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace cylon::exact {
namespace {

constexpr Wide never = std::numeric_limits<Wide>::infinity();
constexpr std::size_t most_pieces = 1000;

Wide sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

CoordinateMotion::CoordinateMotion(const core::JointCoordinate& law, Wide inertia, Wide pull, Wide rate,
                                   Wide horizon)
    : law_(law), inertia_(inertia), constant_(pull + Wide(law.force)), turn_(0, law.target_frequency) {
  const Wide stiffness = law.stiffness, damping = law.damping;
  const WideComplex amplitude = std::polar<Wide>(law.target_amplitude, law.target_phase);
  const bool moves = core::target_moves(law);
  constant_ += stiffness * (Wide(law.target) + (moves ? 0 : amplitude.real()));
  if (moves) push_ = (stiffness + damping * turn_) * amplitude / inertia;
  half_ = damping / (2 * inertia);
  below_ = stiffness / inertia - half_ * half_;
  if (below_ > 0) {
    slow_ = {-half_, std::sqrt(below_)};
    fast_ = std::conj(slow_);
  } else {
    fast_ = -(half_ + std::sqrt(-below_));
    slow_ = fast_.real() == 0 ? 0 : stiffness / inertia / fast_.real();  // r1 r2 = k/M
  }
  pieces_.push_back(go_on(0, law.start, rate));
  if (law.friction != 0 || core::has_limit(law)) follow(horizon);
}

CoordinateMotion::Response CoordinateMotion::response(Wide s) const {
  const WideComplex difference = exponential_difference(slow_, fast_, s);
  return {.s = difference.real(),
          .ds = (slow_ * difference + std::exp(fast_ * s)).real(),
          .push = exponential_difference(slow_, fast_, 0, s).real()};
}

CoordinateMotion::Value CoordinateMotion::along(const Piece& piece, Wide s) const {
  if (piece.held) return {piece.place, 0};
  const Response r = response(s);
  Value value = {piece.place + piece.rate * r.s + piece.acceleration * r.push,
                 piece.rate * r.ds + piece.acceleration * r.s};
  if (push_ != WideComplex(0)) {  // d/ds [a, b, c] = a [a, b, c] + [b, c]
    const WideComplex forced = exponential_difference(slow_, fast_, turn_, s);
    value.place += (push_ * forced).real();
    value.rate += (push_ * (slow_ * forced + exponential_difference(fast_, turn_, s))).real();
  }
  return value;
}

// From the state on: what holds it, or which way friction points.
CoordinateMotion::Piece CoordinateMotion::go_on(Wide t, Wide place, Wide rate) const {
  const Wide force = constant_ - Wide(law_.stiffness) * place, friction = law_.friction;
  const bool moves = core::target_moves(law_);  // then nothing holds it
  const bool pressed = (law_.upper && place >= Wide(*law_.upper) && force > 0) ||
                       (law_.lower && place <= Wide(*law_.lower) && force < 0);
  if (rate == 0 && !moves && (pressed || std::abs(force) <= friction)) return {t, place, 0, 0, true};
  const Wide way = rate != 0 ? sign(rate) : sign(force);
  return {t, place, rate, (force - way * friction) / inertia_};
}

// The first s > 0 at which  v0 [r1, r2]' + a0 [r1, r2] = 0, that is, with w^2 = k/M - (c/(2 M))^2 and b^2 = -w^2,
//   tan(w s)/w = tanh(b s)/b = v0/(c/(2 M) v0 - a0).
Wide CoordinateMotion::turn_after(const Piece& piece) const {
  const Wide v = std::abs(piece.rate), rest = (half_ * piece.rate - piece.acceleration) * sign(piece.rate);
  if (below_ > 0) {
    const Wide w = std::sqrt(below_);
    return piece.rate == 0 ? std::acos(Wide(-1)) / w : std::atan2(v * w, rest) / w;
  }
  if (piece.rate == 0) return never;
  const Wide b = std::sqrt(-below_);
  if (b == 0) return rest > 0 ? v / rest : never;
  return rest > v * b ? std::atanh(v * b / rest) / b : never;
}

// When it comes to a stop that it is past at `within`, up to which it goes one way: Newton's method in a bracket.
Wide CoordinateMotion::reaches(const Piece& piece, Wide stop, Wide within) const {
  Wide early = 0, late = within, s = within / 2;
  const Wide way = sign(along(piece, within).place - piece.place);
  for (int i = 0; i < 200; ++i) {
    const Value here = along(piece, s);
    const Wide past = way * (here.place - stop);
    (past < 0 ? early : late) = s;
    Wide next = s - past / (way * here.rate);
    if (!(early <= next && next <= late)) next = (early + late) / 2;
    if (next == s) break;
    s = next;
  }
  return s;
}

void CoordinateMotion::follow(Wide horizon) {
  while (!pieces_.back().held && pieces_.back().start <= horizon) {
    const Piece piece = pieces_.back();
    if (pieces_.size() > most_pieces) throw std::domain_error("turns or strikes a stop more than 1000 times");
    const Wide turn = turn_after(piece), left = std::min(turn, horizon - piece.start + 1);
    const Wide way = piece.rate != 0 ? sign(piece.rate) : sign(piece.acceleration);
    const auto& stop = way > 0 ? law_.upper : law_.lower;
    if (stop && way * (along(piece, left).place - Wide(*stop)) >= 0) {
      const bool there = way * (piece.place - Wide(*stop)) >= 0;  // it starts at the stop that it moves into
      const Wide s = there ? 0 : reaches(piece, *stop, left);
      pieces_.push_back(go_on(piece.start + s, *stop, -Wide(law_.restitution) * along(piece, s).rate));
      continue;
    }
    if (turn == never) return;
    pieces_.push_back(go_on(piece.start + turn, along(piece, turn).place, 0));
  }
}

std::vector<Wide> CoordinateMotion::starts() const {
  std::vector<Wide> times;
  for (const Piece& piece : pieces_) times.push_back(piece.start);
  return times;
}

std::size_t CoordinateMotion::piece_at(Wide t) const {
  const auto next = std::ranges::upper_bound(pieces_, t, {}, &Piece::start);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - pieces_.begin() - 1, 0));
}

CoordinateMotion::Value CoordinateMotion::at(std::size_t piece, Wide t) const {
  return along(pieces_[piece], t - pieces_[piece].start);
}

}  // namespace cylon::exact
