"""The page: sections with figures that are part of the file, each with where it comes from."""

import base64
import html
import io
from dataclasses import dataclass

import matplotlib
import matplotlib.pyplot as plt

matplotlib.use("Agg")  # No display is needed.

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 68rem; margin: 2rem auto;
  padding: 0 1rem }
h2 { margin-top: 3rem; border-bottom: 1px solid #ccc }
figure { margin: 1.5rem 0 }
img { max-width: 100%; display: block }
figcaption { max-width: 56rem }
.origin { color: #666; font-size: 12px; overflow-wrap: anywhere }
table { border-collapse: collapse; font-size: 14px; font-variant-numeric: tabular-nums; display: block;
  overflow-x: auto }
td, th { padding: 2px 10px; text-align: right; border-bottom: 1px solid #ddd }
td:first-child, th:first-child { text-align: left }
.words td, .words th { text-align: left }
.missed { color: #a40000; font-weight: bold }
"""

# One colour and mark for each method, in all figures.
COLOURS = {
    "area": "tab:red",
    "solid_angle": "tab:orange",
    "published": "tab:purple",
    "published, cube root": "tab:pink",
    "projected_bounded": "tab:green",
    "projected": "tab:blue",
}


@dataclass(frozen=True)
class Section:
    """A part of the page: HTML below a heading."""

    name: str
    title: str
    body: str


def origin(about: dict[str, str]) -> str:
    """Return the line that says where a figure comes from."""
    keys = ("machine", "commit", "compiler", "command", "seed", "date")
    parts = [f"{key}: {html.escape(about[key])}" for key in keys if key in about]
    return f'<p class="origin">{"; ".join(parts)}</p>'


def image(png: bytes, alt: str) -> str:
    """Return a picture as HTML."""
    data = base64.b64encode(png).decode()
    return f'<img alt="{html.escape(alt)}" src="data:image/png;base64,{data}">'


def figure(drawing: plt.Figure, name: str, caption: str, about: dict[str, str]) -> str:
    """Return a drawing with its caption (HTML) and origin, and close it."""
    buffer = io.BytesIO()
    drawing.savefig(buffer, format="png", dpi=120)
    plt.close(drawing)
    return picture(buffer.getvalue(), name, caption, about)


def picture(png: bytes, name: str, caption: str, about: dict[str, str]) -> str:
    """Return a PNG with its caption and origin."""
    text = f"<figcaption>{caption}{origin(about)}</figcaption>"
    return f'<figure id="{html.escape(name)}">{image(png, name)}{text}</figure>'


def table(heads: list[str], rows: list[list[str]]) -> str:
    """Return a table; cells are HTML."""
    head = "".join(f"<th>{cell}</th>" for cell in heads)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><tr>{head}</tr>{body}</table>"


def page(introduction: str, sections: list[Section]) -> str:
    """Return the whole page."""
    links = "".join(f'<li><a href="#{one.name}">{one.title}</a></li>' for one in sections)
    bodies = "".join(f'<h2 id="{one.name}">{one.title}</h2>{one.body}' for one in sections)
    return (
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width"><title>spherecap: speed against error</title>'
        f"<style>{STYLE}</style></head><body><h1>spherecap: speed against error</h1>"
        f"{introduction}<ol>{links}</ol>{bodies}</body></html>\n"
    )
