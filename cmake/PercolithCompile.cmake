# SPDX-License-Identifier: BSD-3-Clause
# One interface target that carries the flags every room is compiled with.
add_library(percolith_compile INTERFACE)
target_include_directories(percolith_compile INTERFACE ${CMAKE_SOURCE_DIR}/src
                                                       ${CMAKE_BINARY_DIR}/generated)
# Bitwise equal results for scalar and vector code need contraction off; square roots vectorise
# only without errno and trapping semantics. Neither flag changes the value of any operation.
target_compile_options(percolith_compile INTERFACE -Wall -Wextra -Wshadow -Wconversion
                                                   -ffp-contract=off -fno-math-errno
                                                   -fno-trapping-math)
if(CMAKE_UNITY_BUILD)
  # Sources read as one see each other's file-wide names; builds without unity check for shadows.
  target_compile_options(percolith_compile INTERFACE -Wno-shadow)
endif()
if(PERCOLITH_WARNINGS_AS_ERRORS)
  target_compile_options(percolith_compile INTERFACE -Werror)
endif()
if(PERCOLITH_ARCHITECTURE AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(percolith_compile INTERFACE -march=${PERCOLITH_ARCHITECTURE})
endif()
if(PERCOLITH_NATIVE AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(percolith_compile INTERFACE -march=native)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 reports false uninitialised reads from inside its AVX-512 intrinsics header.
    target_compile_options(percolith_compile INTERFACE -Wno-uninitialized
                                                       -Wno-maybe-uninitialized)
  endif()
endif()
if(PERCOLITH_SANITIZE)
  target_compile_options(percolith_compile INTERFACE -fsanitize=${PERCOLITH_SANITIZE}
                                                     -fno-omit-frame-pointer
                                                     -fno-sanitize-recover=all)
  target_link_options(percolith_compile INTERFACE -fsanitize=${PERCOLITH_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The sanitizers' code makes g++ 12 report false uninitialised reads from inside <regex>.
    target_compile_options(percolith_compile INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
if(PERCOLITH_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "PERCOLITH_FUZZ needs clang: configure with the preset 'fuzz'")
  endif()
  target_compile_options(percolith_compile INTERFACE -fsanitize=fuzzer-no-link)
endif()
