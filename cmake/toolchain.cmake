# How every file is compiled.  -ffp-contract=off: the same bits from -O2 and -O3, gcc and clang.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

option(CYLON_SANITIZE "AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
set(CYLON_MARCH "x86-64-v3" CACHE STRING "-march of every target")

add_compile_options(-march=${CYLON_MARCH} -ffp-contract=off)
if(CYLON_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# Warnings are errors in our own code; foreign headers are SYSTEM.
add_library(warnings INTERFACE)
target_compile_options(warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  -Wno-missing-field-initializers)  # designated initialisers leave the defaults to the struct, as they should

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
