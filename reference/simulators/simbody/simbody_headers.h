// Simbody's headers, as C++20 takes them.
#pragma once

// Simbody 3.7 is written for C++11.  Its indices compare with each kind of whole number as members, and in C++20, which
// also tries them the other way round, two indices are ambiguous.  Comparisons of two indices are exact, and go first.
namespace SimTK {
class CacheEntryIndex;
class ContactCliqueId;
class ContactGeometryTypeId;
class DiscreteVariableIndex;
class SubsystemIndex;
bool operator==(const CacheEntryIndex&, const CacheEntryIndex&);
bool operator==(const ContactCliqueId&, const ContactCliqueId&);
bool operator==(const ContactGeometryTypeId&, const ContactGeometryTypeId&);
bool operator==(const DiscreteVariableIndex&, const DiscreteVariableIndex&);
bool operator==(const SubsystemIndex&, const SubsystemIndex&);
}  // namespace SimTK

// Debian builds Simbody with its checks on, and what they check is part of its types (SimTKcommon/internal/StateImpl.h):
// sources without them crash.
#ifdef NDEBUG
#undef NDEBUG
#include <simbody/SimTKsimbody.h>
#define NDEBUG
#else
#include <simbody/SimTKsimbody.h>
#endif

namespace SimTK {
inline bool operator==(const CacheEntryIndex& a, const CacheEntryIndex& b) { return int(a) == int(b); }
inline bool operator==(const ContactCliqueId& a, const ContactCliqueId& b) { return int(a) == int(b); }
inline bool operator==(const ContactGeometryTypeId& a, const ContactGeometryTypeId& b) {
  return int(a) == int(b);
}
inline bool operator==(const DiscreteVariableIndex& a, const DiscreteVariableIndex& b) {
  return int(a) == int(b);
}
inline bool operator==(const SubsystemIndex& a, const SubsystemIndex& b) { return int(a) == int(b); }
}  // namespace SimTK
