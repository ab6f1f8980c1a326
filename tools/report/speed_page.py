"""docs/speed.md, its pictures, and the README's figures.

`make speed` measures and writes, `make speed-page` writes alone.

What was measured is committed (docs/speed/measured.json), so that a test can tell that the pages are what
follows from it, and that the kernels are still those that were measured.
"""

import argparse
import hashlib
import io
import json
import sys
from pathlib import Path
from string import Template

import matplotlib.pyplot as plt
from renderlab.scenes import OUTPUT, REPOSITORY
from spherecap_command.errors import UserError

from report import equal_time
from report.data import about, read, rows_by
from report.page import COLOURS
from report.recorded import measure as measure_recorded
from report.speed import MANY, METHODS, ONE, SAME_ERRORS, WAYS, draw, points
from report.targets import DROPPED, counts, plugin_kibibytes, rows, targets

PAGE = Path("docs/speed.md")
PICTURES = Path("docs/speed")
MEASURED = PICTURES / "measured.json"
README = Path("README.md")
TEMPLATE = Template((Path(__file__).parent / "speed.md.in").read_text())
BEGIN, END = "<!-- Made by `make speed`: -->", "<!-- The end of what `make speed` makes. -->"

ORIGIN = ("machine", "commit", "compiler", "command", "date")
# What is drawn and listed of the Rust programs' files.
TASKS = (ONE, MANY)
# The rows of the tables: methods, and what they are called there.
NAMES = {
    "solid_angle": "`solid_angle`: uniform in solid angle",
    "published": "published: Peters and Dachsbacher 2019",
    "published, cube root": "the same, `powf` replaced by our cube root",
    "projected": "**`projected`: ours**",
}
# Gains below this are called none.
NO_GAIN = 1.2
MOST = 1e5  # of the axis of gains

plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "spherecap"})


def kernels() -> str:
    """Return a hash of what the kernels give and of how many operations they are recorded as.

    It changes where a formula changes, and not where code moves or a comment is written.
    """
    data = REPOSITORY / "tests" / "data"
    files = [(data / name).read_bytes() for name in ("hashes.txt", "counts.txt")]
    return hashlib.sha256(b"\0".join(files)).hexdigest()[:16]


def measure() -> dict:
    """Measure what `cargo bench` has not, and return all that the page is made of."""
    described = about("make speed", "1")  # before anything is written here
    measured = {"kernels": kernels(), "plugin_kibibytes": round(plugin_kibibytes(), 1)}
    for name in ("bench", "instructions"):
        found = read(OUTPUT, name)
        found["rows"] = [row for row in found["rows"] if row["task"] in TASKS and row["lane"] != "f64"]
        measured[name] = found
    maps = read(OUTPUT, "maps")
    measured["maps"] = {key: maps[key] for key in (*ORIGIN, "inverse", "deviation")}
    print("emitter sampling alone: half a minute", flush=True)
    measured["recorded"] = measure_recorded(2**20, 11) | described
    print("scenes at equal time: some minutes", flush=True)
    measured["scenes"] = described | {"rows": equal_time.scenes()}
    print("several lights at equal time: a minute or two", flush=True)
    measured["lights"] = described | {"rows": equal_time.lights()}
    return measured


def svg(drawing: plt.Figure) -> str:
    """Return a drawing as SVG, the same for the same drawing, on white: pages may be dark."""
    buffer = io.StringIO()
    drawing.savefig(buffer, format="svg", facecolor="white", metadata={"Date": None, "Creator": None})
    plt.close(drawing)
    return "\n".join(line.rstrip() for line in buffer.getvalue().splitlines()) + "\n"


def summary(measured: dict) -> plt.Figure:
    """Draw noise against time on the mix, and what scenes gain."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    marks = points(measured["bench"], measured["maps"]["deviation"], "deviation", "mix")
    for method, way, time, noise in marks:
        left.loglog(time, noise, WAYS[way][0], color=COLOURS[method], markersize=7, alpha=0.85)
    ticks = (5, 10, 20, 50, 100)
    left.set_xticks(ticks, [str(x) for x in ticks])
    left.minorticks_off()
    left.grid(visible=True, which="major", alpha=0.3)
    left.set(xlabel="nanoseconds per sample", ylabel="relative standard deviation")
    left.set_title("noise of one sample, nothing in the way", fontsize=10)
    for method in METHODS:
        left.plot([], [], "o", color=COLOURS[method], label=method)
    for mark, name in WAYS.values():
        left.plot([], [], mark, color="gray", label=name)
    drawing.legend(loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    gains(right, measured["scenes"]["rows"])
    return drawing


def factor(x: float) -> str:
    """Return a factor with three digits."""
    return f"{x:.2f}" if x < 10 else f"{float(f'{x:.3g}'):.0f}"


def gains(place: plt.Axes, found: list[dict]) -> None:
    """Draw a pair of bars for each scene."""
    values = rows_by(found, "scene", "variant")
    names = sorted({row["scene"] for row in found}, key=lambda name: values[name, "scalar_rgb"]["equal_time"])
    for number, (variant, colour) in enumerate(
        zip(equal_time.WIDTHS, ("tab:blue", "lightskyblue"), strict=True)
    ):
        at = [i + 0.2 - 0.4 * number for i in range(len(names))]
        ratios = [values[name, variant]["equal_time"] for name in names]
        place.barh(at, [min(x, MOST) - 1 for x in ratios], 0.4, left=1, color=colour, label=variant)
        for y, x in zip(at, ratios, strict=True):
            place.text(max(min(x, MOST), 1) * 1.1, y, factor(x), va="center", fontsize=6.5)
    place.set_xscale("log")
    place.minorticks_off()
    place.set_xlim(0.5, 10 * MOST)
    place.axvline(1, color="black", linewidth=0.8)
    place.set_yticks(range(len(names)), names, fontsize=8)
    place.set_title("how many times as long area takes to be as good", fontsize=10)
    place.legend(fontsize=8, loc="lower right", frameon=False)


def pictures(measured: dict) -> dict[str, str]:
    """Return the pictures by name."""
    bench, maps = measured["bench"], measured["maps"]
    return {
        "summary.svg": svg(summary(measured)),
        "noise.svg": svg(draw(bench, maps["deviation"], "deviation", "relative standard deviation")),
        "error.svg": svg(draw(bench, maps["inverse"], "rms", "error of the inverse")),
    }


def table(heads: list[str], lines: list[list[str]]) -> str:
    """Return a table in Markdown, its first column flush left."""
    return "\n".join(
        "| " + " | ".join(cells) + " |" for cells in (heads, ["---", *["--:"] * (len(heads) - 1)], *lines)
    )


def origin(found: dict, *commands: str) -> str:
    """Return the line that says where figures come from."""
    known = found | {"command": ", ".join(commands)}
    return "*" + "; ".join(f"{key}: {known[key]}" for key in ORIGIN if key in known) + "*"


def costs(measured: dict, column: str, file: str, digits: int) -> list[list[str]]:
    """Return cells for each method of `NAMES`: of each way in `WAYS`, a number, or nothing."""
    found = rows_by(measured[file]["rows"], "set", "lane", "method", "task")
    lanes = {lane for _, lane, *_ in found}

    def cell(method: str, lane: str, task: str) -> str:
        row = found.get(("mix", lane, method, task))
        return f"{row[column]:.{digits}f}" if row else ""

    return [[cell(method, lane, task) for lane, task in WAYS if lane in lanes] for method in NAMES]


def heads(measured: dict) -> list[str]:
    """Return the heads of those cells."""
    lanes = {row["lane"] for row in measured["bench"]["rows"]}
    names = {ONE: "one sample", MANY: "one of 16"}
    return [names[task] if lane == "f32" else f"{lane} packets" for lane, task in WAYS if lane in lanes]


def short_table(measured: dict) -> str:
    """Return time, noise and error of each method."""
    noise = rows_by(measured["maps"]["deviation"], "set", "method")
    error = rows_by(measured["maps"]["inverse"], "set", "method")
    lines = []
    for (method, name), times in zip(NAMES.items(), costs(measured, "nanoseconds", "bench", 1), strict=True):
        key = "mix", SAME_ERRORS.get(method, method)
        lines.append([name, *times, f"{noise[key]['deviation']:.1g}", f"{error[key]['rms']:.0e}"])
    return table(["nanoseconds", *heads(measured), "noise", "error"], lines)


def no_gain(measured: dict, where: str) -> str:
    """Say when it gains nothing, with the figures of the scenes.

    where: where those are, in words.
    """
    found = [row for row in measured["scenes"]["rows"] if row["equal_time"] < NO_GAIN]
    listed = ", ".join(f"{row['scene']} {row['equal_time']:.2f} ({row['variant']})" for row in found)
    here = f"Of the scenes {where} these gain less than {NO_GAIN} times: {listed}. " if found else ""
    (wall,) = (row for row in measured["lights"]["rows"] if row["scene"] == "wall")
    return (
        "**When it gains nothing.** It makes light samples better on diffuse surfaces, and nothing else. "
        "Where the noise has another cause, nothing is gained, and its own time is lost: where most light is "
        "indirect, on glossy surfaces, in fog, in the penumbrae of shadows, and where lights are small and "
        f"high above the surface, which solid angles sample as well. {here}Where the brightest lights are "
        f"behind walls, the choice among lights loses: there it takes {factor(1 / wall['all'])} times as "
        "long as `area` to be as good. `spherecap compare` says for your scene which of these it is."
    )


CAPTION = (
    "Nanoseconds per sample in f32. The mix is what the points of a room see of a light: all of it, or what "
    "the horizon leaves. *One sample* is drawn in one call with its preparation, *one of 16* with a "
    "sixteenth of one. *Noise* is the relative standard deviation of cosine over density, the noise of a "
    "diffuse surface with nothing in the way; *error* is what the exact inverse makes of a sample, against "
    "its random numbers."
)


def block(measured: dict) -> str:
    """Return the README's part."""
    return f"""{BEGIN}

![Noise against time of every method, and what scenes gain at equal time](docs/speed/summary.svg)

{short_table(measured)}

{CAPTION} On {measured["bench"]["machine"]}; [docs/speed.md](docs/speed.md) has the rest.

{no_gain(measured, "in the picture")}

{END}"""


def page(measured: dict) -> str:
    """Return docs/speed.md."""
    bench, instructions, recorded = (measured[name] for name in ("bench", "instructions", "recorded"))
    results = measured["scenes"]["rows"]
    size = counts()
    names = [key.partition(", ")[2] for key in size if key.startswith("projected, ")]
    techniques = ("solid_angle", "projected_bounded", "projected")
    scenes = rows_by(results, "scene", "variant")
    lines = []
    for name in sorted({name for name, _ in scenes}):
        found = [scenes[name, variant] for variant in equal_time.WIDTHS]
        cells = [[factor(row[key]) for key in ("error", "time", "equal_time")] for row in found]
        lines.append([name, *(cell for three in cells for cell in three)])
    median = equal_time.median_time(results, "scalar_rgb")
    listed = targets(bench, instructions, recorded["ratio"], median, measured["plugin_kibibytes"])
    methods = zip(NAMES.values(), costs(measured, "instructions", "instructions", 0), strict=True)
    maps = "`make bench`", "`cargo bench --bench maps`"
    widths = [f"{width} pixels wide in `{variant}`" for variant, width in equal_time.WIDTHS.items()]
    several = [[row["scene"], factor(row["one"]), factor(row["all"])] for row in measured["lights"]["rows"]]
    return TEMPLATE.substitute(
        kernels=f"`{measured['kernels']}`",
        short_table=short_table(measured),
        caption=CAPTION,
        no_gain=no_gain(measured, "below"),
        instructions=table(["instructions", *heads(measured)], [[name, *cells] for name, cells in methods]),
        operations=table(
            ["recorded operations", *(f"`{technique}`" for technique in techniques)],
            [[name, *(str(size[f"{technique}, {name}"]) for technique in techniques)] for name in names],
        ),
        sampler_bytes=size["sampler, bytes"],
        variant=recorded["variant"],
        ours_nanoseconds=f"{recorded['spherecap_nanoseconds']:.1f}",
        area_nanoseconds=f"{recorded['area_nanoseconds']:.1f}",
        alone=f"{recorded['ratio']:.2f}",
        scalar_time=f"{median:.2f}",
        llvm_time=f"{equal_time.median_time(results, 'llvm_ad_rgb'):.2f}",
        scenes=table(
            ["", "scalar: error", "time", "**equal time**", "LLVM: error", "time", "**equal time**"], lines
        ),
        spp=equal_time.SPP,
        left_out=equal_time.LEFT_OUT,
        widths=", ".join(widths),
        lights=table(["", "`one`", "`all`"], several),
        met=f"{sum(one.is_met for one in listed)} of {len(listed)}",
        targets=table(["", "at most", "measured", ""], rows(listed)),
        dropped=DROPPED,
        bench_origin=origin(bench, "`make bench`"),
        maps_origin=origin(bench, *maps),
        instructions_origin=origin(instructions, "`make instructions`"),
        recorded_origin=origin(recorded, "`make speed`"),
        scenes_origin=origin(measured["scenes"], "`make speed`"),
        lights_origin=origin(measured["lights"], "`make speed`"),
    )


def files(measured: dict) -> dict[Path, str]:
    """Return the text of every file that is made, by its place in the repository."""
    readme = (REPOSITORY / README).read_text()
    if readme.count(BEGIN) != 1 or readme.count(END) != 1:
        raise UserError(
            f"README.md must have one line '{BEGIN}' and one line '{END}': what is between is made"
        )
    before, _, rest = readme.partition(BEGIN)
    made = {PAGE: page(measured), README: before + block(measured) + rest.partition(END)[2]}
    return made | {PICTURES / name: text for name, text in pictures(measured).items()}


def main() -> None:
    """Measure, unless told not to, and write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--measure", action="store_true", help="measure the renders anew")
    try:
        place = REPOSITORY / MEASURED
        if parser.parse_args().measure:
            found = measure()
            place.parent.mkdir(exist_ok=True)
            place.write_text(json.dumps(found, indent=1) + "\n")
        for path, text in files(json.loads(place.read_text())).items():
            (REPOSITORY / path).write_text(text)
            print(f"written: {path}")
    except UserError as error:
        sys.exit(f"speed: {error}")


if __name__ == "__main__":
    main()
