# The Python package `lamina`, beside the plugin: put LAMINA_PLUGIN_DIR on PYTHONPATH and import filters from it under pvpython.
set(lamina_python_imports "")
foreach(module IN LISTS LAMINA_WRAPPED_MODULES)
  string(REPLACE "::" "" library "${module}")
  string(APPEND lamina_python_imports "from .${library} import *\n")
endforeach()
configure_file("${CMAKE_CURRENT_LIST_DIR}/lamina-init.py.in" "${LAMINA_PLUGIN_DIR}/lamina/__init__.py" @ONLY)
install(FILES "${LAMINA_PLUGIN_DIR}/lamina/__init__.py" DESTINATION "${LAMINA_PLUGIN_FOLDER}/lamina" COMPONENT runtime)

vtk_module_wrap_python(
  MODULES ${LAMINA_WRAPPED_MODULES}
  TARGET Lamina::PythonModules
  PYTHON_PACKAGE "lamina"
  MODULE_DESTINATION "${LAMINA_PLUGIN_FOLDER}"
  CMAKE_DESTINATION "lib/cmake/lamina"
  LIBRARY_DESTINATION "lib"
  INSTALL_HEADERS OFF
  COMPONENT runtime)
