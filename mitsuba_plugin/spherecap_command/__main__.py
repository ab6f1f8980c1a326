"""`spherecap compare`, `spherecap convert` and `spherecap info`; also as `python -m spherecap_command`."""

import argparse
import re
import shlex
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from spherecap_command import info
from spherecap_command.errors import UserError

if TYPE_CHECKING:
    import mitsuba as mi

    from spherecap_command.compare import Reference, Result
    from spherecap_command.scene import ParsedScene

try:
    import spherecap
except ImportError as error:  # not built, or for another Mitsuba: the message says so
    spherecap, UNUSABLE = None, str(error)


# What `compare` does where it is not told: minutes, the most pixels of the longer side, samples per pixel.
# Without an end in time there is no limit to the size, and the reference has so many samples.
MINUTES = 2.0
SIZE = 400
COUNTS = (1, 4, 16, 64)
REFERENCE = 512


def main(words: list[str] | None = None) -> int:
    """Run the command, and turn mistakes that the user can put right into a sentence."""
    chosen = _arguments(words)
    try:
        if chosen.command == "info":
            return _info()
        if spherecap is None:
            raise UserError(UNUSABLE)
        return _compare(chosen) if chosen.command == "compare" else _convert(chosen)
    except UserError as error:
        print(f"spherecap: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("spherecap: stopped; nothing more was written", file=sys.stderr)
        return 130


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="spherecap", description="Compare, convert and inspect: sphere lights in Mitsuba 3."
    )
    parser.add_argument("--version", action="version", version=_version())
    commands = parser.add_subparsers(dest="command", required=True)

    compare = commands.add_parser("compare", help="render a scene with `area` and with `spherecap`")
    compare.add_argument("scene", type=Path, metavar="SCENE.xml")
    compare.add_argument(
        "--minutes",
        type=_minutes,
        metavar="N",
        help=f"how long it may take (default: {MINUTES:g}; without an end with --spp or --reference)",
    )
    compare.add_argument(
        "--size",
        type=_count,
        metavar="N",
        help=f"pixels of the image's longer side (default: the scene's, and {SIZE} at most within --minutes)",
    )
    compare.add_argument(
        "--spp",
        type=_count,
        nargs="+",
        metavar="N",
        help=f"sample counts per pixel (default: {' '.join(map(str, COUNTS))}, as time allows)",
    )
    compare.add_argument(
        "--reference",
        type=_count,
        metavar="N",
        help="samples per pixel of the reference, for each emitter (default: all that is rendered within "
        f"--minutes; {REFERENCE} with --spp)",
    )
    compare.add_argument(
        "--sensor",
        metavar="ID",
        help="the id or the number, from 1, of the sensor, or all: one after the other (default: the first)",
    )
    compare.add_argument(
        "--variant", help="variant of Mitsuba (default: llvm_ad_rgb where LLVM is installed, else scalar_rgb)"
    )
    compare.add_argument(
        "--output", type=Path, metavar="FOLDER", help="a new folder (default: the scene's name with -compare)"
    )

    convert = commands.add_parser("convert", help="write a scene with its sphere lights as `spherecap`")
    convert.add_argument("scene", type=Path, metavar="IN.xml")
    convert.add_argument("result", type=Path, metavar="OUT.xml")
    for with_scene in (compare, convert):
        with_scene.add_argument(
            "-D",
            type=_parameter,
            action="append",
            default=[],
            dest="parameters",
            metavar="NAME=VALUE",
            help="value of a parameter $NAME of the scene",
        )

    commands.add_parser("info", help="print versions, variants and CPU features")
    return parser.parse_args(words)


def _version() -> str:
    built_for = f", for Mitsuba {spherecap.BUILT_FOR}" if spherecap else ""
    return f"spherecap {info.version('spherecap')}{built_for}"


def _count(text: str) -> int:
    try:
        count = int(text)
    except ValueError:
        count = 0
    if count < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a count: give a whole number from 1")
    return count


def _minutes(text: str) -> float:
    try:
        minutes = float(text)
    except ValueError:
        minutes = 0.0
    if not 0 < minutes < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not a time: give a number of minutes above 0")
    return minutes


def _parameter(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"'{text}' is not of the form NAME=VALUE")
    return name, value


def _compare(chosen: argparse.Namespace) -> int:
    from spherecap_command.compare import samples_taken, table, text_table
    from spherecap_command.report import write_report
    from spherecap_command.scene import BUILT_IN, ParsedScene, best_variant, quiet, resize, use_variant
    from spherecap_command.verdict import divide, parts_table, verdict

    output = chosen.output or Path(f"{chosen.scene.stem}-compare")
    if output.exists():  # before anything slow
        raise UserError(f"'{output}' exists: remove it, or choose another folder with --output")
    endless = chosen.minutes is None and bool(chosen.spp or chosen.reference)
    variant = chosen.variant or best_variant()
    use_variant(variant)
    scene = ParsedScene(chosen.scene, dict(chosen.parameters))
    if not scene.convertible:
        raise UserError(scene.explain_no_lights())
    scene.must_be_renderable()
    sensors = _sensors(chosen.scene, scene.sensors, chosen.sensor)
    for light in scene.refused:
        print(f"stays as it is: {light.where}: {light.refusal}")
    reference = chosen.reference or (REFERENCE if endless else None)
    seconds = None if endless else 60 * (chosen.minutes or MINUTES) / len(sensors)
    for sensor, which, folder in sensors:

        def load(emitter: str, sensor: int = sensor, **own: str) -> "mi.Scene":
            loaded = scene.load(emitter, sensor, **own)
            resize(loaded, chosen.size, None if endless else SIZE)
            return loaded

        once = load(BUILT_IN)  # Mitsuba's warnings are heard here.
        width, height = once.sensors()[0].film().crop_size()
        counts = sorted({samples_taken(once, spp) for spp in chosen.spp or COUNTS})
        del once
        count = len(scene.convertible)
        lights = f"{count} sphere light{'s' if count > 1 else ''}"
        details = (
            f"{lights}, {width} x {height} pixels, {variant}, spherecap {info.version('spherecap')}{which}"
        )
        print(f"{chosen.scene}: {details}")
        with quiet():
            results, pieces, truth, is_stopped = _measured(scene, load, counts, reference, seconds)
        parts = divide(pieces, truth) if pieces else None
        sentences = verdict(scene, results, truth, parts)
        print(f"reference: {truth.origin}, relative RMSE {truth.noise**0.5:.2g}")
        print(table(results, truth))
        if parts:
            print(text_table(parts_table(parts)))
        print("\n".join(sentences))
        said = (chosen.scene.name, details, sentences, parts, results, truth)
        page = _write_folder(output / folder, lambda place, said=said: write_report(place, *said))
        print(f"page: {page}", flush=True)
        if is_stopped:
            break
    return 0


def _sensors(scene: Path, ids: list[str], wanted: str | None) -> list[tuple[int, str, str]]:
    """Return the sensors that are wanted: their indices, words on which it is, and folders for their pages.

    If there is one, its words and its folder are empty: the page is in the folder of the comparison itself.
    """
    names = [str(number) for number in range(1, len(ids) + 1)]
    if wanted == "all" and wanted not in ids:
        chosen = range(len(ids))
    elif wanted is None:
        chosen = range(1)
    elif wanted in ids or wanted in names:
        chosen = [ids.index(wanted) if wanted in ids else names.index(wanted)]
    else:
        there = ", ".join(f"{n} ({i})" if i else n for n, i in zip(names, ids, strict=True))
        raise UserError(f"'{scene}' has no sensor '{wanted}'; choose one of: {there}; or all")
    if len(ids) == 1:
        return [(0, "", "")]
    found = []
    for index in chosen:
        name = f" '{ids[index]}'" if ids[index] else ""
        # Ids may have characters that file names may not.
        folder = re.sub(r"[^\w-]", "_", f"{names[index]}-{ids[index]}" if ids[index] else names[index])
        words = f", sensor {names[index]}{name} of {len(ids)} (--sensor chooses)"
        found.append((index, words, folder if len(chosen) > 1 else ""))
    return found


def _measured(
    scene: "ParsedScene",
    load: Callable[..., "mi.Scene"],
    counts: list[int],
    reference: int | None,
    seconds: float | None,
) -> tuple[list["Result"], dict[str, "Result"] | None, "Reference", bool]:
    """Render with a progress bar: results, what the noise is made of, the reference, whether it was stopped.

    reference: its samples per pixel; the mean of all that is rendered if it is None. seconds: how long it may
    take; the fewest samples are measured in any case.
    """
    from tqdm import tqdm

    from spherecap_command.compare import (
        Comparison,
        mean_of_all,
        pairs,
        rendered_reference,
        samples_to_render,
    )
    from spherecap_command.verdict import at_equal_samples, measure_pieces, renders_of_pieces

    begin = time.perf_counter()
    deadline = begin + (seconds or float("inf"))
    # Enough for rare bright samples to count, and no more.
    apart = max((spp for spp in counts if spp <= 16), default=counts[0])
    planned = samples_to_render(counts, reference or 0) + apart * renders_of_pieces(scene)
    done = 0
    pieces, is_stopped = None, False
    form = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}<{remaining}"
    with tqdm(total=1.0, desc="comparing", bar_format=form) as bar:

        def advance(samples: int) -> None:
            nonlocal done
            done += samples
            share = (time.perf_counter() - begin) / seconds if seconds else done / planned
            bar.update(max(min(share, 1) - bar.n, 0))

        comparison = Comparison(load, advance)
        results = comparison.results
        try:
            for spp in counts:
                comparison.measure(spp, deadline if seconds is None else begin + seconds / 2)
                if spp == counts[0]:
                    bar.write(f"so far, with {spp} spp: {at_equal_samples(*results, mean_of_all(results))}")
            for area, ours in reversed(pairs(results)):
                expected = 2 * ours.seconds * renders_of_pieces(scene)
                if area.spp <= apart and time.perf_counter() + expected < deadline:
                    pieces = measure_pieces(scene, load, area, ours, advance)
                    break
            if seconds:
                comparison.repeat(deadline)
            if reference:
                return results, pieces, rendered_reference(load, reference, advance), False
        except KeyboardInterrupt:
            if not results:
                raise
            is_stopped = True
            bar.write("stopped: this is what was found so far")
        finally:
            bar.update(1 - bar.n)
    return results, pieces, mean_of_all(results), is_stopped


def _write_folder(output: Path, write: Callable[[Path], Path]) -> Path:
    """Have a page written into a folder that appears when it is complete; return the page."""
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        unfinished = Path(tempfile.mkdtemp(prefix=f".{output.name}-", dir=output.parent))
        try:
            page = write(unfinished)
            unfinished.chmod(0o755)
            unfinished.rename(output)
        finally:
            shutil.rmtree(unfinished, ignore_errors=True)
    except OSError as error:
        raise UserError(f"'{output}' cannot be written: {error.strerror or error}") from error
    return output / page.name


def _convert(chosen: argparse.Namespace) -> int:
    from spherecap_command.convert import convert, write
    from spherecap_command.scene import ParsedScene, use_variant

    use_variant("scalar_rgb")  # which one does not matter: they read the same scenes
    parameters = dict(chosen.parameters)
    scene = ParsedScene(chosen.scene, parameters)
    conversion = convert(scene, chosen.result, parameters)
    write(conversion)
    for light in conversion.changed:
        print(f"spherecap: {light.where}")
    for light in scene.refused:
        print(f"stays as it is: {light.where}: {light.refusal}")
    for path in conversion.files:
        print(f"written: {path}")
    given = [word for name, value in parameters.items() for word in ("-D", f"{name}={value}")]
    # A variant that needs no LLVM: the command takes any that it finds in the system, too old or not.
    package = str(spherecap.PLUGIN.parent.parent)
    command = shlex.join(["mitsuba", "-m", "scalar_rgb", "-a", package, *given, str(chosen.result)])
    print(f"to render it: {command}\nor in Python: import spherecap, before mitsuba")
    return 0


def _info() -> int:
    name, features = info.processor()
    for package in ("spherecap", "mitsuba", "drjit", "karellen-llvm-core"):
        print(f"{package} {info.version(package)}")
    needed = [f"{feature} {'yes' if feature in features else 'MISSING'}" for feature in info.NEEDED]
    print(f"processor: {name}\nneeded by Mitsuba: {', '.join(needed)}")
    wider = sorted(feature for feature in features if feature.startswith("avx512"))
    print(f"also there: {', '.join(wider) or 'no AVX-512'}")
    if spherecap is None:
        raise UserError(UNUSABLE)
    print(f"plugin: {spherecap.PLUGIN}, built for Mitsuba {spherecap.BUILT_FOR}")
    print(f"for the mitsuba command: -a {shlex.quote(str(spherecap.PLUGIN.parent.parent))}")
    print("variants:")
    for variant, problem in info.usable_variants():
        print(f"  {variant:<32} {problem or 'loads the emitter'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
