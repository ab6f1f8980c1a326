"""Runs the cells of a notebook, and writes what they print and plot into it: `make notebook`.

Its cells are plain Python, so no kernel is needed: what there is to show is what a cell prints, and the
figures that are open at its end.
"""

import base64
import contextlib
import hashlib
import io
import json
import sys
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt

#: Dots per inch: pictures are stored in the notebook, which has to stay small.
RESOLUTION = 64


def outputs(code: str, names: dict) -> list[dict]:
    """Run a cell with the names of those before it; return its outputs, as notebooks store them."""
    printed, found = io.StringIO(), []
    with contextlib.redirect_stdout(printed):
        exec(code, names)
    if text := printed.getvalue():
        found.append({"name": "stdout", "output_type": "stream", "text": text.splitlines(keepends=True)})
    for number in plt.get_fignums():
        picture = io.BytesIO()
        # No version of matplotlib in it, which would change the file.
        plt.figure(number).savefig(picture, format="png", dpi=RESOLUTION, metadata={"Software": None})
        data = {
            "image/png": base64.b64encode(picture.getvalue()).decode() + "\n",
            "text/plain": ["<a figure>"],
        }
        found.append({"data": data, "metadata": {}, "output_type": "display_data"})
    plt.close("all")
    return found


def hash_of(notebook: dict) -> str:
    """Return what tells whether any code was changed after it was run."""
    code = [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    return hashlib.sha256(json.dumps(code).encode()).hexdigest()


def main(path: Path) -> None:
    """Run all cells of the notebook."""
    mpl.use("Agg")
    notebook, names = json.loads(path.read_text(encoding="utf-8")), {}
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for count, cell in enumerate(code, 1):
        cell["execution_count"], cell["outputs"] = count, outputs("".join(cell["source"]), names)
    notebook["metadata"]["hash_of_code"] = hash_of(notebook)
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
