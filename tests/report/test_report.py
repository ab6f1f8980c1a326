"""The report from small inputs and tiny renders: all is there, its numbers are the inputs', it resumes."""

import base64
import io
import re
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from inputs import rows, write_inputs
from spherecap_command.errors import UserError

from report import convergence, crops, renders
from report.build import Plan, build, full_plan
from report.renders import Settings
from report.speed import front
from report.targets import counts

PLAN = Plan(
    # Analytic references: nothing else is rendered.
    convergence=Settings(("cut_light", "open_floor"), spp=(1, 4), seeds=2, width=16, height=12),
    crops=Settings(("cut_light",), (1,), 1, 32, 24),
    recorded_samples=1024,
    recorded_rounds=1,
)
SECTIONS = ("targets", "limits", "speed", "bound", "noise", "errors", "convergence", "crops", "cross")
FIGURES = {"pareto-inverse", "pareto-deviation", "figure-2", "bound-map", "deviation-maps", "error-maps"}
FIGURES |= {"convergence-cut_light", "convergence-open_floor", "crops-cut_light"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the inputs and a built report."""
    folder = tmp_path_factory.mktemp("report")
    write_inputs(folder)
    build(folder, folder / "page", PLAN)
    return folder


@pytest.fixture
def page(folder: Path) -> str:
    """The page as text."""
    return (folder / "page" / "index.html").read_text()


def test_has_all_sections_and_figures(page: str) -> None:
    """Each figure is a picture that shows something, and says where it comes from."""
    assert re.findall(r'<h2 id="([^"]+)"', page) == list(SECTIONS)
    figures = dict(re.findall(r'<figure id="([^"]+)">(.*?)</figure>', page, re.DOTALL))
    assert set(figures) == FIGURES
    for name, body in figures.items():
        (data,) = re.findall(r'src="data:image/png;base64,([^"]+)"', body)
        pixels = matplotlib.image.imread(io.BytesIO(base64.b64decode(data)), format="png")
        assert pixels.shape[0] > 200, name
        assert pixels[..., :3].std() > 0.01, name
        for key in ("machine", "commit", "command", "seed"):
            assert f"{key}: " in body, name


def test_is_self_contained(page: str) -> None:
    """One file: pictures are data, links lead to places within it."""
    targets = re.findall(r'(?:src|href)="([^"]*)"', page)
    assert targets
    assert all(target.startswith(("data:image/png;base64,", "#")) for target in targets)
    for word in ("<script", "<link", "<iframe", "@import", "url("):
        assert word not in page
    assert "a machine &lt;&amp;&gt;" in page


def test_targets_are_the_inputs_numbers(page: str) -> None:
    """Every number of the inputs, and what is said of it."""
    times, counted = rows("ratio", 1.001, 0.01), rows("instructions", 101.0, 1.0)

    def number(table: list[dict], column: str, *key: str) -> float:
        (row,) = (r for r in table if (r["set"], r["lane"], r["method"], r["task"]) == ("mix", *key))
        return row[column]

    def nanoseconds(method: str, task: str) -> float:
        return number(times, "nanoseconds", "f32", method, task)

    one, many = "prepare + 1 sample", "prepare + 16 samples"
    ours, plain = "projected", "solid_angle"
    expected = [
        *((number(counted, "instructions", "f32", ours, task), 0) for task in (one, many)),
        *((number(counted, "instructions", "f32", plain, task), 0) for task in (one, many)),
        *((nanoseconds(ours, task) / nanoseconds("published", task), 2) for task in (one, many)),
        *((nanoseconds(ours, task) / nanoseconds("published, cube root", task), 2) for task in (one, many)),
        *((number(counted, "instructions", lane, ours, one), 0) for lane in ("AVX2", "AVX-512")),
    ]
    section = page[page.index('<h2 id="targets"') : page.index('<h2 id="limits"')]
    cells = [re.findall("<td>(.*?)</td>", row) for row in re.findall("<tr>(.*?)</tr>", section)][1:]
    assert [row[2] for row in cells[:10]] == [f"{value:.{digits}f}" for value, digits in expected]
    for row, (value, _) in zip(cells, expected, strict=False):
        assert re.sub("<.*?>", "", row[3]) == ("met" if value <= float(row[1]) else "missed"), row
    assert {row[3] for row in cells} == {"met", '<span class="missed">missed</span>'}
    assert cells[-2][2] == str(counts()["sampler, bytes"])


def test_resumes(folder: Path) -> None:
    """What is there is not rendered again, and what is lost is."""
    curves, sheets = folder / "report" / "curves", folder / "report" / "crops"
    assert renders.samples_to_render(curves, PLAN.convergence) == 0
    assert crops.samples_to_render(sheets, PLAN.crops) == 0
    before = renders.renders(curves, PLAN.convergence, pytest.fail)
    renders.cache_file(curves, "open_floor", PLAN.convergence).unlink()
    missing = renders.samples_to_render(curves, PLAN.convergence)
    assert missing == len(renders.METHODS) * 2 * (1 + 4)
    done = []
    after = renders.renders(curves, PLAN.convergence, done.append)
    assert sum(done) == missing
    assert after[0] == before[0]
    for method in renders.METHODS:  # The same seeds, so the same pictures.
        assert after[1]["methods"][method]["squared"] == before[1]["methods"][method]["squared"]


def test_other_settings_are_other_renders(folder: Path) -> None:
    """Nothing is mistaken for what it is not."""
    names = {renders.cache_file(folder, "cut_light", s).name for s in (PLAN.convergence, PLAN.crops)}
    names |= {renders.cache_file(folder, "cut_light", full_plan().convergence).name}
    assert len(names) == 3


def test_a_missing_input_is_named(tmp_path: Path) -> None:
    """With what makes it."""
    with pytest.raises(UserError, match=r"make out/bench\.json"):
        build(tmp_path, tmp_path, PLAN)


def test_bands() -> None:
    """0.1 and 0.4 have the geometric mean 0.2, and the interval is symmetric in the logarithm."""
    rmse, low, high = convergence.band(np.array([[0.01, 0.16]]))
    assert rmse == pytest.approx([0.2])
    assert low * high == pytest.approx(rmse**2)
    # t of one degree of freedom, 12.706; the standard error of log 0.1 and log 0.4 is half of log 4.
    assert high / rmse == pytest.approx([4 ** (12.7062 / 2)], rel=1e-4)


def test_front() -> None:
    """What another beats in both respects is not on it."""
    marks = [("a", "", 2.0, 1.0), ("b", "", 1.0, 2.0), ("c", "", 3.0, 1.5), ("d", "", 4.0, 0.5)]
    assert [mark[0] for mark in front(marks)] == ["b", "a", "d"]
