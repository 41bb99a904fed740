# Read by cpack for each kind of package.
if(CPACK_GENERATOR STREQUAL "TGZ")
  # An archive is unpacked anywhere, into a folder of its name.
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  set(CPACK_PACKAGING_INSTALL_PREFIX "/")
endif()
