"""Which renderers there are, and how their work gets done: side by side, kept on disk, resumed."""

import contextlib
import hashlib
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
from renderlab.scenes import OUTPUT, REPOSITORY
from spherecap_command.errors import UserError
from spherecap_command.scene import OURS

from cross.render_c import PROGRAM as C_RENDERER
from cross.scene import by_name
from cross.worker import Job

HERE = Path(__file__).resolve().parent
RENDERS = OUTPUT / "cross" / "renders"
PLUGIN = REPOSITORY / "mitsuba_plugin" / "spherecap" / "plugins" / "spherecap.so"
# What bpy loads and no Python package brings: the names of Debian and Ubuntu.
CYCLES_LIBRARIES = "libgl1 libsm6 libice6 libx11-6 libxext6 libxfixes3 libxi6 libxrender1 libxkbcommon0"


@dataclass(frozen=True)
class Renderer:
    """One renderer: the Python that runs it, and what its images depend on beside the job."""

    name: str
    python: Path
    depends_on: tuple[Path, ...]
    # Imported to see whether all is there; and what to do if that fails.
    module: str
    remedy: str

    @property
    def script(self) -> Path:
        """The file that turns scenes into this renderer's input."""
        return HERE / f"render_{self.name}.py"


def _environment(name: str) -> tuple[Path, Path]:
    """Return the Python of an environment of its own, and the list of what is installed there."""
    return REPOSITORY / f".venv-{name}" / "bin" / "python", HERE / f"requirements-{name}.txt"


_LUXCORE, _CYCLES = _environment("luxcore"), _environment("cycles")
RENDERERS = {
    one.name: one
    for one in (
        Renderer("mitsuba", Path(sys.executable), (), "mitsuba", "run `make build`"),
        Renderer("c", Path(sys.executable), (C_RENDERER,), "numpy", "run `make build/renderer`"),
        Renderer(
            "luxcore",
            _LUXCORE[0],
            (_LUXCORE[1], HERE / "mesh.py"),
            "pyluxcore",
            "run `make .venv-luxcore/installed`",
        ),
        Renderer(
            "cycles",
            _CYCLES[0],
            (_CYCLES[1], HERE / "mesh.py"),
            "bpy",
            "run `make .venv-cycles/installed`; if a shared library is missing, `apt-get install "
            f"{CYCLES_LIBRARIES}` (or your system's names for them)",
        ),
    )
}


def check(renderer: Renderer) -> None:
    """Raise if a renderer is not there, with what to do."""
    missing = [path for path in (renderer.python, *renderer.depends_on) if not path.exists()]
    if missing:
        raise UserError(f"the renderer '{renderer.name}' needs {missing[0]}: {renderer.remedy}")
    done = subprocess.run(
        [renderer.python, "-c", f"import {renderer.module}"], capture_output=True, text=True
    )
    if done.returncode != 0:
        reason = (done.stderr.strip().splitlines() or [f"exit status {done.returncode}"])[-1]
        raise UserError(f"the renderer '{renderer.name}' does not start ({reason}): {renderer.remedy}")


@dataclass(frozen=True)
class Stack:
    """Independent renders: images (seeds, height, width), CPU seconds and samples per pixel of each."""

    images: np.ndarray
    seconds: np.ndarray
    spp: np.ndarray


def kept_file(renderer: Renderer, job: Job, folder: Path) -> Path:
    """Return where a job's images are kept: another scene, setting, script or binary gets another name."""
    files = [renderer.script, *renderer.depends_on]
    if job.light_sampling == OURS:
        files.append(PLUGIN)
    parts = [repr(by_name(job.scene)).encode(), repr(job).encode(), version("mitsuba").encode()]
    parts += [path.read_bytes() for path in files]
    key = hashlib.sha256(b"\0".join(parts)).hexdigest()[:16]
    name = f"{renderer.name}-{job.light_sampling}-{job.sampler}-{job.scene.replace(' ', '_')}-{job.spp}"
    return folder / f"{name}-{key}.npz"


def load(path: Path) -> Stack:
    """Read what a worker saved."""
    with np.load(path) as kept:
        return Stack(kept["images"].astype(np.float64), kept["seconds"], kept["spp"])


class _Worker:
    """A renderer's process."""

    def __init__(self, renderer: Renderer, log: Path):
        self.renderer, self.log = renderer, log
        with log.open("w") as errors:
            self.process = subprocess.Popen(
                [renderer.python, renderer.script],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                text=True,
                errors="replace",
            )

    def carry_out(self, job: Job, path: Path) -> None:
        """Render one job; what else the renderer prints is not of interest."""
        with contextlib.suppress(BrokenPipeError):  # Then the answer is missing, too.
            print(job.to_json(path), file=self.process.stdin, flush=True)
        for line in self.process.stdout:
            if line.strip() == str(path):
                return
        tail = "\n".join(self.log.read_text(errors="replace").splitlines()[-5:])
        raise UserError(f"'{self.renderer.name}' failed on {job}; the end of {self.log}:\n{tail}")

    def close(self) -> None:
        """End the process."""
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


def carry_out(
    work: Sequence[tuple[Renderer, Job]],
    folder: Path = RENDERS,
    progress: Callable[[Renderer, Job], None] = print,
) -> list[Stack]:
    """Render what is not there yet, one worker per core, and return all stacks in the order of the work.

    progress: called after each job that was rendered or found.
    """
    paths = [kept_file(renderer, job, folder) for renderer, job in work]
    folder.mkdir(parents=True, exist_ok=True)
    waiting: queue.SimpleQueue = queue.SimpleQueue()
    for (renderer, job), path in zip(work, paths, strict=True):
        if path.exists():
            progress(renderer, job)
        else:
            waiting.put((renderer, job, path))
    failures: list[Exception] = []

    def serve(number: int) -> None:
        workers: dict[str, _Worker] = {}
        try:
            while not failures:
                renderer, job, path = waiting.get_nowait()
                if renderer.name not in workers:
                    workers[renderer.name] = _Worker(renderer, folder / f"{renderer.name}-{number}.log")
                workers[renderer.name].carry_out(job, path)
                progress(renderer, job)
        except queue.Empty:
            pass
        except Exception as failure:
            failures.append(failure)
        finally:
            for worker in workers.values():
                worker.close()

    threads = [threading.Thread(target=serve, args=(number,)) for number in range(os.cpu_count() or 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if failures:
        raise failures[0]
    return [load(path) for path in paths]
