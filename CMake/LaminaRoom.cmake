# A room: a VTK module of thin algorithms over the kernel, linked statically into the plugin.
#
#   lamina_add_room(Surface CLASSES vtkA vtkB)              classes, each a vtkA.h and vtkA.cxx, wrapped for ParaView and Python
#   lamina_add_room(Common HEADERS A.h B.h SOURCES A.cxx)   helpers, not wrapped (EXCLUDE_WRAP in its vtk.module)
function(lamina_add_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "CLASSES;HEADERS;SOURCES")
  vtk_module_add_module(Lamina::${name} FORCE_STATIC
    CLASSES ${room_CLASSES}
    PRIVATE_HEADERS ${room_HEADERS}
    SOURCES ${room_SOURCES})
  vtk_module_include(Lamina::${name} PRIVATE "${CMAKE_SOURCE_DIR}/Filters/Kernel")
  vtk_module_link(Lamina::${name} PRIVATE LaminaKernel)
  vtk_module_compile_options(Lamina::${name} PRIVATE -Wall -Wextra -Wshadow -Wno-psabi)
endfunction()

# Sets LAMINA_MODULES, LAMINA_MODULE_FILES and LAMINA_WRAPPED_MODULES to the rooms that exist: a folder of Filters with a
# vtk.module and at least one .cxx file.
macro(lamina_find_rooms)
  foreach(room IN ITEMS ${ARGN})
    set(folder "${CMAKE_SOURCE_DIR}/Filters/${room}")
    file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cxx")
    if(sources AND EXISTS "${folder}/vtk.module")
      list(APPEND LAMINA_MODULE_FILES "${folder}/vtk.module")
      list(APPEND LAMINA_MODULES "Lamina::${room}")
      if(NOT room STREQUAL "Common")
        list(APPEND LAMINA_WRAPPED_MODULES "Lamina::${room}")
      endif()
    endif()
  endforeach()
endmacro()
