# The API reference (docs/api/Doxyfile.in) where Doxygen is found, and the pages as a site where MkDocs
# is: targets of their own, which nothing needs.
find_program(MENISCUS_DOXYGEN doxygen)
find_program(MENISCUS_MKDOCS mkdocs)
configure_file(${PROJECT_SOURCE_DIR}/docs/api/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
if(MENISCUS_DOXYGEN)
    add_custom_target(docs_api COMMAND ${MENISCUS_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
        COMMENT "API reference in ${PROJECT_BINARY_DIR}/docs_api/html")
endif()
if(MENISCUS_MKDOCS)
    add_custom_target(docs_site COMMAND ${MENISCUS_MKDOCS} build --strict --quiet
        --config-file ${PROJECT_SOURCE_DIR}/mkdocs.yml --site-dir ${PROJECT_BINARY_DIR}/docs_site
        COMMENT "Site in ${PROJECT_BINARY_DIR}/docs_site")
endif()
