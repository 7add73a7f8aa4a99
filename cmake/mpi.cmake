# libcylon-mpi.so, which `cylon farm` loads: built where MPI is (Debian: libopenmpi-dev), missing without harm elsewhere.
# The program itself is linked with no MPI.
layer(crew FOLDER harness/crew KIND text USES core PRIVATE fmt::fmt ${CMAKE_DL_LIBS})
headers_of(MPI::MPI_C "mpi[.]h")
declare(cylon-mpi KIND layer PLACES harness/mpi/ PRIVATE crew MPI::MPI_C)

# It is the interface in C that is called, of whichever MPI is the system's.
pkg_search_module(MPI_C IMPORTED_TARGET mpi-c ompi-c mpich)
if(NOT MPI_C_FOUND)
  message(STATUS "cylon farm is not here: apt-get install libopenmpi-dev openmpi-bin, and build again")
  file(REMOVE ${PROJECT_BINARY_DIR}/libcylon-mpi.so)  # of an earlier build, without its library
  return()
endif()
add_library(cylon-mpi MODULE harness/mpi/crew.cc)
target_include_directories(cylon-mpi PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(cylon-mpi PRIVATE PkgConfig::MPI_C warnings)
# Without the old interface in C++, which needs a library of its own.
target_compile_definitions(cylon-mpi PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
set_target_properties(cylon-mpi PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
