# meniscus_kernel(TARGET FILES...): adds kernels (runtime/simd/dispatch.hpp) to a target. Each file is
# compiled once as all others of the target, for the baseline, and once for each wider instruction
# set, by way of a file in the build folder that includes it.
function(meniscus_kernel target)
    target_sources(${target} PRIVATE ${ARGN})
    meniscus_compile_alone(${ARGN})
    foreach(file ${ARGN})
        cmake_path(GET file STEM name)
        file(RELATIVE_PATH kernel ${CMAKE_CURRENT_BINARY_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
        foreach(set AVX2 AVX512)
            string(TOLOWER ${name}_${set}.cpp wide)
            configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/kernel.cpp.in ${wide} @ONLY)
            target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${wide})
            meniscus_compile_alone(${CMAKE_CURRENT_BINARY_DIR}/${wide})
        endforeach()
    endforeach()
endfunction()
