# Reads reference/simulators/engines.txt: one simulator() per build, and the rows of the default engines as C++.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS reference/simulators/engines.txt)
file(STRINGS reference/simulators/engines.txt rows REGEX "^[^#]")

set(engine_builds "")
set(engine_rows "")
foreach(row IN LISTS rows)
  string(REGEX REPLACE "[ \t]+" ";" row "${row}")
  list(POP_FRONT row id build path compared adapter library package header)
  string(REGEX REPLACE "^-$" "" path "${path}")
  string(REPLACE "compared" "true" compared "${compared}")
  string(REGEX REPLACE "^-$" "false" compared "${compared}")
  string(APPEND engine_rows "      {\"${id}\", \"${build}\", \"${path}\", ${compared}},\n")
  if(NOT adapter)
    if(NOT build IN_LIST engine_builds)
      message(FATAL_ERROR "reference/simulators/engines.txt: ${id}: the first row of build ${build} names no adapter")
    endif()
    continue()
  endif()
  list(APPEND engine_builds ${build})
  # What nobody compares unless it is named can wait until it is asked for.
  set(later "")
  if(compared STREQUAL "false")
    set(later LATER)
  endif()
  if(library MATCHES "^pkg:(.+)")
    string(MAKE_C_IDENTIFIER "${build}" module)
    pkg_check_modules(${module} REQUIRED IMPORTED_TARGET ${CMAKE_MATCH_1})
    cmake_path(GET header PARENT_PATH folder)
    set(folders "")
    foreach(include ${${module}_INCLUDE_DIRS} /usr/include)
      cmake_path(GET include FILENAME last)
      if(last STREQUAL folder)
        list(APPEND folders ${include})
      else()
        list(APPEND folders ${include}/${folder})
      endif()
    endforeach()
    headers_in(${library} ${folders})
    simulator(${build} ADAPTER ${adapter} USES ${library} applied LINKS PkgConfig::${module} applied KIND numbers ${later})
  else()
    simulator(${build} ADAPTER ${adapter} USES ${library} LINKS ${library} KIND engine ${later})
  endif()
endforeach()

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/engine_table.cc @ONLY CONTENT [[
// Generated from reference/simulators/engines.txt.
#include "harness/process/engine_table.h"

namespace cylon::process {

std::span<const BuiltEngine> engine_table() {
  static constexpr BuiltEngine table[] = {
@engine_rows@  };
  return table;
}

}  // namespace cylon::process
]])
target_sources(process PRIVATE ${PROJECT_BINARY_DIR}/engine_table.cc)
