// The rows.  The first is the default where nobody chooses.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/integrators/splittings.h"
#include "engine/integrators/tableaus.h"

#include <array>

namespace cylon::engine {

inline constexpr std::string_view symplectic_conserves =
    "linear and angular momentum to rounding; energy bounded (symplectic) without damping, joints and "
    "impacts";

inline constexpr std::array<Integrator, 13> integrator_table = {{
    {.name = "rk4",
     .order = 4,
     .drag_order = 4,
     .evaluations = 4,
     .kind = Kind::runge_kutta,
     .conserves = "linear momentum to rounding; energy and angular momentum to O(h^4)",
     .tableau = {rk4_nodes, rk4_matrix, rk4_weights}},

    // The seed's own, eq. 57-64.  Energy grows by 1 + (omega h)^2 a step on a spring (errata 13).
    {.name = "explicit-euler",
     .order = 1,
     .drag_order = 1,
     .evaluations = 1,
     .kind = Kind::runge_kutta,
     .conserves = "linear momentum to rounding; energy grows",
     .tableau = {euler_nodes, euler_matrix, euler_weights}},

    {.name = "rk8",
     .order = 8,
     .drag_order = 8,
     .evaluations = 12,
     .kind = Kind::runge_kutta,
     .conserves = "linear momentum to rounding; energy and angular momentum to O(h^8)",
     .tableau = {dop853::nodes, dop853::matrix, dop853::weights}},

    {.name = "dop853",
     .order = 8,
     .drag_order = 8,
     .evaluations = 12,
     .kind = Kind::adaptive,
     .conserves = "linear momentum to rounding; all else to the tolerance",
     .tableau = {dop853::nodes, dop853::matrix, dop853::weights}},

    // Lie and Trotter's splitting: the momenta by the forces, then free motion with the new momenta (errata
    // 13), in which a body turns exactly.  Of points it is symplectic Euler; of bodies that turn it is more,
    // hence the name.
    {.name = "lie-trotter",
     .order = 1,
     .drag_order = 1,
     .evaluations = 1,
     .symplectic = true,
     .constraints = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::kick, euler_parts, whole_step}},

    {.name = "velocity-verlet",
     .order = 2,
     .drag_order = 2,
     .evaluations = 2,
     .symplectic = true,
     .reversible = true,
     .constraints = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::kick, verlet_parts, whole_step}},

    {.name = "stormer-verlet",
     .order = 2,
     .drag_order = 2,
     .evaluations = 1,
     .symplectic = true,
     .reversible = true,
     .constraints = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::drift, verlet_parts, whole_step}},

    {.name = "yoshida4",
     .order = 4,
     .drag_order = 4,
     .evaluations = 4,
     .symplectic = true,
     .reversible = true,
     .constraints = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::kick, yoshida4_parts, yoshida4_weights}},

    {.name = "yoshida6",
     .order = 6,
     .drag_order = 6,
     .evaluations = 8,
     .symplectic = true,
     .reversible = true,
     .constraints = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::kick, yoshida6_parts, yoshida6_weights}},

    {.name = "bm4",
     .order = 4,
     .drag_order = 4,
     .evaluations = 6,
     .symplectic = true,
     .reversible = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::drift, bm4_parts, {}}},

    {.name = "bm6",
     .order = 6,
     .drag_order = 6,
     .evaluations = 10,
     .symplectic = true,
     .reversible = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::drift, bm6_parts, {}}},

    {.name = "rkn4",
     .order = 4,
     .drag_order = 4,  // the conditions of order 4 are met in full; only its error is optimised without
     .evaluations = 7,
     .symplectic = true,
     .reversible = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::kick, rkn4_parts, {}}},

    {.name = "rkn6",
     .order = 6,
     .drag_order = 4,
     .evaluations = 14,
     .symplectic = true,
     .reversible = true,
     .conserves = symplectic_conserves,
     .splitting = {Part::drift, rkn6_parts, {}}},
}};

}  // namespace cylon::engine
