# The few kinds of target: a layer, an engine build, a program, a test suite, a benchmark.
include(GoogleTest)
include(cmake/batches.cmake)
include(cmake/declared.cmake)
enable_testing()

# own_sources(out folder pattern): the files under a folder that no folder declared before, below it, has taken.
function(own_sources out folder pattern)
  file(GLOB_RECURSE sources RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/${pattern})
  get_property(taken GLOBAL PROPERTY cylon_folders)
  foreach(other ${taken})
    if(NOT other STREQUAL folder)
      list(FILTER sources EXCLUDE REGEX "^${other}/")
    endif()
    string(FIND "${folder}/" "${other}/" inside)
    if(inside EQUAL 0 AND NOT other STREQUAL folder)
      message(FATAL_ERROR "${folder} is declared after ${other}, which has taken its sources: declare it before")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY cylon_folders ${folder})
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# layer(name FOLDER folder USES libraries… PRIVATE libraries… DEFINES macros… KIND kind): every source under a folder
# (programs' main.cc and reports/web, which is cmake/web.cmake's, left out); the kinds are cmake/speed.cmake's, numbers
# unless it is said.  What is PRIVATE, no header shows that another layer includes.
# A layer inside another's folder is declared before it.
function(layer name)
  cmake_parse_arguments(ARG "" "FOLDER;KIND" "USES;PRIVATE;DEFINES" ${ARGN})
  own_sources(sources ${ARG_FOLDER} *.cc)
  list(FILTER sources EXCLUDE REGEX "/main[.]cc$|/web/")
  if(ARG_KIND STREQUAL engine)
    in_batches(sources ${name} "" ${sources})
  endif()
  add_library(${name} STATIC ${sources})
  target_compile_definitions(${name} PUBLIC ${ARG_DEFINES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE} warnings)
  declare(${name} KIND layer PLACES ${ARG_FOLDER}/ PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE})
  if(NOT ARG_KIND)
    set(ARG_KIND numbers)
  endif()
  compiled_as(${name} ${ARG_KIND})
endfunction()

# simulator(build ADAPTER name USES engine LINKS its target KIND kind LATER): library sim_<build> and executable
# cylon-worker-<build>.  The target `cylon` builds the workers of those that are not LATER; `engines` builds every worker.
add_custom_target(engines)
function(simulator build)
  cmake_parse_arguments(ARG "LATER" "ADAPTER;KIND" "USES;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS reference/simulators/${ARG_ADAPTER}/*.cc)
  string(REPLACE "-" "_" library sim_${build})
  add_library(${library} STATIC ${sources})
  target_link_libraries(${library} PUBLIC core PRIVATE ${ARG_LINKS} warnings)
  declare(${library} KIND simulator PLACES reference/simulators/${ARG_ADAPTER}/ PUBLIC core PRIVATE ${ARG_USES})
  compiled_as(${library} ${ARG_KIND})
  add_executable(cylon-worker-${build} reference/workers/main.cc)
  # The engine comes first: of templates that it shares with other layers the linker takes its, which are optimised most.
  target_link_libraries(cylon-worker-${build} PRIVATE ${library} ${ARG_LINKS} worker warnings)
  declare(cylon-worker-${build} KIND program PLACES reference/workers/ PRIVATE worker)
  add_dependencies(engines cylon-worker-${build})
  if(NOT ARG_LATER)
    set_property(GLOBAL APPEND PROPERTY cylon_workers cylon-worker-${build})
  endif()
endfunction()

function(program name)
  cmake_parse_arguments(ARG "" "SOURCE" "USES" ${ARGN})
  get_property(workers GLOBAL PROPERTY cylon_workers)
  add_executable(${name} ${ARG_SOURCE})
  target_link_libraries(${name} PRIVATE ${ARG_USES} warnings)
  declare(${name} KIND program PLACES ${ARG_SOURCE} PRIVATE ${ARG_USES})
  add_dependencies(${name} ${workers})
  add_dependencies(tests ${name} engines)
  # What an earlier program certified says nothing of this one.
  add_custom_command(TARGET ${name} POST_BUILD COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/tests_cache)
endfunction()

# All that ctest runs.
add_custom_target(tests)

# tests/paths.h: the one source that knows where the repository and the build stand.  It also gives every test one cache of
# certified solutions and one key that seals it, so that a scene is certified once for all of them, and the user's own cache and
# key are left alone.  Whatever an environment says comes first.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/test_paths.cc CONTENT [=[
#include "tests/paths.h"

#include <cstdlib>
const char* const cylon::source_dir = "@PROJECT_SOURCE_DIR@";
const char* const cylon::binary_dir = "@PROJECT_BINARY_DIR@";
namespace {
[[maybe_unused]] const int of_tests = ::setenv("CYLON_CACHE", "@PROJECT_BINARY_DIR@/tests_cache", 0) |
                                      ::setenv("CYLON_KEY", "@PROJECT_BINARY_DIR@/tests_key", 0);
}  // namespace
]=] @ONLY)
add_library(test_paths STATIC ${PROJECT_BINARY_DIR}/test_paths.cc)
target_include_directories(test_paths PUBLIC ${PROJECT_SOURCE_DIR})
declare(test_paths KIND layer PLACES tests/paths.h tests/temporary_folder.h)
set(tests_environment "CYLON_CACHE=${PROJECT_BINARY_DIR}/tests_cache;CYLON_KEY=${PROJECT_BINARY_DIR}/tests_key")
if(NOT EXISTS ${PROJECT_BINARY_DIR}/tests_key)  # a key is 32 bytes that nobody else may read (harness/seal)
  execute_process(COMMAND head -c 32 /dev/urandom OUTPUT_FILE ${PROJECT_BINARY_DIR}/tests_key COMMAND_ERROR_IS_FATAL ANY)
  file(CHMOD ${PROJECT_BINARY_DIR}/tests_key PERMISSIONS OWNER_READ OWNER_WRITE)
endif()

# ctest starts the tests of the greatest COST first, so that no long one runs alone at the end.
set(long_test 100)

# test_suite(name FOLDER folder USES libraries… SHARES files… AS_ONE fixtures… OF_EACH parameters…): one executable for every
# *_test.cc under a folder (a suite inside another's folder is declared before it), and for files of another suite that hold
# of these libraries too.  Each test is a process of its own; those of an AS_ONE fixture share one, for they judge one long
# run, or share what takes longer than they do: engines that start, scenes with their truths.  So do those of all fixtures
# with a parameter of such a name, OF_EACH.
function(test_suite name)
  cmake_parse_arguments(ARG "" "FOLDER" "USES;SHARES;AS_ONE;OF_EACH" ${ARGN})
  own_sources(sources ${ARG_FOLDER} *_test.cc)
  in_batches(batches ${name} OWN_NAMES ${sources} ${ARG_SHARES})
  add_executable(${name}_tests ${batches})
  target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name}_tests PRIVATE ${ARG_USES} test_paths GTest::gtest_main warnings)
  declare(${name}_tests KIND tests PLACES ${ARG_FOLDER}/ PRIVATE ${ARG_USES} test_paths GTest::gtest_main)
  compiled_as(${name}_tests test)
  add_dependencies(tests ${name}_tests)
  set(alone "")
  foreach(fixture ${ARG_AS_ONE})
    string(APPEND alone ":${fixture}.*")
    add_test(NAME ${name}/${fixture} COMMAND ${name}_tests --gtest_brief=1 --gtest_filter=${fixture}.*)
    set_tests_properties(${name}/${fixture} PROPERTIES LABELS ${name} COST ${long_test} TIMEOUT 3600)
  endforeach()
  foreach(parameter ${ARG_OF_EACH})
    string(APPEND alone ":*/${parameter}")
    add_test(NAME ${name}/${parameter} COMMAND ${name}_tests --gtest_brief=1 --gtest_filter=*/${parameter})
    set_tests_properties(${name}/${parameter} PROPERTIES LABELS ${name} FAIL_REGULAR_EXPRESSION "] 0 tests from")
  endforeach()
  # Without the values of parameters, which may be addresses: ctest knows again what a test of the same name took.
  gtest_discover_tests(${name}_tests TEST_FILTER "*-${alone}" TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES
                       PROPERTIES LABELS ${name})
endfunction()

# adapter_tests(build library USES libraries…): the tests of an optional engine's adapter alone, which see its headers and
# those of the engine (named as in reference/simulators/engines.txt); where the engine is not here, there are none.
function(adapter_tests build library)
  cmake_parse_arguments(ARG "" "" "USES" ${ARGN})
  set(folder tests/reference/simulators/${build})
  if(TARGET sim_${build})
    test_suite(${build} FOLDER ${folder} USES sim_${build} ${ARG_USES})
    target_include_directories(${build}_tests SYSTEM PRIVATE $<TARGET_PROPERTY:sim_${build},INCLUDE_DIRECTORIES>)
  else()
    declare(${build}_tests KIND tests PLACES ${folder}/ PRIVATE sim_${build} ${ARG_USES} test_paths GTest::gtest_main)
  endif()
  declare(${build}_tests KIND tests PLACES ${folder}/ PRIVATE ${library} refusals)
endfunction()

# javascript_tests(folder): its *_test.mjs in node, where that is; they leave out engines whose packages are not.
function(javascript_tests folder)
  find_program(node_program node)
  if(NOT node_program)
    return()
  endif()
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*_test.mjs)
  foreach(test IN LISTS tests)
    cmake_path(GET test STEM name)
    add_test(NAME javascript/${name} COMMAND ${node_program} --test ${test})
    set_tests_properties(javascript/${name} PROPERTIES LABELS javascript)
  endforeach()
endfunction()

# tool(name SOURCE file USES libraries…): an executable that a script builds when it needs it.
function(tool name)
  cmake_parse_arguments(ARG "" "SOURCE" "USES" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCE})
  target_link_libraries(${name} PRIVATE ${ARG_USES} warnings)
  declare(${name} KIND tool PLACES ${ARG_SOURCE} PRIVATE ${ARG_USES})
endfunction()

# plugin(name file): a library with forces, as its author would compile it (cylon/force.h).
function(plugin name source)
  add_library(${name} MODULE ${source})
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE warnings)
  add_dependencies(tests ${name})
endfunction()

# The test reads what every target has declared by the end of CMakeLists.txt.
function(layering_test)
  declare(lint_scope KIND tool PLACES tests/lint_scope.cc PRIVATE clang)  # tests/lint.py loads it into clang-tidy
  declare(fault KIND tool PLACES tests/hostile/fault.cc)                  # tests/hostile/faults.py compiles it
  cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL write_declared)")
  add_test(NAME layering COMMAND ${PROJECT_SOURCE_DIR}/tests/layering_test.py ${PROJECT_BINARY_DIR}/layers.json)
  set_tests_properties(layering PROPERTIES LABELS layering)
endfunction()

# gcc 12's own contraction, which no flag forbids (cmake/toolchain.cmake): none of it in what computes.
function(contraction_test)
  foreach(library ${ARGN})
    add_test(NAME no_contraction_in_${library}
             COMMAND sh -c "! objdump -d --no-show-raw-insn \"$0\" | grep -E 'vfm(addsub|subadd)'" $<TARGET_FILE:${library}>)
    set_tests_properties(no_contraction_in_${library} PROPERTIES LABELS engine)
  endforeach()
endfunction()

# The generated tables of README.md and docs/ are what the program says today.
function(readme_test)
  add_test(NAME readme_is_current COMMAND ${PROJECT_SOURCE_DIR}/docs/update.py --check --cylon $<TARGET_FILE:cylon>)
  add_test(NAME fairness_is_current COMMAND ${PROJECT_SOURCE_DIR}/docs/fairness.py --check --cylon $<TARGET_FILE:cylon>)
  set_tests_properties(readme_is_current fairness_is_current PROPERTIES LABELS conformance COST ${long_test}
                       ENVIRONMENT "${tests_environment}")
endfunction()

# hostile_test(script words…): tests/hostile/<script>.py, which attacks the program with files, texts and engines.
function(hostile_test script)
  add_test(NAME hostile/${script} COMMAND ${PROJECT_SOURCE_DIR}/tests/hostile/${script}.py $<TARGET_FILE:cylon> ${ARGN})
  set_tests_properties(hostile/${script} PROPERTIES LABELS hostile COST ${long_test})
endfunction()

# slow_test(name command…): what takes an hour or uses every core; only ./test slow runs it, alone.
function(slow_test name)
  add_test(NAME slow/${name} COMMAND ${ARGN})
  set_tests_properties(slow/${name} PROPERTIES LABELS slow RUN_SERIAL ON)
endfunction()

# launcher_test(launcher): shards that GNU parallel or Slurm starts on this machine.
function(launcher_test launcher)
  add_test(NAME launcher/${launcher} COMMAND ${PROJECT_SOURCE_DIR}/tests/harness/cli/launchers.sh ${launcher} $<TARGET_FILE:cylon>)
  set_tests_properties(launcher/${launcher} PROPERTIES LABELS harness SKIP_RETURN_CODE 77)
endfunction()

# The pages in a real browser, and whether the committed bundle is that of their sources.
function(web_tests)
  add_test(NAME web COMMAND ${PROJECT_SOURCE_DIR}/tests/reports/web/run.sh ${PROJECT_BINARY_DIR})
  add_test(NAME web_bundle_is_current COMMAND ${PROJECT_SOURCE_DIR}/cmake/web_bundle.sh --check)
  set_tests_properties(web PROPERTIES LABELS web SKIP_RETURN_CODE 77 COST ${long_test} ENVIRONMENT "${tests_environment}")
  set_tests_properties(web_bundle_is_current PROPERTIES LABELS web)
endfunction()

# What is installed and packed, and used where nothing else is (tests/package/).
function(package_tests)
  foreach(script installed library packages bare_root reproducible)
    add_test(NAME package/${script} COMMAND ${PROJECT_SOURCE_DIR}/tests/package/${script}.sh ${PROJECT_BINARY_DIR})
    set_tests_properties(package/${script} PROPERTIES LABELS package SKIP_RETURN_CODE 77 COST ${long_test})
  endforeach()
  # These take minutes: a Debian from its mirrors, and two builds.
  set_tests_properties(package/bare_root package/reproducible PROPERTIES LABELS "package;slow" TIMEOUT 7200)
endfunction()

# bench(name USES libraries…): `benches` builds them all, `all` builds none.
add_custom_target(benches)
function(bench name)
  cmake_parse_arguments(ARG "" "" "USES" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL bench/${name}.cc)
  add_dependencies(benches ${name})
  target_link_libraries(${name} PRIVATE ${ARG_USES} benchmark::benchmark warnings)
  declare(${name} KIND bench PLACES bench/${name}.cc PRIVATE ${ARG_USES} benchmark::benchmark bench)
  declare(bench KIND bench PLACES bench/ PRIVATE ${ARG_USES} benchmark::benchmark)  # what benches share
endfunction()

# scaling_cells(bench builds…): what a bench runs in processes of their own, one executable per engine build.
function(scaling_cells bench)
  target_sources(${bench} PRIVATE bench/scaling/kinds.cc)
  foreach(build ${ARGN})
    string(REPLACE "-" "_" library sim_${build})
    add_executable(scaling-cell-${build} EXCLUDE_FROM_ALL bench/scaling/cell.cc bench/scaling/kinds.cc)
    target_link_libraries(scaling-cell-${build} PRIVATE exact ${library} warnings)
    declare(scaling-cell-${build} KIND bench PLACES bench/scaling/ PRIVATE exact ${library})
    add_dependencies(${bench} scaling-cell-${build})
  endforeach()
endfunction()
