# An overlay port: vcpkg install strata --overlay-ports=packaging/vcpkg, with STRATA_SOURCE=FOLDER for a checkout in place of a release.
# A release fills in where its source is (tools/release prints the sum).
if(DEFINED ENV{STRATA_SOURCE})
  set(SOURCE_PATH "$ENV{STRATA_SOURCE}")
else()
  get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
endif()

vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES assimp STRATA_WITH_ASSIMP tools STRATA_BUILD_TOOLS)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${options} -DSTRATA_BUILD_TESTS=OFF -DSTRATA_BUILD_ORACLE=OFF -DSTRATA_INSTALL=ON
    -DSTRATA_WITH_LIBDEFLATE=OFF -DSTRATA_WITH_PNG=OFF -DSTRATA_WITH_JPEG=OFF -DSTRATA_WITH_FONTS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/strata)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES strata strata-verify AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/python/THIRD_PARTY_LICENSES.txt")
