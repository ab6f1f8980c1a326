"""How work is handed to renderers: what is missing is said, what is done is kept."""

from dataclasses import replace
from pathlib import Path

import pytest
from cross.jobs import CYCLES_LIBRARIES, RENDERERS, carry_out, check, kept_file
from cross.worker import Job
from renderlab.scenes import REPOSITORY
from spherecap_command.errors import UserError

SMALL = Job("S1", 8, 6, "projected", "independent", 1, (1, 2))


@pytest.mark.parametrize("name", ["luxcore", "cycles"])
def test_missing_renderer_says_what_to_do(name: str, tmp_path: Path) -> None:
    """With no environment, and with one that lacks the renderer."""
    renderer = RENDERERS[name]
    with pytest.raises(UserError, match=rf"'{name}' needs .*: run `make \.venv-{name}/installed`"):
        check(replace(renderer, python=tmp_path / "python"))
    with pytest.raises(UserError, match=rf"'{name}' does not start .*: run `make \.venv-{name}/installed`"):
        check(replace(renderer, python=RENDERERS["mitsuba"].python))


def test_missing_c_renderer_says_what_to_do(tmp_path: Path) -> None:
    """It was not built."""
    with pytest.raises(UserError, match="run `make build/renderer`"):
        check(replace(RENDERERS["c"], depends_on=(tmp_path / "renderer",)))


def test_readme_names_the_libraries_of_cycles() -> None:
    """The same as the message."""
    assert CYCLES_LIBRARIES in " ".join((REPOSITORY / "README.md").read_text().split())


def test_a_failing_renderer_fails_the_run(tmp_path: Path) -> None:
    """With the end of what it said."""
    with pytest.raises(UserError, match=r"(?s)'c' failed on .*there is no such choice: astrology"):
        carry_out([(RENDERERS["c"], replace(SMALL, sampler="astrology"))], tmp_path, progress=lambda *_: None)
    assert not list(tmp_path.glob("*.npz"))


def test_what_is_done_is_kept_and_what_changes_is_not(tmp_path: Path) -> None:
    """By content: settings and binaries."""
    work = [(RENDERERS["c"], SMALL)]
    (first,) = carry_out(work, tmp_path, progress=lambda *_: None)
    assert first.images.shape == (2, 6, 8)
    assert not (first.images[0] == first.images[1]).all(), "seeds differ"
    (path,) = tmp_path.glob("*.npz")
    written = path.stat().st_mtime_ns
    (again,) = carry_out(work, tmp_path, progress=lambda *_: None)
    assert (first.images == again.images).all()
    assert path.stat().st_mtime_ns == written

    binary = tmp_path / "renderer"
    binary.write_bytes(b"another")
    changed = [
        (RENDERERS["c"], replace(SMALL, spp=2)),
        (RENDERERS["c"], replace(SMALL, scene="S2")),
        (replace(RENDERERS["c"], depends_on=(binary,)), SMALL),
    ]
    assert len({path, *(kept_file(renderer, job, tmp_path) for renderer, job in changed)}) == 4
