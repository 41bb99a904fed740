# Run by cpack on the staged tree. In a .deb the plugin lies where Debian's ParaView keeps its own, Debian's Python finds the
# package, and ParaView is told of the plugin: it reads paraview.conf beside its program, which Debian ships without.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
file(GLOB usr LIST_DIRECTORIES ON "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr" "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr")
list(GET usr 0 usr)
set(version "paraview-${CPACK_LAMINA_PARAVIEW_VERSION}")
set(libraries "lib/${CPACK_LAMINA_MULTIARCH}")
if(EXISTS "${usr}/lib/${version}")
  file(MAKE_DIRECTORY "${usr}/${libraries}")
  file(RENAME "${usr}/lib/${version}" "${usr}/${libraries}/${version}")
endif()
file(WRITE "${usr}/bin/paraview.conf"
  "../${libraries}/${version}/plugins/paraview.plugins.xml\n../${libraries}/${version}/plugins/lamina.plugins.xml\n")
file(MAKE_DIRECTORY "${usr}/lib/python3/dist-packages")
file(CREATE_LINK "../../${CPACK_LAMINA_MULTIARCH}/${version}/plugins/Lamina/lamina" "${usr}/lib/python3/dist-packages/lamina"
  SYMBOLIC)
