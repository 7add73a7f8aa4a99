// The headers of Siconos that this adapter needs, as one.
#pragma once

#include <siconos/numerics/SolverOptions.h>
#include <siconos/kernel/BlockVector.hpp>
#include <siconos/kernel/FrictionContact.hpp>
#include <siconos/kernel/Interaction.hpp>
#include <siconos/kernel/LCP.hpp>
#include <siconos/kernel/MoreauJeanOSI.hpp>
#include <siconos/kernel/NewtonEuler1DR.hpp>
#include <siconos/kernel/NewtonEuler3DR.hpp>
#include <siconos/kernel/NewtonEulerDS.hpp>
#include <siconos/kernel/NewtonImpactFrictionNSL.hpp>
#include <siconos/kernel/NewtonImpactNSL.hpp>
#include <siconos/kernel/NonSmoothDynamicalSystem.hpp>
#include <siconos/kernel/SiconosVector.hpp>
#include <siconos/kernel/SimpleMatrix.hpp>
#include <siconos/kernel/TimeDiscretisation.hpp>
#include <siconos/kernel/TimeStepping.hpp>
