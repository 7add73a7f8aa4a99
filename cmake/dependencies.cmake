# Packages are listed in cmake/packages.txt, which ./run and ./test install; the engines to judge stand in
# reference/simulators/engines.txt.
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
pkg_check_modules(SODIUM REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)  # with the flags that its library was built with
pkg_check_modules(LIBPQ IMPORTED_TARGET libpq)  # without it a store is a file (Debian: libpq-dev)

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

# NLopt's two packages, C and C++, bring a NLoptConfig.cmake each, of which CMake would take one.
find_library(NLOPT_LIBRARY nlopt REQUIRED)
add_library(nlopt INTERFACE)
target_link_libraries(nlopt INTERFACE ${NLOPT_LIBRARY})

# Whose a header is: Debian keeps them all in one folder, so that the layering test tells them apart by their names.
headers_of(Eigen3::Eigen                Eigen/)
headers_of(fmt::fmt                     fmt/)
headers_of(nlohmann_json::nlohmann_json nlohmann/)
headers_of(tomlplusplus::tomlplusplus   toml[+][+]/)
headers_of(tinyobjloader_double         tiny_obj_loader)
headers_of(Boost::headers               boost/)
headers_of(nlopt                        nlopt)
headers_of(arb                          "(arb|acb|arf|mag|flint/)")
headers_of(TBB::tbb                     "(tbb|oneapi)/")
headers_of(CLI11::CLI11                 CLI/)
headers_of(SQLite::SQLite3              sqlite3)
headers_of(PkgConfig::LIBPQ            libpq-fe)
headers_of(PkgConfig::SODIUM            sodium)
headers_of(PkgConfig::HTTPLIB           httplib)
headers_of(ZLIB::ZLIB                   zlib)
headers_of(GTest::gtest_main            "(gtest|gmock)/")
headers_of(benchmark::benchmark         benchmark/)
headers_of(clang                        clang/)
