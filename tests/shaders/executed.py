"""The shaders, run by a Vulkan device and held to the library over 2^20 inputs, half of them hard.

`make test-shaders` runs it, on the inputs of tests/source.rs and on the reference rows.
"""

import csv
import pathlib
import subprocess

import cost
import dxc
import numpy as np
import picture
import pytest
from devices import Vulkan, compiled, run_wgsl
from mains import GLSL, INPUTS, OUTPUTS, main

ROOT = pathlib.Path(__file__).parents[2]
RECORDS = ROOT / "target/tmp/source"
FORM, NORMAL, DEFENSIVE, U = 0, slice(1, 4), 8, slice(9, 11)
CENTRE, RADIUS, DIRECTION, STRENGTH = slice(4, 7), 7, slice(11, 14), 14
IS_SAMPLED, PROJECTED_SOLID_ANGLE, TO, COSINE = 0, 2, slice(3, 6), 10
PDF, PROJECTED_PDF, PDF_ON_SPHERE, IMPORTANCE = 11, 12, 14, 15
HLSL = ["-D", "-e", "main"]


@pytest.fixture(scope="session")
def device():
    """Run everything on this one."""
    device = Vulkan()
    print("Vulkan device:", device.name)
    return device


def run(device, language, records, folder):
    """Give what a file's functions give for records."""
    if language == "wgsl":
        return run_wgsl(main(language), records, OUTPUTS)
    if language == "hlsl by DXC":
        return device.run(dxc.compiled(main("hlsl")), records, OUTPUTS)
    # What the file for Slang uses is HLSL, too.
    spirv = compiled(main(language), [] if language == "glsl" else HLSL, folder, language)
    return device.run(spirv, records, OUTPUTS)


def relative(found, expected):
    """Give errors as parts of what is expected."""
    return np.abs(found / expected.astype(np.float64) - 1)


@pytest.mark.parametrize("language", ["glsl", "hlsl", "hlsl by DXC", "slang", "wgsl"])
def test_shaders_agree_with_the_library(device, language, tmp_path):
    """Over the records of tests/source.rs."""
    records = np.fromfile(RECORDS / "records", np.float32).reshape(-1, INPUTS)
    expected = np.fromfile(RECORDS / "expected", np.float32).reshape(-1, OUTPUTS)
    found = run(device, language, records, tmp_path)
    assert len(found) == 1 << 20
    assert np.isfinite(found).all()

    # A normal that has to be normalised first is another one by a rounding, which a sphere that has all but
    # set shows.
    normal = records[:, NORMAL].astype(np.float64)
    with np.errstate(invalid="ignore"):
        is_unit = np.abs(np.linalg.norm(normal, axis=1) - 1) < 1e-6
    is_refused = found[:, IS_SAMPLED] != expected[:, IS_SAMPLED]
    cosine = np.maximum(np.abs(found[:, COSINE]), np.abs(expected[:, COSINE]))
    assert not (is_refused & is_unit & (cosine > 2e-7)).any()
    assert is_refused.sum() < 100, is_refused.sum()

    is_sampled = (found[:, IS_SAMPLED] == 1) & (expected[:, IS_SAMPLED] == 1)
    lengths = np.linalg.norm(found[is_sampled, TO].astype(np.float64), axis=1)
    print(f"{language}: {is_refused.sum()} refused otherwise, lengths off by {np.abs(lengths - 1).max():.1e}")
    assert np.abs(lengths - 1).max() < 1e-6

    is_hard = np.arange(len(records)) % 2 == 1
    with np.errstate(invalid="ignore"):
        towards = np.abs((normal * records[:, DIRECTION]).sum(axis=1))
    for form, name in enumerate(("surface", "front", "both")):
        is_form = is_sampled & is_unit & (records[:, FORM] == form)
        is_pure = is_form & ((form == 0) | ~(records[:, DEFENSIVE] > 0))
        for hard in False, True:
            # Of samples the density over the cosine: the cosine of another sample is another. A direction's
            # cosine is known to the rounding of a unit vector, and so is its side of the horizon.
            chosen = is_pure & (is_hard == hard) & (expected[:, PROJECTED_PDF] > 0)
            of_samples = relative(found[chosen, PROJECTED_PDF], expected[chosen, PROJECTED_PDF]).max()
            chosen = is_form & (is_hard == hard) & (expected[:, PDF_ON_SPHERE] > 0) & (towards > 2e-7)
            errors = relative(found[chosen, PDF_ON_SPHERE], expected[chosen, PDF_ON_SPHERE])
            of_directions = (errors * towards[chosen]).max()
            kind = "hard" if hard else "ordinary"
            print(f"{language}, {name}, {kind}: samples' densities are off by {of_samples:.1e},")
            print(f"    those of directions by {of_directions:.1e}")
            # Of `both` the share of a side, a difference of two polynomials, adds its roundings.
            assert of_samples < (5e-6 if hard else 3e-6 if form == 2 else 2e-6)
            assert of_directions < 5e-6
        # Of what a light of that size could give: what all but set gives next to nothing.
        centre, radius = records[:, CENTRE].astype(np.float64), records[:, RADIUS].astype(np.float64)
        with np.errstate(all="ignore"):
            most = records[:, STRENGTH] * radius**2 / (centre**2).sum(axis=1)
            errors = np.abs(found[:, IMPORTANCE] - expected[:, IMPORTANCE].astype(np.float64)) / most
        of_importances = errors[
            (records[:, FORM] == form) & is_unit & (expected[:, IMPORTANCE] > 1e-37)
        ].max()
        print(f"{language}, {name}: importances are off by {of_importances:.1e} of the most")
        assert of_importances < 2e-6


@pytest.mark.parametrize("language", ["glsl", "wgsl"])
def test_projected_solid_angles_are_those_of_the_reference(device, language, tmp_path):
    """Over the rows of tests/data/caps.csv."""
    rows = list(csv.DictReader((ROOT / "tests/data/caps.csv").open()))
    assert len(rows) == 400
    records = np.zeros((len(rows), INPUTS), np.float32)
    records[:, FORM] = 1
    for record, row in zip(records, rows, strict=True):
        record[1:8] = [float.fromhex(row[name]) for name in ("nx", "ny", "nz", "cx", "cy", "cz", "r")]
    records[:, U] = 0.5
    found = run(device, language, records, tmp_path)
    expected = np.array([float(row["projected_solid_angle"]) for row in rows])
    is_visible = expected > 0
    assert (found[~is_visible, IS_SAMPLED] == 0).all()
    errors = relative(found[is_visible, PROJECTED_SOLID_ANGLE], expected[is_visible])
    print(f"{language}: projected solid angles of {len(errors)} rows are off by {errors.max():.1e}")
    assert errors.max() < 2e-6


PUBLISHED = """
    uint i = 15u * gl_GlobalInvocationID.x, o = 5u * gl_GlobalInvocationID.x;
    vec3 normal = vec3(records[i + 1u], records[i + 2u], records[i + 3u]);
    vec3 centre = vec3(records[i + 4u], records[i + 5u], records[i + 6u]);
    published_sample light = published_sample_once(
        normal, centre, records[i + 7u], records[i + 9u], records[i + 10u]);
    results[o] = light.direction.x;
    results[o + 1u] = light.direction.y;
    results[o + 2u] = light.direction.z;
    results[o + 3u] = light.pdf;
    results[o + 4u] = light.projected_pdf;
"""


def check_page(name, numbers, slack):
    """Hold numbers to a row of a table of docs/source.md: a tenth off at most, and the slack."""
    lines = (ROOT / "docs/source.md").read_text().splitlines()
    rows = [line.split("|")[2:] for line in lines if line.startswith(f"| {name} |")]
    assert len(rows) == 1, name
    for number, stated in zip(numbers, rows[0], strict=False):
        assert abs(number - float(stated.replace(",", ""))) <= 0.1 * number + slack, name


def test_the_published_method_has_the_faults_that_the_page_counts(device, tmp_path):
    """Over the records of tests/source.rs, of lights that give something to a surface."""
    records = np.fromfile(RECORDS / "records", np.float32).reshape(-1, INPUTS)
    expected = np.fromfile(RECORDS / "expected", np.float32).reshape(-1, OUTPUTS)
    source = GLSL.format(define="", file=(ROOT / "tests/shaders/published.glsl").read_text(), body=PUBLISHED)
    found = device.run(compiled(source, [], tmp_path, "published"), records, 5)
    ours = run(device, "glsl", records, tmp_path)
    is_hard = np.arange(len(records)) % 2 == 1
    with np.errstate(invalid="ignore"):
        is_inside = ((records[:, U] > 0) & (records[:, U] < 1)).all(axis=1)
    is_fair = (records[:, FORM] == 0) & (expected[:, IS_SAMPLED] == 1) & is_inside
    # The density of the part whose centre is below the horizon is not meant to be uniform.
    with np.errstate(all="ignore"):
        height = (records[:, NORMAL].astype(np.float64) * records[:, CENTRE]).sum(axis=1)
    for hard in False, True:
        for above in True, False:
            with np.errstate(invalid="ignore"):
                is_side = (height > 0) == above
            is_chosen = is_fair & (is_hard == hard) & is_side
            samples = found[is_chosen]
            is_lost = ~np.isfinite(samples).all(axis=1) | ~(samples[:, 3] > 0)
            counts = [is_chosen.sum(), is_lost.sum()]
            assert (ours[is_chosen, PDF] > 0).all()
            if above:
                with np.errstate(invalid="ignore"):
                    errors = relative(samples[:, 4], expected[is_chosen, PROJECTED_PDF])
                counts.append((~is_lost & (errors > 0.01)).sum())
            name = f"{'hard' if hard else 'ordinary'}, centre {'above' if above else 'below'} the horizon"
            print(f"published, {name}: {counts}")
            # Devices differ in their functions.
            check_page(name, counts, 5)


def test_costs_are_those_of_the_page():
    """But for other releases of Mesa, whose compiler is another."""
    for name, numbers in cost.costs().items():
        print(name, *numbers)
        check_page(name, numbers, 0)


def test_the_examples_give_the_picture_of_the_page(device, tmp_path):
    """In GLSL and in C, by the same random numbers: but for shadows' edges, where rounding decides."""
    committed = picture.pixels_of(ROOT / "docs/source.png").astype(int)
    program, file = tmp_path / "direct_light", ROOT / "examples/direct_light.c"
    command = [
        "cc",
        "-std=c99",
        "-O2",
        "-mfma",
        f"-I{ROOT / 'shaders'}",
        str(file),
        "-lm",
        "-o",
        str(program),
    ]
    subprocess.run(command, check=True)
    printed = subprocess.run([program], check=True, capture_output=True).stdout
    from_c = np.frombuffer(printed[-committed.size :], np.uint8).reshape(committed.shape)
    from_shader = picture.rendered(ROOT / "examples/direct_light.comp", device, tmp_path)
    for found in from_shader, from_c:
        differs = np.abs(found - committed).max(axis=2) > 2
        print(f"{differs.sum()} of {differs.size} pixels differ from docs/source.png")
        assert differs.sum() < differs.size / 1000


def test_the_function_of_the_page_compiles(tmp_path):
    """The block of docs/source.md, pasted into a shader after the file; for Vulkan and for OpenGL 4.0."""
    page = (ROOT / "docs/source.md").read_text()
    block = page.split("```glsl\n")[1].split("```")[0]
    rest = f"{(ROOT / 'shaders/spherecap.glsl').read_text()}\n{block}\nvoid main() {{}}\n"
    compiled(f"#version 450\n{rest}", [], tmp_path, "page")
    text = tmp_path / "page.frag"
    text.write_text(f"#version 400\n{rest}")
    done = subprocess.run(["glslangValidator", str(text)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
