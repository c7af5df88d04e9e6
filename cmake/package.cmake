# Packages: `cpack` in a build folder of the preset release, or tools/packages. Two packages for Debian, `strata` (the programs) and
# `libstrata-dev`; and a tarball of both, for systems with the same libraries, which its name tells.
set(CPACK_PACKAGE_NAME strata)
set(CPACK_PACKAGE_VENDOR "The Strata contributors")
set(CPACK_PACKAGE_CONTACT "The Strata contributors <maintainers@strata.invalid>" CACHE STRING "Maintainer of packages")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact Booleans of solids given as triangle meshes")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
cmake_host_system_information(RESULT distribution QUERY DISTRIB_ID DISTRIB_VERSION_ID)
list(JOIN distribution "" distribution)
set(CPACK_PACKAGE_FILE_NAME strata-${PROJECT_VERSION}-${distribution}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL tools development debian_tools debian_development)
set(CPACK_COMPONENT_TOOLS_GROUP tools)
set(CPACK_COMPONENT_DEBIAN_TOOLS_GROUP tools)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENT_DEBIAN_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME strata)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "librsvg2-bin, libstrata-dev")
# cpack puts the summary before descriptions, and a space before each line.
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "Unions, intersections, differences and symmetric differences of solids,
computed exactly on the doubles in the files. Coplanar faces, touching edges
and all other degenerate cases are ordinary input. There is no tolerance, and
nothing is moved.

The command line also slices, splits, draws, offsets and compares solids,
finds contacts in assemblies, combines polygons, and tests other engines.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libstrata-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(JOIN linked_packages ", " development_needs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${development_needs}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "The library for C++. Unions, intersections, differences and symmetric
differences of solids given as triangle meshes, computed exactly on the
doubles given.

Headers, static libraries, and files for CMake and pkg-config.")

# What Debian wants in a package: copyright, changes, and reasons for what lintian finds. The bill of materials lies beside them.
find_program(STRATA_GZIP gzip)
find_package(Python3 QUIET COMPONENTS Interpreter)
if(STRATA_GZIP AND Python3_FOUND)
  set(debian ${PROJECT_BINARY_DIR}/debian)
  set(release 1)  # of the package, within one version of Strata
  set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
  execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/bill_of_materials.py
    OUTPUT_VARIABLE bill_of_materials COMMAND_ERROR_IS_FATAL ANY)
  # A field of several lines: each begins with a space, and an empty one is a point.
  file(READ python/THIRD_PARTY_LICENSES.txt third_party)
  string(REGEX REPLACE "[ \t]+\n" "\n" third_party "${third_party}")
  string(REPLACE "\n" "\n " third_party "${third_party}")
  string(REPLACE " \n" " .\n" third_party " ${third_party}")
  string(STRIP "${third_party}" third_party)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  foreach(package strata libstrata-dev)
    set(folder ${debian}/${package})
    set(component debian_tools)
    set(more_overrides "# libgmp is linked dynamically; the program knows a message of it, by which it tells a lack of memory.
strata: embedded-library gmp *
")
    if(package STREQUAL libstrata-dev)
      set(component debian_development)
      set(more_overrides "")
    endif()
    configure_file(packaging/debian/copyright.in ${folder}/copyright @ONLY)
    configure_file(packaging/debian/changelog.in ${folder}/changelog.Debian @ONLY)
    configure_file(packaging/debian/lintian-overrides.in ${folder}/overrides/${package} @ONLY)
    configure_file(CHANGELOG.md ${folder}/changelog COPYONLY)
    execute_process(COMMAND ${STRATA_GZIP} -9nf ${folder}/changelog ${folder}/changelog.Debian)
    file(WRITE ${folder}/strata.cdx.json "${bill_of_materials}")
    install(FILES ${folder}/copyright ${folder}/changelog.gz ${folder}/changelog.Debian.gz ${folder}/strata.cdx.json
      DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${folder}/overrides/${package} DESTINATION share/lintian/overrides COMPONENT ${component} EXCLUDE_FROM_ALL)
  endforeach()
endif()
include(CPack)
