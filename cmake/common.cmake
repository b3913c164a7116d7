# Include paths and compiler settings that every target of the project shares.

# Headers are included as <meniscus/FOLDER/NAME.hpp>, here as in an installed copy. Here that path
# leads through links in the build tree to the source folders.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/meniscus)
foreach(folder runtime c_interface data labeler classifier sph)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/include/meniscus/${folder}
        SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/c_interface/meniscus.h
    ${PROJECT_BINARY_DIR}/include/meniscus/meniscus.h SYMBOLIC)

configure_file(${PROJECT_SOURCE_DIR}/cmake/version.hpp.in
    ${PROJECT_BINARY_DIR}/include/meniscus/version.hpp @ONLY)

# Warnings for our own code; -ffp-contract=off because the same input must give the same bits on
# every x86-64 machine, and a compiler that fuses a multiplication with an addition does not. A
# target with the property CONTRACTED is built as a host may build it: there it does.
add_library(meniscus_settings INTERFACE)
target_compile_options(meniscus_settings INTERFACE -Wall -Wextra
    -ffp-contract=$<IF:$<BOOL:$<TARGET_PROPERTY:CONTRACTED>>,fast,off>)

# meniscus_library(NAME [STATIC|SHARED|MODULE] SOURCES...): a library of the project.
function(meniscus_library name)
    add_library(${name} ${ARGN})
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:meniscus_settings>)
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()
