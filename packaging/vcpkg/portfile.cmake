# A port for vcpkg, of the checkout that it lies in, as no release is published:
#     vcpkg install meniscus --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options INVERTED_FEATURES tools MENISCUS_RUNTIME_ONLY)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS ${options}
        -DMENISCUS_TRAINER=OFF
        -DMENISCUS_TESTS=OFF
        -DMENISCUS_PYTHON=OFF
        -DMENISCUS_BENCHMARKS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/meniscus)
if("tools" IN_LIST FEATURES)
    vcpkg_fixup_pkgconfig()
    vcpkg_copy_tools(TOOL_NAMES meniscus AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
