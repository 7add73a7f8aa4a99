# Fuzz targets of tests/fuzz/targets.txt: their table as C++ and, in the preset `fuzz`, a libFuzzer program of each.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS tests/fuzz/targets.txt)
file(STRINGS tests/fuzz/targets.txt rows REGEX "^[^#]")

if(CYLON_FUZZ)
  # clang 14 has no coroutines with libstdc++'s headers; the targets ask http_head.cc and gate.cc and open no socket.
  set_source_files_properties(harness/view/http.cc PROPERTIES HEADER_FILE_ONLY ON)
endif()

add_custom_target(fuzzers)
set(fuzz_rows "")
foreach(row IN LISTS rows)
  string(REGEX REPLACE "[ \t]+" ";" row "${row}")
  list(POP_FRONT row name seeds)
  string(APPEND fuzz_rows "      {\"${name}\", ${name}, \"${seeds}\"},\n")
  if(CYLON_FUZZ)
    # One program each: libFuzzer looks at the counters of all code that is linked after every execution.
    add_executable(fuzz-${name} EXCLUDE_FROM_ALL tests/fuzz/libfuzzer.cc)
    target_compile_definitions(fuzz-${name} PRIVATE CYLON_FUZZ_TARGET=${name})
    target_link_libraries(fuzz-${name} PRIVATE fuzz_targets warnings)
    target_link_options(fuzz-${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers fuzz-${name})
  endif()
endforeach()
declare(fuzzers KIND tests PLACES tests/fuzz/libfuzzer.cc PRIVATE fuzz_targets)

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/fuzz_table.cc @ONLY CONTENT [[
// Generated from tests/fuzz/targets.txt.
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

std::span<const Target> targets() {
  static constexpr Target table[] = {
@fuzz_rows@  };
  return table;
}

}  // namespace cylon::fuzz
]])
target_sources(fuzz_targets PRIVATE ${PROJECT_BINARY_DIR}/fuzz_table.cc)
