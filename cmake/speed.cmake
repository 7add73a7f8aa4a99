# How fast it compiles: a compiler cache, optimisation where numbers are computed, headers compiled once.

# ---- Compiler cache: what one clone compiled, a clone in another folder finds -----------------------
# The inode cache remembers the hashes of files that did not change: of a precompiled header's 140 to 190 MB above all,
# which every hit would read anew.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_INODECACHE=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

# ---- Kinds of source: one set of flags and one precompiled header each ------------------------------
#   engine   what the user waits for while it runs: -O3
#   numbers  what computes a number of a verdict: -O2, which gives the bits of -O3
#   text     what reads, writes and shows: -O1
#   json     the same of JSON, whose header costs 0.8 s in every source, used or not, and saves more where it is used
#   test     -O1
set(optimised_numbers -O2)
set(optimised_text -O1)
set(optimised_json -O1)
set(optimised_test -O1)

set(headers_std <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numbers> <optional> <set>
  <span> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
set(headers_engine ${headers_std} <Eigen/Dense>)
# A scene is what nearly all of them are about: to read its header takes 0.8 s.
set(headers_numbers ${headers_std} <chrono> <filesystem> <sstream> <Eigen/Core> <Eigen/Geometry> <cmake/templates/eigen.h>
  <fmt/ranges.h> <cmake/templates/fmt.h> <harness/core/scene.h>)
set(headers_text ${headers_numbers} <iostream>)
set(headers_json ${headers_text} <cmake/templates/json.h>)
set(headers_test ${headers_numbers} <random> <gtest/gtest.h>)

# What precompiled headers declare as compiled elsewhere.
add_library(templates STATIC cmake/templates/eigen.cc cmake/templates/fmt.cc cmake/templates/json.cc)
declare(templates KIND layer PLACES cmake/templates/ PUBLIC Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
target_compile_options(templates PRIVATE $<$<CONFIG:Release>:${optimised_text}>)
target_include_directories(templates PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(templates PRIVATE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json warnings)

# compiled_as(target kind): its flags, and the kind's precompiled header.  The header is a speed-up alone: every source
# includes what it uses, and builds with -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
function(compiled_as target kind)
  if(NOT TARGET headers_${kind})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/${kind}.cc CONTENT "// Carries the precompiled header.\n")
    add_library(headers_${kind} OBJECT ${PROJECT_BINARY_DIR}/headers/${kind}.cc)
    target_include_directories(headers_${kind} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(headers_${kind} PRIVATE Eigen3::Eigen nlohmann_json::nlohmann_json
                          $<$<STREQUAL:${kind},test>:GTest::gtest> warnings)
    target_precompile_headers(headers_${kind} PRIVATE ${headers_${kind}})
  endif()
  foreach(one ${target} headers_${kind})
    target_compile_options(${one} PRIVATE $<$<CONFIG:Release>:${optimised_${kind}}>)
    # gcc takes the header only where the macros that it has asked for are the same.
    target_compile_definitions(${one} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endforeach()
  target_precompile_headers(${target} REUSE_FROM headers_${kind})
  target_link_libraries(${target} PRIVATE templates)
endfunction()
