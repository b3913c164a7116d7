# What makes a fault in a program harder to turn into more than a crash, as Debian builds its own
# packages (dpkg-buildflags): for what is installed, that is, what people run on files from elsewhere.
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX) # programs lie at random addresses; the code is made for that anyway

# Arrays on the stack end in a word that is checked; calls of the C library whose room is known are
# checked, too; and nobody can write to the tables of functions, which are filled at the start. Loops
# over particles stay what they are.
add_library(meniscus_hardening INTERFACE)
target_compile_options(meniscus_hardening INTERFACE -fstack-protector-strong)
target_link_options(meniscus_hardening INTERFACE -Wl,-z,relro,-z,now)
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize") # which check more, and in their own way
    target_compile_options(meniscus_hardening INTERFACE
        $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE>
        $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-D_FORTIFY_SOURCE=2>)
endif()

# meniscus_harden(TARGET): a program or a library that is loaded. It looks for libraries where they
# were found when it was built, the same in the build tree and installed. CMake would else make room
# for another path by a colon at the end, and that means the current folder.
function(meniscus_harden target)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:meniscus_hardening>)
    set_target_properties(${target} PROPERTIES
        BUILD_WITH_INSTALL_RPATH ON
        INSTALL_RPATH_USE_LINK_PATH ON)
endfunction()
