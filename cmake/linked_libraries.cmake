# What a program is linked with beside Strata's own archives: `linked_libraries`, as linkers are told, and `linked_packages`, the
# packages of Debian with which programs are built.
set(linked_libraries "")
set(linked_packages "libboost-dev")
macro(strata_links libraries packages)  # the rest: the condition
  if(${ARGN})
    list(APPEND linked_libraries ${libraries})
    list(APPEND linked_packages ${packages})
  endif()
endmacro()
strata_links("-ltbb" "libtbb-dev" STRATA_WITH_TBB)
strata_links("-lgmp" "libgmp-dev" STRATA_WITH_GMP)
strata_links("-lz" "zlib1g-dev" TRUE)
strata_links("-ldeflate" "libdeflate-dev" STRATA_WITH_LIBDEFLATE)
strata_links("-lassimp" "libassimp-dev" STRATA_WITH_ASSIMP)
strata_links("-lpng" "libpng-dev" STRATA_WITH_PNG AND TARGET strata_openscad)
strata_links("-lfontconfig;-lharfbuzz;-lfreetype" "libfontconfig-dev;libharfbuzz-dev;libfreetype-dev"
  STRATA_WITH_FONTS AND TARGET strata_openscad)
strata_links("-lpugixml" "libpugixml-dev" TARGET strata_planar)
