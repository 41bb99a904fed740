# SPDX-License-Identifier: BSD-3-Clause
"""The audit's report as one HTML page that needs nothing beside it: verdict, tables, histograms, pictures."""
import base64
import html
import os

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em; color: #1c2733; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; border-bottom: 1px solid #ccd4dc; }
table { border-collapse: collapse; margin: .6em 0; } td, th { padding: .15em .8em; text-align: right; }
td:first-child, th:first-child { text-align: left; } tr:nth-child(even) { background: #f3f6f8; }
.verdict { padding: .6em 1em; border-radius: .4em; font-weight: 600; } .passed { background: #dcf2e0; } .failed { background: #f9dcd9; }
figure { display: inline-block; margin: .5em 1.5em .5em 0; } figcaption { font-size: .85em; } img { max-width: 48%; }
"""


def number(value):
    if value is None:
        return "-"
    if isinstance(value, float) and value != int(value):
        return f"{value:.6g}"
    return f"{int(value):,}"


def table(head, rows):
    lines = ["<table><tr>" + "".join(f"<th>{html.escape(text)}</th>" for text in head) + "</tr>"]
    for row in rows:
        cells = (text if isinstance(text, str) else number(text) for text in row)
        lines.append("<tr>" + "".join(f"<td>{html.escape(text)}</td>" for text in cells) + "</tr>")
    return "\n".join(lines) + "</table>"


def histogram(counts, caption):
    """Bars of equal width from quality 0 to 1."""
    width, height, most = 300, 110, max(max(counts), 1)
    step = width / len(counts)
    bars = "".join(f'<rect x="{i * step:.1f}" y="{height - height * n / most:.1f}" width="{step - 1:.1f}" '
                   f'height="{height * n / most:.1f}" fill="#3f7cac"><title>{i / len(counts):.2f}: {int(n):,}</title></rect>'
                   for i, n in enumerate(counts))
    ticks = "".join(f'<text x="{x * width:.0f}" y="{height + 14}" font-size="11" text-anchor="{anchor}">{x:g}</text>'
                    for x, anchor in ((0, "start"), (0.5, "middle"), (1, "end")))
    return (f'<figure><svg width="{width}" height="{height + 18}" role="img" aria-label="{html.escape(caption)}">{bars}{ticks}</svg>'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def pictures(paths):
    found = []
    for path in paths:
        with open(path, "rb") as file:
            data = base64.b64encode(file.read()).decode("ascii")
        found.append(f'<img alt="{html.escape(os.path.basename(path))}" src="data:image/png;base64,{data}">')
    return "\n".join(found)


def quality_part(report):
    rows, charts = [], []
    for material in report["materials"]:
        for q in material.get("qualities", []):
            p = q["percentiles"]
            rows.append([f"{material['material']}, {q['type']}", q["count"], q["least"], *p])
            charts.append(histogram(q["histogram"], f"material {material['material']}, {q['type']}: quality of {q['count']:,}"))
    worst = [[f"{w['type']} {w['cell']:,}", w["material"], w["quality"], ", ".join(f"{x:.6g}" for x in w["place"])]
             for w in report.get("worstCells", [])]
    return (table(["material, cells", "count", "least", "1%", "5%", "25%", "50%", "95%"], rows) + "".join(charts) +
            "<h2>Worst cells</h2>" + table(["cell", "material", "quality", "place"], worst))


def image_part(image):
    volumes = [[f"material {r['material']}", r["voxels"], r["voxelVolume"], r["meshVolume"],
                f"{100 * (r['meshVolume'] / r['voxelVolume'] - 1):+.3f}%"] for r in image["materials"]]
    volumes += [[f"piece of material {r['material']}", r["voxels"], r["voxelVolume"], r["meshVolume"],
                 f"{100 * (r['meshVolume'] / r['voxelVolume'] - 1):+.3f}%"] for r in image["pieces"]]
    distances = [[f"{r['materials'][0]} and {r['materials'][1]}", r["median"], r["p95"], r["largest"],
                  f"{100 * r['withinHalfVoxel']:.2f}%"] for r in image["distancesInVoxels"]]
    return ("<h2>Against the image's voxels</h2>" + table(["", "voxels", "their volume", "mesh", "difference"], volumes) +
            table(["distance to the border of", "median, voxels", "95%", "largest", "within half a voxel"], distances))


def page(title, report, images=()):
    verdict = "The audit found nothing wrong." if report["passed"] else "The audit found what is wrong:"
    parts = [f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title><style>{STYLE}</style></head>',
             f"<body><h1>{html.escape(title)}</h1>",
             f'<p class="verdict {"passed" if report["passed"] else "failed"}">{verdict}</p>']
    if report.get("findings"):
        parts.append("<ul>" + "".join(f"<li>{html.escape(text)}</li>" for text in report["findings"]) + "</ul>")
    parts.append(pictures(images))
    skipped = ("passed", "findings", "materials", "layersAchieved", "worstCells", "patches", "image")
    parts.append("<h2>Figures</h2>" + table(["figure", "value"], [[k, v] for k, v in report.items() if k not in skipped]))
    names = [k for k, v in report["materials"][0].items() if not isinstance(v, list)] if report["materials"] else []
    if names:
        parts.append("<h2>Materials</h2>" + table(names, [[row.get(k) for k in names] for row in report["materials"]]))
    if report.get("worstCells") is not None:
        parts.append("<h2>Quality</h2>" + quality_part(report))
    if report.get("layersAchieved"):
        parts.append("<h2>Layers of prisms on the walls</h2>" + table(
            ["prisms", "triangles of walls"], [[str(r["prisms"]), r["count"]] for r in report["layersAchieved"]]))
    if report.get("patches"):
        parts.append("<h2>Patches</h2>" + table(["name", "faces", "area"], [[r["name"], r["faces"], r["area"]] for r in report["patches"]]))
    parts += [image_part(image) for image in report.get("image", [])]
    return "\n".join(parts) + "</body></html>\n"
