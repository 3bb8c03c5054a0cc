# aspect_documents(PROGRAM WRITER... COMPONENT name): the manual pages and completions of a program,
# written when it is built, into share/ of the build folder as they are installed. WRITER... FOLDER
# writes them: the program itself, which makes them of what its --help says.
include(GNUInstallDirs)
set(aspect_documents_folder ${CMAKE_BINARY_DIR}/share)
if(CMAKE_CROSSCOMPILING)
  # What runs a board's program here may be missing where it is only built.
  list(GET CMAKE_CROSSCOMPILING_EMULATOR 0 emulator)
  find_program(aspect_documents_emulator ${emulator})
endif()
add_custom_target(documents ALL)

function(aspect_documents program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "COMPONENT;SECTION" "WRITER")
  if(CMAKE_CROSSCOMPILING AND NOT aspect_documents_emulator)
    return()
  endif()
  set(stamp ${CMAKE_CURRENT_BINARY_DIR}/${program}.documents)
  list(GET arg_WRITER 0 writer)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${arg_WRITER} ${aspect_documents_folder}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${writer} VERBATIM)
  add_custom_target(${program}_documents_written DEPENDS ${stamp})
  add_dependencies(documents ${program}_documents_written)
  install(DIRECTORY ${aspect_documents_folder}/man/man${arg_SECTION}
    DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT ${arg_COMPONENT}
    FILES_MATCHING REGEX "/${program}(-[a-z-]+)?\\.${arg_SECTION}$")
  install(FILES ${aspect_documents_folder}/bash-completion/completions/${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${arg_COMPONENT})
  install(FILES ${aspect_documents_folder}/zsh/vendor-completions/_${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT ${arg_COMPONENT})
endfunction()
