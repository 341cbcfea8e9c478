# keiko_room(NAME SOURCES file... [LINK target...] [PRIVATE target...])
# One target a room, so that a forbidden #include is also a missing link.
# LINK names the rooms (and the libraries of its public headers) it is built on;
# PRIVATE names third-party libraries that no header of the room shows.
function(keiko_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(keiko_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(keiko_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(keiko_${name} PUBLIC ${ROOM_LINK} PRIVATE keiko_flags ${ROOM_PRIVATE})
endfunction()
