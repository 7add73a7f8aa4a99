# How fast it compiles: a compiler cache, optimisation where numbers are computed, headers compiled once.

# ---- Compiler cache: what one clone compiled, a clone in another folder finds -----------------------
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

# ---- Kinds of source: one set of flags and one precompiled header each ------------------------------
#   engine   what the user waits for while it runs: -O3
#   numbers  what computes a number of a verdict: -O2, which gives the bits of -O3
#   text     commands, pages and their tests: -O1
set(optimised_numbers -O2)
set(optimised_text -O1)
set(optimised_test -O1)

set(headers_std <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <iostream> <limits> <map>
  <memory> <numbers> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
set(headers_engine <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory> <optional> <span> <string>
  <utility> <vector> <Eigen/Dense>)
set(headers_numbers ${headers_std} <Eigen/Core> <Eigen/Geometry> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)
set(headers_text ${headers_numbers})
set(headers_test ${headers_numbers} <random> <gtest/gtest.h>)

# compiled_as(target kind): its flags, and the kind's precompiled header.  The header is a speed-up alone: every source
# includes what it uses, and builds with -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
function(compiled_as target kind)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${optimised_${kind}}>)
  if(NOT TARGET headers_${kind})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/${kind}.cc CONTENT "// Carries the precompiled header.\n")
    add_library(headers_${kind} OBJECT ${PROJECT_BINARY_DIR}/headers/${kind}.cc)
    target_compile_options(headers_${kind} PRIVATE $<$<CONFIG:Release>:${optimised_${kind}}>)
    target_link_libraries(headers_${kind} PRIVATE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json
                          $<$<STREQUAL:${kind},test>:GTest::gtest> warnings)
    target_precompile_headers(headers_${kind} PRIVATE ${headers_${kind}})
  endif()
  # gcc takes the header only where the macros that it has asked for are the same.
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  target_precompile_headers(${target} REUSE_FROM headers_${kind})
endfunction()
