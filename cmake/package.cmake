# `cpack -G DEB` (or RPM, TGZ) in the build folder: one package of command, libraries, headers and
# Python module, and one of the libtorch module, whose libraries nothing else needs. What each depends
# on Debian's own tools find (docs/packages.md).
set(CPACK_PACKAGE_NAME meniscus)
set(CPACK_PACKAGE_VENDOR meniscus)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Finds the free surface of SPH fluids, trains and exports surface classifiers, and
computes surface tension: a command, C and C++ libraries, and a Python module.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_CONTACT "The authors of meniscus")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_THREADS 0)
# A tree of sources is what `git archive` makes.
set(CPACK_SOURCE_GENERATOR "")

# Components of one group become one package.
set(CPACK_COMPONENTS_ALL Unspecified python)
set(CPACK_COMPONENT_UNSPECIFIED_GROUP meniscus)
set(CPACK_COMPONENT_PYTHON_GROUP meniscus)
if(MENISCUS_TRAINER)
    list(APPEND CPACK_COMPONENTS_ALL trainer)
    set(CPACK_COMPONENT_TRAINER_GROUP trainer)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_MENISCUS_PACKAGE_NAME meniscus)
set(CPACK_DEBIAN_MENISCUS_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
if(MENISCUS_PYTHON AND TARGET meniscus_python)
    set(CPACK_DEBIAN_MENISCUS_PACKAGE_DEPENDS "python3, python3-numpy")
    set(CPACK_DEBIAN_MENISCUS_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/debian/prerm)
endif()
# What programs that are built against the static libraries need besides.
set(CPACK_DEBIAN_MENISCUS_PACKAGE_SUGGESTS "libhdf5-dev, libssl-dev, libzstd-dev, zlib1g-dev, meniscus-trainer")
set(CPACK_DEBIAN_TRAINER_PACKAGE_NAME meniscus-trainer)
set(CPACK_DEBIAN_TRAINER_PACKAGE_DEPENDS "meniscus (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_TRAINER_DESCRIPTION
    "The libtorch module: `meniscus train --objective logistic` and `network`, and `calibrate`.")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
include(CPack)
