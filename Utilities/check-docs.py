#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages hold together: no dead link, no missing or unused picture, a page for every stage and every property.

    check-docs.py [ROOT]        check the tree at ROOT, by default the one this file lies in
    check-docs.py --self-test   plant one fault of each kind in a copy and see that it is found
"""
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ElementTree


def pages(root):
    return [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").rglob("*.md"))]


def prose(path):
    """A page without its blocks of code."""
    return re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.S | re.M)


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(path):
    return {slug(heading) for heading in re.findall(r"^#+ (.*)$", prose(path), re.M)}


def links(path):
    return re.findall(r"\]\(([^)\s]+)\)", prose(path))


def check_links(root):
    """Links to files and headings lead somewhere."""
    for page in pages(root):
        for link in links(page):
            if re.match(r"[a-z]+:", link):
                continue
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                yield f"{page}: {link} is not there"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                yield f"{page}: {link}: no such heading"


def check_pictures(root):
    """Every picture is shown on some page, and is one."""
    shown = {(page.parent / link).resolve() for page in pages(root) for link in links(page) if link.endswith(".png")}
    for picture in sorted((root / "docs" / "pictures").glob("*")):
        if picture.resolve() not in shown:
            yield f"{picture}: shown on no page"
        if picture.read_bytes()[:8] != b"\x89PNG\r\n\x1a\n":
            yield f"{picture}: not a PNG"


def proxies(root):
    for path in sorted((root / "Plugin" / "Proxies").glob("*.xml")):
        for proxy in ElementTree.parse(path).getroot().iterfind("ProxyGroup/*[@class]"):
            yield proxy


def check_stages(root):
    """Every stage has a page with a picture, its class and its properties, and stands in the list of pages."""
    index = (root / "docs" / "README.md").read_text(encoding="utf-8")
    for proxy in proxies(root):
        label = proxy.get("label")
        if proxy.tag == "WriterProxy":
            if re.sub(r"\W", "", label) not in (root / "docs/filters/writers.md").read_text(encoding="utf-8"):
                yield f"docs/filters/writers.md: {label} is not named"
            continue
        name = label.lower().replace(" ", "-") + ".md"
        page = root / "docs" / "filters" / name
        if not page.is_file():
            yield f"{page}: no page for {label}"
            continue
        text = page.read_text(encoding="utf-8")
        if f"(filters/{name})" not in index:
            yield f"docs/README.md: {name} is not listed"
        if "](../pictures/" not in text:
            yield f"{page}: no picture"
        if proxy.get("class") not in text:
            yield f"{page}: {proxy.get('class')} is not named"
        for prop in proxy:
            if prop.tag.endswith("Property") and prop.get("information_only") != "1" and \
                    prop.get("label", prop.get("name")).lower() not in " ".join(text.lower().split()):
                yield f"{page}: the property {prop.get('label')} is not explained"


CHECKS = [check_links, check_pictures, check_stages]

# A fault of each kind: the check that must find it, the page, and what to replace by what.
PLANTED = [
    ("check_links", "docs/README.md", "(tutorial.md)", "(tutorials.md)"),
    ("check_links", "docs/README.md", "#adding-a-filter", "#adding-filters"),
    ("check_pictures", "docs/filters/prism-layer.md", "prism-layer.png", "core-tetrahedra.png"),
    ("check_stages", "docs/filters/prism-layer.md", "Growth Ratio", "Ratio"),
    ("check_stages", "docs/filters/prism-layer.md", "](../pictures/", "](pictures/"),
    ("check_stages", "docs/README.md", "(filters/prism-layer.md)", "(filters/core-tetrahedra.md)"),
]


def found(root):
    return [(check.__name__, text) for check in CHECKS for text in check(root)]


def self_test(root):
    failures = 0
    for check, name, old, new in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy"
            copy.mkdir()
            for part in ("docs", "Plugin/Proxies"):
                shutil.copytree(root / part, copy / part)
            for part in ("README.md", "CONTRIBUTING.md", "LICENSE"):
                shutil.copy(root / part, copy / part)
            path = copy / name
            text = path.read_text(encoding="utf-8")
            path.write_text(text.replace(old, new), encoding="utf-8")
            before = sum(rule == check for rule, _ in found(root))
            hit = old in text and sum(rule == check for rule, _ in found(copy)) > before
            failures += not hit
            print(f"{check}: {new} in {name}: {'found' if hit else 'NOT FOUND'}")
    return failures


def main(arguments):
    root = pathlib.Path(__file__).resolve().parent.parent
    if arguments[:1] == ["--self-test"]:
        return 1 if self_test(root) else 0
    faults = found(pathlib.Path(arguments[0]).resolve() if arguments else root)
    for check, text in faults:
        print(f"{check}: {text}")
    print(f"{len(pages(root))} pages, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
