"""`spherecap compare`, `spherecap convert` and `spherecap info`; also as `python -m spherecap_command`."""

import argparse
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from spherecap_command import info
from spherecap_command.errors import UserError

try:
    import spherecap
except ImportError as error:  # not built, or for another Mitsuba: the message says so
    spherecap, UNUSABLE = None, str(error)


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
        print("spherecap: stopped; nothing was written", file=sys.stderr)
        return 130


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="spherecap", description="Compare, convert and inspect: sphere lights in Mitsuba 3."
    )
    commands = parser.add_subparsers(dest="command", required=True)

    compare = commands.add_parser("compare", help="render a scene with `area` and with `spherecap`")
    compare.add_argument("scene", type=Path, metavar="SCENE.xml")
    compare.add_argument(
        "--spp",
        type=_count,
        nargs="+",
        default=[1, 4, 16, 64],
        metavar="N",
        help="sample counts per pixel (default: 1 4 16 64)",
    )
    compare.add_argument(
        "--reference",
        type=_count,
        default=512,
        metavar="N",
        help="samples per pixel of the reference, for each emitter (default: %(default)s)",
    )
    compare.add_argument("--variant", default="scalar_rgb", help="variant of Mitsuba (default: %(default)s)")
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


def _count(text: str) -> int:
    try:
        count = int(text)
    except ValueError:
        count = 0
    if count < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a sample count: give a whole number from 1")
    return count


def _parameter(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"'{text}' is not of the form NAME=VALUE")
    return name, value


def _compare(chosen: argparse.Namespace) -> int:
    from tqdm import tqdm

    from spherecap_command.compare import (
        compare,
        rendered_reference,
        samples_taken,
        samples_to_render,
        table,
    )
    from spherecap_command.report import write_report
    from spherecap_command.scene import BUILT_IN, ParsedScene, use_variant

    output = chosen.output or Path(f"{chosen.scene.stem}-compare")
    if output.exists():  # before anything slow
        raise UserError(f"'{output}' exists: remove it, or choose another folder with --output")
    use_variant(chosen.variant)
    scene = ParsedScene(chosen.scene, dict(chosen.parameters))
    if not scene.convertible:
        raise UserError(scene.explain_no_lights())
    for light in scene.refused:
        print(f"stays as it is: {light.where}: {light.refusal}")
    counts = sorted({samples_taken(scene.load(BUILT_IN), spp) for spp in chosen.spp})
    with tqdm(total=samples_to_render(counts, chosen.reference), unit=" spp") as bar:
        bar.set_description("reference")
        truth = rendered_reference(scene.load, chosen.reference, bar.update)
        bar.set_description("compare")
        results = compare(scene.load, counts, truth, bar.update)
    height, width, _ = truth.image.shape
    count = len(scene.convertible)
    lights = f"{count} sphere light{'s' if count > 1 else ''}"
    details = f"{lights}, {width} x {height} pixels, {chosen.variant}, spherecap {info.version('spherecap')}"
    print(f"{chosen.scene}: {details}\nreference: {truth.origin}, relative RMSE {truth.noise**0.5:.2g}")
    print(table(results))
    page = _write_folder(
        output, lambda folder: write_report(folder, chosen.scene.name, details, results, truth)
    )
    print(f"page: {page}")
    return 0


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
    print(f"for the mitsuba command: -a {spherecap.PLUGIN.parent.parent}")
    print("variants:")
    for variant, problem in info.usable_variants():
        print(f"  {variant:<32} {problem or 'loads the emitter'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
