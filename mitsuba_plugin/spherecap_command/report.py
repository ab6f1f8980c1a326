"""What `spherecap compare` leaves: images as EXR and PNG, and one HTML page that needs no other file."""

import base64
import html
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from spherecap_command.compare import FOOTNOTE, HEADINGS, Reference, Result, rows
from spherecap_command.measure import error_scale
from spherecap_command.pictures import densest_crop, exposure, save_exr, save_png

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 100em; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: 1em 0 }
th, td { padding: .25em .9em; text-align: right; border-bottom: 1px solid #ddd }
figure { margin: 0; flex: 1; min-width: 0 }
figcaption { padding: .2em 0 }
img { width: 100%; image-rendering: pixelated; display: block }
.row { display: flex; gap: .6em; margin-bottom: 1em }
.note { color: #666 }
"""


def _image(path: Path, caption: str) -> str:
    data = base64.b64encode(path.read_bytes()).decode()
    text = html.escape(caption)
    image = f'<img alt="{text}" src="data:image/png;base64,{data}">'
    return f"<figure>{image}<figcaption>{text}</figcaption></figure>"


def _table(results: Sequence[Result]) -> str:
    def row(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>\n"

    return (
        "<table>\n" + row(HEADINGS, "th") + "".join(row(cells, "td") for cells in rows(results)) + "</table>"
    )


def write_report(folder: Path, title: str, details: str, results: Sequence[Result], truth: Reference) -> Path:
    """Write everything into an existing folder, and return the page.

    title: the page's heading. details: a line below it, on how this was made.
    """
    factor = exposure(truth.image)
    # Where the built-in emitter errs most at the lowest count, as seen on the screen.
    scale = error_scale(truth.image)
    error = (np.abs(results[0].image - truth.image) / scale).mean(axis=-1)
    side = max(min(error.shape) // 4, 1)
    crop = densest_crop(np.minimum(error, 1), side)

    def save(name: str, image: np.ndarray) -> tuple[Path, Path]:
        save_exr(folder / f"{name}.exr", image)
        whole, detail = folder / f"{name}.png", folder / f"{name}-detail.png"
        save_png(whole, image, factor)
        save_png(detail, image[crop], factor)
        return whole, detail

    reference = save("reference", truth.image)
    groups = []
    for spp in sorted({one.spp for one in results}):
        saved = [
            (save(f"{one.technique}-{spp}spp", one.image), f"{one.technique}, relative RMSE {one.rmse:.3g}")
            for one in results
            if one.spp == spp
        ]
        saved.append((reference, f"reference: {truth.origin}"))
        rows_of_images = [
            '<div class="row">' + "".join(_image(paths[part], caption) for paths, caption in saved) + "</div>"
            for part in (0, 1)
        ]
        groups.append(
            f"<h2>{spp} sample{'s' if spp > 1 else ''} per pixel</h2>\n" + "\n".join(rows_of_images)
        )
    page = folder / "index.html"
    page.write_text(
        f"""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>{html.escape(title)}</title>
<style>{_STYLE}</style>
<h1>{html.escape(title)}</h1>
<p>{html.escape(details)}</p>
{_table(results)}
<p class="note">{html.escape(FOOTNOTE)}. Errors are relative to the reference, whose own is \
{truth.noise**0.5:.2g}. Below each image: the square in which {html.escape(results[0].technique)} errs most, \
enlarged. The images are beside this page, as EXR and PNG.</p>
{chr(10).join(groups)}
</html>
""",
        encoding="utf-8",
    )
    return page
