# The rooms as a plugin of ParaView.
find_package(ParaView 5.11 REQUIRED
  COMPONENTS RemotingCore RemotingServerManager RemotingViews VTKExtensionsExtraction WrapClientServer)
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel FiltersExtraction IOCore IOXML nlohmannjson WrappingPythonCore)
if(LAMINA_BUILD_TESTING)
  find_package(VTK REQUIRED COMPONENTS TestingCore FiltersSources)
endif()
lamina_find_rooms(Common Segmentation Surface Sizing Volume Mesh IO)

option(LAMINA_WITH_WINDOW "Build LaminaWindow, the plugin of icons and widgets for ParaView's window (Qt)" ${PARAVIEW_USE_QT})
set(plugin_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin")
if(LAMINA_WITH_WINDOW)
  list(APPEND plugin_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/Window/paraview.plugin")
  find_package(Qt5 REQUIRED COMPONENTS Core Widgets)
  find_library(LAMINA_PQ_CORE "pqCore-pv${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}" REQUIRED)
  find_library(LAMINA_PQ_COMPONENTS "pqComponents-pv${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}" REQUIRED)
endif()

# Plugin/paraview.plugin links to the manifest in the root: given the latter, ParaView would add the root to itself.
paraview_plugin_scan(
  PLUGIN_FILES ${plugin_files}
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON)
paraview_plugin_build(
  PLUGINS ${plugins}
  TARGET LaminaPlugins
  LIBRARY_DESTINATION "lib"
  LIBRARY_SUBDIRECTORY "paraview-5.11/plugins"
  PLUGINS_COMPONENT runtime
  INSTALL_HEADERS OFF
  DISABLE_XML_DOCUMENTATION ON)
