# keiko_room(NAME SOURCES file... [LINK target...] [PRIVATE target...])
# One target a room, so that a forbidden #include is also a missing link.
# LINK names the rooms (and the libraries of its public headers) it is built on;
# PRIVATE names third-party libraries that no header of the room shows.
# The objects serve programs and the shared library alike, so that each file is compiled once.
function(keiko_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(keiko_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(keiko_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(keiko_${name} PUBLIC ${ROOM_LINK} PRIVATE keiko_flags ${ROOM_PRIVATE})
  set_target_properties(keiko_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # clang 14 takes the mark of a namespace for its classes, not for its functions: it hides nothing.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_target_properties(keiko_${name} PROPERTIES
      CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  endif()
  # Nobody replaces the library's functions by others of their name: calls may be inlined.
  target_compile_options(keiko_${name} PRIVATE -fno-semantic-interposition)
endfunction()

# Sets `rooms` to all rooms that a target is built on and the kernels of these (keiko_kernels), and
# `third_party` to the libraries that they link.
function(keiko_parts_of target rooms third_party)
  set(left ${target})
  set(found_rooms "")
  set(found_libraries "")
  while(left)
    list(POP_FRONT left one)
    get_target_property(interface ${one} INTERFACE_LINK_LIBRARIES)
    foreach(library ${interface})
      string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}")
      get_target_property(kind ${library} TYPE)
      if(NOT library MATCHES "^keiko_")
        list(APPEND found_libraries ${library})
      elseif(kind STREQUAL "STATIC_LIBRARY" AND NOT library IN_LIST found_rooms)
        list(APPEND found_rooms ${library})
        list(APPEND left ${library})
        get_property(kernels TARGET ${library} PROPERTY KEIKO_KERNELS)
        list(APPEND found_rooms ${kernels})
      endif()
    endforeach()
  endwhile()
  list(REMOVE_DUPLICATES found_libraries)
  set(${rooms} ${found_rooms} PARENT_SCOPE)
  set(${third_party} ${found_libraries} PARENT_SCOPE)
endfunction()
