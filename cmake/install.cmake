# Install rules: public headers, one archive per module, the CMake package, the pkg-config file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
get_property(module_targets GLOBAL PROPERTY strata_modules)
list(REVERSE module_targets)  # in the order in which a linker wants archives
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/strata)

install(TARGETS strata ${module_targets} EXPORT strata ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
# The headers of the core, and those of the extensions that are built.
set(public_headers strata attributes carry_attributes check combine coordinate_grid errors expression file_path formula function io measure mesh monitor options plane primitives
  rational resolve rounding shared solid srgb transform unit version)
get_property(built_extensions GLOBAL PROPERTY strata_extensions)
foreach(extension ${built_extensions})
  if(extension STREQUAL scene)
    list(APPEND public_headers query)
  else()
    list(APPEND public_headers ${extension})
  endif()
endforeach()
list(TRANSFORM public_headers PREPEND include/strata/)
list(TRANSFORM public_headers APPEND .h)
install(FILES ${public_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/strata)
install(EXPORT strata NAMESPACE strata:: FILE strataTargets.cmake DESTINATION ${package_dir})

configure_package_config_file(cmake/strataConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/strataConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/strataConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/strataConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/strataConfigVersion.cmake
  DESTINATION ${package_dir})
if(STRATA_WITH_GMP)
  install(FILES cmake/FindGMP.cmake DESTINATION ${package_dir})
endif()
if(STRATA_WITH_LIBDEFLATE)
  install(FILES cmake/FindLibDeflate.cmake DESTINATION ${package_dir})
endif()

# pkg-config: the prefix is found from the file's own place, so that the tree can be moved.
list(TRANSFORM module_targets PREPEND -l OUTPUT_VARIABLE pc_modules)
list(JOIN pc_modules " " pc_modules)
list(JOIN linked_libraries " " pc_libraries)
set(pc_definitions "")
if(NOT STRATA_WITH_GMP)
  set(pc_definitions " -DSTRATA_WITHOUT_GMP=1")
endif()
file(RELATIVE_PATH pc_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/strata.pc.in ${CMAKE_CURRENT_BINARY_DIR}/strata.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/strata.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES LICENSE python/THIRD_PARTY_LICENSES.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licences)
