# The rooms over plain VTK, without ParaView: the Python package `lamina`, in lib/lamina beside the programs it starts.
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(VTK 9.1 REQUIRED
  COMPONENTS CommonCore CommonDataModel CommonExecutionModel FiltersExtraction FiltersHybrid ImagingCore IOCore IOXML Python WrappingPythonCore
  OPTIONAL_COMPONENTS nlohmannjson)
if(NOT TARGET VTK::nlohmannjson)
  find_package(nlohmann_json 3.7 REQUIRED)
endif()
if(LAMINA_BUILD_TESTING)
  find_package(VTK REQUIRED COMPONENTS TestingCore FiltersSources)
endif()
lamina_find_rooms(Common Segmentation Surface Sizing Volume Mesh IO)

vtk_module_scan(
  MODULE_FILES ${LAMINA_MODULE_FILES}
  REQUEST_MODULES ${LAMINA_MODULES}
  PROVIDES_MODULES modules)
vtk_module_build(
  MODULES ${modules}
  PACKAGE Lamina
  INSTALL_HEADERS OFF
  ARCHIVE_DESTINATION "${LAMINA_PLUGIN_FOLDER}"
  LIBRARY_DESTINATION "${LAMINA_PLUGIN_FOLDER}"
  RUNTIME_DESTINATION "${LAMINA_PLUGIN_FOLDER}")
