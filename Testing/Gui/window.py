# SPDX-License-Identifier: BSD-3-Clause
"""Play clicks in ParaView's real window, as ParaView's own recorder writes them; needs an X server (xvfb-run)."""
import os
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

WINDOW = "pqClientMainWindow"
PANEL = f"{WINDOW}/propertiesDock/propertiesPanel"
PROPERTIES = f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"

FILTERS = f"{WINDOW}/menubar/menuFilters"
APPLY = (f"{PANEL}/Accept", "activate", "")
OPEN_PHANTOM = (
    (f"{WINDOW}/menubar", "activate", "menuSources"),
    (f"{WINDOW}/menubar/menuSources", "activate", "Lamina"),
    (f"{WINDOW}/menubar/menuSources/Lamina", "activate", "HeartPhantom"),
)


def apply_filter(name):
    return ((f"{WINDOW}/menubar", "activate", "menuFilters"), (FILTERS, "activate", "Lamina"), (f"{FILTERS}/Lamina", "activate", name), APPLY)


def resolution(voxels):
    return (f"{PROPERTIES}/Resolution/IntRangeWidget/LineEdit", "set_string", str(voxels))


def save_state(path):
    return (
        (f"{WINDOW}/menubar", "activate", "menu_File"),
        (f"{WINDOW}/menubar/menu_File", "activate", "actionFileSaveServerState"),
        (f"{WINDOW}/FileSaveServerStateDialog", "filesSelected", path),
    )


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def said_in(log):
    with open(log, encoding="utf-8", errors="replace") as file:
        return file.read()


def prepare(home, sources, events):
    """Settings of a new user: no welcome, and the macro imported. Events are object, command, arguments; or, with "check" before
    them, object, property and the value that it has to have."""
    settings = os.path.join(home, ".config", "ParaView")
    os.makedirs(os.path.join(settings, "Macros"))
    with open(os.path.join(settings, "ParaView5.11.0.ini"), "w", encoding="utf-8") as file:
        file.write("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
    shutil.copy(os.path.join(sources, "Plugin", "Macros", "Mesh This Image.py"), os.path.join(settings, "Macros"))
    root = ElementTree.Element("pqevents")
    for event in events:
        if event[0] == "check":
            ElementTree.SubElement(root, "pqcheck", dict(zip(("object", "property", "arguments"), event[1:])))
        else:
            ElementTree.SubElement(root, "pqevent", dict(zip(("object", "command", "arguments"), event)))
    script = os.path.join(home, "clicks.xml")
    ElementTree.ElementTree(root).write(script)
    return script


def screenshot(path):
    subprocess.run(["import", "-window", "root", "-trim", path], check=True, timeout=60)
    check(os.path.getsize(path) > 10000, f"{path} is empty")


def play(home, plugins, script, log, done, picture, seconds):
    """Play the clicks until done(), an error, or the time is up; then take the picture. Returns what ParaView said."""
    environment = {**os.environ, "HOME": home, "PV_PLUGIN_PATH": f"{plugins}/Lamina;{plugins}/LaminaWindow", "XDG_RUNTIME_DIR": home}
    with open(log, "w", encoding="utf-8") as file:
        window = subprocess.Popen(["paraview", f"--test-script={script}"], stdout=file, stderr=file, env=environment)
        end = time.monotonic() + seconds
        try:
            while time.monotonic() < end and window.poll() is None and not done() and "critical:" not in said_in(log):
                time.sleep(1)
            time.sleep(5)
            screenshot(picture)
        finally:
            window.terminate()
            window.wait(30)
    return said_in(log)
