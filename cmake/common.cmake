# Compiler settings that every target of the project shares.
include(${CMAKE_CURRENT_LIST_DIR}/hardening.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/kernel.cmake)

# Warnings for our own code; -ffp-contract=off because the same input must give the same bits on
# every x86-64 machine, and a compiler that fuses a multiplication with an addition does not. A
# target with the property CONTRACTED is built as a host may build it: there it does.
add_library(meniscus_settings INTERFACE)
target_compile_options(meniscus_settings INTERFACE -Wall -Wextra
    -ffp-contract=$<IF:$<BOOL:$<TARGET_PROPERTY:CONTRACTED>>,fast,off>)

# meniscus_library(NAME [STATIC|SHARED|MODULE] SOURCES...): a library of the project. Headers are
# included as <meniscus/FOLDER/ROOM/NAME.hpp>, in the tree, by way of the links in include/, as in an
# installed copy.
function(meniscus_library name)
    add_library(${name} ${ARGN})
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:meniscus_settings>
        $<BUILD_INTERFACE:meniscus_hardening>)
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# meniscus_compile_alone(SOURCES...): files that share names within themselves with a neighbor (each file
# format has its header). All others can be compiled several at a time, so that headers are read less
# often: -DCMAKE_UNITY_BUILD=ON, as the scripts do.
function(meniscus_compile_alone)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# meniscus_install_headers(FOLDERS...): what a folder, or a room of one, offers to others. What it
# keeps for itself lies in folders named `detail`.
function(meniscus_install_headers)
    foreach(folder ${ARGN})
        install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/meniscus/${folder}
            FILES_MATCHING PATTERN "*.hpp" PATTERN detail EXCLUDE)
    endforeach()
endfunction()
