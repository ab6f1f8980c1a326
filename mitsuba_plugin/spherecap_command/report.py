"""What `spherecap compare` leaves: images as EXR and PNG, and one HTML page that needs no other file."""

import base64
import html
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from spherecap_command.compare import FOOTNOTE, HEADINGS, Reference, Result, rows
from spherecap_command.measure import error_scale
from spherecap_command.pictures import densest_crop, exposure, save_exr, save_png, signed, to_srgb
from spherecap_command.scene import BUILT_IN, OURS
from spherecap_command.verdict import Parts, parts_table

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: 1em 0 }
th, td { padding: .25em .9em; text-align: right; border-bottom: 1px solid #ddd }
td:first-child { text-align: left }
figure { margin: 0; min-width: 0 }
figcaption { padding: .2em 0 }
img { width: 100%; image-rendering: pixelated; display: block }
.row { display: flex; flex-wrap: wrap; gap: 0 3em; align-items: flex-start }
.images { display: grid; grid-template-columns: 3fr 2fr 3fr; gap: .8em; margin-bottom: 1em; align-items: end }
.images .detail img { aspect-ratio: 1 }
.verdict { font-size: 120%; font-weight: 600 }
.note { color: #666 }
.scale { background: linear-gradient(90deg, rgb(13 64 166), white, rgb(178 13 26)); height: 1em }
.ends { display: flex; justify-content: space-between }
svg { font: 12px system-ui, sans-serif }
"""
_COLOURS = {BUILT_IN: "#c0392b", OURS: "#1f5fa8"}


def _figure(path: Path, caption: str, kind: str = "") -> str:
    data = base64.b64encode(path.read_bytes()).decode()
    text = html.escape(caption)
    image = f'<img alt="{text}" src="data:image/png;base64,{data}">'
    return f'<figure class="{kind}">{image}<figcaption>{text}</figcaption></figure>'


def _table(lines: Sequence[Sequence[str]]) -> str:
    def row(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>\n"

    return "<table>\n" + row(lines[0], "th") + "".join(row(cells, "td") for cells in lines[1:]) + "</table>"


def _ticks(low: float, high: float) -> list[float]:
    """Return 1, 2 and 5 times powers of ten between two positive numbers, or the powers alone if many."""
    exponents = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    steps = (1, 2, 5) if math.log10(high / low) < 2.5 else (1,)
    return [x for e in exponents for s in steps if low <= (x := float(f"{s}e{e}")) <= high]


def _curves(results: Sequence[Result], truth: Reference, against: str) -> str:
    """Draw the error of both against samples or seconds, both axes logarithmic, as SVG."""
    points = {
        technique: [
            (one.spp if against == "samples" else one.seconds, one.rmse(truth))
            for one in results
            if one.technique == technique and one.rmse(truth) > 0
        ]
        for technique in (BUILT_IN, OURS)
    }
    everything = np.array([point for line in points.values() for point in line])
    if len(everything) == 0:
        return ""
    (left, bottom), (right, top) = everything.min(axis=0) / 1.3, everything.max(axis=0) * 1.3
    x0, y0, width, height = 60, 20, 320, 220

    def place(x: float, y: float) -> tuple[float, float]:
        return (
            x0 + width * math.log(x / left) / math.log(right / left),
            y0 + height * (1 - math.log(y / bottom) / math.log(top / bottom)),
        )

    def text(x: float, y: float, words: str, anchor: str) -> str:
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="#444">{html.escape(words)}</text>'

    drawn = [f'<rect x="{x0}" y="{y0}" width="{width}" height="{height}" fill="none" stroke="#999"/>']
    for x in _ticks(left, right):
        at, _ = place(x, bottom)
        drawn.append(f'<path d="M{at:.1f} {y0}v{height}" stroke="#e4e4e4"/>')
        drawn.append(text(at, y0 + height + 16, f"{x:g}", "middle"))
    for y in _ticks(bottom, top):
        _, at = place(left, y)
        drawn.append(f'<path d="M{x0} {at:.1f}h{width}" stroke="#e4e4e4"/>')
        drawn.append(text(x0 - 6, at + 4, f"{y:g}", "end"))
    for technique, line in points.items():
        colour = _COLOURS[technique]
        at = [place(*point) for point in sorted(line)]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in at)
        drawn.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        drawn += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in at]
    name = "samples per pixel" if against == "samples" else "seconds per render"
    drawn.append(text(x0 + width / 2, y0 + height + 36, name, "middle"))
    drawn.append(text(x0, y0 - 7, "relative RMSE", "start"))
    for number, technique in enumerate((BUILT_IN, OURS)):
        x = x0 + width - 150 + 75 * number
        drawn.append(f'<circle cx="{x}" cy="{y0 - 11}" r="3.5" fill="{_COLOURS[technique]}"/>')
        drawn.append(text(x + 8, y0 - 7, technique, "start"))
    label = f"relative RMSE of both emitters against {name}"
    return f'<svg role="img" aria-label="{label}" width="400" height="290">{"".join(drawn)}</svg>'


def write_report(
    folder: Path,
    title: str,
    details: str,
    sentences: Sequence[str],
    parts: Parts | None,
    results: Sequence[Result],
    truth: Reference,
) -> Path:
    """Write everything into an existing folder, and return the page.

    title: the page's heading. details: a line below it, on how this was made. sentences: the verdict.
    """
    exposed = exposure(truth.image)
    scale = error_scale(truth.image)
    # Where the built-in emitter errs most at the lowest count, as seen on the screen.
    visible = np.abs(to_srgb(results[0].image, exposed) - to_srgb(truth.image, exposed)).mean(axis=-1)
    crop = densest_crop(visible, max(min(visible.shape) // 4, 1))

    def save(name: str, image: np.ndarray) -> tuple[Path, Path]:
        save_exr(folder / f"{name}.exr", image)
        whole, detail = folder / f"{name}.png", folder / f"{name}-detail.png"
        encoded = to_srgb(image, exposed)
        save_png(whole, encoded)
        save_png(detail, encoded[crop])
        return whole, detail

    whole, detail = save("reference", truth.image)
    rows_of_images = [
        _figure(whole, f"reference: {truth.origin}")
        + _figure(detail, "detail", "detail")
        + '<div><div class="scale"></div><div class="ends"><span>darker</span><span>no error</span>'
        "<span>brighter</span></div>error; in full colour it is as large as the reference</div>"
    ]
    for one in sorted(results, key=lambda one: one.spp):
        name = f"{one.technique}-{one.spp}spp"
        whole, detail = save(name, one.image)
        errors = folder / f"{name}-error.png"
        save_png(errors, signed(((one.image - truth.image) / scale).mean(axis=-1)))
        caption = f"{one.technique}, {one.spp} sample{'s' if one.spp > 1 else ''} per pixel"
        rows_of_images.append(
            _figure(whole, caption)
            + _figure(detail, "detail", "detail")
            + _figure(errors, f"error, relative RMSE {one.rmse(truth):.3g}")
        )
    images = "\n".join(f'<div class="images">{row}</div>' for row in rows_of_images)
    page = folder / "index.html"
    first, *others = (html.escape(sentence) for sentence in sentences)
    page.write_text(
        f"""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{html.escape(title)}</title>
<style>{_STYLE}</style>
<h1>{html.escape(title)}</h1>
<p>{html.escape(details)}</p>
<p class="verdict">{first}</p>
<p>{" ".join(others)}</p>
<div class="row">
{_curves(results, truth, "samples")}
{_curves(results, truth, "seconds")}
{_table(parts_table(parts)) if parts else ""}
</div>
{_table([HEADINGS, *rows(results, truth)])}
<p class="note">{html.escape(FOOTNOTE)}. The error is what renders with different seeds differ by, relative \
to the reference, whose own is {truth.noise**0.5:.2g}. The detail is the square in which {BUILT_IN} looks \
worst. All images are beside this page, as EXR and PNG.</p>
{images}
</html>
""",
        encoding="utf-8",
    )
    return page
