# Makes the Debian packages of a build and runs what is in them from a scratch root: the command, the
# libraries by pkg-config and find_package, and the Python module.
cmake_minimum_required(VERSION 3.25)

# run(OUTPUT COMMAND...): the command must succeed; OUTPUT becomes what it prints.
function(run output)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT status EQUAL 0)
        list(JOIN ARGN " " command)
        message("${out}${err}")
        message(FATAL_ERROR "${command}\nended with ${status}")
    endif()
    set(${output} "${out}" PARENT_SCOPE)
endfunction()

function(expect_match text pattern)
    if(NOT text MATCHES "${pattern}")
        message(FATAL_ERROR "no '${pattern}' in:\n${text}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(ignored ${CPACK} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${WORK})
file(GLOB package ${WORK}/meniscus_*.deb)
list(LENGTH package count)
if(NOT count EQUAL 1)
    message(FATAL_ERROR "expected one package of meniscus, found '${package}'")
endif()

# The libraries that the command links, found by dpkg-shlibdeps; not those of the trainer.
run(depends dpkg-deb --field ${package} Depends)
foreach(library libc6 libfmt libhdf5 libssl libstdc)
    expect_match("${depends}" "${library}")
endforeach()
if(depends MATCHES "torch")
    message(FATAL_ERROR "the command does not need libtorch: ${depends}")
endif()

set(root ${WORK}/root)
run(ignored dpkg-deb -x ${package} ${root})
run(printed ${root}/usr/bin/meniscus --version)
run(ignored ${root}/usr/bin/meniscus label ${root}/usr/share/meniscus/samples/droplet_iisph_01.vtkhdf
    -o ${WORK}/labelled --samples 100 --quiet)
if(PYTHON)
    file(GLOB module ${root}/usr/lib/python3*/dist-packages)
    run(ignored ${CMAKE_COMMAND} -E env PYTHONPATH=${module} ${PYTHON} -B -c
        "import meniscus; meniscus.Line.shipped(2, 2)")
endif()

find_program(pkg_config pkg-config)
if(pkg_config)
    file(GLOB_RECURSE description ${root}/*/meniscus.pc)
    cmake_path(GET description PARENT_PATH folder)
    run(flags ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
        ${pkg_config} --cflags --libs meniscus)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    cmake_path(GET folder PARENT_PATH libraries)
    run(ignored ${C_COMPILER} ${SOURCE}/examples/04_c_interface.c -o ${WORK}/c_interface
        ${flags} -lm)
    run(ignored ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${WORK}/c_interface)
endif()
run(ignored ${CMAKE_COMMAND} -S ${SOURCE}/examples -B ${WORK}/examples -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${root}/usr)
run(ignored ${CMAKE_COMMAND} --build ${WORK}/examples --target example_classify)
run(ignored ${WORK}/examples/example_classify)
