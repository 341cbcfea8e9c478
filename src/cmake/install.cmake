# What is installed, by component: runtime (programs, library, data), dev (headers and what finds the
# library), doc (pages and examples). docs/library.md lists it for users.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/keiko)
set(data_folder ${CMAKE_INSTALL_DATADIR}/keiko)

install(TARGETS keiko RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
# The program and the library look for it there (import/worker/import_worker.cpp).
install(TARGETS keiko-import RUNTIME DESTINATION libexec/keiko COMPONENT runtime)
install(TARGETS keiko_library
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(DIRECTORY lightrigs/ DESTINATION ${data_folder}/rigs COMPONENT runtime
  PATTERN presets EXCLUDE PATTERN README.md EXCLUDE)
install(DIRECTORY lightrigs/presets DESTINATION ${data_folder} COMPONENT runtime)
install(DIRECTORY docs/schema DESTINATION ${data_folder} COMPONENT runtime)
install(FILES src/cmake/slurm/keiko-array.sbatch DESTINATION ${data_folder} COMPONENT runtime)

install(CODE "
  include(${PROJECT_SOURCE_DIR}/src/cmake/public_headers.cmake)
  keiko_install_public_headers(${PROJECT_SOURCE_DIR}/src
    \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")" COMPONENT dev)

# A static library hands its own dependencies on to those who link it, on the system it was built on.
set(KEIKO_LINKED "")
if(NOT KEIKO_SHARED)
  keiko_parts_of(keiko_api rooms third_party)
  foreach(library ${third_party})
    get_target_property(kind ${library} TYPE)
    if(NOT kind STREQUAL "INTERFACE_LIBRARY")
      list(APPEND KEIKO_LINKED $<TARGET_LINKER_FILE:${library}>)
    endif()
  endforeach()
  list(APPEND KEIKO_LINKED ${OPENIMAGEIO_UTIL_LIBRARY} -pthread -ldl)
endif()
set(KEIKO_KIND $<IF:$<BOOL:${KEIKO_SHARED}>,SHARED,STATIC>)
set(KEIKO_LIBRARY_FILE $<TARGET_FILE_NAME:keiko_library>)

function(keiko_install_package_file template name folder)
  configure_package_config_file(src/cmake/${template} ${PROJECT_BINARY_DIR}/package/${name}.in
    INSTALL_DESTINATION ${folder} PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/package/${name}
    INPUT ${PROJECT_BINARY_DIR}/package/${name}.in)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name} DESTINATION ${folder} COMPONENT dev)
endfunction()

keiko_install_package_file(keikoConfig.cmake.in keikoConfig.cmake ${package_folder})
# Before 1.0 a minor version may change what the last one had.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/keikoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/keikoConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT dev)

file(RELATIVE_PATH KEIKO_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" KEIKO_PREFIX_FROM_PC "${KEIKO_PREFIX_FROM_PC}")
list(JOIN KEIKO_LINKED " " KEIKO_LIBS_PRIVATE)
keiko_install_package_file(keiko.pc.in keiko.pc ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc
  PATTERN "*.py" EXCLUDE PATTERN schema EXCLUDE PATTERN decisions EXCLUDE
  PATTERN Doxyfile EXCLUDE PATTERN CONTRIBUTING.md EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
