# Debian packages, made by `./dev package` or by cpack in the folder of the build: keiko, keiko-dev,
# keiko-doc and python3-keiko hold the components runtime, dev, doc and python3.
if(KEIKO_SANITIZE)
  return()
endif()
set(KEIKO_MAINTAINER "The Keiko authors <keiko@example.org>" CACHE STRING
  "Name and address of who answers for the Debian packages")
set(KEIKO_HOMEPAGE "" CACHE STRING "Page of the project, named by the Debian packages; empty: none")

set(debian ${PROJECT_SOURCE_DIR}/src/cmake/debian)
set(changelog ${PROJECT_BINARY_DIR}/package/changelog.gz)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${debian}/changelog)
execute_process(COMMAND gzip -9nc ${debian}/changelog OUTPUT_FILE ${changelog}
  COMMAND_ERROR_IS_FATAL ANY)

# Fields of the package of a component, and the two files that policy wants in each package.
function(keiko_debian_package component name section depends summary text)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  install(FILES ${debian}/copyright ${changelog} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(same_keiko "keiko (= ${PROJECT_VERSION})")
# Lines of at most 80 characters, as policy has it.
set(what_it_is "Keiko judges car-body surfaces by the reflections of parallel lamps, which it
computes on the CAD surface itself. With each number it states how far that may
be wrong.")

set(CPACK_COMPONENTS_ALL "")
keiko_debian_package(runtime keiko science ""
  "surface quality by exact reflections of lamps" "${what_it_is}
This package has the command line, the shared library, and the reader of STEP,
IGES and BREP files.")
keiko_debian_package(dev keiko-dev libdevel "${same_keiko}, libimath-dev"
  "surface quality by exact reflections of lamps (development files)" "${what_it_is}
This package has the headers, and what CMake and pkg-config need to find the
library.")
keiko_debian_package(doc keiko-doc doc ""
  "surface quality by exact reflections of lamps (documentation)" "${what_it_is}
This package has the pages of the documentation, with pictures and examples.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "keiko-doc, python3-keiko")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${debian}/triggers)

# The module serves the Python that it was built for; Debian packages have their distribution's.
if(KEIKO_PYTHON_BUILT)
  execute_process(COMMAND /usr/bin/python3 -c
    "import sys, sysconfig as s; v = sys.version_info
print(s.get_config_var('EXT_SUFFIX'), f'{v[0]}.{v[1]}', f'{v[0]}.{v[1] + 1}', sep=';')"
    OUTPUT_VARIABLE system_python OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  get_target_property(suffix keiko_python SUFFIX)
  list(LENGTH system_python known)
endif()
if(known EQUAL 3 AND system_python MATCHES "^${suffix};")
  list(GET system_python 1 python_version)
  list(GET system_python 2 next_version)
  keiko_debian_package(python3 python3-keiko python
    "${same_keiko}, python3 (>= ${python_version}), python3 (<< ${next_version}), python3-numpy"
    "surface quality by exact reflections of lamps (Python 3 module)" "${what_it_is}
This package has the module, with NumPy arrays in and out.")
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_SUGGESTS python3-pytest)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_CONTROL_EXTRA ${debian}/postinst ${debian}/prerm)
else()
  message(STATUS "Package python3-keiko: there is no module for /usr/bin/python3; not made")
endif()

# What the packages are made of, without the tests.
add_custom_target(keiko_packaged)
foreach(part keiko keiko-import keiko_library keiko_user_pages keiko_python)
  if(TARGET ${part})
    add_dependencies(keiko_packaged ${part})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME keiko)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each component has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${KEIKO_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${KEIKO_HOMEPAGE}")
set(CPACK_DEBIAN_PACKAGE_SOURCE keiko)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The module finds the library of this build; the package of that is a dependency already.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
include(CPack)
