#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rules of the house (docs/architecture.md), checked on the sources.

    check-house.py [ROOT]        check the tree at ROOT, by default the one this file lies in
    check-house.py --self-test   plant one violation of each rule in a copy and see that it is found

Exits 1 if a rule is broken. File lengths are a guide: only warned about.
"""
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

# What a room of the kernel may include besides itself.
BELOW = {"Base": []}
BELOW["Geometry"] = ["Base"]
BELOW["Mesh"] = ["Geometry", "Base"]
BELOW["Search"] = ["Mesh", "Geometry", "Base"]
BELOW["Sizing"] = ["Search", "Mesh", "Geometry", "Base"]
for top in ("Segmentation", "Surface", "Volume"):
    BELOW[top] = ["Sizing", "Search", "Mesh", "Geometry", "Base"]

# Files of the kernel that may reach farther, with the reason.
KERNEL_EXCEPTIONS = {
    "Mesh/Audit.cxx": ["Search"],  # overlap is looked for in the spatial tree
}

# What a shell's room may include of the kernel: its own room and what lies below. Audits have no room of their own in
# the kernel: that of surfaces needs the search for intersections, and lives with the surfaces.
SHELL_EXTRA = {"Mesh": ["Surface"]}

NAMES_FILE = "Filters/Common/MeshArrayNames.h"
CPP = (".h", ".cxx", ".txx")
LENGTHS = {".h": 150, ".cxx": 300, ".xml": 150}
SHELL_LENGTH = 200
SKIPPED_FOLDERS = {".git", "build", "demo-output", "__pycache__"}
ABSOLUTE = re.compile(r"""["'(=\s](/(?:home|root|usr|opt|tmp|work|mnt|var|data)/[\w./-]+)""")
ABSOLUTE_ALLOWED = ("/usr/bin/env", "/usr/bin/python3")
# Their places are those of a clean Debian that they make.
IN_A_CLEAN_DEBIAN = {"clean-debian.sh", "test-package.sh", "test-plain-vtk.sh"}


def files(root, folder, endings):
    base = root / folder
    for path in sorted(base.rglob("*")) if base.is_dir() else []:
        parts = path.relative_to(root).parts
        if path.is_file() and path.suffix in endings and not SKIPPED_FOLDERS & set(parts):
            yield path


def includes(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1), match.group(2)


def kernel_rooms(root):
    kernel = root / "Filters" / "Kernel"
    for path in files(root, "Filters/Kernel", CPP):
        inside = path.relative_to(kernel)
        if len(inside.parts) == 2:
            yield path, inside.parts[0], inside.as_posix()


def check_kernel_includes(root):
    """Includes of the kernel go down only."""
    for path, room, inside in kernel_rooms(root):
        if room not in BELOW:
            yield f"{path}: {room} is not a room of the kernel; add it to BELOW in {pathlib.Path(__file__).name}"
            continue
        allowed = [room] + BELOW[room] + KERNEL_EXCEPTIONS.get(inside, [])
        for number, kind, name in includes(path):
            if kind != '"':
                continue
            target = (path.parent / name).resolve()
            other = target.parent.name if "/" in name else room
            if other not in allowed:
                yield f"{path}:{number}: {room} must not include {name}: allowed are {', '.join(allowed)}"


def check_kernel_without_vtk(root):
    """The kernel knows no VTK; its headers show neither CGAL, Eigen nor TetGen."""
    for path, _, _ in kernel_rooms(root):
        for number, _, name in includes(path):
            if re.match(r"(vtk|pq)", name):
                yield f"{path}:{number}: the kernel includes {name}"
            if path.suffix == ".h" and re.match(r"(CGAL/|Eigen/|tetgen)", name):
                yield f"{path}:{number}: a header of the kernel shows {name}"


def check_shell_includes(root):
    """A shell includes Common and its own room of the kernel, and no other shell."""
    filters = root / "Filters"
    shells = [p for p in files(root, "Filters", (".h",)) if p.name.startswith("vtk")]
    # A base class may be included, by those that derive from it, in its own room.
    bases = {p.name: p.parent.name for p in shells if "vtkAbstractTypeMacro" in p.read_text(encoding="utf-8")}
    classes = {p.name: p.parent.name for p in shells}
    for path in files(root, "Filters", CPP):
        room = path.relative_to(filters).parts[0]
        if room in ("Kernel", "Common"):
            continue
        allowed = [room] + BELOW.get(room, list(BELOW)) + SHELL_EXTRA.get(room, [])
        # A class may lie in several sources: vtkName.cxx, vtkNamePart.cxx.
        own = max((c for c in classes if path.stem.startswith(c[:-2])), key=len, default="")
        for number, _, name in includes(path):
            if name in classes and name != own and bases.get(name) != room:
                yield f"{path}:{number}: shells meet only through the pipeline, not by including {name}"
            first = name.split("/")[0]
            if "/" in name and first in BELOW and first not in allowed:
                yield f"{path}:{number}: the shells of {room} must not include {name}"


def array_names(root):
    text = (root / NAMES_FILE).read_text(encoding="utf-8")
    return dict(re.findall(r'constexpr const char\* (\w+) = "(\w+)";', text))


def check_array_names(root):
    """Names of arrays are spelled out in one file only; tests pin them down by spelling them again."""
    names = set(array_names(root).values())
    for path in files(root, "Filters", CPP):
        if path == root / NAMES_FILE:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            code = line.split("//")[0]
            if "AttachReport(" in code:  # the name of a stage, which an array may share
                continue
            for literal in re.findall(r'"(\w+)"', code):
                if literal in names:
                    yield f"{path}:{number}: \"{literal}\" belongs into {NAMES_FILE}"


def xml_properties(root):
    for path in files(root, "Plugin/Proxies", (".xml",)):
        for proxy in ElementTree.parse(path).getroot().iter():
            if not proxy.tag.endswith("Proxy"):
                continue
            yield path, proxy, [p for p in proxy if p.tag.endswith("Property")]


def documented(element):
    text = element.find("Documentation")
    return text is not None and bool(" ".join(text.itertext()).strip())


def check_proxies(root):
    """Every proxy and property is documented; at most seven are visible; labels are the names with spaces."""
    for path, proxy, properties in xml_properties(root):
        name = proxy.get("name")
        if not documented(proxy) or not proxy.find("Documentation").get("short_help"):
            yield f"{path}: proxy {name} is not documented, or has no short_help"
        for prop in properties:
            if not documented(prop):
                yield f"{path}: property {prop.get('name')} is not documented"
            label = prop.get("label", prop.get("name"))
            if re.sub(r"\W", "", label) != prop.get("name"):
                yield f"{path}: the label \"{label}\" is not the name {prop.get('name')} with spaces"
        hidden = ("advanced", "never")
        visible = [p for p in properties if p.tag != "InputProperty" and p.get("panel_visibility") not in hidden
                   and p.get("information_only") != "1"]  # what is told is nothing to set
        if len(visible) > 7:
            yield f"{path}: {len(visible)} visible properties, at most 7"


def numbers(prop, attribute):
    return [float(word) for word in (prop.get(attribute) or "").split()]


def outside_of(domain, values):
    """The values that a domain does not allow."""
    if domain.tag == "EnumerationDomain":
        allowed = [float(entry.get("value")) for entry in domain.iter("Entry")]
        return [value for value in values if value not in allowed]
    if domain.tag == "BooleanDomain":
        return [value for value in values if value not in (0, 1)]
    least, most = float(domain.get("min") or "-inf"), float(domain.get("max") or "inf")
    return [value for value in values if not least <= value <= most]


def check_domains(root):
    """Every number in the panel has a domain and a default that lies in it; every stage stands in the menu with an icon."""
    for path, proxy, properties in xml_properties(root):
        for prop in properties:
            if prop.tag not in ("IntVectorProperty", "DoubleVectorProperty", "IdTypeVectorProperty"):
                continue
            if prop.get("information_only") == "1":
                continue
            name = prop.get("name")
            domains = [child for child in prop if child.tag.endswith("Domain")]
            if not domains:
                yield f"{path}: property {name} has no domain"
            defaults = numbers(prop, "default_values")
            if prop.get("repeat_command") != "1" and len(defaults) != int(prop.get("number_of_elements", 1)):
                yield f"{path}: property {name} has {len(defaults)} default values for {prop.get('number_of_elements')} elements"
            for domain in domains:
                if domain.tag != "BoundsDomain" and outside_of(domain, defaults):
                    yield f"{path}: the default of {name} is outside its domain: {outside_of(domain, defaults)}"
        menu = proxy.find("Hints/ShowInMenu")
        if proxy.tag != "WriterProxy":
            icon = menu.get("icon", "") if menu is not None and menu.get("category") == "Lamina" else ""
            file = root / "Plugin" / "Window" / "Icons" / icon.rsplit("/", 1)[-1]
            if not icon.startswith(":/Lamina/Icons/") or not file.is_file():
                yield f"{path}: {proxy.get('name')} is not in the menu Lamina with an icon of Plugin/Window/Icons"


def check_absolute_paths(root):
    """No file names a place of one machine."""
    endings = CPP + (".py", ".sh", ".xml", ".txt", ".cmake", ".json", ".in")
    for folder in ("Filters", "Plugin", "Programs", "Testing", "Utilities", "Examples", "CMake"):
        for path in files(root, folder, endings):
            if path.name == pathlib.Path(__file__).name or path.name in IN_A_CLEAN_DEBIAN:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for found in ABSOLUTE.findall(line):
                    if not found.startswith(ABSOLUTE_ALLOWED):
                        yield f"{path}:{number}: absolute path {found}"


def check_licence_lines(root):
    """Every source file says its licence in its first two lines."""
    for folder in ("Filters", "Programs", "Testing", "Utilities", "Examples"):
        for path in files(root, folder, CPP + (".py", ".sh")):
            head = path.read_text(encoding="utf-8").splitlines()[:2]
            if not any("SPDX-License-Identifier: BSD-3-Clause" in line for line in head):
                yield f"{path}: no SPDX-License-Identifier in its first two lines"


def shared_types(path):
    """Types of a file that other files can meet: at its left margin and in no namespace without a name."""
    hidden = False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        hidden = (hidden or line == "namespace") and line != "} // namespace"
        match = re.match(r"(?:struct|class|enum|enum class) (?:\w+_EXPORT )?(\w+)(?: final)?(?:\s*: .*)?$", line)
        if match and not hidden:
            yield number, match.group(1)


def check_type_names(root):
    """A type's name is given once: two types of one name in a plugin are one to the linker, which mixes them."""
    first = {}
    for path in files(root, "Filters", CPP):
        for number, name in shared_types(path):
            if first.setdefault(name, path) != path:
                yield f"{path}:{number}: {name} is also defined in {first[name]}: rename one, or hide it"


CHECKS = [check_kernel_includes, check_kernel_without_vtk, check_shell_includes, check_array_names, check_proxies, check_domains,
          check_absolute_paths, check_licence_lines, check_type_names]


def length_warnings(root):
    for folder in ("Filters", "Programs", "Plugin"):
        for path in files(root, folder, tuple(LENGTHS)):
            is_shell = path.name.startswith("vtk") and path.suffix == ".cxx"
            most = SHELL_LENGTH if is_shell else LENGTHS[path.suffix]
            length = len(path.read_text(encoding="utf-8").splitlines())
            if length > most:
                yield f"{path}: {length} lines, the guide is {most}"


def broken_rules(root):
    return [(check.__name__, text) for check in CHECKS for text in check(root)]


# One violation of each rule: the check that must find it, the file, and what to add at its end (or to replace).
PLANTED = [
    ("check_kernel_includes", "Filters/Kernel/Base/Types.h", '#include "../Mesh/LabelImage.h"\n', None),
    ("check_kernel_without_vtk", "Filters/Kernel/Base/Types.h", "#include <vtkPoints.h>\n", None),
    ("check_shell_includes", "Filters/Sizing/vtkFeatureSize.cxx", '#include "Volume/CoreTets.h"\n', None),
    ("check_shell_includes", "Filters/Sizing/vtkFeatureSize.cxx", '#include "vtkPrismLayer.h"\n', None),
    ("check_array_names", "Filters/Sizing/vtkFeatureSize.cxx", 'auto a = d->GetArray("FeatureSize");\n', None),
    ("check_proxies", "Plugin/Proxies/FeatureSize.xml", r"(<DoubleRangeDomain[^>]*>\s*)<Documentation>[^<]*<", r"\1<Documentation><"),
    ("check_proxies", "Plugin/Proxies/FeatureSize.xml", r'label="Gradient"', r'label="Slope"'),
    ("check_domains", "Plugin/Proxies/FeatureSize.xml", r'(<IntRangeDomain name="range" )min="1"/>', r'\1min="7"/>'),
    ("check_domains", "Plugin/Proxies/FeatureSize.xml", r'<IntRangeDomain name="range" min="1"/>', ""),
    ("check_domains", "Plugin/Proxies/FeatureSize.xml", r'Icons/FeatureSize', r'Icons/Missing'),
    ("check_absolute_paths", "Filters/Sizing/vtkFeatureSize.cxx", 'auto p = "/home/someone/mesh.vtu";\n', None),
    ("check_type_names", "Filters/Kernel/Base/Types.h", "struct Error\n{\n};\n", None),
    ("check_licence_lines", "Filters/Sizing/vtkFeatureSize.cxx", r"// SPDX[^\n]*\n", "\n\n"),
]


def self_test(root):
    failures = 0
    for check, name, text, replacement in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy"
            for part in ("Filters", "Plugin"):
                shutil.copytree(root / part, copy / part)
            path = copy / name
            old = path.read_text(encoding="utf-8")
            new = old + text if replacement is None else re.sub(text, replacement, old, count=1)
            path.write_text(new, encoding="utf-8")
            before = sum(1 for rule, _ in broken_rules(root) if rule == check)
            found = sum(1 for rule, _ in broken_rules(copy) if rule == check)
            outcome = "found" if new != old and found > 0 and found != before else "NOT FOUND"
            failures += outcome != "found"
            print(f"{check}: planted in {name}: {outcome}")
    return failures


def main(arguments):
    root = pathlib.Path(__file__).resolve().parent.parent
    if arguments[:1] == ["--self-test"]:
        return 1 if self_test(root) else 0
    if arguments:
        root = pathlib.Path(arguments[0]).resolve()
    for text in length_warnings(root):
        print(f"warning: {text}")
    broken = broken_rules(root)
    for check, text in broken:
        print(f"{check}: {text}")
    print(f"{len(CHECKS)} rules checked, {len(broken)} violations")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
