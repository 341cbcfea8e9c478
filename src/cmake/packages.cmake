# Third-party libraries, all from Debian 12. Each is linked by the one room that adapts it.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(hwy REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(httplib REQUIRED IMPORTED_TARGET cpp-httplib)
if(KEIKO_FUZZ)
  # Compiled along from its headers, so that the fuzzer sees the paths through it.
  set_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_COMPILE_OPTIONS "")
endif()
find_package(OpenCASCADE REQUIRED)

# Debian's Imath config insists on the Python bindings, which the -dev package does not bring.
find_library(IMATH_LIBRARY Imath REQUIRED)
find_path(IMATH_INCLUDE_DIR Imath/ImathVec.h REQUIRED)
add_library(Imath::Imath UNKNOWN IMPORTED)
set_target_properties(Imath::Imath PROPERTIES
  IMPORTED_LOCATION ${IMATH_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES "${IMATH_INCLUDE_DIR};${IMATH_INCLUDE_DIR}/Imath")

# Debian's OpenImageIO config asks for tools and libraries that the -dev package does not bring.
find_library(OPENIMAGEIO_LIBRARY OpenImageIO REQUIRED)
find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  IMPORTED_LOCATION ${OPENIMAGEIO_LIBRARY}
  INTERFACE_LINK_LIBRARIES "${OPENIMAGEIO_UTIL_LIBRARY};Imath::Imath"
  INTERFACE_INCLUDE_DIRECTORIES ${OPENIMAGEIO_INCLUDE_DIR})

# Debian's OpenSubdiv config insists on static libraries that the -dev package does not bring.
find_library(OPENSUBDIV_LIBRARY osdCPU REQUIRED)
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/bfr/surface.h REQUIRED)
file(STRINGS ${OPENSUBDIV_INCLUDE_DIR}/opensubdiv/version.h OpenSubdiv_VERSION
  REGEX "define OPENSUBDIV_VERSION_NUMBER")
# 30500 is 3.5.0.
string(REGEX REPLACE ".* ([0-9]+)(..)(..)$" "\\1.\\2.\\3" OpenSubdiv_VERSION "${OpenSubdiv_VERSION}")
string(REGEX REPLACE "\\.0" "." OpenSubdiv_VERSION "${OpenSubdiv_VERSION}")
add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED)
set_target_properties(OpenSubdiv::osdCPU PROPERTIES
  IMPORTED_LOCATION ${OPENSUBDIV_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${OPENSUBDIV_INCLUDE_DIR})

# OpenCASCADE's headers are warning-rich: hand them on as system headers, data exchange and all.
add_library(keiko_occt INTERFACE)
target_include_directories(keiko_occt SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(keiko_occt INTERFACE
  TKXDESTEP TKXDEIGES TKXCAF TKLCAF TKCAF TKCDF TKSTEP TKSTEPAttr TKSTEPBase TKSTEP209 TKIGES
  TKXSBase TKOffset TKBool TKFillet TKShHealing TKMesh TKBO TKPrim TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d
  TKG2d TKMath TKernel)
