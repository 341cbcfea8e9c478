# keiko_kernels(TARGET file...)
# Compiles files of a target once for each instruction set, into the namespace KEIKO_LEVEL
# (docs/decisions/0020-one-formula-for-all-lanes.md). They are optimised in every configuration, and
# link-time optimisation does not see them: what is inlined leaves no symbol that the linker could
# choose for code of another set. tests/kernel_symbols.py holds that.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(KEIKO_LEVELS base v3 v4)
else()
  set(KEIKO_LEVELS base)
endif()
# AES is no part of a level, but Highway's sets have it, and so do all processors of these levels.
set(KEIKO_FLAGS_base "")
set(KEIKO_FLAGS_v3 -march=x86-64-v3 -maes -mpclmul)
set(KEIKO_FLAGS_v4 -march=x86-64-v4 -maes -mpclmul)

function(keiko_kernels user)
  foreach(level ${KEIKO_LEVELS})
    set(target ${user}_kernels_${level})
    add_library(${target} OBJECT ${ARGN})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${target} PRIVATE keiko_flags Imath::Imath fmt::fmt hwy::hwy)
    target_compile_definitions(${target} PRIVATE KEIKO_LEVEL=level_${level})
    target_compile_options(${target} PRIVATE ${KEIKO_FLAGS_${level}} -O2 -fno-lto)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON
      CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_sources(${user} PRIVATE $<TARGET_OBJECTS:${target}>)
    set_property(TARGET ${user} APPEND PROPERTY KEIKO_KERNELS ${target})
    set_property(GLOBAL APPEND PROPERTY KEIKO_KERNEL_TARGETS ${target})
  endforeach()
endfunction()
