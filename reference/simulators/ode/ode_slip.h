// The first friction direction of a contact along its slip.
#pragma once

struct dContact;
struct dxBody;  // ODE's body

namespace cylon::simulators {

/// t = s/|s| with the slip s = v - (v.n) n of the first body's point against the second's; ODE's own where |s|
/// is too small to have a direction.  Null: what rests.
void ode_turn_along_slip(dContact&, dxBody* first, dxBody* second);

}  // namespace cylon::simulators
