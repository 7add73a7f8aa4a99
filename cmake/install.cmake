# cmake --install: the layout that harness/cli/folders.h looks for, of the target `installable`.
#   PREFIX/bin/cylon                 the program, which finds the rest by its own place
#   PREFIX/libexec/cylon/            a worker of each engine (and its border, where it has one), an importer of each format,
#                                    libcylon-mpi.so where MPI is
#   PREFIX/share/cylon/              scenarios, suites, expected verdicts, the scenario format as JSON Schema
#   PREFIX/lib/, PREFIX/include/cylon/   libraries, CMake package and headers (cmake/library.cmake)
#   PREFIX/share/{man,bash-completion,zsh,fish}/, PREFIX/share/doc/cylon/
# A component is a Debian package (cmake/package.cmake): cylon, cylon-ENGINE for each optional engine, cylon-mpi, and
# libcylon-dev.
set(written ${PROJECT_BINARY_DIR}/written)
add_custom_command(
  OUTPUT ${written}/stamp
  COMMAND ${PROJECT_SOURCE_DIR}/cmake/package/write_files.py $<TARGET_FILE:cylon> ${written}
  COMMAND ${CMAKE_COMMAND} -E touch ${written}/stamp
  DEPENDS cylon cmake/package/write_files.py cmake/package/man.py
  COMMENT "Writing man pages, completion scripts and schema" VERBATIM)
add_custom_target(written_files DEPENDS ${written}/stamp)
add_custom_target(installable DEPENDS written_files)
add_dependencies(installable cylon engines library)
add_dependencies(tests installable)

install(TARGETS cylon RUNTIME DESTINATION bin COMPONENT cylon)
get_property(workers TARGET engines PROPERTY MANUALLY_ADDED_DEPENDENCIES)
set(optional_packages "")
foreach(worker IN LISTS workers)
  set(component cylon)
  string(REGEX REPLACE "^cylon-(worker-)?" "" build ${worker})  # importers too: cylon-import-mjcf
  if(NOT build IN_LIST engine_builds)
    set(component cylon-${build})
    list(APPEND optional_packages ${component})
  endif()
  install(TARGETS ${worker} RUNTIME DESTINATION libexec/cylon COMPONENT ${component})
  if(TARGET border_${build})
    set_target_properties(${worker} PROPERTIES INSTALL_RPATH $ORIGIN)
    install(TARGETS border_${build} LIBRARY DESTINATION libexec/cylon COMPONENT ${component})
  endif()
endforeach()
if(TARGET cylon-mpi)
  install(TARGETS cylon-mpi LIBRARY DESTINATION libexec/cylon COMPONENT cylon-mpi)
endif()

install(DIRECTORY scenarios DESTINATION share/cylon COMPONENT cylon)
install(FILES ${written}/cylon/scenario.schema.json DESTINATION share/cylon COMPONENT cylon)
install(DIRECTORY ${written}/man DESTINATION share COMPONENT cylon)
install(FILES ${written}/completion/bash DESTINATION share/bash-completion/completions RENAME cylon COMPONENT cylon)
install(FILES ${written}/completion/fish DESTINATION share/fish/vendor_completions.d RENAME cylon.fish COMPONENT cylon)
install(FILES ${written}/completion/zsh DESTINATION share/zsh/site-functions RENAME _cylon COMPONENT cylon-upstream)
install(DIRECTORY docs/examples DESTINATION share/doc/cylon COMPONENT cylon)
install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/cylon COMPONENT cylon-upstream)
install(FILES cmake/package/copyright DESTINATION share/doc/cylon COMPONENT cylon)
