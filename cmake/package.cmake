# Debian packages: cpack, or ./run package, writes them to build/PRESET/packages.
#   cylon           the program, the engines that every build has, the scenarios
#   cylon-import-FORMAT  the importer of a format of others, for the same reason
#   cylon-ENGINE    the worker of an optional engine, so that cylon itself does not need the engine's library
#   cylon-mpi       what `cylon farm` loads, so that cylon itself does not need MPI
#   libcylon-dev    headers, static libraries and the CMake package, for engines outside the tree
# The same sources give the same bytes (tests/package/reproducible.sh): every time in a package is that of the last commit,
# or SOURCE_DATE_EPOCH where somebody says another.
set(debian ${PROJECT_BINARY_DIR}/debian)
set(epoch $ENV{SOURCE_DATE_EPOCH})
if(NOT epoch)
  execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                  OUTPUT_VARIABLE epoch OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT epoch MATCHES "^[0-9]+$")
  message(STATUS "No commit here and no SOURCE_DATE_EPOCH: packages bear 2026-01-01")
  set(epoch 1767225600)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cylon)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "")
set(CPACK_PACKAGE_CONTACT "The Cylon authors <cylon@users.noreply.github.com>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE cylon)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_PROJECT_CONFIG_FILE ${debian}/epoch.cmake)
file(CONFIGURE OUTPUT ${debian}/epoch.cmake CONTENT "set(ENV{SOURCE_DATE_EPOCH} @epoch@)\nset(ENV{LC_ALL} C)\n" @ONLY)

# compressed(file): FILE.gz, without name and time.
function(compressed file)
  execute_process(COMMAND gzip --best --no-name --force ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(ENV{SOURCE_DATE_EPOCH} ${epoch})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${debian}/changelog.Debian @ONLY CONTENT "cylon (@PROJECT_VERSION@-1) bookworm; urgency=medium

  * Release @PROJECT_VERSION@. The package cylon has the changes in changelog.gz.

 -- @CPACK_PACKAGE_CONTACT@  @date@
")
compressed(${debian}/changelog.Debian)
file(COPY_FILE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${debian}/changelog)
compressed(${debian}/changelog)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CHANGELOG.md)

# debian_package(name ABOUT description FIELDS field value…): a package of the component of its name and of `name-debian`,
# which only packages install.
set(CPACK_COMPONENTS_ALL "")
function(debian_package name)
  cmake_parse_arguments(ARG "" "ABOUT" "FIELDS" ${ARGN})
  string(TOUPPER ${name} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${ARG_ABOUT}" PARENT_SCOPE)
  while(ARG_FIELDS)
    list(POP_FRONT ARG_FIELDS field value)
    set(CPACK_DEBIAN_${key}_PACKAGE_${field} "${value}" PARENT_SCOPE)
  endwhile()
  foreach(component ${name} ${name}-debian)
    string(TOUPPER ${component} component_key)
    set(CPACK_COMPONENT_${component_key}_GROUP ${name} PARENT_SCOPE)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
  endforeach()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
  install(FILES cmake/package/overrides DESTINATION share/lintian/overrides RENAME ${name} COMPONENT ${name}-debian
          EXCLUDE_FROM_ALL)
  install(FILES ${debian}/changelog.Debian.gz DESTINATION share/doc/${name} COMPONENT ${name}-debian EXCLUDE_FROM_ALL)
endfunction()


set(mpi_package "")
if(TARGET cylon-mpi)
  set(mpi_package cylon-mpi)
endif()
string(JOIN ", " suggested ${optional_packages} ${mpi_package} valgrind)
debian_package(cylon ABOUT "judge of physics engines
Runs the same scenes on several engines and compares each with exact
mechanics: trajectories, events, momentum, angular momentum and energy. Every
result is a verdict: measured error, allowed error, and the reason for the
allowed error.
.
Bullet, ODE and an engine of its own are here, and others take part by a
protocol of JSON lines, in any language. It needs a processor with AVX2
(x86-64-v3)."
  FIELDS RECOMMENDS bubblewrap SUGGESTS "${suggested}")
install(FILES ${debian}/changelog.gz DESTINATION share/doc/cylon COMPONENT cylon-debian EXCLUDE_FROM_ALL)
install(FILES ${written}/completion/zsh DESTINATION share/zsh/vendor-completions RENAME _cylon
        COMPONENT cylon-debian EXCLUDE_FROM_ALL)

foreach(package IN LISTS optional_packages)
  string(REPLACE cylon- "" id ${package})
  if(id MATCHES "^import-(.*)")
    debian_package(${package} ABOUT "judge of physics engines: importer of ${CMAKE_MATCH_1}
Lets cylon read scenes in this format, by the format's own library, in a
process of its own.
.
Without this package cylon says of such files that it cannot read them."
      FIELDS DEPENDS "cylon (= ${PROJECT_VERSION}-1)")
    install(FILES cmake/package/copyright DESTINATION share/doc/${package} COMPONENT ${package}-debian EXCLUDE_FROM_ALL)
    continue()
  endif()
  debian_package(${package} ABOUT "judge of physics engines: worker of ${id}
Adds the engine ${id} to cylon, which runs it as a process of its own.
.
Without this package cylon says of ${id} that it is not here."
    FIELDS DEPENDS "cylon (= ${PROJECT_VERSION}-1)")
  install(FILES cmake/package/copyright DESTINATION share/doc/${package} COMPONENT ${package}-debian EXCLUDE_FROM_ALL)
endforeach()

if(mpi_package)
  debian_package(cylon-mpi ABOUT "judge of physics engines: cylon farm
Lets cylon share out the scenes of one question among the processes of an MPI
job: mpirun cylon farm run.
.
Without this package cylon farm says that it needs MPI, and all other commands
work."
    FIELDS DEPENDS "cylon (= ${PROJECT_VERSION}-1)" RECOMMENDS openmpi-bin)
  install(FILES cmake/package/copyright DESTINATION share/doc/cylon-mpi COMPONENT cylon-mpi-debian EXCLUDE_FROM_ALL)
endif()

debian_package(libcylon-dev ABOUT "judge of physics engines: library
Headers, static libraries and a CMake package for engines: a worker out of a
class in C++ or a table of functions in C, and EXPECT_CONFORMS for the tests
of an engine with GoogleTest."
  FIELDS SECTION libdevel
         DEPENDS "cylon (= ${PROJECT_VERSION}-1), libeigen3-dev, libfmt-dev, libflint-arb-dev, libflint-dev, libsodium-dev, libtbb-dev, libtinyobjloader-dev, libtomlplusplus-dev"
         RECOMMENDS "cmake, g++, libgtest-dev")
install(FILES cmake/package/copyright DESTINATION share/doc/libcylon-dev COMPONENT libcylon-dev-debian EXCLUDE_FROM_ALL)

include(CPack)
