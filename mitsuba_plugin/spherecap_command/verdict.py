"""Says in words what a comparison found, and why: from parts of the noise, each measured by itself.

A part is what is left out by a cheaper integrator. A path tracer that stops at the first surface has direct
light alone; one that takes no BSDF samples has the noise of light samples alone; ours with `lights` = `one`
chooses a light blindly, as the built-in emitter does. The differences of the variances are the parts. What
many light samples for each of the camera's leave is the picture's own: edges and detail in its pixels.
"""

import gc
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mitsuba as mi
import numpy as np

from spherecap_command.compare import RENDERS, Advance, Reference, Result, equal_time, relative, render
from spherecap_command.measure import error_scale
from spherecap_command.scene import BUILT_IN, OURS, ParsedScene

FIRST_SEED = 9000

# Renders that differ by less than this in brightness, or by less than so many standard deviations of their
# noise, are not said to differ. The noise of the built-in emitter has rare bright samples, and a
# reconstruction filter makes neighbours alike: both make the deviation look smaller than it is.
NOTICEABLE = 0.01
DEVIATIONS = 8

# Single precision gives samples of the same random numbers the same value to within this.
ROUNDING = 1e-3

PIXELS, LIGHTS, CHOICE = "edges in pixels", "light sampling", "choice among lights"
BSDF, INDIRECT = "BSDF sampling", "indirect light"

# How many times as many light samples as in the scene tell the noise of the picture itself.
MANY = 16


@dataclass(frozen=True)
class Parts:
    """Where the noise comes from: parts of the variance, for the built-in emitter and for ours.

    All are relative to the variance of the built-in emitter. front: what `hemispheres` = `front` would leave
    of it in all; nothing where it changes nothing, or changes the image.
    """

    shares: dict[str, tuple[float, float]]
    front: float | None


def _cheaper(scene: ParsedScene) -> dict[str, dict] | None:
    """Return integrators that have direct light alone, light samples alone, and many light samples.

    The first two are left out where the scene's own has no more; nothing is returned for integrators that
    cannot be taken apart.
    """
    props = scene.integrator
    hide = {"hide_emitters": props.get("hide_emitters", False)}
    kind = props.plugin_name()
    samples = props.get("shading_samples", 1)
    light_samples = props.get("emitter_samples", samples) if kind == "direct" else 1
    if kind not in ("path", "direct") or light_samples == 0:
        return None
    lights = {"type": "direct", "emitter_samples": light_samples, "bsdf_samples": 0, **hide}
    cheaper = {"many": {**lights, "emitter_samples": MANY * light_samples}}
    if kind == "path" or props.get("bsdf_samples", samples) > 0:
        cheaper["lights"] = lights
    if kind == "path" and not 0 <= props.get("max_depth", -1) <= 2:
        cheaper["direct"] = {"type": "path", "max_depth": 2, **hide}
    return cheaper


def renders_of_pieces(scene: ParsedScene) -> int:
    """Return how many renders `measure_pieces` may take."""
    cheaper = _cheaper(scene)
    if cheaper is None:
        return 0
    return RENDERS * (2 * len(cheaper) + (len(scene.convertible) > 1))


def measure_pieces(
    scene: ParsedScene, load: Callable[..., "mi.Scene"], area: Result, ours: Result, advance: Advance
) -> dict[str, Result] | None:
    """Render what `divide` needs beside two results: the same by cheaper integrators, and other parameters.

    load: returns the scene with an emitter, and with parameters of ours.
    """
    cheaper = _cheaper(scene)
    if cheaper is None or _same(area, ours):
        return None
    pieces = {f"{BUILT_IN} all": area, f"{OURS} all": ours}
    spp = area.spp

    def measure(name: str, technique: str, integrator: str = "all", **own: str) -> None:
        loaded = load(technique, **own)
        made = None if integrator == "all" else mi.load_dict(cheaper[integrator])
        pieces[name] = Result(technique, spp)
        for seed in range(FIRST_SEED, FIRST_SEED + RENDERS):
            pieces[name].add(render(loaded, spp, seed, made))
            advance(spp)
        del loaded
        gc.collect()

    for integrator in cheaper:
        measure(f"{OURS} {integrator}", OURS, integrator)
        if integrator != "many":
            measure(f"{BUILT_IN} {integrator}", BUILT_IN, integrator)
    if len(scene.convertible) > 1:
        measure("blind", OURS, "lights" if "lights" in cheaper else "all", lights="one")
    if _both_sides(load):
        measure("front", OURS, hemispheres="front")
    return pieces


def divide(pieces: dict[str, Result], truth: Reference) -> Parts:
    """Return the parts of the noise."""
    noise = {name: relative(result.variance, truth) for name, result in pieces.items()}
    for technique in (BUILT_IN, OURS):  # the scene's own integrator, if there was no cheaper one
        noise.setdefault(f"{technique} direct", noise[f"{technique} all"])
        noise.setdefault(f"{technique} lights", noise[f"{technique} direct"])
    # The variance of n light samples for each of the camera's is that of the picture and an n-th of theirs.
    picture = max((MANY * noise[f"{OURS} many"] - noise[f"{OURS} lights"]) / (MANY - 1), 0.0)
    columns = []
    for technique in (BUILT_IN, OURS):
        whole = noise[f"{technique} all"]
        direct = min(noise[f"{technique} direct"], whole)
        # Where BSDF samples help more than they harm, light samples alone are the noisier.
        lights = min(noise[f"{technique} lights"], direct)
        pixels = min(picture, lights)
        columns.append(
            {
                PIXELS: pixels,
                LIGHTS: lights - pixels,
                CHOICE: 0.0,
                BSDF: direct - lights,
                INDIRECT: whole - direct,
            }
        )
    area, ours = columns
    if "blind" in noise:
        area[CHOICE] = min(max(noise["blind"] - noise[f"{OURS} lights"], 0.0), area[LIGHTS])
        area[LIGHTS] -= area[CHOICE]
    whole = noise[f"{BUILT_IN} all"] or 1.0
    front = None
    # Clearly so, as rare bright samples make the noise itself uncertain.
    helps = "front" in noise and noise["front"] < 0.75 * noise[f"{OURS} all"]
    if helps and not _brighter(pieces["front"], pieces[f"{OURS} all"]):
        front = noise["front"] / whole
    return Parts({name: (area[name] / whole, ours[name] / whole) for name in area}, front)


def _both_sides(load: Callable[..., "mi.Scene"]) -> bool:
    """Does a light of ours sample both sides of surfaces because there are surfaces with two sides?"""
    scene = load(OURS)  # lives longer than what is asked: emitters do not keep their shapes
    return any("hemispheres = both (auto)" in str(emitter) for emitter in scene.emitters())


def _brighter(one: Result, other: Result) -> float:
    """Return by how much one is brighter on the average, or 0 if that is noise or cannot be seen."""
    deviation = sum(np.sum(each.variance / each.renders) for each in (one, other)) ** 0.5
    difference, total = np.sum(one.mean - other.mean), np.sum(other.mean)
    told = abs(difference) > max(DEVIATIONS * deviation, NOTICEABLE * total) and total > 0
    return float(difference / total) if told else 0.0


def _same(area: Result, ours: Result) -> bool:
    """Are the images the same, sample by sample?"""
    return bool(np.all(np.abs(area.image - ours.image) <= ROUNDING * error_scale(area.mean)))


def at_equal_samples(area: Result, ours: Result, truth: Reference) -> str:
    """Return a first answer; what times tell comes later, as the first are mostly overhead."""
    errors = [one.rmse(truth) for one in (area, ours)]
    ratio = errors[0] / errors[1] if errors[1] > 0 else np.inf
    return f"the error of {BUILT_IN} is {ratio:.3g} times that of {OURS}, at equal samples"


def headline(area: Result, ours: Result, truth: Reference) -> str:
    """Return who is better, in one sentence."""
    ratio = equal_time(area, ours, truth)
    if area.rmse(truth) == ours.rmse(truth) == 0:
        return "Neither has any noise."
    if not np.isfinite(ratio):
        return f"{OURS} has no noise at all, {BUILT_IN} has."
    samples = (area.rmse(truth) / ours.rmse(truth)) ** 2
    if ratio >= 1.1:
        many = f", and {samples:.3g} times as many samples" if samples >= 1.1 else ""
        return f"{BUILT_IN} takes {ratio:.3g} times as long as {OURS} to be as good{many}."
    if ratio <= 0.9:
        many = f", and {1 / samples:.3g} times as many samples" if samples <= 0.9 else ""
        return f"{OURS} takes {1 / ratio:.3g} times as long as {BUILT_IN} to be as good{many}."
    return f"Neither is better: in equal time {BUILT_IN} and {OURS} are equally good, to within 10 %."


def verdict(
    scene: ParsedScene, results: Sequence[Result], truth: Reference, parts: Parts | None
) -> list[str]:
    """Return sentences, the headline first: what is said of the most samples."""
    area, ours = results[-2:]
    integrator = scene.integrator.plugin_name()
    if _same(area, ours):
        return [
            "Both give the same images, sample by sample: it makes no difference which emitter lights have. "
            f"Either the integrator `{integrator}` does not ask lights for samples, or the camera sees "
            "nothing that these lights light."
        ]
    if more := _brighter(area, ours):
        return [
            f"{BUILT_IN} is {100 * abs(more):.3g} % {'brighter' if more > 0 else 'darker'} than {OURS}, and "
            f"that is not noise, so one of them is wrong: {BUILT_IN} is for lights that are seen smaller "
            f'than a degree, and {OURS} where a scene says hemispheres="front" but shows backs of surfaces.'
        ]
    said = [headline(area, ours, truth)]
    if parts is not None:
        said += _explanation(parts, len(scene.refused))
    elif integrator not in ("path", "direct"):
        said.append(
            f"Where the noise comes from can be measured for the integrators `path` and `direct` alone, and "
            f"this scene has `{integrator}`."
        )
    return said


def _explanation(parts: Parts, others: int) -> list[str]:
    shares = parts.shares
    theirs = shares[LIGHTS][0] + shares[CHOICE][0]
    left = shares[LIGHTS][1] + shares[CHOICE][1]
    choice = (
        f" ({_percent(shares[CHOICE][0])} from the choice among lights)" if shares[CHOICE][0] > 0.01 else ""
    )
    said = [
        f"{_percent(theirs)} of the noise (variance) of {BUILT_IN} comes from light samples where the camera "
        f"looks{choice}; {OURS} leaves {_percent(left)}."
    ]
    if shares[INDIRECT][0] >= 0.01:
        indirect = [_percent(share) for share in shares[INDIRECT]]
        said.append(f"Indirect light makes {indirect[0]} of it; {OURS} leaves {indirect[1]}.")
    total = sum(ours for _, ours in shares.values())
    largest = max(shares, key=lambda name: shares[name][1])
    reasons = {
        PIXELS: "the picture's own: edges and detail in its pixels, which only more samples make smooth",
        LIGHTS: "light sampling: shadows, surfaces that are not diffuse"
        + (f", and the lights that are no {OURS}" if others else ""),
        BSDF: "BSDF sampling: the integrator's rays that follow surfaces' BSDFs, and find lights by chance",
        INDIRECT: "indirect light, by way of other surfaces, mirrors and glass: which of them a path visits "
        "is chance with any light",
    }
    if total > 0.05:  # else there is little to explain
        said.append(
            f"Of the noise that {OURS} has, {_percent(shares[largest][1] / total)} is {reasons[largest]}."
        )
    if parts.front is not None:
        said.append(
            "Surfaces with two sides are in the way: because of them both sides of all surfaces are sampled. "
            f'With hemispheres="front" {OURS} would have {_percent(parts.front)} of the noise of {BUILT_IN}, '
            f"instead of {_percent(total)}: that is right if nobody sees the backs of surfaces lit."
        )
    return said


def _percent(share: float) -> str:
    return "less than 1 %" if share < 0.01 else f"{100 * share:.0f} %"


def parts_table(parts: Parts) -> list[tuple[str, str, str]]:
    """Return the parts as rows of a table, with a heading; those that nobody has are left out."""
    rows = [("of the noise (variance)", BUILT_IN, OURS)]
    for name, (area, ours) in parts.shares.items():
        if max(area, ours) > 0:
            rows.append((name, f"{100 * area:.1f} %", f"{100 * ours:.1f} %"))
    total = sum(ours for _, ours in parts.shares.values())
    return [*rows, ("all", "100.0 %", f"{100 * total:.1f} %")]
