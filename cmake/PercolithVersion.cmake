# SPDX-License-Identifier: BSD-3-Clause
# Defines the target percolith_version, which keeps percolith/version.hpp up to date: the revision
# is asked of git at every build, and the header changes only when its text would.
if(CMAKE_SCRIPT_MODE_FILE)
  set(PERCOLITH_REVISION "unknown")
  execute_process(COMMAND git describe --always --dirty --tags
                  WORKING_DIRECTORY ${PERCOLITH_SOURCE_DIR}
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
                  RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(PERCOLITH_REVISION ${described})
  endif()
  configure_file(${PERCOLITH_SOURCE_DIR}/cmake/version.hpp.in ${PERCOLITH_VERSION_HEADER} @ONLY)
  return()
endif()

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(flags percolith_compile INTERFACE_COMPILE_OPTIONS)
string(JOIN " " flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${flags})
set(write_version
    ${CMAKE_COMMAND} -DPERCOLITH_SOURCE_DIR=${CMAKE_SOURCE_DIR}
    -DPERCOLITH_VERSION=${PROJECT_VERSION}
    -DPERCOLITH_VERSION_HEADER=${CMAKE_BINARY_DIR}/generated/percolith/version.hpp
    "-DPERCOLITH_COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    "-DPERCOLITH_FLAGS=${flags}" -P ${CMAKE_CURRENT_LIST_FILE})
add_custom_target(percolith_version
                  COMMAND ${write_version}
                  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/percolith/version.hpp
                  COMMENT "Asking git for the revision" VERBATIM)
add_dependencies(percolith_compile percolith_version)
