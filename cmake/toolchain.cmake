# How every file is compiled.  -ffp-contract=off: the same bits from -O2 and -O3, gcc and clang.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

# gcc 12 makes one rounding of a*b - c*d beside a*b + c*d (vfmaddsub) when it vectorises straight-line code, whatever
# -ffp-contract says.  These are the files in which it did; tests/determinism.sh looks for others.
set_source_files_properties(engine/body.cc engine/contact/coulomb_point.cc engine/event_holds.cc
                            engine/pile/body_contacts.cc engine/pile/crowd.cc engine/pile/islands.cc
  PROPERTIES COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
             SKIP_PRECOMPILE_HEADERS ON)  # gcc takes the options of a precompiled header in place of the source's own

set(CYLON_SANITIZE "" CACHE STRING "Sanitizers of all code: address,undefined or thread")
option(CYLON_FUZZ "libFuzzer's programs and its counters in all code; needs clang" OFF)
set(CYLON_MARCH "x86-64-v3" CACHE STRING "-march of every target")

add_compile_options(-march=${CYLON_MARCH} -ffp-contract=off)
if(CYLON_MARCH MATCHES "^x86-64-v[234]$")
  add_link_options(-Wl,-z,${CYLON_MARCH})  # an older processor is refused by the loader, not killed by its first AVX2
endif()
if(CYLON_SANITIZE)
  add_compile_options(-fsanitize=${CYLON_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${CYLON_SANITIZE})
endif()
if(CYLON_SANITIZE MATCHES undefined)
  # Left out, as they double the time to compile (22.5 to 12.5 s for engine/contact/coulomb_point.cc): null and
  # object-size, whose accesses AddressSanitizer sees itself, alignment and vptr.
  add_compile_options(-fno-sanitize=null,object-size,alignment,vptr -fno-sanitize-recover=undefined)
endif()
if(CYLON_SANITIZE STREQUAL "thread")
  # Asio has fences, which ThreadSanitizer does not see, beside mutexes, which it does.
  set_source_files_properties(harness/view/http.cc PROPERTIES COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()
if(CYLON_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Warnings are errors in our own code; foreign headers are SYSTEM.
add_library(warnings INTERFACE)
target_compile_options(warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  -Wno-missing-field-initializers  # designated initialisers leave the defaults to the struct, as they should
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>)  # false alarms of gcc 12 at -O3: bugs 105329, 105593

# What a report says of its build.
add_compile_definitions(CYLON_VERSION="${PROJECT_VERSION}")
execute_process(COMMAND git describe --always --abbrev=12 --dirty WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set_source_files_properties(reports/provenance.cc PROPERTIES COMPILE_DEFINITIONS
  "CYLON_REVISION=\"${revision}\";CYLON_FLAGS=\"${CMAKE_BUILD_TYPE} -march=${CYLON_MARCH} -ffp-contract=off\"")
if(EXISTS ${PROJECT_SOURCE_DIR}/.git/logs/HEAD)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/.git/logs/HEAD)
endif()

# Libraries beside a program are found from where it is: the folder of the build is in no program that is installed.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
