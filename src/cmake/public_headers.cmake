# The installed headers: those of api, and exactly what they reach. Run as a script, it lists them:
# cmake -P src/cmake/public_headers.cmake
cmake_policy(VERSION 3.25)

function(keiko_public_headers sources result)
  file(GLOB left RELATIVE ${sources} ${sources}/keiko/api/*.h)
  set(found ${left})
  while(left)
    list(POP_FRONT left header)
    file(STRINGS ${sources}/${header} includes REGEX "^#include \"keiko/")
    foreach(include ${includes})
      string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" include "${include}")
      if(NOT include IN_LIST found)
        list(APPEND found ${include})
        list(APPEND left ${include})
      endif()
    endforeach()
  endwhile()
  list(SORT found)
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# Installs them below `folder`. They are searched for when Keiko is installed, so that a changed
# include needs no new configuration.
function(keiko_install_public_headers sources folder)
  keiko_public_headers(${sources} headers)
  foreach(header ${headers})
    cmake_path(GET header PARENT_PATH place)
    file(INSTALL ${sources}/${header} DESTINATION ${folder}/${place})
  endforeach()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_path(SET sources NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/..)
  keiko_public_headers(${sources} headers)
  foreach(header ${headers})
    message(${header})
  endforeach()
endif()
