# Reads reference/simulators/engines.txt: one simulator() per build whose library is here, and all rows as C++.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS reference/simulators/engines.txt)
file(STRINGS reference/simulators/engines.txt rows REGEX "^[^#]")

# border(build ADAPTER name LIBRARY name LINKS libraries HEADERS folders): the adapter's folder border/ as a shared library,
# which alone includes the engine's headers, and shows plain numbers.  It is for an engine that Debian builds in another way
# than this program is built: for x86-64, where Eigen's types have another alignment, with assertions, where types of the
# engine have other members, or in C++17.  A static library would not do: of a template that both sides instantiate, the
# linker keeps one.  So the border is a library of its own, compiled as Debian compiles the engine, and what links it
# shows it none of its own functions of Eigen.
function(border build)
  cmake_parse_arguments(ARG "" "ADAPTER;LIBRARY" "LINKS;HEADERS" ${ARGN})
  set(folder reference/simulators/${ARG_ADAPTER}/border)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cc)
  set(border border_${build})
  add_library(${border} SHARED ${sources})
  set_target_properties(${border} PROPERTIES OUTPUT_NAME cylon-border-${build} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
                        CXX_STANDARD 17)
  target_compile_options(${border} PRIVATE -march=x86-64 -UNDEBUG $<$<CONFIG:Release>:-O2>)
  target_include_directories(${border} PUBLIC ${PROJECT_SOURCE_DIR})
  target_include_directories(${border} SYSTEM PRIVATE ${ARG_HEADERS})
  target_link_libraries(${border} PRIVATE ${ARG_LINKS} Eigen3::Eigen warnings)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/own_eigen.map CONTENT "{ local: *Eigen*; };\n")
  target_link_options(${border} INTERFACE -Wl,--version-script=${PROJECT_BINARY_DIR}/own_eigen.map)
  declare_border(${build} ${ARG_ADAPTER} ${ARG_LIBRARY})
endfunction()

# package_version(package result): the upstream version of an installed Debian package, for engines whose libraries and
# headers state none; "of unknown version" where dpkg does not know the package.
function(package_version package result)
  set(version "")
  execute_process(COMMAND dpkg-query -W -f=\${source:Upstream-Version} ${package} OUTPUT_VARIABLE version ERROR_QUIET)
  string(REGEX REPLACE "[+~](dfsg|ds|repack).*$" "" version "${version}")
  if(NOT version)
    set(version "of unknown version")
  endif()
  set(${result} "${version}" PARENT_SCOPE)
endfunction()

function(declare_border build adapter library)
  declare(border_${build} KIND layer PLACES reference/simulators/${adapter}/border/ PRIVATE ${library} Eigen3::Eigen)
endfunction()

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
  set(is_packaged true)
  set(npm "")
  if(library MATCHES "^npm:(.+)")
    set(is_packaged false)
    set(npm ${CMAKE_MATCH_1})
  endif()
  set(takes_plugins false)
  if(adapter STREQUAL "in_house")
    set(takes_plugins true)
  endif()
  string(APPEND engine_rows "      {\"${id}\", \"${build}\", \"${path}\", ${is_compared}, \"${brought_by}\", ${takes_plugins}, \"${npm}\", ${is_packaged}},\n")
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
      if(EXISTS ${PROJECT_SOURCE_DIR}/reference/simulators/${adapter}/border)
        declare_border(${build} ${adapter} ${library})
        set(library border_${build})
      endif()
      declare(sim_${build} KIND simulator PLACES reference/simulators/${adapter}/ PUBLIC core PRIVATE ${library} applied)
      continue()
    endif()
    if(EXISTS ${PROJECT_SOURCE_DIR}/reference/simulators/${adapter}/border)
      # Siconos's own headers include each other without their folders.
      file(GLOB inner LIST_DIRECTORIES true ${found_headers}/${folder}/*)
      list(FILTER inner INCLUDE REGEX "/siconos/(kernel|numerics)$")
      border(${build} ADAPTER ${adapter} LIBRARY ${library} LINKS ${found_libraries}
             HEADERS ${found_headers} ${found_headers}/${folder} ${inner})
      simulator(${build} ADAPTER ${adapter} USES border_${build} applied LINKS border_${build} applied KIND numbers ${later})
      package_version(${package} version)
      target_compile_definitions(sim_${build} PRIVATE CYLON_PACKAGE_VERSION="${version}")
      continue()
    endif()
    simulator(${build} ADAPTER ${adapter} USES ${library} applied LINKS ${found_libraries} applied KIND numbers ${later})
    target_include_directories(sim_${build} SYSTEM PRIVATE ${found_headers} ${found_headers}/${folder})
  elseif(library MATCHES "^npm:(.+)")
    # Nothing is compiled: the worker is a link to the one of all engines in JavaScript, whose name says which it is.
    set(folder ${PROJECT_SOURCE_DIR}/reference/simulators/${adapter})
    unset(found_node CACHE)
    find_program(found_node node)
    file(REMOVE ${PROJECT_BINARY_DIR}/cylon-worker-${build})
    if(found_node AND EXISTS ${folder}/node_modules/${CMAKE_MATCH_1}/package.json)
      file(CREATE_LINK ${folder}/worker.mjs ${PROJECT_BINARY_DIR}/cylon-worker-${build} SYMBOLIC)
    else()
      message(STATUS "${id} is not here: ${brought_by} installs node and the npm package ${CMAKE_MATCH_1}")
    endif()
  else()
    simulator(${build} ADAPTER ${adapter} USES ${library} plugin_header LINKS ${library} ${CMAKE_DL_LIBS} KIND engine ${later})
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
