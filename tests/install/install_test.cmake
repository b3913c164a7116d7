cmake_minimum_required(VERSION 3.25)

# run(OUTPUT COMMAND...): the command must succeed; OUTPUT becomes what it prints.
function(run output)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT status EQUAL 0)
        list(JOIN ARGN " " command)
        message("${out}${err}") # as it is: an error message would be wrapped
        message(FATAL_ERROR "${command}\nended with ${status}")
    endif()
    set(${output} "${out}" PARENT_SCOPE)
endfunction()

# build_consumer(NAME OPTIONS...): configures and builds the project in the folder of that name.
function(build_consumer name)
    run(ignored ${CMAKE_COMMAND} -S ${CONSUMERS}/${name} -B ${WORK}/${name} -G ${GENERATOR}
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
        "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -DCMAKE_C_COMPILER=${C_COMPILER}
        "-DCMAKE_C_FLAGS=${CXX_FLAGS}" ${ARGN})
    run(ignored ${CMAKE_COMMAND} --build ${WORK}/${name})
endfunction()

function(expect_mention text part)
    string(FIND "${text}" "${part}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "no '${part}' in:\n${text}")
    endif()
endfunction()

# A machine that has no library.
set(no_library)
foreach(package benchmark CLI11 Eigen3 fmt GTest HDF5 hwy nlohmann_json OpenMP OpenSSL Qhull Torch ZLIB zstd)
    list(APPEND no_library -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --config "${CONFIG}")

# What is there, and nothing that only the build needs.
foreach(file bin/meniscus include/meniscus/runtime/version.hpp
        include/meniscus/runtime/features/classifier.hpp
        include/meniscus/runtime/coefficients/surface_3d.hpp
        include/meniscus/data/formats/vtkhdf.hpp
        include/meniscus/labeler/labeler.hpp share/meniscus/samples/droplet_iisph_01.vtkhdf
        share/meniscus/models/surface_3d.json share/meniscus/scenes/dam_break.json
        share/man/man1/meniscus.1 share/bash-completion/completions/meniscus
        share/zsh/site-functions/_meniscus
        share/meniscus/scenes/meshes/glass.obj include/meniscus/data/particles/boundary_sampling.hpp
        include/meniscus/meniscus.h)
    if(NOT EXISTS ${prefix}/${file})
        message(FATAL_ERROR "${file} is not installed")
    endif()
endforeach()
file(GLOB_RECURSE sources ${prefix}/*.cpp ${prefix}/*_test.hpp)
file(GLOB_RECURSE kept RELATIVE ${prefix} ${prefix}/*.hpp)
list(FILTER kept INCLUDE REGEX "/detail/|/hdf5/|/json/")
list(FILTER kept EXCLUDE REGEX "meniscus/runtime/") # whose headers include theirs
list(APPEND sources ${kept})
if(sources)
    message(FATAL_ERROR "installed but not meant to be: ${sources}")
endif()

# The command, away from its build tree.
set(meniscus ${prefix}/bin/meniscus)
run(printed ${meniscus} demo -o ${WORK}/demo)
expect_mention("${printed}" "struct SurfaceCoefficients")
if(TRAINER)
    run(loaded ${CMAKE_COMMAND} -E env LD_DEBUG=files LD_DEBUG_OUTPUT=${WORK}/loaded
        ${meniscus} train ${WORK}/demo/labelled/droplet_iisph_01.vtkhdf -o ${WORK}/logistic.json
        --objective logistic)
    file(GLOB log ${WORK}/loaded.*)
    file(STRINGS ${log} module REGEX "calling init: .*/libmeniscus_torch_trainer.so")
    file(REAL_PATH ${prefix} real_prefix)
    expect_mention("${module}" "${prefix}")
endif()

# Studies are a part of a build with benchmarks.
if(BENCHMARKS)
    run(printed ${meniscus} study thin_shells -o ${WORK}/study --check)
    expect_mention("${printed}" "| 10 | ball |")
    run(printed ${meniscus} study --list)
    expect_mention("${printed}" "liquid_crown")
endif()

# The Python module, with the models that it ships.
if(PYTHON)
    run(printed ${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/${PYTHON_FOLDER} ${PYTHON} -B -c
        "import meniscus\nprint(meniscus.__file__, meniscus.Line.shipped(2, 2))")
    expect_mention("${printed}" "${prefix}/${PYTHON_FOLDER}/meniscus/__init__.py y <=")
endif()

# A solver that uses the headers, with coefficients exported for it by the installed command; one
# that writes, labels and reads snapshots; and the headers out of the source tree.
run(ignored ${meniscus} export ${WORK}/demo/model.json -o ${WORK}/exported.hpp --name Exported)
foreach(flags "" "-ffast-math -mavx2")
    build_consumer(solver -DCMAKE_PREFIX_PATH=${prefix} -DEXPORTED=${WORK}/exported.hpp
        "-DEXTRA_FLAGS=${flags}" ${no_library})
    if(flags STREQUAL "") # a machine may compile for another's instruction set
        run(ignored ${WORK}/solver/solver)
    endif()
endforeach()
build_consumer(snapshots -DCMAKE_PREFIX_PATH=${prefix})
run(ignored ${WORK}/snapshots/snapshots ${WORK}/written.vtkhdf)
run(printed ${meniscus} label ${WORK}/written.vtkhdf -o ${WORK}/labelled)
expect_mention("${printed}" "1000 particles in 3D")

# The examples as a project of their own.
run(ignored ${CMAKE_COMMAND} -S ${SOURCE}/examples -B ${WORK}/examples -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -DCMAKE_C_COMPILER=${C_COMPILER} "-DCMAKE_C_FLAGS=${CXX_FLAGS}")
foreach(example classify c_interface) # the others take longer to compile
    run(ignored ${CMAKE_COMMAND} --build ${WORK}/examples --target example_${example})
    run(ignored ${WORK}/examples/example_${example})
endforeach()

# The runtime alone, on a machine that has no library: inside another project, and installed by
# itself, where nothing else is offered.
set(subproject subproject -DMENISCUS_SOURCE=${SOURCE} -DSOLVER=${CONSUMERS}/solver
    -DEXPORTED=${WORK}/exported.hpp -DCMAKE_BUILD_TYPE=Debug)
foreach(fetch ON OFF)
    build_consumer(${subproject} -DFETCH=${fetch} ${no_library})
    run(ignored ${WORK}/subproject/solver)
endforeach()
run(ignored ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/runtime -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DMENISCUS_RUNTIME_ONLY=ON ${no_library})
set(runtime_prefix ${WORK}/runtime_prefix)
run(ignored ${CMAKE_COMMAND} --install ${WORK}/runtime --prefix ${runtime_prefix})
build_consumer(solver -DEXPORTED=${WORK}/exported.hpp -DCMAKE_BUILD_TYPE=Debug ${no_library}
    -DCMAKE_PREFIX_PATH=${runtime_prefix} --fresh)
run(ignored ${WORK}/solver/solver)
file(GLOB folders RELATIVE ${runtime_prefix} ${runtime_prefix}/* ${runtime_prefix}/include/meniscus/*)
list(SORT folders)
if(NOT folders STREQUAL "include;include/meniscus/runtime;lib")
    message(FATAL_ERROR "the runtime alone installs ${folders}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMERS}/snapshots -B ${WORK}/snapshots -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${runtime_prefix} --fresh
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE printed)
if(status EQUAL 0)
    message(FATAL_ERROR "the runtime alone offers snapshots, too")
endif()
expect_mention("${printed}" "this copy offers runtime\n")

# All of it inside another project, for one that wants more than the runtime.
build_consumer(${subproject} -DMENISCUS_RUNTIME_ONLY=OFF -DMENISCUS_TRAINER=OFF --fresh)

# The README's lines, and the example in C, told where the library is by pkg-config.
build_consumer(readme -DCMAKE_PREFIX_PATH=${prefix} -DREADME=${SOURCE}/README.md)
run(ignored ${WORK}/readme/readme)
find_program(pkg_config pkg-config)
if(pkg_config)
    file(GLOB_RECURSE description ${prefix}/*/meniscus.pc)
    cmake_path(GET description PARENT_PATH folder)
    run(flags ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
        ${pkg_config} --cflags --libs meniscus)
    separate_arguments(flags UNIX_COMMAND "${CXX_FLAGS} ${flags}")
    run(ignored ${C_COMPILER} -std=c99 -Wall -Wextra -Wpedantic -Werror
        ${SOURCE}/examples/04_c_interface.c -o ${WORK}/plain_c_example ${flags})
endif()
