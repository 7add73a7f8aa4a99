# Reads reference/simulators/engines.txt: one simulator() per build whose library is here, and all rows as C++.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS reference/simulators/engines.txt)
file(STRINGS reference/simulators/engines.txt rows REGEX "^[^#]")

set(known_builds "")
set(engine_builds "")  # those that every build of Cylon has
set(engine_rows "")
foreach(row IN LISTS rows)
  string(REGEX REPLACE "[ \t]+" ";" row "${row}")
  list(POP_FRONT row id build path compared adapter library package header)
  string(REGEX REPLACE "^-$" "" path "${path}")
  set(is_compared false)
  set(brought_by "")
  if(compared STREQUAL "compared")
    set(is_compared true)
  elseif(compared STREQUAL "optional")
    set(brought_by "./run engines")
  elseif(NOT compared STREQUAL "-")
    message(FATAL_ERROR "reference/simulators/engines.txt: ${id}: '${compared}' is not 'compared', 'optional' or '-'")
  endif()
  string(APPEND engine_rows "      {\"${id}\", \"${build}\", \"${path}\", ${is_compared}, \"${brought_by}\"},\n")
  if(NOT adapter)
    if(NOT build IN_LIST known_builds)
      message(FATAL_ERROR "reference/simulators/engines.txt: ${id}: the first row of build ${build} names no adapter")
    endif()
    continue()
  endif()
  list(APPEND known_builds ${build})
  if(NOT brought_by)
    list(APPEND engine_builds ${build})
  endif()
  # What nobody compares unless it is named can wait until it is asked for.
  set(later "")
  if(NOT is_compared)
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
  elseif(library MATCHES "^lib:(.+)")
    # Looked for anew each time: a package that was installed since then must be found, and one that went must not.
    set(found_libraries "")
    string(REPLACE "," ";" names "${CMAKE_MATCH_1}")
    foreach(name IN LISTS names)
      unset(found_library CACHE)
      find_library(found_library ${name})
      list(APPEND found_libraries ${found_library})
    endforeach()
    unset(found_headers CACHE)
    find_path(found_headers ${header})
    cmake_path(GET header PARENT_PATH folder)
    headers_of(${library} ${folder}/)
    if("${found_libraries}" MATCHES NOTFOUND OR NOT found_headers)
      if(NOT brought_by)
        message(FATAL_ERROR "${id} needs the Debian package ${package}")
      endif()
      message(STATUS "${id} is not here: ${brought_by} installs ${package} and builds it")
      file(REMOVE ${PROJECT_BINARY_DIR}/cylon-worker-${build})  # of an earlier build, without its library
      declare(sim_${build} KIND simulator PLACES reference/simulators/${adapter}/ PUBLIC core PRIVATE ${library} applied)
      continue()
    endif()
    simulator(${build} ADAPTER ${adapter} USES ${library} applied LINKS ${found_libraries} applied KIND numbers ${later})
    target_include_directories(sim_${build} SYSTEM PRIVATE ${found_headers} ${found_headers}/${folder})
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
