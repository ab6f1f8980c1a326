"""The notebook runs, and shows what its cells give."""

import base64
import io
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
TUTORIAL = REPOSITORY / "docs/tutorial.ipynb"
#: The mean difference of pictures, as a part of their range. Where sums are rounded in another order, curves
#: move by a pixel, and here and there another sample is taken; all others (another seed) make 0.04.
ALIKE = 0.01


def read(path: Path) -> dict:
    """Return a notebook."""
    return json.loads(path.read_text(encoding="utf-8"))


def outputs(notebook: dict) -> list[dict]:
    """Return what all cells show."""
    return [output for cell in notebook["cells"] for output in cell.get("outputs", [])]


def printed(notebook: dict) -> str:
    """Return what all cells print."""
    return "".join(line for output in outputs(notebook) for line in output.get("text", []))


def pictures(notebook: dict) -> list[np.ndarray]:
    """Return the pictures of all cells, from 0 to 1."""
    files = [
        base64.b64decode(output["data"]["image/png"]) for output in outputs(notebook) if "data" in output
    ]
    return [matplotlib.image.imread(io.BytesIO(file)) for file in files]


@pytest.fixture(scope="module")
def remade(tmp_path_factory: pytest.TempPathFactory) -> dict:
    """Return the notebook as `make notebook` leaves it."""
    path = Path(shutil.copy(TUTORIAL, tmp_path_factory.mktemp("tutorial")))
    environment = {**os.environ, "PYTHONPATH": str(REPOSITORY / "mitsuba_plugin")}
    program = [sys.executable, REPOSITORY / "tools/notebook.py", path]
    done = subprocess.run(program, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return read(path)


def test_what_it_shows_is_what_its_cells_give(remade: dict) -> None:
    """Who changes a cell, or what it prints or plots, runs `make notebook`."""
    stored = read(TUTORIAL)
    assert stored["metadata"] == remade["metadata"], "a cell was changed after it was run"
    number = r"\d+\.\d+(?!\.)"
    assert re.sub(number, "#", printed(stored)) == re.sub(number, "#", printed(remade))
    found, expected = (
        [float(text) for text in re.findall(number, printed(notebook))] for notebook in (remade, stored)
    )
    # Mitsuba's version is among them; what a descent through noise leads to is known to a fifth.
    assert found == pytest.approx(expected, rel=0.2)
    assert len(pictures(stored)) >= 3
    for picture, again in zip(pictures(stored), pictures(remade), strict=True):
        assert picture.shape == again.shape
        assert np.abs(picture - again).mean() < ALIKE


def test_what_it_says_is_so(remade: dict) -> None:
    """There is less noise, and the light is found."""
    percent = [float(text) for text in re.findall(r"off by ([\d.]+) %", printed(remade))]
    distance = [float(text) for text in re.findall(r"are ([\d.]+) from", printed(remade))]
    assert percent[1] < percent[0] / 20
    assert percent[3] < percent[2] / 4
    assert distance[1] < min(0.03, distance[0] / 3)


def test_it_is_small_and_its_links_lead_somewhere() -> None:
    """GitHub shows notebooks that are."""
    assert TUTORIAL.stat().st_size < 5e5
    text = "".join(line for cell in read(TUTORIAL)["cells"] for line in cell["source"])
    links = [link for link in re.findall(r"\]\(([^)]+)\)", text) if not link.startswith("http")]
    assert links
    for link in links:
        assert (TUTORIAL.parent / link).exists(), link
