# What `cmake --install` and `cpack` make: a tree that may be moved anywhere, and packages of it.
#
#   lib/paraview-5.11/plugins/Lamina/     the plugin, lamina-tetgen, the Python package (installed where they are made)
#   lib/paraview-5.11/plugins/lamina.plugins.xml   tells ParaView to load it at the start
#   bin/lamina-mesh, bin/lamina-audit, bin/lamina-paraview
#   share/lamina/                         the scripts behind them, and the macro
#   share/doc/lamina/                     the pages
# Libraries find each other through $ORIGIN: nothing else names a place.
# VTK's macros install the static libraries of the rooms as well, which are no use to anyone.
install(CODE "
  set(tree \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
  file(GLOB archives \"\${tree}/lib/libLamina*.a\" \"\${tree}/${LAMINA_PLUGIN_FOLDER}/libLamina*.a\")
  if(archives)
    file(REMOVE \${archives})
  endif()" ALL_COMPONENTS)

if(NOT LAMINA_WITH_PARAVIEW)
  return() # the commands below run under ParaView's Python
endif()

set(LAMINA_PARAVIEW_VERSION "5.11")
get_filename_component(plugins_folder "${LAMINA_PLUGIN_FOLDER}" DIRECTORY)

install(PROGRAMS Utilities/lamina-audit Utilities/lamina-paraview DESTINATION bin COMPONENT runtime)
install(PROGRAMS Utilities/mesh.sh DESTINATION bin RENAME lamina-mesh COMPONENT runtime)
install(FILES Utilities/lamina-run.sh DESTINATION share/lamina COMPONENT runtime)
install(DIRECTORY Examples/ DESTINATION share/lamina/scripts COMPONENT runtime FILES_MATCHING PATTERN "*.py")
install(DIRECTORY Plugin/Macros/ DESTINATION share/lamina/macros COMPONENT runtime)
install(DIRECTORY docs/ DESTINATION share/doc/lamina COMPONENT runtime)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/lamina COMPONENT runtime)
install(FILES CMake/debian/copyright DESTINATION share/doc/lamina COMPONENT runtime)
install(FILES Plugin/lamina.plugins.xml DESTINATION "${plugins_folder}" COMPONENT runtime)
set(CPACK_PACKAGE_NAME "lamina")
set(CPACK_PACKAGE_VENDOR "The Lamina developers")
set(CPACK_PACKAGE_CONTACT "The Lamina developers <lamina@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ParaView plugin: from an image of several materials to a fluid-solid mesh")
set(CPACK_PACKAGE_DESCRIPTION
  "Filters for ParaView and Python that segment an image, extract and smooth the surface between its materials, size it,
and fill it with layered tetrahedra, prisms and tetrahedra that share their nodes; with writers for solvers.")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_STRIP_FILES ON)
# The runtime component alone, in one package.
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_SOURCE_DIR}/CMake/LaminaPackage.cmake")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_SOURCE_DIR}/CMake/LaminaDebian.cmake")
set(CPACK_LAMINA_PARAVIEW_VERSION "${LAMINA_PARAVIEW_VERSION}")
set(CPACK_LAMINA_MULTIARCH "${CMAKE_LIBRARY_ARCHITECTURE}")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION "science")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# A plugin goes with the one version of ParaView that it was built for.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${LAMINA_PARAVIEW_VERSION}), paraview (<< ${LAMINA_PARAVIEW_VERSION}.99), python3-paraview, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "xvfb, xauth")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_SOURCE_DIR}/CMake/debian/prerm")
include(CPack)
