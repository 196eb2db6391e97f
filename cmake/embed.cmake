# SPDX-License-Identifier: Apache-2.0
# Puts files into a program as they are: for page.html in the folder, dioptre_embed(target page.html)
# defines `std::string_view dioptre::embedded::page_html()`, its bytes. Nothing is copied or done at
# the start of the program.

function(dioptre_embed target)
  foreach(file ${ARGN})
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} name)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}.cpp)
    configure_file(${CMAKE_SOURCE_DIR}/cmake/embedded.cpp.in ${source} @ONLY)
    set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${path})
    target_sources(${target} PRIVATE ${source})
  endforeach()
endfunction()
