"""Fixtures of the render tests, and the table that they print at the end."""

import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(REPOSITORY / "tools"), str(Path(__file__).resolve().parent)]

import renderlab  # noqa: E402, F401 (registers the plugin, or says how to build it)
from gallery import Gallery  # noqa: E402 (needs the paths above)
from plan import VARIANTS  # noqa: E402
from spherecap_command.scene import OURS, use_variant  # noqa: E402

TABLE = pytest.StashKey[dict]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--candidate area` puts the built-in emitter in our place: a check of the tests themselves."""
    parser.addoption("--candidate", default=OURS, help="emitter under test (default: %(default)s)")


def candidate_of(config: pytest.Config) -> str:
    """Return the emitter under test; pytest knows the option only if it was started on this folder."""
    return config.getoption("--candidate", default=OURS)


def pytest_configure(config: pytest.Config) -> None:
    """Start with an empty table."""
    config.stash[TABLE] = {}


@pytest.fixture(scope="session", params=VARIANTS)
def gallery(request: pytest.FixtureRequest) -> Gallery:
    """All images of one variant."""
    use_variant(request.param)
    return Gallery(request.param, candidate_of(request.config))


@pytest.fixture
def record(request: pytest.FixtureRequest):
    """Return a function that adds values to a row of the table: record(name, column=value)."""
    table = request.config.stash[TABLE]

    def add(name: str, **columns: object) -> None:
        table.setdefault(name, {}).update(columns)

    return add


def pytest_terminal_summary(terminalreporter, config: pytest.Config) -> None:
    """Print what was measured: RMSE is relative, at so many samples per pixel; p-values are Sidak-corrected.

    "dimmed": the p-value of a copy that is 1 % too dark, for the test to its left; small is good.
    """
    table = config.stash[TABLE]
    if not table:
        return
    columns = ["spp", "RMSE area", "RMSE ours", "area/ours", "slope"]
    columns += ["p pixels", "dimmed", "p mean", "dimmed, mean", "p analytic", "dimmed, analytic"]
    widths = [max(len(c), 9) for c in columns]
    name_width = max(len(n) for n in table)
    write = terminalreporter.write_line
    terminalreporter.section(f"renders: {candidate_of(config)} against area")
    write(" ".join(["scene".ljust(name_width)] + [c.rjust(w) for c, w in zip(columns, widths, strict=True)]))
    for name, row in table.items():
        cells = [row.get(c, "") for c in columns]
        texts = [f"{v:.3g}" if isinstance(v, float) else str(v) for v in cells]
        write(" ".join([name.ljust(name_width)] + [t.rjust(w) for t, w in zip(texts, widths, strict=True)]))
