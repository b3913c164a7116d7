# Doxygen over the public headers without writing pages, which takes longer than reading them.
cmake_minimum_required(VERSION 3.25)
if(NOT DOXYGEN)
    message(STATUS "skipped: doxygen is not installed")
    return()
endif()
file(READ ${DOXYFILE} settings)
file(MAKE_DIRECTORY ${WORK})
string(APPEND settings "\nOUTPUT_DIRECTORY = ${WORK}\nGENERATE_HTML = NO\nGENERATE_XML = YES\n"
    "XML_PROGRAMLISTING = NO\nSOURCE_BROWSER = NO\n")
file(WRITE ${WORK}/Doxyfile "${settings}")
execute_process(COMMAND ${DOXYGEN} ${WORK}/Doxyfile RESULT_VARIABLE status OUTPUT_VARIABLE printed
    ERROR_VARIABLE printed)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "doxygen ended with ${status}:\n${printed}")
endif()
# It read what is public.
file(GLOB classes ${WORK}/xml/*SurfaceTension*.xml)
if(NOT classes)
    message(FATAL_ERROR "no page of SurfaceTension in ${WORK}/xml")
endif()
