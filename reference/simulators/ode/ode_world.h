// What ODE allocates: the library's global state, and one world.  Included by the adapter's own sources only.
#pragma once

#include "reference/simulators/ode/ode_shapes.h"

#include <ode/ode.h>

namespace cylon::simulators {

/// Global state of the library, from the first simulator to the end of the program.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  static void enter() {
    static const Library library;
    dAllocateODEDataForThread(
        static_cast<unsigned>(dAllocateMaskAll));  // once per thread; later calls cost nothing
  }
};

/// Owns what ODE allocates for one world.
struct World {
  OdeSurfaces surfaces;  // goes last
  dWorldID id = dWorldCreate();
  dSpaceID space = dHashSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  dThreadingImplementationID threading = dThreadingAllocateSelfThreadedImplementation();

  World() {
    dWorldSetStepThreadingImplementation(id, dThreadingImplementationGetFunctions(threading), threading);
  }
  ~World() {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(id);
    dThreadingFreeImplementation(threading);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
};

}  // namespace cylon::simulators
