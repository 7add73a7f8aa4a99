#include "harness/scenario/claim_label.h"

#include <fmt/format.h>

namespace cylon::scenario {

using core::Observable;
using core::Quantity;
using core::Reduction;

std::string label_of(const Table& t, const core::Claim& claim) {
  const Observable& q = claim.observable;
  std::string label(core::name(q.quantity));
  label += claim.follows.empty() ? " conserved" : " follows " + claim.follows;
  if (q.quantity == Quantity::event)
    label += fmt::format(", {}{} {}", core::name(q.event),
                         q.event_quantity == core::EventQuantity::order ? "" : fmt::format(" {}", q.index),
                         core::name(q.event_quantity));
  if (t.has("body")) label += ", " + t.text("body");
  if (t.has("to")) label += ", to " + t.text("to");
  if (q.component != core::Component::all) label += ", " + t.text("component");
  if (t.has("about")) label += fmt::format(", about {} {} {}", q.about.x(), q.about.y(), q.about.z());
  if (t.has("until")) label += fmt::format(", until {}{}", t.is_text("until") ? "horizon " : "", claim.until);
  if (claim.reduction != Reduction::max) label += ", " + t.text("measure");
  if (claim.tolerance.order) label += ", order";
  return label;
}

}  // namespace cylon::scenario
