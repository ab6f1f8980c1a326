"""What README and docs say is so: their examples run, their numbers and names are those of the code."""

import re
import subprocess
import sys
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest
import spherecap_command.__main__ as command
import tomllib
from spherecap_command.__main__ import _arguments as command_line
from spherecap_command.scene import OWN_PARAMETERS

REPOSITORY = Path(__file__).parents[2]
README = REPOSITORY / "README.md"
GUIDE = REPOSITORY / "docs/mitsuba.md"
PAGES = sorted([*REPOSITORY.glob("*.md"), *(REPOSITORY / "docs").glob("*.md")])


def blocks(page: Path, language: str) -> list[str]:
    """Return the blocks of code of a page in a language."""
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.fixture(scope="module")
def image_from_python() -> np.ndarray:
    """Run the guide's Python example and return the image that it renders."""
    names = {}
    exec(blocks(GUIDE, "python")[0], names)
    return np.array(names["image"])


def test_the_python_example_renders(image_from_python: np.ndarray) -> None:
    """The example renders a floor that is lit everywhere."""
    assert image_from_python.shape == (48, 64, 3)
    assert np.all(np.isfinite(image_from_python))
    assert np.median(image_from_python) > 0


def test_the_xml_example_is_the_same_scene(image_from_python: np.ndarray) -> None:
    """Both examples show one scene: the same samples give the same image."""
    mi.set_variant("scalar_rgb")
    image = np.array(mi.render(mi.load_string(blocks(GUIDE, "xml")[0]), spp=4))
    # Transformations are composed in another order of roundings.
    np.testing.assert_allclose(image, image_from_python, rtol=1e-3, atol=1e-4)


def test_the_readmes_light_is_one(scalar_rgb: None) -> None:
    """The snippet is a shape of a scene."""
    (light,) = blocks(README, "xml")
    scene = mi.load_string(f'<scene version="3.0.0">{light}</scene>')
    assert scene.emitters()[0].class_name() == "SphereCap"


def test_the_guides_parameters_are_the_emitters(scalar_rgb: None) -> None:
    """Each row of the table: the name is known, the default is what an emitter says that it has."""
    row = r"^\| `(\w+)` \| (\w+) \| (.+?) \| (.*?) \|.*\|$"
    rows = re.findall(row, GUIDE.read_text(encoding="utf-8"), re.MULTILINE)
    defaults = {name: default.strip("`") for name, _, default, _ in rows}
    expected = {
        "radiance": "1",
        "technique": "projected",
        "hemispheres": "auto",
        "defensive": "automatic",
        "lights": "all",
    }
    assert defaults == expected
    # `area` has the radiance, too; the rest is taken off where the command puts an `area` in its place.
    assert {"radiance", *OWN_PARAMETERS} == set(expected)
    text = str(mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}}).emitter())
    meanings = {name: meaning for name, _, _, meaning in rows}
    automatic = re.search(r"else `([\d.]+)`", meanings["defensive"])[1]
    # Before there is a scene, the automatic choices are the careful ones.
    for line in (
        "value=1.0",
        "technique = projected,",
        "hemispheres = both (auto)",
        f"defensive = {automatic} (auto)",
    ):
        assert line in text
    for name in ("technique", "hemispheres"):
        for choice in re.findall("`(\\w+)`(?:, |; )", meanings[name]):
            if choice != "area":
                mi.load_dict({"type": "spherecap", name: choice})


@pytest.mark.parametrize("page", [README, GUIDE])
def test_the_commands_exist(page: Path) -> None:
    """Every line that calls the command is one that it understands."""
    lines = [line for block in blocks(page, "sh") for line in block.splitlines()]
    calls = [line.split()[1:] for line in lines if line.startswith("spherecap ")]
    assert calls
    for words in calls:
        command_line(words)


def test_the_guides_numbers_are_the_commands() -> None:
    """What `compare` does where nobody asks for something else."""
    text = " ".join(GUIDE.read_text(encoding="utf-8").split())
    for pattern, number in (
        (r"It takes (\d+) minutes, or as many as `--minutes`", command.MINUTES),
        (r"at most (\d+) pixels along their longer side unless `--size`", command.SIZE),
        (r"(\d+) samples per pixel unless `--reference`", command.REFERENCE),
        (r"then follow 4, 16 and (\d+) samples per pixel", command.COUNTS[-1]),
    ):
        assert float(re.search(pattern, text)[1]) == number, pattern


def test_the_guides_sun_shines() -> None:
    """Its program renders a floor of the reflectance .5 in the sun."""
    names = {}
    exec(blocks(GUIDE, "python")[1], names)
    expected = 1000 * 2 / 5**0.5 * 0.5 / np.pi
    np.testing.assert_allclose(np.array(names["image"]), expected, rtol=1e-5)


def test_the_readmes_renders() -> None:
    """The picture is what `make picture` makes, and the demo's scenes exist."""
    text = README.read_text(encoding="utf-8")
    picture = re.search(
        r"^picture:.*\n.* --spp (\d+) .*--picture (.*)$", (REPOSITORY / "Makefile").read_text(), re.MULTILINE
    )
    assert f"{picture[1]} samples per pixel]({picture[2]})" in text
    scenes = re.findall(r"SCENE=(\w+)", text)
    assert scenes
    for scene in scenes:
        assert (REPOSITORY / f"scenes/{scene}.xml").is_file()


def test_the_mathematics_holds() -> None:
    """The page's program runs to its end."""
    program = "\n".join(blocks(REPOSITORY / "docs/mathematics.md", "python"))
    assert program.count("assert ") >= 4
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_versions_are_those_of_the_manifests() -> None:
    """Wherever a page names one."""
    package = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["package"]
    mitsuba = re.search(r"^mitsuba==(.+)$", (REPOSITORY / "requirements.txt").read_text(), re.MULTILINE)[1]
    found = set()
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for pattern, version in (
            (r"Rust (?:\()?(\d+\.\d+)", package["rust-version"]),
            (r"(?:; |for )Mitsuba (\d+\.\d+\.\d+)", mitsuba),
            (r"mitsuba==([\d.]+) nanobind==[\d.]+$", mitsuba),
            (r"find_package\(MitsubaWheel ([\d.]+)", mitsuba),
            (r"find_package\(spherecap ([\d.]+)", package["version"].rpartition(".")[0]),
            (r"^## Unreleased \(([\d.]+)\)", package["version"]),
        ):
            for named in re.findall(pattern, text, re.MULTILINE):
                assert named == version, f"{page.name} says {named}, not {version}"
                found.add(pattern)
    assert len(found) == 6, found


def test_releases_of_mitsuba_are_those_of_the_build() -> None:
    """Each row of the guide's table prepares the build for a release; the other pages list the same."""
    releases = re.search(
        r"^set\(mitsubas (.*)\)$", (REPOSITORY / "mitsuba_plugin/CMakeLists.txt").read_text(), re.MULTILINE
    )[1].split()
    module = (REPOSITORY / "mitsuba_plugin/spherecap/cmake/FindMitsubaWheel.cmake").read_text()
    (row,) = re.findall(r"^set\(_MitsubaWheel_KNOWN_NANOBIND (.*)\)$", module, re.MULTILINE)
    nanobinds = dict(pair.split("=") for pair in re.findall(r'"(.*?)"', row))
    backend = re.search(
        r"^scikit-build-core==.+$", (REPOSITORY / "requirements.txt").read_text(), re.MULTILINE
    )[0]
    assert re.findall(
        r"^\| (.*) \| `(pip install .*)` \|$", GUIDE.read_text(encoding="utf-8"), re.MULTILINE
    ) == [
        (release, f"pip install mitsuba=={release} nanobind=={nanobinds[release]} {backend} cmake ninja")
        for release in releases
    ]
    listed = f"{', '.join(releases[:-1])} or {releases[-1]}"
    for page in (README, REPOSITORY / "CHANGELOG.md"):
        assert listed in page.read_text(encoding="utf-8")


def test_links_lead_somewhere() -> None:
    """All that point into the repository, and to headings there."""
    links = [
        (page, link)
        for page in PAGES
        for link in re.findall(r"\]\(\s*([^)\s]+?)\s*\)", page.read_text(encoding="utf-8"))
        if not link.startswith("http")
    ]
    assert len(links) > 15
    for page, link in links:
        name, _, heading = link.partition("#")
        target = page.parent / name if name else page
        assert target.exists(), f"{page.name}: {link}"
        if heading:
            titles = re.findall(r"^#+ (.*)$", target.read_text(encoding="utf-8"), re.MULTILINE)
            assert heading in [title.lower().replace(" ", "-") for title in titles], f"{page.name}: {link}"


def test_targets_of_make_exist() -> None:
    """Every `make target` that a page or a block of code names."""
    targets = set(re.findall(r"^([a-z0-9-]+):", (REPOSITORY / "Makefile").read_text(), re.MULTILINE))
    named = set()
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        inline = re.sub("```.*?```", "", text, flags=re.DOTALL)
        named |= set(re.findall(r"`make\s+([a-z0-9-]+)", inline)) | set(
            re.findall(r"^make ([a-z0-9-]+)", text, re.MULTILINE)
        )
    assert {"demo", "test", "install"} <= named <= targets, named - targets
