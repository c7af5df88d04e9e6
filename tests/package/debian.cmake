# Debian's packages of this build: what must be in them, and what they need. lintian finds no fault, where it is there.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(DPKG_DEB dpkg-deb)
if(NOT DPKG_DEB)
  message("SKIPPED: there is no dpkg-deb.")
  return()
endif()
file(REMOVE_RECURSE ${SCRATCH})
run(sh -c "umask 022 && '${CPACK}' -G DEB --config '${BUILD}/CPackConfig.cmake' -B '${SCRATCH}'")

# The package NAME must have each of the files, with something in it, and each of the fields.
function(expect_package name)
  cmake_parse_arguments(PARSE_ARGV 1 this "" "" "FILES;FIELDS")
  file(GLOB package ${SCRATCH}/${name}_*.deb)
  run(${DPKG_DEB} --extract ${package} ${SCRATCH}/${name})
  foreach(file ${this_FILES})
    file(SIZE ${SCRATCH}/${name}/usr/${file} size)
    if(size EQUAL 0)
      message(FATAL_ERROR "${file} is empty in ${package}")
    endif()
  endforeach()
  run(${DPKG_DEB} --info ${package})
  foreach(field ${this_FIELDS})
    if(NOT run_output MATCHES "${field}")
      message(FATAL_ERROR "expected '${field}' in: ${run_output}")
    endif()
  endforeach()
  file(READ ${SCRATCH}/${name}/usr/share/doc/${name}/copyright copyright)
  foreach(library oneTBB Boost pugixml fmt nlohmann-json CLI11)
    if(NOT copyright MATCHES "\n ${library}")
      message(FATAL_ERROR "${package}: the licence of ${library} is missing")
    endif()
  endforeach()
endfunction()

expect_package(strata FILES bin/strata bin/strata-verify share/man/man1/strata.1.gz share/man/man1/strata-union.1.gz
  share/bash-completion/completions/strata share/zsh/site-functions/_strata share/fish/vendor_completions.d/strata.fish
  share/doc/strata/strata.cdx.json share/doc/strata/changelog.gz share/doc/strata/changelog.Debian.gz
  share/strata/data/cases/contact-vertex-face-outside-union/case.json FIELDS "Depends: .*libtbb12 .*zlib1g")
expect_package(libstrata-dev FILES lib/libstrata_csg.a include/strata/strata.h lib/cmake/strata/strataConfig.cmake lib/pkgconfig/strata.pc
  share/doc/libstrata-dev/strata.cdx.json share/doc/libstrata-dev/changelog.gz FIELDS "Depends: .*libtbb-dev.*zlib1g-dev")

find_program(LINTIAN lintian)
if(LINTIAN)
  file(GLOB packages ${SCRATCH}/*.deb)
  # tools/packages names Debian's own folder for libraries, this build need not.
  run(${LINTIAN} --fail-on error,warning --suppress-tags pkg-config-unavailable-for-cross-compilation ${packages})
endif()
