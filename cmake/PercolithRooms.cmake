# SPDX-License-Identifier: BSD-3-Clause
# A room is a folder under src/percolith with its own static library; a topic of several files may
# have a folder within it. Its DEPENDS are the only rooms it may include (tools/check_rooms.py
# compares them with the include lines). PRIVATE libraries are seen by the room's own sources alone.
# A main.cpp belongs to a program, not a room.
function(percolith_room name)
  cmake_parse_arguments(room "" "" "DEPENDS;LIBRARIES;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp
       ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  set(library percolith_${name})
  if(sources)
    add_library(${library} STATIC ${sources})
    # Only in unity builds, where a generated file includes the sources.
    set_target_properties(${library} PROPERTIES UNITY_BUILD_CODE_BEFORE_INCLUDE
                                                "// NOLINTNEXTLINE(bugprone-suspicious-include)")
    target_link_libraries(${library} PRIVATE ${room_PRIVATE})
    set(scope PUBLIC)
  else()
    add_library(${library} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(${library} ${scope} percolith_compile ${room_LIBRARIES})
  foreach(dependency ${room_DEPENDS})
    target_link_libraries(${library} ${scope} percolith_${dependency})
  endforeach()
endfunction()

# Unit tests of a room: tests/unit/<room>/test_*.cpp become one program.
function(percolith_room_tests name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/unit/${name}/test_*.cpp)
  if(sources)
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE percolith_${name} GTest::gtest GTest::gtest_main
                                               ${ARGN})
    target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60
                         PROPERTIES ENVIRONMENT "OMP_WAIT_POLICY=passive"
                         WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  endif()
endfunction()

# percolith_fuzz_target(NAME ROOMS... LIBRARIES...): fuzz/fuzz_<name>.cpp becomes a libFuzzer program.
# It takes the objects of the rooms that it calls in place of their libraries: those would have all
# rooms built of which these include a header. (The preset's CMAKE_OPTIMIZE_DEPENDENCIES is needed
# too: without it objects wait for the libraries that theirs depends on.)
function(percolith_fuzz_target name)
  cmake_parse_arguments(fuzz "" "" "ROOMS;LIBRARIES" ${ARGN})
  set(target fuzz_${name})
  add_executable(${target} fuzz/${target}.cpp)
  foreach(room ${fuzz_ROOMS})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:percolith_${room}>)
    target_include_directories(${target}
                               PRIVATE $<TARGET_PROPERTY:percolith_${room},INCLUDE_DIRECTORIES>)
  endforeach()
  target_link_libraries(${target} PRIVATE percolith_compile ${fuzz_LIBRARIES})
  target_link_options(${target} PRIVATE -fsanitize=fuzzer)
endfunction()
