# keiko_layer(NAME SOURCES file... [LINK target...] [PRIVATE target...])
# One target per layer, so that a forbidden #include is also a missing link.
# LINK names the layers (and the libraries of its public headers) it is built on;
# PRIVATE names third-party libraries that no header of the layer shows.
function(keiko_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(keiko_${name} STATIC ${LAYER_SOURCES})
  target_include_directories(keiko_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(keiko_${name} PUBLIC ${LAYER_LINK} PRIVATE keiko_flags ${LAYER_PRIVATE})
endfunction()
