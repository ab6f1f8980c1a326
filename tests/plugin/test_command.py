"""The command `spherecap`, on scenes such as users have: folders of their own, meshes, includes, defaults."""

import os
import re
import shlex
import subprocess
import sys
import time
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest
import spherecap
from spherecap_command import info
from spherecap_command.__main__ import SIZE, main
from spherecap_command.compare import Comparison
from spherecap_command.scene import (
    BUILT_IN,
    OURS,
    OWN_PARAMETERS,
    ParsedScene,
    best_variant,
    use_variant,
)

REPOSITORY = Path(__file__).resolve().parents[2]

# Every kind of light that there is. {…} are replaced by the two emitters.
SCENE = """<?xml version="1.0" encoding="utf-8"?>
<!-- Kerzen für Zoë: <emitter type="area"/> in a comment stays. -->
<scene version="3.0.0">
\t<default name="lamp" value="{lamp}"/>
    <default name="parts" value="parts"/>
    <path value="textures"/>
    <integrator type="direct"/>
    <sensor type="perspective">
        <transform name="to_world"><lookat origin="1, -4, 7" target="0, 0, 0" up="0, 0, 1"/></transform>
        <!-- A box filter: others add up in the order in which threads finish. -->
        <film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="16"/>
            <rfilter type="box"/></film>
    </sensor>
    <shape type="obj"><string name="filename" value="floor.obj"/></shape>

    <!-- By a default that nothing else reads, in two places. -->
    <shape type="sphere"><point name="center" x="-2" y="0" z="0.2"/><float name="radius" value="0.4"/>
        <emitter type="$lamp"><rgb name="radiance" value="3, 2, 1"/></emitter></shape>
    <shape type="sphere"><point name="center" x="-2" y="2" z="0.2"/><float name="radius" value="0.4"/>
        <emitter type="$lamp"/></shape>

    <!-- Odd formatting, and a > within an attribute. -->
    <shape id="a > b" type='sphere'><point name="center" x="2" y="0" z="0.6"/>
        <float name="radius" value="0.4"/>
        <emitter
            id="c > d"   type = '{plain}'
        ><rgb name="radiance" value="1, 2, 3"/></emitter></shape>

    <!-- Referred to from elsewhere. -->
    <emitter id="far" type="{plain}"/>
    <shape type="sphere"><point name="center" x="0" y="3" z="0.1"/><float name="radius" value="0.3"/>
        <ref id="far"/></shape>
    <include filename="$parts/lamp.xml"/>

    <!-- To be left alone: not a sphere, textured, stretched. -->
    <shape type="rectangle"><transform name="to_world"><scale value="0.3"/>
        <rotate x="1" angle="180"/><translate z="3"/></transform><emitter type="area"/></shape>
    <shape type="sphere"><point name="center" x="2" y="2" z="0.6"/><float name="radius" value="0.3"/>
        <emitter type="area"><texture name="radiance" type="bitmap">
            <string name="filename" value="stripes.png"/></texture></emitter></shape>
    <shape type="sphere"><transform name="to_world"><scale x="0.2" y="0.3" z="0.2"/>
        <translate x="3" z="1"/></transform><emitter type="area"/></shape>
</scene>
"""
INCLUDED = """<scene version="3.0.0">
    <shape type="sphere"><point name="center" x="0" y="-2" z="0.3"/><float name="radius" value="0.3"/>
        <emitter type="{plain}"/></shape>
</scene>
"""
FLOOR = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A user's folder, with a space in its name."""
    home = tmp_path / "my scenes"
    for sub in ("parts", "textures"):
        (home / sub).mkdir(parents=True)
    (home / "scene.xml").write_text(SCENE.format(lamp="area", plain="area"), encoding="utf-8")
    (home / "parts/lamp.xml").write_text(INCLUDED.format(plain="area"), encoding="utf-8")
    (home / "floor.obj").write_text(FLOOR)
    use_variant("scalar_rgb")
    mi.Bitmap(np.full((4, 4, 3), 200, dtype=np.uint8)).write(str(home / "textures/stripes.png"))
    return home


def small_scene(light: str) -> str:
    """Return a scene with one light."""
    return f"""<scene version="3.0.0">
    <integrator type="direct"/>
    <sensor type="perspective">
        <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/></film>
    </sensor>
    {light}
</scene>
"""


SPHERE = '<shape type="sphere"><point name="center" x="0" y="0" z="4"/><emitter type="area"/></shape>'


def test_convert_changes_the_sphere_lights_and_nothing_else(
    folder: Path, capsys: pytest.CaptureFixture
) -> None:
    """Byte for byte what an author would have written."""
    source, result = folder / "scene.xml", folder / "new.xml"
    before = source.read_bytes()
    assert main(["convert", str(source), str(result)]) == 0
    expected = SCENE.format(lamp="area", plain="spherecap").replace("$parts/lamp.xml", "new-1-lamp.xml")
    # A default of a scene of several files may be read elsewhere: it is the lights that change.
    expected = expected.replace('type="$lamp"', 'type="spherecap"')
    assert result.read_text(encoding="utf-8") == expected
    assert (folder / "new-1-lamp.xml").read_text() == INCLUDED.format(plain="spherecap")
    assert source.read_bytes() == before
    printed = capsys.readouterr().out
    assert printed.count("spherecap: ") == 5
    assert "[" not in printed.replace("[31m", "")  # no places in Mitsuba's sources
    for reason in ("a 'rectangle', not a sphere", "must not vary over the sphere", "uniformly scaled"):
        assert re.search(rf"stays as it is: .*scene\.xml \(line \d+, col \d+\): .*{reason}", printed), printed


def test_convert_changes_a_default_that_only_lights_read(folder: Path) -> None:
    """So that the scene's own switch goes on working."""
    source, result = folder / "one.xml", folder / "new.xml"
    text = SCENE.format(lamp="area", plain="spherecap").replace('<include filename="$parts/lamp.xml"/>', "")
    text = text.replace('<default name="parts" value="parts"/>', "")
    source.write_text(text, encoding="utf-8")
    assert main(["convert", str(source), str(result)]) == 0
    assert result.read_text(encoding="utf-8") == text.replace(
        '"lamp" value="area"', '"lamp" value="spherecap"'
    )


def test_what_was_converted_renders_from_another_folder(folder: Path, tmp_path: Path) -> None:
    """With the meshes, textures and includes of the original, and as `compare` renders it."""
    (tmp_path / "other").mkdir()
    result = tmp_path / "other/new.xml"
    assert main(["convert", str(folder / "scene.xml"), str(result)]) == 0
    images = {
        name: np.array(mi.render(scene, spp=4, seed=1))
        for name, scene in {
            "converted": mi.load_file(str(result)),
            "as ours": ParsedScene(folder / "scene.xml", {}).load(OURS),
            "as built in": ParsedScene(result, {}).load(BUILT_IN),
            "original": mi.load_file(str(folder / "scene.xml")),
        }.items()
    }
    np.testing.assert_array_equal(images["converted"], images["as ours"])
    np.testing.assert_array_equal(images["original"], images["as built in"])
    assert np.any(images["converted"] != images["original"])


def test_includes_of_includes_are_converted(tmp_path: Path) -> None:
    """Also those of the same name."""
    include = '<scene version="3.0.0"><include filename="{}/lamp.xml"/>{}</scene>'
    for name in ("a", "a/b"):
        (tmp_path / name).mkdir()
    (tmp_path / "scene.xml").write_text(include.format("a", ""))
    (tmp_path / "a/lamp.xml").write_text(include.format("a/b", SPHERE))
    (tmp_path / "a/b/lamp.xml").write_text(f'<scene version="3.0.0">{SPHERE}</scene>')
    assert main(["convert", str(tmp_path / "scene.xml"), str(tmp_path / "new.xml")]) == 0
    converted = ParsedScene(tmp_path / "new.xml", {})
    assert [light.emitter for light in converted.lights] == ["spherecap", "spherecap"]
    assert {file.name for file in converted.files} == {"new.xml", "new-1-lamp.xml", "new-2-lamp.xml"}


def test_a_byte_order_mark_does_not_shift_the_edits(tmp_path: Path) -> None:
    """As some editors write it."""
    source, result = tmp_path / "a.xml", tmp_path / "b.xml"
    source.write_bytes(b"\xef\xbb\xbf" + small_scene(SPHERE).encode())
    assert main(["convert", str(source), str(result)]) == 0
    assert result.read_bytes() == source.read_bytes().replace(b'"area"', b'"spherecap"')


def test_compare_leaves_images_and_a_page(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture
) -> None:
    """From another folder, and with the scene's resources."""
    monkeypatch.chdir(tmp_path)
    command = ["compare", "my scenes/scene.xml", "--spp", "4", "1", "--reference", "16"]
    assert main(command) == 0
    output = tmp_path / "scene-compare"
    names = {f"{emitter}-{spp}spp" for emitter in (BUILT_IN, OURS) for spp in (1, 4)} | {"reference"}
    expected = {f"{name}{end}" for name in names for end in (".exr", ".png", "-detail.png")} | {"index.html"}
    expected |= {f"{name}-error.png" for name in names - {"reference"}}
    assert {path.name for path in output.iterdir()} == expected
    for name in names:
        image = np.array(mi.Bitmap(str(output / f"{name}.exr")))
        assert image.shape == (16, 24, 3)
        assert np.all(np.isfinite(image))
        assert image.max() > 0
    captured = capfd.readouterr()
    rows = re.findall(r"^ +(\d+) +(area|spherecap) +([\d.]+) +([\d.]+)", captured.out, re.MULTILINE)
    assert [(row[0], row[1]) for row in rows] == [
        ("1", "area"),
        ("1", "spherecap"),
        ("4", "area"),
        ("4", "spherecap"),
    ]
    assert "5 sphere lights, 24 x 16 pixels, llvm_ad_rgb" in captured.out
    assert captured.out.count("[Sphere]") == 1  # a warning of Mitsuba's, once
    assert "100%" in captured.err  # the progress bar
    page = (output / "index.html").read_text(encoding="utf-8")
    assert page.count("data:image/png;base64,") == 2 * 2 * 3 + 2  # the reference is there once
    assert page.count("<svg ") == 2
    assert "http" not in page
    for row in rows:
        assert f"<td>{row[3]}</td>" in page


@pytest.mark.parametrize("variant", ["llvm_ad_mono", "llvm_ad_spectral_polarized"])
def test_compare_in_other_variants(tmp_path: Path, variant: str, capsys: pytest.CaptureFixture) -> None:
    """Whatever the colours are."""
    (tmp_path / "a.xml").write_text(small_scene(SPHERE))
    output = tmp_path / "out/a"  # whose parent is made, too
    command = ["compare", str(tmp_path / "a.xml"), "--variant", variant, "--spp", "1", "--reference", "8"]
    assert main([*command, "--output", str(output)]) == 0
    assert variant in capsys.readouterr().out
    assert (output / "spherecap-1spp.exr").exists()


def test_compare_takes_off_what_area_does_not_know(tmp_path: Path) -> None:
    """All of our own parameters, on the lights of a scene."""
    parameters = (
        '<string name="technique" value="solid_angle"/><string name="hemispheres" value="both"/>'
        '<float name="defensive" value="0.5"/><string name="lights" value="one"/>'
    )
    assert all(f'"{name}"' in parameters for name in OWN_PARAMETERS)
    light = SPHERE.replace('<emitter type="area"/>', f'<emitter type="spherecap">{parameters}</emitter>')
    (tmp_path / "a.xml").write_text(small_scene(2 * light))
    command = ["compare", str(tmp_path / "a.xml"), "--spp", "1", "--reference", "8"]
    assert main([*command, "--output", str(tmp_path / "out")]) == 0


def test_info(capsys: pytest.CaptureFixture) -> None:
    """Versions, variants, the processor."""
    assert main(["info"]) == 0
    printed = capsys.readouterr().out
    assert f"mitsuba {mi.__version__}\n" in printed
    assert f"spherecap.so, built for Mitsuba {mi.__version__}\n" in printed
    for feature in ("sse4_2", "avx2", "fma", "f16c"):
        assert f"{feature} yes" in printed
    for variant in mi.variants():
        assert re.search(
            rf"^  {variant} +(loads the emitter|not on this machine: .+)$", printed, re.MULTILINE
        )
    assert re.search("scalar_rgb +loads the emitter", printed)


def test_version(capsys: pytest.CaptureFixture) -> None:
    """Ours, and which Mitsuba it is for."""
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0
    version = info.version("spherecap")
    assert capsys.readouterr().out == f"spherecap {version}, for Mitsuba {mi.__version__}\n"


def test_convert_says_how_to_render(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """By a command that does."""
    home = tmp_path / "my scenes"
    home.mkdir()
    scene(home, SPHERE.replace("<emitter", '<float name="radius" value="$r"/><emitter'))
    text = (home / "a.xml").read_text(encoding="utf-8")
    (home / "a.xml").write_text(
        text.replace("<sensor", '<default name="r" value="0"/><sensor'), encoding="utf-8"
    )
    assert main(["convert", str(home / "a.xml"), str(home / "b.xml"), "-D", "r=1.5"]) == 0
    command = re.search("^to render it: mitsuba (.*)$", capsys.readouterr().out, re.MULTILINE)[1]
    words = [sys.executable, "-m", "mitsuba.python.cli", *shlex.split(command)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (home / "b.exr").exists()


def test_llvm_is_used_where_it_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """That of this Python, or one that the user names, but none that is just somewhere in the system."""
    assert best_variant() == "llvm_ad_rgb"
    monkeypatch.setenv("DRJIT_LIBLLVM_PATH", str(tmp_path / "libLLVM.so"))
    assert best_variant() == "scalar_rgb"
    monkeypatch.delenv("DRJIT_LIBLLVM_PATH")
    assert best_variant() == "scalar_rgb"


def room(
    lights: str, integrator: str = '<integrator type="direct"/>', more: str = "", width: int = 32
) -> str:
    """Return a scene: a piece of floor that a camera sees, beside the origin, and what lights it."""
    return f"""<scene version="3.0.0">
    {integrator}
    <sensor type="perspective" id="above">
        <transform name="to_world"><lookat origin="1, -4, 7" target="2, 0, 0" up="0, 0, 1"/></transform>
        <float name="fov" value="12"/>
        <film type="hdrfilm">
            <integer name="width" value="{width}"/><integer name="height" value="{width // 2}"/>
            <rfilter type="box"/>
        </film>
    </sensor>
    <shape type="rectangle"><transform name="to_world"><scale value="20"/></transform></shape>
    {lights}
    {more}
</scene>
"""


def lamp(x: float, z: float, radiance: float = 1, radius: float = 0.5) -> str:
    """Return a sphere light."""
    return f"""<shape type="sphere"><point name="center" x="{x}" y="0" z="{z}"/>
        <float name="radius" value="{radius}"/>
        <emitter type="area"><rgb name="radiance" value="{radiance}"/></emitter></shape>"""


def compared(folder: Path, text: str, capsys: pytest.CaptureFixture, *words: str) -> str:
    """Compare a scene and return what was printed."""
    (folder / "a.xml").write_text(text)
    assert main(["compare", str(folder / "a.xml"), "--output", str(folder / "out"), *words]) == 0
    return capsys.readouterr().out


ALONE = '<integrator type="direct"><integer name="bsdf_samples" value="0"/></integrator>'
IN_FULL = ("--spp", "16", "--reference", "64")


def shares(printed: str, part: str) -> tuple[float, float]:
    """Return a row of the table of parts."""
    row = re.search(rf"^ *{part} +([\d.]+) % +([\d.]+) %$", printed, re.MULTILINE)
    return float(row[1]), float(row[2])


def test_the_noise_of_a_cut_light_is_light_sampling(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """All of it, and nearly all of it goes."""
    printed = compared(tmp_path, room(lamp(0, 0.1), ALONE), capsys, *IN_FULL)
    assert shares(printed, "light sampling")[0] > 95
    assert shares(printed, "light sampling")[1] < 5
    assert re.search(
        r"^area takes [\d.e+]+ times as long as spherecap to be as good, and [\d.e+]+ times as many",
        printed,
        re.MULTILINE,
    )
    assert re.search(r"^\d+ % of the noise \(variance\) of area comes from light samples", printed, re.M)
    assert "Surfaces with two sides" not in printed


def test_surfaces_with_two_sides_are_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """One leaf far away costs most of the gain."""
    leaf = (
        '<shape type="rectangle"><transform name="to_world"><scale value="0.1"/><translate x="15" z="1"/>'
        '</transform><bsdf type="twosided"><bsdf type="diffuse"/></bsdf></shape>'
    )
    printed = compared(tmp_path, room(lamp(0, 0.1), ALONE, leaf), capsys, *IN_FULL)
    found = re.search(
        r'With hemispheres="front" spherecap would have (less than 1|\d+) % of the noise of area, instead of '
        r"(\d+) %: that is right if nobody sees the backs",
        printed,
    )
    assert int(found[1].removeprefix("less than ")) < 0.75 * int(found[2])


def test_the_choice_among_lights_is_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Of a bright light and nine dim ones it is nearly everything."""
    lights = lamp(0, 2, 100) + "".join(lamp(x, 3, 0.1) for x in range(-9, 0))
    printed = compared(tmp_path, room(lights), capsys, *IN_FULL)
    choice, light = shares(printed, "choice among lights"), shares(printed, "light sampling")
    assert choice[0] > 80 > light[0]
    assert choice[1] == 0
    assert re.search(r"comes from light samples where the camera looks \(\d+ % from the choice", printed)


def test_indirect_light_is_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Where the floor is lit by a ceiling alone, whose lamp is above the floor's edge."""
    lights = (
        '<shape type="sphere"><point name="center" x="0" y="0" z="9"/><float name="radius" value="0.5"/>'
        '<emitter type="area"/></shape>'
        '<shape type="disk"><transform name="to_world"><scale value="4"/><translate z="8"/></transform>'
        "</shape>"
        '<shape type="rectangle"><transform name="to_world"><rotate x="1" angle="180"/><scale value="20"/>'
        '<translate z="10"/></transform></shape>'
    )
    path = '<integrator type="path"><integer name="max_depth" value="4"/></integrator>'
    printed = compared(tmp_path, room(lights, path), capsys, *IN_FULL)
    area, ours = shares(printed, "indirect light")
    assert area > 60
    assert re.search(r"Indirect light makes \d+ % of it; spherecap leaves \d+ %\.", printed)
    assert ours > 30
    assert "is indirect light, by way of other surfaces" in printed


def test_bsdf_sampling_is_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Under a light so large that rays by chance meet it, it is what is left."""
    printed = compared(tmp_path, room(lamp(-2, 4, radius=3)), capsys, *IN_FULL)
    total = shares(printed, "all")[1]
    assert shares(printed, "BSDF sampling")[1] > 0.5 * total


def test_integrators_that_do_not_ask_lights_are_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Measured, not known: the images are the same."""
    integrator = '<integrator type="ptracer"><integer name="max_depth" value="3"/></integrator>'
    printed = compared(tmp_path, room(lamp(0, 3), integrator), capsys, *IN_FULL, "--variant", "scalar_rgb")
    assert "Both give the same images, sample by sample" in printed
    assert "Either the integrator `ptracer` does not ask lights for samples" in printed
    assert "of the noise (variance)" not in printed


def test_other_integrators_are_not_taken_apart(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """And it is said which are."""
    printed = compared(tmp_path, room(lamp(0, 0.1), '<integrator type="volpath"/>'), capsys, *IN_FULL)
    assert "for the integrators `path` and `direct` alone, and this scene has `volpath`." in printed


def in_the_sun(folder: Path, degrees: float) -> str:
    """Return a scene with a sun."""
    use_variant("scalar_rgb")
    floor = mi.load_file(write(folder / "floor.xml", room("")))
    sun = spherecap.sun([1, 0, 1], degrees, 1, floor)
    x, y, z = sun["center"]
    return room(f"""<shape type="sphere"><point name="center" x="{x}" y="{y}" z="{z}"/>
        <float name="radius" value="{sun["radius"]}"/><emitter type="area">
        <rgb name="radiance" value="{sun["emitter"]["radiance"]["value"]}"/></emitter></shape>""")


def test_a_wrong_area_is_named(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """A sun so small that it is too bright."""
    printed = compared(tmp_path, in_the_sun(tmp_path, 0.05), capsys, *IN_FULL)
    assert re.search(
        r"^area is 25(\.\d)? % brighter than spherecap, and that is not noise, so one of them is wrong: area",
        printed,
        re.MULTILINE,
    )
    assert "times as long" not in printed


def test_compare_within_a_time(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """An answer at once, in the end a page; no larger than it need be."""
    start = time.monotonic()
    printed = compared(tmp_path, room(lamp(0, 0.1), width=800), capsys, "--minutes", "0.05")
    assert printed.count("so far, with ") == printed.count("so far, with 1 spp: the error of area is ") == 1
    assert f"{SIZE} x {SIZE // 2} pixels" in printed
    assert "page: " in printed
    # 3 seconds were asked for. Compiling and writing the page come on top, on a machine that may be busy.
    assert time.monotonic() - start < 60


def test_compare_stops_with_what_it_has(
    tmp_path: Path, capsys: pytest.CaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """When it is interrupted after the first answer."""

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Comparison, "repeat", interrupted)
    printed = compared(tmp_path, room(lamp(0, 0.1)), capsys, "--minutes", "0.05")
    assert "stopped: this is what was found so far" in printed
    assert (tmp_path / "out/index.html").exists()


def test_the_size_of_the_image(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Larger, too; and of a part of the image, that part."""
    printed = compared(tmp_path, room(lamp(0, 0.1)), capsys, "--size", "50", *IN_FULL)
    assert "50 x 25 pixels" in printed
    crop = "".join(
        f'<integer name="crop_{name}" value="{value}"/>'
        for name, value in (("width", 20), ("height", 10), ("offset_x", 8), ("offset_y", 2))
    )
    text = room(lamp(0, 0.1)).replace('<rfilter type="box"/>', f'{crop}<rfilter type="box"/>')
    (tmp_path / "part").mkdir()
    printed = compared(tmp_path / "part", text, capsys, "--size", "10", *IN_FULL)
    assert "10 x 5 pixels" in printed


OTHER_SENSOR = """<sensor type="perspective" id="other">
    <transform name="to_world"><lookat origin="3, 0, 5" target="0, 0, 0" up="0, 0, 1"/></transform>
    <film type="hdrfilm"><integer name="width" value="10"/><integer name="height" value="10"/></film>
</sensor>"""


def test_a_sensor_is_chosen(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """By its id or its number; the first, and the output says so, where none is."""
    text = room(lamp(0, 0.1), more=OTHER_SENSOR)
    for number, (words, expected) in enumerate(
        {
            (): "32 x 16 pixels, .*, sensor 1 'above' of 2 \\(--sensor chooses\\)",
            ("--sensor", "other"): "10 x 10 pixels, .*, sensor 2 'other' of 2",
            ("--sensor", "2"): "10 x 10 pixels, .*, sensor 2 'other' of 2",
        }.items()
    ):
        (tmp_path / str(number)).mkdir()
        assert re.search(expected, compared(tmp_path / str(number), text, capsys, *IN_FULL, *words))


def test_all_sensors(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """One after the other, each with a page of its own, within the time for all."""
    start = time.perf_counter()
    printed = compared(
        tmp_path, room(lamp(0, 0.1), more=OTHER_SENSOR), capsys, "--sensor", "all", "--minutes", "0.1"
    )
    assert time.perf_counter() - start < 20  # The fewest renders are taken in any case, and much is loaded.
    assert re.findall(r"sensor (\d '\w+') of 2", printed) == ["1 'above'", "2 'other'"]
    pages = [Path(page) for page in re.findall("^page: (.*)$", printed, re.MULTILINE)]
    assert [page.parent.name for page in pages] == ["1-above", "2-other"]
    sizes = [mi.Bitmap(str(page.parent / "reference.exr")).size() for page in pages]
    assert [list(size) for size in sizes] == [[32, 16], [10, 10]]
    assert all(page.name in {one.name for one in page.parent.iterdir()} for page in pages)


def test_stopping_stops_all_sensors(
    tmp_path: Path, capsys: pytest.CaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the first has is kept, and the second is not begun."""

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Comparison, "repeat", interrupted)
    text = room(lamp(0, 0.1), more=OTHER_SENSOR)
    printed = compared(tmp_path, text, capsys, "--sensor", "all", "--minutes", "0.1")
    assert printed.count("page: ") == 1
    assert [one.name for one in (tmp_path / "out").iterdir()] == ["1-above"]


BELOW = SPHERE.replace('z="4"', 'z="-9"')
# A blackbody has no scale.
MISTAKEN = SPHERE.replace(
    'area"/>',
    'area"><spectrum name="radiance" type="blackbody"><float name="temperature" value="3000"/>'
    '<float name="scale" value="1e-4"/></spectrum></emitter>',
)
CUBE = '<shape type="cube"><emitter type="area"/></shape>'
MESH = '<shape type="obj"><string name="filename" value="x.obj"/></shape>'


def scene(folder: Path, *shapes: str, encoding: str = "utf-8") -> str:
    """Write a scene, and return its name."""
    return write(folder / "a.xml", small_scene("<!-- Zoë -->" + "".join(shapes)), encoding)


def write(path: Path, text: str, encoding: str = "utf-8") -> str:
    """Write a file, and return its name."""
    path.write_text(text, encoding=encoding)
    return str(path)


# Arguments, made in a temporary folder, and what the message says.
MISTAKES = {
    "no file": (lambda t: ["compare", f"{t}/moon.xml"], "there is no file '.*moon.xml'"),
    "no file to convert": (lambda t: ["convert", f"{t}/moon.xml", f"{t}/b.xml"], "there is no file"),
    "no such variant": (
        lambda t: ["compare", scene(t, SPHERE), "--variant", "quantum_rgb"],
        "no variant 'quantum_rgb'; choose one of: .*scalar_rgb",
    ),
    "not XML": (
        lambda t: ["convert", write(t / "a.xml", "<scene"), f"{t}/b.xml"],
        "(?s)Mitsuba cannot read '.*a.xml'",
    ),
    "not quite XML": (
        lambda t: ["convert", scene(t, SPHERE.replace("<emitter", '<emitter id="a" id="a"')), f"{t}/b.xml"],
        "'.*a.xml' is not correct XML: duplicate attribute",
    ),
    "not UTF-8": (
        lambda t: ["convert", scene(t, SPHERE, encoding="latin-1"), f"{t}/b.xml"],
        "'.*a.xml' is not encoded in UTF-8",
    ),
    "no mesh": (lambda t: ["compare", scene(t, SPHERE, MESH)], "(?s)cannot load '.*a.xml'.*x.obj"),
    "no light": (
        lambda t: ["compare", scene(t, '<emitter type="constant"/>')],
        'has no sphere light: no <shape type="sphere"> with an area emitter',
    ),
    "no sphere": (
        lambda t: ["convert", scene(t, CUBE), f"{t}/b.xml"],
        r"(?s)that could be a spherecap:\n  .*a.xml \(line \d+, col \d+\): its shape is a 'cube'",
    ),
    "nothing to do": (
        lambda t: ["convert", scene(t, SPHERE.replace("area", "spherecap")), f"{t}/b.xml"],
        "are spherecaps already",
    ),
    "result exists": (
        lambda t: ["convert", scene(t, SPHERE), write(t / "b.xml", "mine")],
        "b.xml' exists: remove it, or choose another name",
    ),
    "result in no folder": (
        lambda t: ["convert", scene(t, SPHERE), f"{t}/no/b.xml"],
        "b.xml' cannot be written: No such file or directory",
    ),
    "output exists": (
        lambda t: ["compare", scene(t, SPHERE), "--output", str(t)],
        "exists: remove it, or choose another folder with --output",
    ),
    "no sensor": (
        lambda t: ["compare", write(t / "a.xml", f'<scene version="3.0.0">{SPHERE}</scene>')],
        "a.xml' has no sensor: without a camera there is nothing to render",
    ),
    "no integrator": (
        lambda t: ["compare", write(t / "a.xml", room(lamp(0, 1), integrator=""))],
        "a.xml' has no integrator: add one",
    ),
    "no such sensor": (
        lambda t: ["compare", scene(t, SPHERE), "--sensor", "left"],
        "a.xml' has no sensor 'left'; choose one of: 1; or all$",
    ),
    "a mistake in the light": (
        lambda t: ["compare", scene(t, MISTAKEN)],
        r"(?s)Mitsuba cannot load '.*a.xml': While loading .*a.xml \(line \d+.*blackbody.*scale",
    ),
    "a mistake in the light to convert": (
        lambda t: ["convert", scene(t, SPHERE + MISTAKEN), f"{t}/b.xml"],
        r"(?s)Mitsuba cannot load '.*a.xml': While loading .*a.xml \(line \d+.*blackbody.*scale",
    ),
    "a sun too small for area": (
        lambda t: ["compare", write(t / "a.xml", in_the_sun(t, 0.01)), "--spp", "1", "--output", f"{t}/o"],
        "with 'area' the scene renders black, with 'spherecap' it does not: its lights are seen too small",
    ),
    "black": (
        lambda t: ["compare", scene(t, BELOW), "--reference", "1", "--spp", "1", "--output", f"{t}/o"],
        "renders black",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_are_explained(name: str, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """In a sentence; and nothing is written, or lost."""
    arguments, message = MISTAKES[name]
    words = arguments(tmp_path)
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    assert main(words) == 1
    last = capsys.readouterr().err.split("spherecap: ", 1)[1]
    assert re.search(message, last), last
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["compare", "a.xml", "--spp", "0"], "'0' is not a count"),
        (["compare", "a.xml", "--spp", "many"], "'many' is not a count"),
        (["compare", "a.xml", "--minutes", "0"], "'0' is not a time"),
        (["compare", "a.xml", "--minutes", "soon"], "'soon' is not a time"),
        (["compare", "a.xml", "--size", "-1"], "'-1' is not a count"),
        (["convert", "a.xml", "b.xml", "-D", "lamp"], "'lamp' is not of the form NAME=VALUE"),
        ([], "required: command"),
    ],
)
def test_wrong_words_are_explained(words: list[str], message: str, capsys: pytest.CaptureFixture) -> None:
    """By the parser of the command line."""
    with pytest.raises(SystemExit) as stop:
        main(words)
    assert stop.value.code == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("command", ["info", "compare"])
def test_another_mitsuba_is_one_sentence(command: str) -> None:
    """And `info` says what it can."""
    words = [command] + (["scene.xml"] if command == "compare" else [])
    program = (
        "import mitsuba; mitsuba.__version__ = '3.8.0'\n"
        f"import sys; from spherecap_command.__main__ import main; sys.exit(main({words}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONPATH": str(REPOSITORY / "mitsuba_plugin")},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 1
    assert re.fullmatch(
        r"spherecap: The spherecap plugin was built for Mitsuba [\d.]+, but this is Mitsuba 3\.8\.0: .*\n",
        done.stderr,
    )
    assert ("processor: " in done.stdout) == (command == "info")
