"""The page from its inputs: Rust's JSON files, and renders, which are made if they are missing."""

from dataclasses import dataclass
from pathlib import Path

from renderlab.scenes import scene_names
from tqdm import tqdm

from report import across, bound, convergence, crops, errors, limits, noise, renders, speed, targets
from report.data import read
from report.page import page
from report.recorded import recorded
from report.renders import Settings


@dataclass(frozen=True)
class Plan:
    """How much is rendered."""

    convergence: Settings
    crops: Settings
    recorded_samples: int
    recorded_rounds: int


def full_plan() -> Plan:
    """Return what `make report` renders."""
    return Plan(
        convergence=Settings(tuple(scene_names()), spp=(1, 4, 16, 64), seeds=8, width=64, height=48),
        crops=Settings(("cut_light", "sunken_light", "soft_shadows", "cornell_box"), (4,), 1, 128, 96),
        recorded_samples=2**20,
        recorded_rounds=11,
    )


def introduction(maps: dict, bench: dict) -> str:
    """Say what the methods are, and whether all numbers are of one commit."""
    commits = {maps["commit"], bench["commit"]}
    note = "" if len(commits) == 1 else "<p>The inputs are of different commits: see the lines in grey.</p>"
    return (
        "<p>A spherical light as seen from a point on a surface is a spherical cap. "
        "<code>solid_angle</code> and Mitsuba's "
        "<code>area</code> sample it uniformly in solid angle; <code>published</code> is the method of "
        "Peters and "
        "Dachsbacher (2019), in single precision, with the formulas and the quintic of the paper; "
        "<code>projected_bounded</code> is our rendering of the same map; <code>projected</code> is "
        "uniform in "
        "projected solid angle in every case. Case 1: all of the cap is above the horizon; case 2: more "
        "than half of it, "
        "case 3: less. All captions and tables are made from what was measured, but for what is told of "
        "experiments.</p>" + note
    )


def build(inputs: Path, output: Path, plan: Plan) -> Path:
    """Build `index.html` in a folder, and return where it is; what is rendered is kept below `inputs`."""
    bench, counts, maps = (read(inputs, name) for name in ("bench", "instructions", "maps"))
    kept = inputs / "report"
    kept.mkdir(parents=True, exist_ok=True)
    # Before the renders, because it needs a variant that compiles.
    alone = recorded(kept, plan.recorded_samples, plan.recorded_rounds)
    total = renders.samples_to_render(kept / "curves", plan.convergence)
    total += crops.samples_to_render(kept / "crops", plan.crops)
    with tqdm(total=total, unit="spp", disable=total == 0) as bar:
        results = renders.renders(kept / "curves", plan.convergence, bar.update)
        pictures = crops.section(kept / "crops", plan.crops, bar.update)
    sections = [
        targets.section(bench, counts, alone, results),
        limits.section(),
        speed.section(bench, maps),
        bound.section(maps),
        noise.section(maps),
        errors.section(maps),
        convergence.section(results),
        pictures,
        across.section(inputs / "cross"),
    ]
    output.mkdir(parents=True, exist_ok=True)
    draft, file = output / "index.html.new", output / "index.html"
    draft.write_text(page(introduction(maps, bench), sections))
    draft.replace(file)
    return file
