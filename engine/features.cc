#include "engine/features.h"

#include <array>

namespace cylon::engine {

namespace {

struct Name {
  Feature feature;
  const char* text;
};

constexpr std::array feature_names = {
    Name{Feature::locked_body, "locked bodies"},
    Name{Feature::spin, "spinning bodies"},
    Name{Feature::changing_mass, "changing masses"},
    Name{Feature::pinned_body, "bodies pinned at a point"},
    Name{Feature::one_axis_body, "bodies held on an axis"},
    Name{Feature::spring, "springs"},
    Name{Feature::damped_spring, "damped springs"},
    Name{Feature::off_centre_spring, "springs that pull off centre"},
    Name{Feature::drag, "drag"},
    Name{Feature::thrust, "thrust"},
    Name{Feature::drive, "drives"},
    Name{Feature::attraction, "bodies that attract each other"},
    Name{Feature::water, "water"},
    Name{Feature::unknown_displacement, "the volume of a capsule below a water surface"},
    Name{Feature::joint_together, "joints at a point"},
    Name{Feature::joint_at_length, "joints at a length"},
    Name{Feature::joint_about_axis, "joints about an axis"},
    Name{Feature::joint_never, "joints that keep the orientation"},
    Name{Feature::contact, "contacts"},
    Name{Feature::lasting_contact, "contacts that persist"},
    Name{Feature::friction, "friction"},
    Name{Feature::sphere, "spheres that touch"},
    Name{Feature::box, "boxes that touch"},
    Name{Feature::capsule, "capsules that touch"},
    Name{Feature::hull, "hulls that touch"},
    Name{Feature::turning_frame, "a rotating frame"},
    Name{Feature::contact_in_turning_frame, "contacts in a rotating frame"},
    Name{Feature::world_joint_in_turning_frame, "joints to the world in a rotating frame"},
    Name{Feature::force_in_turning_frame, "drag in a rotating frame"},
    Name{Feature::chosen_integrator, "a chosen integrator"},
    Name{Feature::account, "the work of each force"},
    Name{Feature::every_stage, "option model = full"},
    Name{Feature::path_events, "the path events"},
    Name{Feature::path_stepping, "the path stepping"},
};

constexpr bool one_name_each() {
  if (feature_names.size() != static_cast<std::size_t>(Feature::count)) return false;
  for (std::size_t i = 0; i < feature_names.size(); ++i)
    if (feature_names[i].feature != static_cast<Feature>(i)) return false;
  return true;
}
static_assert(one_name_each(), "every feature has a name, in the order of the enumeration");

}  // namespace

std::string names(Features features) {
  std::string text;
  for (const Name& name : feature_names)
    if (features.has(name.feature)) text += (text.empty() ? "" : ", ") + std::string(name.text);
  return text;
}

}  // namespace cylon::engine
