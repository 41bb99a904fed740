#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of docs/ as HTML for ParaView's Help, with the project file that Qt's qhelpgenerator takes.

    write-help.py ROOT FOLDER    fills FOLDER with the pages, their pictures and lamina.qhp

A page of a stage is called as ParaView's Help button asks for it, GROUP.PROXY.html. What the pages use of Markdown is what
is understood here: headings, paragraphs, lists, tables, blocks of code, pictures, links, emphasis, code.
"""
import html
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

STYLE = """body { font-family: sans-serif; max-width: 52em; margin: 1em; }
table { border-collapse: collapse; } td, th { border: 1px solid #bbb; padding: 2px 6px; } img { max-width: 100%; }
pre { background: #f2f2f2; padding: 6px; } code { background: #f2f2f2; }"""


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def pages_of(root):
    """The HTML name of each page: those of stages by their proxies."""
    names = {}
    proxies = {}
    for path in (root / "Plugin" / "Proxies").glob("*.xml"):
        for group in ElementTree.parse(path).getroot().iterfind("ProxyGroup"):
            for proxy in group.iterfind("*[@label]"):
                page = re.sub(r"\W+", "-", proxy.get("label").lower())
                proxies[page] = f"{group.get('name')}.{proxy.get('name')}.html"
    for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        inside = path.relative_to(root).with_suffix("")
        names[path] = proxies.get(path.stem) if path.parent.name == "filters" else None
        names[path] = names[path] or "-".join(inside.parts).lower() + ".html"
    return names


class Writer:
    """One page, line after line."""

    def __init__(self, page, names):
        self.page, self.names = page, names
        self.out, self.open = [], None

    def target(self, link):
        if re.match(r"[a-z]+:", link):
            return link
        name, _, anchor = link.partition("#")
        path = (self.page.parent / name).resolve() if name else self.page
        if path.suffix == ".png":
            return "pictures/" + path.name
        return self.names.get(path, "docs-readme.html") + ("#" + anchor if anchor else "")

    def inline(self, text):
        kept = []

        def keep(markup):
            kept.append(markup)
            return f"\0{len(kept) - 1}\0"
        text = re.sub(r"`([^`]+)`", lambda m: keep(f"<code>{html.escape(m[1])}</code>"), text)
        text = re.sub(r"!\[([^\]]*)\]\(([^)\s]+)\)", lambda m: keep(f'<img src="{self.target(m[2])}" alt="{html.escape(m[1])}"/>'), text)
        text = re.sub(r"\[([^\]]*)\]\(([^)\s]+)\)", lambda m: keep(f'<a href="{self.target(m[2])}">') + m[1] + keep("</a>"), text)
        text = html.escape(text, quote=False)
        text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
        text = re.sub(r"(?<![\w*])\*(?!\s)([^*]+)\*", r"<i>\1</i>", text)
        while "\0" in text:
            text = re.sub(r"\0(\d+)\0", lambda m: kept[int(m[1])], text)
        return text

    def close(self):
        if self.open:
            kind, lines = self.open
            body = self.inline(" ".join(lines))
            self.out.append(f"<{kind}>{body}</{kind}>")
        self.open = None

    def table(self, rows):
        cells = [[c.strip() for c in re.split(r"(?<!\\)\|", row.strip().strip("|"))] for row in rows]
        self.out.append("<table>")
        for number, row in enumerate(cells):
            if number != 1:
                kind = "th" if number == 0 else "td"
                self.out.append("<tr>" + "".join(f"<{kind}>{self.inline(c)}</{kind}>" for c in row) + "</tr>")
        self.out.append("</table>")

    def write(self, text):
        lines = text.splitlines()
        number = 0
        while number < len(lines):
            line = lines[number]
            if line.startswith("```"):
                end = next(i for i in range(number + 1, len(lines)) if lines[i].startswith("```"))
                self.close()
                self.out.append("<pre>" + html.escape("\n".join(lines[number + 1:end])) + "</pre>")
                number = end
            elif line.startswith("|"):
                end = next((i for i in range(number, len(lines)) if not lines[i].startswith("|")), len(lines))
                self.close()
                self.table(lines[number:end])
                number = end - 1
            elif heading := re.match(r"(#+) (.*)", line):
                self.close()
                level = len(heading[1])
                self.out.append(f'<h{level} id="{slug(heading[2])}">{self.inline(heading[2])}</h{level}>')
            elif item := re.match(r"\s*(?:-|\d+\.) (.*)", line):
                self.close()
                self.open = ("li", [item[1]])
            elif not line.strip():
                self.close()
            elif self.open:
                self.open[1].append(line.strip())
            else:
                self.open = ("p", [line.strip()])
            number += 1
        self.close()
        return "\n".join(self.out)


def title_of(path):
    return re.search(r"^# (.*)", path.read_text(encoding="utf-8"), re.M)[1]


def project(names):
    """What qhelpgenerator reads: the contents, and all files."""
    top = [path for path in names if path.parent.name not in ("decisions", "filters")]
    entry = '<section title="{}" ref="{}">'.format
    lines = []
    for path in top:
        lines.append(entry(html.escape(title_of(path)), names[path]) + "</section>")
    for folder, title in (("filters", "The stages"), ("decisions", "Decisions")):
        inside = [path for path in names if path.parent.name == folder]
        lines.append(entry(title, names[inside[0]]))
        lines += [entry(html.escape(title_of(path)), names[path]) + "</section>" for path in inside]
        lines.append("</section>")
    return ('<?xml version="1.0" encoding="UTF-8"?>\n<QtHelpProject version="1.0">\n<namespace>lamina.org</namespace>\n'
            '<virtualFolder>lamina</virtualFolder>\n<filterSection>\n<toc>\n<section title="Lamina" ref="docs-readme.html">\n'
            + "\n".join(lines) + "\n</section>\n</toc>\n<files>\n<file>*.html</file>\n<file>pictures/*.png</file>\n</files>\n"
            "</filterSection>\n</QtHelpProject>\n")


def main():
    root, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "pictures").mkdir(parents=True)
    names = pages_of(root)
    for path, name in names.items():
        body = Writer(path, names).write(path.read_text(encoding="utf-8"))
        page = (f'<html><head><meta charset="utf-8"/><title>{html.escape(title_of(path))}</title><style>{STYLE}</style></head>\n'
                f'<body>\n{body}\n</body></html>\n')
        (folder / name).write_text(page, encoding="utf-8")
    for picture in (root / "docs" / "pictures").glob("*.png"):
        shutil.copy(picture, folder / "pictures")
    (folder / "lamina.qhp").write_text(project(names), encoding="utf-8")
    print(f"{len(names)} pages")


if __name__ == "__main__":
    main()
