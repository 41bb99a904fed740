# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's Help holds the pages: one for every stage under the name that its Help button asks for, and no link leads nowhere.

    TestHelp.py SOURCES HELP.qch LAMINA_WINDOW.so
"""
import os
import pathlib
import re
import sqlite3
import sys
import xml.etree.ElementTree as ElementTree
import zlib


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def main():
    sources, book, library = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    base = sqlite3.connect(f"file:{book}?mode=ro", uri=True)
    namespace, = base.execute("SELECT Name FROM NamespaceTable").fetchone()
    folder, = base.execute("SELECT Name FROM FolderTable").fetchone()
    check((namespace, folder) == ("lamina.org", "lamina"), f"{namespace}/{folder}")
    rows = base.execute("SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON FileNameTable.FileId = FileDataTable.Id").fetchall()
    # Qt writes the length, four bytes, before what zlib made.
    files = {name.removeprefix("./"): zlib.decompress(bytes(data)[4:]) for name, data in rows if data}
    stages = 0
    for path in (sources / "Plugin" / "Proxies").glob("*.xml"):
        for group in ElementTree.parse(path).getroot().iterfind("ProxyGroup"):
            for proxy in group.iterfind("*[@label]"):
                if group.get("name") != "writers":
                    name = f"{group.get('name')}.{proxy.get('name')}.html"
                    check(name in files, f"{name} is not in the Help: {sorted(files)}")
                    check(f"<h1 id=\"" in files[name].decode() and proxy.get("class") in files[name].decode(), f"{name} is another page")
                    stages += 1
    links = 0
    for name, data in files.items():
        if not name.endswith(".html"):
            continue
        page = data.decode()
        for link in re.findall(r'(?:href|src)="([^"]+)"', page):
            if re.match(r"[a-z]+:", link):
                continue
            target, _, anchor = link.partition("#")
            check(target in files, f"{name}: {link} is not there")
            check(not anchor or f'id="{anchor}"' in files[target].decode(), f"{name}: no heading {link}")
            links += 1
        body = re.sub(r"<pre>.*?</pre>|<code>.*?</code>", "", page, flags=re.S)
        for trace in ("\n|", "](", "**", "\0"):
            check(trace not in body, f"{name}: Markdown was left over: {trace!r}")
    # The resource compiler packs the book once more: what carries it cannot be much smaller.
    check(os.path.getsize(library) > 0.3 * os.path.getsize(book), f"{library} does not carry the pages")
    print(f"{len(files)} files, {stages} stages, {links} links in the Help")


if __name__ == "__main__":
    main()
