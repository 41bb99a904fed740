# SPDX-License-Identifier: BSD-3-Clause
"""The plugin for scripts: where it lies, and whether it is of this ParaView."""
import glob
import os
import re

from paraview import simple


class Failed(Exception):
    def __init__(self, stage, message, code=1):
        super().__init__(message)
        self.stage = stage
        self.code = code


def load_plugin():
    """Load the plugin that LAMINA_PLUGIN names, or the one of this source tree or installed tree."""
    here = os.path.dirname(os.path.abspath(__file__))
    path = os.environ.get("LAMINA_PLUGIN")
    if not path:
        end = os.path.join("paraview-*", "plugins", "Lamina", "Lamina.so")
        places = ((here, "..", "build", "release", "lib"), (here, "..", "..", "..", "lib"), (here, "..", "..", "..", "lib", "*"))
        path = next((found for place in places for found in glob.glob(os.path.join(*place, end))), None)
    if not path or not os.path.isfile(path):
        raise Failed("plugin", "Lamina.so is not there; build it: cmake --preset release && cmake --build --preset release")
    check_version(path)
    simple.LoadPlugin(os.path.abspath(path), remote=False, ns=vars(simple))


def check_version(path):
    """A plugin loads in the one version of ParaView that it was built for; its folder tells which."""
    built = re.search(r"paraview-(\d+\.\d+)", os.path.abspath(path))
    version = simple.GetParaViewVersion()
    running = f"{version.major}.{version.minor}"
    if built and built.group(1) != running:
        raise Failed("plugin", f"it was built for ParaView {built.group(1)}, this is ParaView {running}: start the pvpython of "
                     f"{built.group(1)}, or build Lamina against {running}")
