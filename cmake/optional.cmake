# strata_optional(NAME WITHOUT PACKAGE TARGET [PACKAGE TARGET...]): looks for what the option STRATA_WITH_<NAME> needs. Where a
# package is missing, says what does not work without it, and turns the option off.
macro(strata_optional name without)
  if(STRATA_WITH_${name})
    set(strata_needed ${ARGN})
    while(strata_needed)
      list(POP_FRONT strata_needed strata_package strata_target)
      if(NOT TARGET ${strata_target})  # HarfBuzz's files for CMake cannot be read twice
        find_package(${strata_package} QUIET)
      endif()
      if(NOT TARGET ${strata_target})
        message(STATUS "${strata_package} not found: ${without}")
        set(STRATA_WITH_${name} OFF)
      endif()
    endwhile()
  endif()
endmacro()
