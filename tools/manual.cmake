# Manual pages and completions, which the programs write themselves once they are built.
set(manual ${PROJECT_BINARY_DIR}/manual)
find_program(STRATA_GZIP gzip)
set(compress "")
if(STRATA_GZIP)
  set(compress COMMAND sh -c "${STRATA_GZIP} -9nf '${manual}'/man1/*.1")
endif()
set(programs strata_tool)
if(TARGET strata_verify)
  list(APPEND programs strata_verify)  # describes two of the verbs
endif()
add_custom_command(OUTPUT ${manual}/stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
  COMMAND strata_tool manual --all ${manual}/man1
  ${compress}
  COMMAND strata_tool completion bash > ${manual}/strata
  COMMAND strata_tool completion zsh > ${manual}/_strata
  COMMAND strata_tool completion fish > ${manual}/strata.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${manual}/stamp
  DEPENDS ${programs} VERBATIM)
add_custom_target(strata_manual ALL DEPENDS ${manual}/stamp)

include(GNUInstallDirs)
install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT tools OPTIONAL)
install(FILES ${manual}/strata DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools OPTIONAL)
install(FILES ${manual}/_strata DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT tools OPTIONAL)
install(FILES ${manual}/strata.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tools OPTIONAL)
