# Man pages and shell completions, written by the program that they are about. They come with the
# component runtime, in the places where Debian's man, bash, zsh and fish look.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND OR KEIKO_SANITIZE)
  message(STATUS "Man pages and completions: no Python, or sanitizers; not written")
  return()
endif()

set(pages ${PROJECT_BINARY_DIR}/pages)
set(written_by docs/generate_man.py docs/generate_cli.py)
list(TRANSFORM written_by PREPEND ${PROJECT_SOURCE_DIR}/)
add_custom_command(OUTPUT ${pages}/man/keiko.1.gz
  COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/docs/generate_man.py
    $<TARGET_FILE:keiko> ${pages}/man
  DEPENDS keiko ${written_by} VERBATIM)

set(completions "")
function(keiko_completion shell file folder)
  add_custom_command(OUTPUT ${pages}/${file}
    COMMAND $<TARGET_FILE:keiko> completion ${shell} > ${pages}/${file}
    DEPENDS keiko VERBATIM)
  install(FILES ${pages}/${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT runtime)
  set(completions ${completions} ${pages}/${file} PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY ${pages})
keiko_completion(bash keiko bash-completion/completions)
keiko_completion(zsh _keiko zsh/vendor-completions)
keiko_completion(fish keiko.fish fish/vendor_completions.d)

add_custom_target(keiko_user_pages ALL DEPENDS ${pages}/man/keiko.1.gz ${completions})
# A page for each command, whatever commands there are.
install(DIRECTORY ${pages}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime
  FILES_MATCHING PATTERN "*.1.gz")
