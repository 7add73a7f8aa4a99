# Packages are listed in cmake/packages.txt, which ./run and ./test install.
find_package(Eigen3 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(Boost REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(SQLite3 3.40 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(BULLET_F64 REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(BULLET_F32 REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
pkg_check_modules(HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)  # with the flags that its library was built with

# The double build needs the library *and* the define; pkg-config passes no define.
find_library(TINYOBJLOADER_DOUBLE tinyobjloader_double REQUIRED)
add_library(tinyobjloader_double INTERFACE)
target_link_libraries(tinyobjloader_double INTERFACE ${TINYOBJLOADER_DOUBLE})
target_compile_definitions(tinyobjloader_double INTERFACE TINYOBJLOADER_USE_DOUBLE)

# Ball arithmetic; neither library comes with a CMake or pkg-config file.
find_library(FLINT_ARB flint-arb REQUIRED)
find_library(FLINT flint REQUIRED)
add_library(arb INTERFACE)
target_link_libraries(arb INTERFACE ${FLINT_ARB} ${FLINT})
