# SPDX-License-Identifier: BSD-3-Clause
"""The default of every property in the proxies is that of the C++ class.

    pvpython TestDefaults.py PROXY_FOLDER [--self-test]

The self-test changes one default in a copy of the proxies and sees that it is found.
"""
import pathlib
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import lamina


def proxies(folder):
    for path in sorted(pathlib.Path(folder).glob("*.xml")):
        for proxy in ElementTree.parse(path).getroot().iterfind("ProxyGroup/*[@class]"):
            yield path.name, proxy


def cpp_default(instance, prop):
    """The value (or list) that a new object has, asked for by the getter that belongs to the property's command."""
    command = prop.get("command")
    if command.startswith("Add"):
        single = command[len("Add"):]
        count = getattr(instance, f"GetNumberOf{single}s")()
        values = [getattr(instance, f"Get{single}")(i) for i in range(count)]
        return [float(v) for value in values for v in (value if isinstance(value, (tuple, list)) else [value])]
    value = getattr(instance, "Get" + command[len("Set"):])()
    return [float(v) for v in value] if isinstance(value, (tuple, list)) else [float(value)]


def differences(folder):
    found = []
    checked = 0
    for name, proxy in proxies(folder):
        instance = getattr(lamina, proxy.get("class"))()
        for prop in proxy:
            if not prop.tag.endswith("VectorProperty") or prop.get("information_only") == "1":
                continue
            if prop.tag == "StringVectorProperty":
                continue
            xml = [float(v) for v in (prop.get("default_values") or "").split()]
            try:
                cpp = cpp_default(instance, prop)
            except AttributeError as error:
                found.append(f"{name}: {prop.get('name')}: {error}")
                continue
            checked += 1
            if xml != cpp:
                found.append(f"{name}: {prop.get('name')} is {xml} in the proxy, {cpp} in C++")
    return checked, found


def self_test(folder):
    with tempfile.TemporaryDirectory() as copy:
        for path in pathlib.Path(folder).glob("*.xml"):
            text = path.read_text(encoding="utf-8")
            if path.name == "FeatureSize.xml":
                text = text.replace('default_values="0.3"', 'default_values="0.4"')
            (pathlib.Path(copy) / path.name).write_text(text, encoding="utf-8")
        _, found = differences(copy)
        return any("Gradient" in text for text in found)


def main():
    folder = sys.argv[1]
    if "--self-test" in sys.argv:
        ok = self_test(folder)
        print("a changed default is", "found" if ok else "NOT FOUND")
        return 0 if ok else 1
    checked, found = differences(folder)
    for text in found:
        print(text)
    print(f"{checked} defaults compared, {len(found)} differ")
    return 1 if found or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
