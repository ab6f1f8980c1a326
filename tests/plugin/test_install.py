"""`pip install` gives packages and a command that need neither this repository nor a path to it."""

import email
import inspect
import os
import platform
import re
import subprocess
import sys
import sysconfig
import zipfile
from email import message
from importlib import metadata
from pathlib import Path

import pytest
import spherecap
import tomllib

REPOSITORY = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent  # cmake and ninja are in the same environment


def run(*command: object, **variables: str) -> str:
    """Run a command outside of the repository and return what it printed."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    environment |= {"PATH": f"{TOOLS}{os.pathsep}{environment['PATH']}", **variables}
    words = [str(word) for word in command]
    done = subprocess.run(words, env=environment, cwd="/", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel from a source archive, as `make wheel` does, with the requirements that are here."""
    folder = tmp_path_factory.mktemp("a wheel")
    run(sys.executable, REPOSITORY / "packaging/wheel.py", folder)
    (path,) = folder.glob("*.whl")
    return path


def metadata_of(wheel: Path) -> message.Message:
    """Return what the wheel says about itself."""
    with zipfile.ZipFile(wheel) as archive:
        (file,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
        return email.message_from_bytes(archive.read(file))


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new virtual environment, in a folder with a space, that has what this one has."""
    folder = tmp_path_factory.mktemp("an environment") / "venv"
    run(sys.executable, "-m", "venv", "--without-pip", folder)
    (site,) = folder.glob("lib/python*/site-packages")
    (site / "everything_else.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return folder


def test_the_wheel_holds_the_packages_and_nothing_else(wheel: Path) -> None:
    """Python, the plugin, one CMake module; for any Python, on Linux; of the library's version.

    The older the glibc that it asks for, the better; none is newer than that of this machine.
    """
    names = zipfile.ZipFile(wheel).namelist()
    ours = {name for name in names if not re.search(r"\.dist-info/|/$", name)}
    package = REPOSITORY / "mitsuba_plugin"
    python = {path.relative_to(package).as_posix() for path in package.glob("spherecap*/*.py")}
    assert ours == python | {
        "spherecap/plugins/spherecap.so",
        "spherecap/plugins/spherecap_emitter.so",
        "spherecap/cmake/FindMitsubaWheel.cmake",
        "spherecap/py.typed",
    }
    version = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["package"]["version"]
    tag = re.fullmatch(rf"spherecap-{version}-py3-none-manylinux_2_(\d+)_x86_64\.whl", wheel.name)
    assert int(tag[1]) <= int(platform.libc_ver()[1].split(".")[1])


def test_the_wheel_depends_on_the_mitsuba_that_it_was_built_for(wheel: Path) -> None:
    """Which is the one that is installed."""
    assert f"mitsuba=={metadata.version('mitsuba')}" in metadata_of(wheel).get_all("Requires-Dist")


def test_the_page_on_pypi_leads_somewhere(wheel: Path) -> None:
    """Its text is the README; links are absolute, into the release's files."""
    page = metadata_of(wheel)
    version, text = page["Version"], page.get_payload()
    package = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["package"]
    addresses = dict(url.split(", ") for url in page.get_all("Project-URL"))
    assert addresses["Repository"] == package["repository"]
    links = re.findall(r"\]\(\s*([^)\s]+)\s*\)", text) + re.findall(r'(?:src|href)="([^"]+)"', text)
    assert len(links) > 15
    ours = [link for link in (*links, *addresses.values()) if link.startswith(package["repository"])]
    for link in ours:
        path = re.fullmatch(rf"{package['repository']}(?:/(?:blob|raw)/v{version}/(.+)|/issues|)", link)[1]
        assert (REPOSITORY / (path or "").split("#")[0]).exists(), link
    assert all(link in ours or link.startswith(("https://", "#")) for link in links), links
    assert sum(f"/raw/v{version}/" in link for link in ours) == len(
        re.findall(r"!\[|<img", (REPOSITORY / "README.md").read_text())
    )


def test_sizes(wheel: Path) -> None:
    """The guide states them, neither too low nor much too high."""
    guide = (REPOSITORY / "docs/mitsuba.md").read_text(encoding="utf-8")
    (archive,) = wheel.parent.glob("*.tar.gz")
    stated = re.search(r"wheel has less than ([\d.]+) MB and the source archive less than ([\d.]+) MB", guide)
    with zipfile.ZipFile(wheel) as files:
        installed = sum(file.file_size for file in files.infolist())
    for path, megabytes in zip((wheel, archive), map(float, stated.groups()), strict=True):
        assert megabytes / 2 < path.stat().st_size / 1e6 < megabytes
    assert f"Installed, it is {installed / 1e6:.1f} MB" in guide


def test_types() -> None:
    """Whoever checks types with the package, which says that it has them (`py.typed`), finds them."""
    functions = [getattr(spherecap, name) for name in spherecap.__all__]
    for function in filter(inspect.isfunction, functions):
        signature = inspect.signature(function)
        assert signature.return_annotation is not inspect.Signature.empty, function
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty, f"{function}: {parameter}"


def test_installed_used_and_uninstalled(wheel: Path, environment: Path, tmp_path: Path) -> None:
    """The import is all that the emitter needs; the command is there; and afterwards all is as before."""
    before = sorted(environment.rglob("*"))
    pip = (sys.executable, "-m", "pip", "--python", environment / "bin/python", "--disable-pip-version-check")
    run(*pip, "install", "--quiet", "--no-deps", "--no-index", wheel)
    program = """
import mitsuba as mi, spherecap
mi.set_variant("scalar_rgb")
print(spherecap.PLUGIN)
print(mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}}).emitter().class_name())
"""
    plugin, name = run(environment / "bin/python", "-c", program).split("\n")[:2]
    assert Path(plugin).is_relative_to(environment)
    assert name == "SphereCap"

    modules = run(environment / "bin/python", "-m", "spherecap", "--cmake_dir").strip()
    assert Path(modules).is_relative_to(environment)
    assert (Path(modules) / "FindMitsubaWheel.cmake").is_file()

    command = environment / "bin/spherecap"
    version = wheel.name.split("-")[1]
    assert f"spherecap {version}\n" in run(command, "info")
    scene = REPOSITORY / "scenes/cut_light.xml"
    words = ("-D", "width=16", "-D", "height=12", "--spp", "1", "--reference", "8")
    output = ("--output", tmp_path / "compared")
    printed = run(command, "compare", scene, *words, *output)
    assert re.search(r"^ +1 +spherecap +[\d.]+ +[\d.]+ +[\d.]+x +[\d.]+x$", printed, re.MULTILINE)
    assert (tmp_path / "compared/index.html").is_file()

    run(*pip, "uninstall", "--quiet", "--yes", "spherecap")
    assert sorted(environment.rglob("*")) == before
