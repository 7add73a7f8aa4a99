# What find_package(cylon) gives: libcylon_{simulator,worker,judge,in_house}.a, the public headers, cylonConfig.cmake.
#
# Each archive is one object in which all but the public functions are local.  An engine's own flags (-ffast-math,
# -march) then do not reach the judge through the templates that both instantiate, of which a linker keeps one; and no
# other version of a library's header does.
set(public_headers cylon/engine.h cylon/force.h cylon/worker.h cylon/gtest.h harness/judge/conform.h harness/results/verdict.h
    harness/told/diagnostic.h harness/core/simulator.h harness/core/engine.h harness/core/scene.h
    harness/core/joint_kinds.h harness/core/shapes.h harness/core/field.h harness/core/range.h)

# archive(name WHOLE layers… PARTS layers… KEEPS regex): everything of WHOLE and what that needs of PARTS, with the
# functions whose mangled names match as the only visible ones.
add_custom_target(library)
function(archive name)
  cmake_parse_arguments(ARG "" "KEEPS" "WHOLE;PARTS" ${ARGN})
  list(TRANSFORM ARG_WHOLE REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  list(TRANSFORM ARG_PARTS REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  set(made ${PROJECT_BINARY_DIR}/library/libcylon_${name}.a)
  add_custom_command(
    OUTPUT ${made}
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/archive.py ${made} --keeps ${ARG_KEEPS} --whole ${ARG_WHOLE} --parts ${ARG_PARTS}
    DEPENDS cmake/archive.py ${ARG_WHOLE} ${ARG_PARTS}
    COMMENT "Making libcylon_${name}.a" VERBATIM)
  add_custom_target(library_${name} DEPENDS ${made})
  add_dependencies(library library_${name})
  install(FILES ${made} DESTINATION lib COMPONENT libcylon-dev)
endfunction()

archive(simulator WHOLE core told PARTS templates KEEPS "_ZNK?5cylon(4core|4told)")
archive(worker    WHOLE worker    PARTS process core told results input templates KEEPS "_ZN5cylon6worker3run|cylon_worker_main$")
archive(in_house  WHOLE sim_in_house engine PARTS core told templates KEEPS "_ZN5cylon4core14make_simulatorEv$")
archive(judge     WHOLE judge told
        PARTS study process scenario results statistics seal input exact certified core templates
        KEEPS "_ZNK?5cylon(5judge|7results|4told)")

foreach(header IN LISTS public_headers)
  cmake_path(GET header PARENT_PATH folder)
  if(folder STREQUAL cylon)
    set(folder "")
  endif()
  install(FILES ${header} DESTINATION include/cylon/${folder} COMPONENT libcylon-dev)
endforeach()

include(CMakePackageConfigHelpers)
set(made ${PROJECT_BINARY_DIR}/library)
string(REGEX MATCH "^[0-9]+" fmt_major "${fmt_VERSION}")
# As every target here is compiled and linked (cmake/toolchain.cmake).
set(library_link_options "")
if(CYLON_MARCH MATCHES "^x86-64-v[234]$")
  set(library_link_options "LINKER:-z,${CYLON_MARCH}")
endif()
set(library_alignment 32)  # of Eigen under AVX
configure_package_config_file(cmake/cylonConfig.cmake.in ${made}/cylonConfig.cmake INSTALL_DESTINATION lib/cmake/cylon)
write_basic_package_version_file(${made}/cylonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/cylonConfig.cmake ${made}/cylonConfigVersion.cmake DESTINATION lib/cmake/cylon COMPONENT libcylon-dev)
