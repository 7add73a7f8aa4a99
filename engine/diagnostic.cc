#include "engine/diagnostic.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cylon::engine {

using K = DiagnosticKind;

const std::array<DiagnosticRow, static_cast<std::size_t>(DiagnosticKind::count)> diagnostic_rows = {{
    {K::forced, "forced", "", "", "runs by force; else refused: {cause}"},
    {K::deep_overlap, "deep-overlap", "m", "m",
     "{cause} overlap by {reached} m at the start, more than {limit} m, a tenth of the thinner one's width: "
     "the direction in which they would separate is not defined"},
    {K::jointed_overlap, "jointed-overlap", "m", "m",
     "{cause} overlap by {reached} m at the start, more than {limit} m, a tenth of the thinner one's width, "
     "and are connected by joints: they do not collide with each other"},
    {K::not_divided, "not-divided", "bodies", "bodies",
     "more than {limit} bodies ({reached}) may touch others: they are one island, however far apart"},
    {K::merged, "merged", "", "", "from t = {since} s on these may meet and are one island"},
    {K::parted, "parted", "", "", "from t = {since} s on an island of its own"},
    {K::not_followed, "not-followed", "", "", "from t = {since} s on in fixed steps, because {cause}"},
    {K::handed_over, "handed-over", "", "", "closed form until t = {since} s, then {cause}"},
    {K::path_not_taken, "path-not-taken", "", "",
     "path {cause} was asked for, but nothing can touch: it is not taken"},
    {K::tolerance_not_kept, "tolerance-not-kept", "1", "",
     "path stepping: {cause}; the tolerance {limit} that was asked for is not kept"},
    {K::error_not_controlled, "error-not-controlled", "", "",
     "path stepping: {cause}; the error is not controlled"},
    {K::tolerance_missed, "tolerance-missed", "1", "1",
     "auto: from t = {since} s on the tolerance {limit} is not reached: solutions at {cause} "
     "differ by up to {reached} of the scales of the motion (chaos or ill-conditioning)"},
    {K::last_not_compared, "last-not-compared", "1", "1",
     "auto: the sample at t = {since} s lies within a step of an impact: solutions at the two finest local "
     "tolerances differ by {reached} of the scales of the motion there, beside the tolerance {limit}"},
    {K::tolerance_unknown, "tolerance-unknown", "1", "",
     "auto: from t = {since} s on the error is not known, and the tolerance {limit} may be missed: the "
     "solution used a fallback that does not obey the contact laws exactly, so that the agreement of two "
     "solutions proves nothing"},
    {K::rounding_exceeds, "rounding-exceeds", "", "",
     "in {count} steps of the integrator, from t = {since} s on, rounding of the forces makes errors above "
     "the "
     "local tolerance, and shorter steps would not make them smaller"},
    {K::integration_ended, "integration-ended", "", "", "integration stopped at t = {since} s: {cause}"},
    {K::switches_not_located, "switches-not-located", "switches", "",
     "from t = {since} s on a force switches on and off more than {limit} times in a step: its switching "
     "times are not located"},
    {K::series_not_ended, "series-not-ended", "parts", "",
     "from t = {since} s on {count} substeps were too long for velocity-dependent forces, even after "
     "division into {limit} parts: the motion is not a number"},
    {K::drift_open, "drift-open", "rounds", "m, rad",
     "in {count} substeps, from t = {since} s on, the joint iteration (SHAKE) did not close the joints in "
     "{limit} iterations; the largest gap is {reached} m or rad: the step is too long"},
    {K::joints_open, "joints-open", "rounds", "m, rad",
     "at {count} instants, from t = {since} s on, the joints were not closed in {limit} iterations; the "
     "largest gap is {reached} m or rad"},
    {K::contacts_open, "contacts-open", "rounds", "m, rad",
     "at {count} instants, from t = {since} s on, persistent contacts and joints were not closed in {limit} "
     "iterations; the largest gap is {reached} m or rad"},
    {K::forces_inexact, "forces-inexact", "", "m/s²",
     "{count} contact problems, from t = {since} s on, were solved iteratively, not to rounding: "
     "accelerations at contacts are off by up to {reached} m/s²"},
    {K::loads_undecided, "loads-undecided", "", "m/s²",
     "at {count} instants, from t = {since} s on, rigid bodies leave open how much of a load each of several "
     "sliding points carries: it is shared evenly; shared otherwise, they would accelerate by up to "
     "{reached} "
     "m/s² more or less"},
    {K::impacts_inexact, "impacts-inexact", "", "m/s",
     "{count} impacts, from t = {since} s on, were solved iteratively, not to rounding: velocities at "
     "contacts are off by up to {reached} m/s"},
    {K::interval_missed, "interval-missed", "", "",
     "{count} integration intervals, from t = {since} s on, did not reach the tolerance"},
    {K::meeting_not_searched, "meeting-not-searched", "", "m",
     "{count} searches for collisions, from t = {since} s on, reached their limit of work: surfaces may have "
     "overlapped by up to {reached} m unnoticed"},
    {K::changes_not_searched, "changes-not-searched", "", "",
     "{count} times, from t = {since} s on, contacts changed too often at one instant: the interval after it "
     "was not searched for contact changes"},
    {K::impacts_ordered, "impacts-ordered", "", "",
     "at {count} instants, from t = {since} s on, a body had several impacts at once: they were resolved one "
     "after another, in the order of the bodies in the scene; in another order the motion after them may be "
     "another"},
    {K::impacts_unending, "impacts-unending", "rounds", "",
     "{count} impacts of several pairs, from t = {since} s on, did not end one after another in {limit} "
     "iterations: they were solved at once, without restitution"},
    {K::frictionless, "frictionless", "", "",
     "at {count} instants, from t = {since} s on, Coulomb friction had no solution, or stick and slip "
     "alternated too often: these contacts had no friction for the rest of the step"},
    {K::wedged, "wedged", "", "",
     "at {count} instants, from t = {since} s on, friction grew without bound: an impulse stopped the slip"},
    {K::crawled, "crawled", "", "m/s",
     "at {count} instants, from t = {since} s on, contacts alternated between stick and slip without end, or "
     "friction jammed: impulses within the friction cones advanced the motion over a short time, with "
     "contact velocities off by up to {reached} m/s"},
    {K::slip_turned_late, "slip-turned-late", "", "m/s",
     "from t = {since} s on, the direction of friction follows late at slips slower than {reached} m/s: "
     "velocities after such a slip are right to about that"},
    {K::plastic, "plastic", "events", "",
     "{count} steps, from t = {since} s on, had more than {limit} events: for the rest of these steps, "
     "contacts had no restitution and no friction"},
    {K::not_located, "not-located", "", "m/s",
     "{count} steps, from t = {since} s on, had more events than the limit: the rest of these steps was made "
     "in {cause} of first order, without location of events, with contact velocities off by up to {reached} "
     "m/s"},
    {K::too_fast, "too-fast", "parts", "",
     "in {count} steps, from t = {since} s on, bodies moved farther than half the smallest half-width in "
     "1/{limit} of a step: they may have passed through each other"},
    {K::contacts_unsolved, "contacts-unsolved", "", "m/s",
     "contact and joint equations were solved only to {reached} m/s: {count} times, from t = {since} s on"},
    {K::contacts_swept, "contacts-swept", "sweeps", "m/s",
     "contacts of many bodies were solved by sweeps, up to {limit} in a step: in {count} steps, from t = "
     "{since} s on, contact velocities were off by up to {reached} m/s at the end"},
    {K::overlaps_unsolved, "overlaps-unsolved", "", "m",
     "{count} corrections of overlaps, from t = {since} s on, were solved only to {reached} m"},
    {K::joints_drifted, "joints-drifted", "rounds", "m, rad",
     "after {count} steps, from t = {since} s on, the joints were not closed in {limit} iterations; the "
     "largest gap is {reached} m or rad"},
    {K::joint_forces_implicit, "joint-forces-implicit", "forces", "",
     "{limit} forces in joints are too stiff for steps of this length: they are integrated implicitly, which "
     "damps their oscillations"},
    {K::gimbal_passed, "gimbal-passed", "", "rad",
     "in {count} steps, from t = {since} s on, a gimbal came close to parallel axes, where its angles are "
     "singular: the angle between the axes changed by up to {reached} rad, more than half its distance from "
     "parallel, and the motion after that is not reliable"},
    {K::gimbal_parallel, "gimbal-parallel", "", "rad",
     "from t = {since} s on the motion is not a number: the axes of a gimbal become parallel, where its "
     "angles have no values and what acts on them grows without bound; they were {reached} rad from that a "
     "step before"},
    {K::stiff, "stiff", "parts", "",
     "steps are divided into up to {limit} parts: {cause} is too stiff for longer ones"},
    {K::unstable, "unstable", "s", "",
     "steps longer than {limit} s are unstable where {cause} acts in full: the motion may grow without "
     "limit"},
    {K::solved_at_once, "solved-at-once", "", "",
     "impacts = sequential was not kept in {count} substeps, from t = {since} s on: sweeps solved impacts of "
     "one body, or one and what it presses the body onto, at once"},
    {K::solved_in_turn, "solved-in-turn", "", "",
     "impacts = simultaneous was not kept in {count} steps, from t = {since} s on: impacts of one body at "
     "one instant were solved one after another"},
    {K::blows_swept, "blows-swept", "spheres", "",
     "from t = {since} s on, sweeps passed on blows of spheres without restitution, as there are more than "
     "{limit}: "
     "up to a quarter of such a blow comes back"},
    {K::approaching, "approaching", "rounds", "",
     "impacts of spheres within a substep did not end in {limit} iterations, {count} times from t = {since} "
     "s on: the pairs that still approached were solved as contacts in the next substep"},
    {K::facets_unsettled, "facets-unsettled", "rounds", "m",
     "at {count} contacts of round bodies, from t = {since} s on, the contact point was not found in {limit} "
     "iterations: its gap is off by at most {reached} m"},
    {K::points_left_out, "points-left-out", "points", "",
     "{count} contacts, from t = {since} s on, had more than {limit} points; only the deepest and the "
     "outermost were kept: the supporting area may be taken too small"},
    {K::more, "more", "", "", "{count} more diagnostics are not listed"},
}};

namespace {

std::string shown(double x, int digits) {
  std::ostringstream text;
  text.precision(digits);
  if (std::abs(x) < 1e9 && x == std::floor(x))
    text << static_cast<std::int64_t>(x);
  else
    text << x;
  return text.str();
}

void replace(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

std::string names_of(const IslandName& island, const Names& names) {
  std::string text;
  for (const int body : island.bodies) text += (text.empty() ? "" : ", ") + names(Thing::body, body);
  if (island.count > island.bodies.size())
    text += " and " + std::to_string(island.count - island.bodies.size()) + " more";
  return text;
}

std::string sentence(const Diagnostic& d, const Names& names) {
  std::string text(row(d.kind).text);
  replace(text, "{since}", shown(static_cast<double>(d.since), 6));
  replace(text, "{count}", std::to_string(d.count));
  replace(text, "{limit}", shown(d.limit.value_or(0), 4));
  replace(text, "{reached}", shown(d.reached.value_or(0), 4));
  replace(text, "{cause}", d.cause);  // last: nothing in it is replaced
  if (!d.island.whole) text = names_of(d.island, names) + ": " + text;
  if (d.until) text = "until t = " + shown(static_cast<double>(*d.until), 6) + " s " + text;
  return text;
}

std::vector<std::string> sentences(const std::vector<Diagnostic>& all, const Names& names) {
  std::vector<std::string> texts;
  for (const Diagnostic& d : all) texts.push_back(sentence(d, names));
  return texts;
}

bool same_matter(const Diagnostic& a, const Diagnostic& b) {
  return a.kind == b.kind && a.cause == b.cause && a.island.count == b.island.count &&
         a.island.bodies == b.island.bodies;
}

void add(const Diagnostic& more, Diagnostic& to) {
  to.since = std::min(to.since, more.since);
  to.count += more.count;
  if (more.limit) to.limit = more.limit;
  if (more.reached) to.reached = std::max(*more.reached, to.reached.value_or(0));
  if (!more.cause.empty()) to.cause = more.cause;
  if (more.until) to.until = more.until;
}

void DiagnosticLog::note(DiagnosticKind kind, Time now, std::optional<double> limit,
                         std::optional<double> reached, const std::string& cause) {
  // A splitting of high order also goes back in time, in its first step to before the start.
  take({.kind = kind, .since = std::max(now, Time(0)), .limit = limit, .reached = reached, .cause = cause});
}

void DiagnosticLog::take(const Diagnostic& one) {
  const auto at = std::lower_bound(noted_.begin(), noted_.end(), one.kind,
                                   [](const Diagnostic& d, DiagnosticKind k) { return d.kind < k; });
  if (at != noted_.end() && at->kind == one.kind)
    add(one, *at);
  else
    noted_.insert(at, one);
}

bool DiagnosticLog::has(DiagnosticKind kind) const {
  return std::any_of(noted_.begin(), noted_.end(), [&](const Diagnostic& d) { return d.kind == kind; });
}

std::vector<Diagnostic> DiagnosticLog::all() const { return noted_; }

}  // namespace cylon::engine
