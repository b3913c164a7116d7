# What `cmake --install` puts where, and the package files for find_package(meniscus).
include(CMakePackageConfigHelpers)

# The runtime is headers alone, which include what lies in their `detail`, too.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/meniscus/runtime FILES_MATCHING PATTERN "*.hpp")
install(TARGETS meniscus_runtime EXPORT meniscus_targets)
set(MENISCUS_COMPONENTS runtime)

if(NOT MENISCUS_RUNTIME_ONLY)
    meniscus_install_headers(data/clouds data/formats data/particles data/ranks data/slabs data/text
        labeler)
    install(FILES ${PROJECT_SOURCE_DIR}/bindings/c/meniscus.h
        ${PROJECT_SOURCE_DIR}/bindings/fortran/meniscus.f90
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/meniscus)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/samples/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus/samples FILES_MATCHING PATTERN "*.vtkhdf")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs/models/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus/models FILES_MATCHING PATTERN "*.json")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs/curvature/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus/curvature FILES_MATCHING PATTERN "*.json")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs/scenes/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus/scenes
        FILES_MATCHING PATTERN "*.json" PATTERN "*.obj")
    if(MENISCUS_BENCHMARKS)
        install(DIRECTORY ${PROJECT_SOURCE_DIR}/validation/
            DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus/studies
            FILES_MATCHING PATTERN "*.json" PATTERN framework EXCLUDE)
    endif()
    install(TARGETS meniscus_neighbor_search meniscus_data meniscus_labeler meniscus_c
        EXPORT meniscus_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    list(APPEND MENISCUS_COMPONENTS c neighbor_search data labeler)

    # For builds that know neither CMake nor C++.
    file(RELATIVE_PATH MENISCUS_PREFIX_FROM_PKGCONFIG
        ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
    configure_file(${PROJECT_SOURCE_DIR}/cmake/meniscus.pc.in ${PROJECT_BINARY_DIR}/meniscus.pc
        @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/meniscus.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

install(EXPORT meniscus_targets FILE meniscusTargets.cmake NAMESPACE meniscus::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/meniscus)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/meniscusConfig.cmake.in
    ${PROJECT_BINARY_DIR}/meniscusConfig.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/meniscus)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/meniscusConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/meniscusConfig.cmake
    ${PROJECT_BINARY_DIR}/meniscusConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/meniscus)
