# cylon-worker-mutated: the in-house engine with a switch at each statement that tests/mutants/generated.py changes.
# That script writes the sources and builds the target; nothing else does.
file(GLOB_RECURSE mutated RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS engine/*.cc)
list(TRANSFORM mutated PREPEND ${PROJECT_BINARY_DIR}/mutated/)
list(APPEND mutated ${PROJECT_BINARY_DIR}/mutated/mutant.cc)
set_source_files_properties(${mutated} PROPERTIES GENERATED TRUE)
file(GLOB adapter CONFIGURE_DEPENDS reference/simulators/in_house/*.cc)
add_executable(cylon-worker-mutated EXCLUDE_FROM_ALL reference/workers/main.cc ${adapter} ${mutated})
target_include_directories(cylon-worker-mutated PRIVATE ${PROJECT_BINARY_DIR}/mutated ${PROJECT_SOURCE_DIR})
target_link_libraries(cylon-worker-mutated PRIVATE worker core process Eigen3::Eigen TBB::tbb)
target_compile_options(cylon-worker-mutated PRIVATE -w $<$<CONFIG:Release>:${optimised_numbers}>)  # changes may be unsound
declare(cylon-worker-mutated KIND program PLACES reference/workers/ PRIVATE worker process core engine)
