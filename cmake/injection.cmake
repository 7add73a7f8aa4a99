# Builds that are worse in a known way, to show that `cylon track gate` finds them (docs/ci.md).  Never released: the
# defaults change nothing, to the last bit of the binary.
set(CYLON_INJECT_SLOWDOWN 0 CACHE STRING "The in-house engine's steps take this many percent longer; 0: none")
set(CYLON_INJECT_FAULT "" CACHE STRING "scheme-constant: the inner coefficient of rk4 is 20 % too large; empty: none")
set_property(CACHE CYLON_INJECT_FAULT PROPERTY STRINGS "" scheme-constant)

if(NOT CYLON_INJECT_SLOWDOWN EQUAL 0)
  target_compile_definitions(sim_in_house PRIVATE CYLON_INJECT_SLOWDOWN=${CYLON_INJECT_SLOWDOWN})
endif()
if(CYLON_INJECT_FAULT STREQUAL "scheme-constant")
  target_compile_definitions(engine PRIVATE CYLON_SPOILED=1.2)
elseif(NOT CYLON_INJECT_FAULT STREQUAL "")
  message(FATAL_ERROR "CYLON_INJECT_FAULT='${CYLON_INJECT_FAULT}': must be empty or scheme-constant")
endif()
