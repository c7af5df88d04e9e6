# Install rules: headers, one archive per room, the CMake package, the pkg-config file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
get_property(room_targets GLOBAL PROPERTY strata_rooms)
list(REVERSE room_targets)  # in the order in which a linker wants archives
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/strata)

install(TARGETS strata ${room_targets} EXPORT strata ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY lib/strata DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*_internal.h" EXCLUDE PATTERN "internal" EXCLUDE)
install(EXPORT strata NAMESPACE strata:: FILE strataTargets.cmake DESTINATION ${package_dir})

configure_package_config_file(cmake/strataConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/strataConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/strataConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/strataConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/strataConfigVersion.cmake
  cmake/FindGMP.cmake DESTINATION ${package_dir})

# pkg-config: the prefix is found from the file's own place, so that the tree can be moved.
list(TRANSFORM room_targets PREPEND -l OUTPUT_VARIABLE pc_rooms)
list(JOIN pc_rooms " " pc_rooms)
set(pc_assimp "")
if(STRATA_WITH_ASSIMP)
  set(pc_assimp -lassimp)
endif()
file(RELATIVE_PATH pc_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/strata.pc.in ${CMAKE_CURRENT_BINARY_DIR}/strata.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/strata.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
