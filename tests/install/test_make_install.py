"""`make install`, and what it installs, consumed as a C, a C++ and a Mitsuba plugin author would."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import tomllib

REPOSITORY = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent  # cmake, ninja and pkg-config are in the same environment
VERSION = tomllib.loads((REPOSITORY / "Cargo.toml").read_text())["package"]["version"]
HEADER = (REPOSITORY / "include/spherecap.h").read_text()
ABI = re.search(r"^#define SPHERECAP_ABI (\d+)$", HEADER, re.MULTILINE)[1]
SONAME = f"libspherecap.so.{ABI}"
CC = os.environ.get("CC", "cc")

# The same for C99 and C++17: what a first program does.
PROGRAM = """
#include <spherecap.h>
#include <spherecap_record.h>
#include <stdio.h>

int main(void) {
    const spherecap_receiver_t floor = {{0, 0, 1}, SPHERECAP_TECHNIQUE_PROJECTED,
                                        SPHERECAP_HEMISPHERES_FRONT, 0};
    const float centre[3] = {0, 0, 2};
    spherecap_sampler_t sampler;
    float irradiance = 0;
    uint32_t status = spherecap_prepare(&floor, centre, 1, &sampler);
    if (status == SPHERECAP_STATUS_OK)
        status = spherecap_projected_solid_angle(&sampler, &irradiance);
    printf("%s %u %.5f\\n", spherecap_version(), spherecap_abi_version(), irradiance);
    return (int)status;
}
"""
# Radius over distance is 1/2, so the irradiance is pi / 4.
PRINTED = f"{VERSION} {ABI} 0.78540\n"


def run(*command: object, folder: Path, **variables: str) -> str:
    """Run a command and return what it printed."""
    environment = {**os.environ, "PATH": f"{TOOLS}{os.pathsep}{os.environ['PATH']}", **variables}
    words = [str(word) for word in command]
    done = subprocess.run(words, env=environment, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(words)}\n{done.stdout}{done.stderr}"
    return done.stdout


def make(target: str, *settings: str) -> str:
    """Run make in the repository."""
    return run("make", target, *settings, folder=REPOSITORY)


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install once, in a folder with a space."""
    folder = tmp_path_factory.mktemp("a prefix")
    make("install", f"PREFIX={folder}")
    return folder


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    """Return a folder with the program in both languages."""
    (tmp_path / "program.c").write_text(PROGRAM)
    (tmp_path / "program.cpp").write_text(PROGRAM)
    return tmp_path


def pkg_config(prefix: Path, *words: str) -> list[str]:
    """Ask pkg-config, which has to be installed."""
    program = TOOLS / "pkg-config"
    assert program.exists(), f"there is no {program}: install what requirements.txt lists"
    path = str(prefix / "lib/pkgconfig")
    return shlex.split(run(program, *words, "spherecap", folder=prefix, PKG_CONFIG_PATH=path))


@pytest.mark.parametrize(("compiler", "standard", "source"), [
    (CC, "-std=c99", "program.c"), (os.environ.get("CXX", "c++"), "-std=c++17", "program.cpp")
])  # fmt: skip
@pytest.mark.parametrize("linkage", ["shared", "static"])
def test_pkg_config(
    prefix: Path, sources: Path, compiler: str, standard: str, source: str, linkage: str
) -> None:
    """As on the page on the C library."""
    extra = ["-static"] if linkage == "static" else []
    flags = pkg_config(prefix, "--cflags", "--libs", *["--static" for _ in extra])
    warnings = ("-pedantic", "-Wall", "-Wextra", "-Werror", "-Wl,--fatal-warnings")
    run(compiler, standard, *warnings, *extra, source, *flags, "-o", "program", folder=sources)
    needed = re.findall(r"NEEDED.*\[(.*)\]", run("readelf", "-d", "program", folder=sources))
    assert (SONAME in needed) == (linkage == "shared"), needed
    path = str(prefix / "lib") if linkage == "shared" else ""
    assert run(sources / "program", folder=sources, LD_LIBRARY_PATH=path) == PRINTED


def test_pkg_config_knows_the_version(prefix: Path) -> None:
    """For those who ask for one."""
    assert pkg_config(prefix, "--modversion") == [VERSION]


def test_cmake(prefix: Path, sources: Path) -> None:
    """All three targets, in both languages, from an installation that was moved to a path with a space."""
    moved = sources / "moved here"
    run("cp", "-a", prefix, moved, folder=sources)
    major, minor, _ = VERSION.split(".")
    (sources / "CMakeLists.txt").write_text(
        f"""cmake_minimum_required(VERSION 3.24)
project(consumer LANGUAGES C CXX)
set(CMAKE_C_STANDARD 99)
set(CMAKE_CXX_STANDARD 17)
find_package(spherecap {major}.{minor} REQUIRED)
foreach(target spherecap static shared)
    add_executable(c_${{target}} program.c)
    add_executable(cpp_${{target}} program.cpp)
    target_link_libraries(c_${{target}} PRIVATE spherecap::${{target}})
    target_link_libraries(cpp_${{target}} PRIVATE spherecap::${{target}})
endforeach()
"""
    )
    for shared in ("OFF", "ON"):
        build = sources / f"build {shared}"
        settings = (f"-DCMAKE_PREFIX_PATH={moved}", f"-DBUILD_SHARED_LIBS={shared}")
        run("cmake", "-G", "Ninja", "-S", sources, "-B", build, *settings, folder=sources)
        run("cmake", "--build", build, folder=sources)
        linked_shared = set()
        for language in ("c", "cpp"):
            for target in ("spherecap", "static", "shared"):
                program = build / f"{language}_{target}"
                assert run(program, folder=sources) == PRINTED
                if SONAME in run("readelf", "-d", program, folder=sources):
                    linked_shared.add(target)
        assert linked_shared == ({"shared", "spherecap"} if shared == "ON" else {"shared"})


@pytest.mark.parametrize("wanted", ["99.0", "0.0.1", "0.99"])
def test_cmake_refuses_another_version(prefix: Path, tmp_path: Path, wanted: str) -> None:
    """The minor version must be the same."""
    (tmp_path / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.24)\nproject(x NONE)\nfind_package(spherecap {wanted})\n"
        'if(spherecap_FOUND OR NOT "${spherecap_CONSIDERED_VERSIONS}" STREQUAL "' + VERSION + '")\n'
        '    message(FATAL_ERROR "found")\nendif()\n'
    )
    run("cmake", "-S", ".", "-B", "b", f"-DCMAKE_PREFIX_PATH={prefix}", folder=tmp_path)


def exported(library: Path, *options: str) -> set[str]:
    """Return what a library defines for others."""
    table = run("readelf", "-W", *options, library, folder=library.parent)
    symbols = [line.split() for line in table.splitlines()]
    return {s[7] for s in symbols if len(s) >= 8 and s[4] in ("GLOBAL", "WEAK") and s[6] != "UND"}


def test_the_libraries_export_the_header_and_nothing_else(prefix: Path) -> None:
    """And the shared one has its name, and links that lead to it."""
    library = prefix / "lib/libspherecap.so"
    assert os.readlink(library) == SONAME
    assert os.readlink(prefix / "lib" / SONAME) == f"libspherecap.so.{VERSION}"
    assert f"soname: [{SONAME}]" in run("readelf", "-d", library, folder=prefix)
    headers = HEADER + (REPOSITORY / "include/spherecap_record.h").read_text()
    declared = set(re.findall(r"^\w[\w ]*\*?\b(spherecap_\w+)\(", headers, re.MULTILINE))
    assert len(declared) >= 29
    assert exported(library, "--dyn-syms") == declared
    assert exported(prefix / "lib/libspherecap.a", "--syms") == declared


def test_the_static_library_carries_what_it_uses(prefix: Path) -> None:
    """Kernels, and what of Rust's standard library prints the message of a panic.

    The kernels are half a megabyte, that a quarter, and relocations and names as much again. The whole
    standard library, even without debug information and bitcode, is more than three megabytes.
    """
    library = prefix / "lib/libspherecap.a"
    page = (REPOSITORY / "docs/c.md").read_text(encoding="utf-8")
    stated = re.search(r"the library; less than ([\d.]+) MB and ([\d.]+) MB", page).groups()
    for path, megabytes in zip((library, library.with_suffix(".so")), map(float, stated), strict=True):
        assert megabytes / 2 < path.stat().st_size / 1e6 < megabytes
    sections = run("readelf", "-W", "--sections", library, folder=prefix)
    assert ".text.spherecap_sample" in sections
    assert not re.search(r" \.(debug|llvm)", sections)


def test_uninstall_leaves_nothing_but_what_was_there(tmp_path: Path) -> None:
    """Staged in a folder with a space, as packagers do, beside somebody else's files."""
    stage = tmp_path / "a stage"
    other = stage / "usr/lib/pkgconfig/other.pc"
    other.parent.mkdir(parents=True)
    other.touch()
    make("install", f"DESTDIR={stage}", "PREFIX=/usr")
    installed = {path.relative_to(stage).as_posix() for path in stage.rglob("*") if not path.is_dir()}
    assert len(installed) == 1 + 9, installed
    for path in stage.rglob("*"):
        if path.is_file() and path.suffix in (".pc", ".cmake"):
            assert str(stage) not in path.read_text()
            assert not re.search(r"@\w+@", path.read_text())
    make("uninstall", f"DESTDIR={stage}", "PREFIX=/usr")
    assert [path for path in stage.rglob("*") if not path.is_dir()] == [other]
    assert not list(stage.rglob("*spherecap*"))


def blocks(page: Path, language: str) -> list[str]:
    """Return the blocks of code of a page in a language."""
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def test_the_page_on_the_c_library(prefix: Path, tmp_path: Path) -> None:
    """Its programs, in both languages, by its lines for pkg-config, and its list of what is installed.

    The lines as they are to be written for a folder with a space.
    """
    page = REPOSITORY / "docs/c.md"
    single, several, sun, batch = blocks(page, "c")
    _, compile_lines = blocks(page, "sh")

    def printed_by(program: str, compile_line: str) -> list[str]:
        (tmp_path / "program.c").write_text(program)
        warnings = "-pedantic -Wall -Wextra -Werror"
        line = compile_line.replace("program.c", f"{warnings} program.c")
        run("sh", "-ec", f"eval {line}", folder=tmp_path, PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig"))
        return run(tmp_path / "program", folder=tmp_path, LD_LIBRARY_PATH=str(prefix / "lib")).split()

    lines = compile_lines.splitlines()
    in_cpp = [
        line.replace("cc -std=c99", "c++ -std=c++17 -x c++").replace("program.c", "program.c -x none")
        for line in lines
    ]
    for line in lines + in_cpp:
        reflected = printed_by(single, line)
        assert len(reflected) == 4
        assert len(set(reflected)) == 1, "no noise"
        *choices, probability, _, irradiance = printed_by(several, line)
        lights, estimates = choices[::2], [float(word) for word in choices[1::2]]
        assert lights == sorted(lights), "one interval for each"
        assert set(lights) == {"0", "1", "2"}
        assert estimates == pytest.approx([float(irradiance)] * 8, rel=0.05)
        assert abs(lights.count("1") / 8 - float(probability)) < 1 / 8
        assert [float(word) for word in printed_by(sun, line)] == pytest.approx([600] * 3, abs=0.11)
        words = printed_by(batch, line)
        by_distance = dict(zip(words[::2], words[1::2], strict=True))
        assert by_distance["3.0"] == reflected[0], "the point of the other program"
        assert by_distance["0.5"] == "0.0000", "inside the light"
        lit = [float(light) for light in words[1::2] if light != "0.0000"]
        assert len(lit) > 5
        assert lit == sorted(lit, reverse=True), "the further, the darker"
    listed = re.findall(r"`((?:include|lib|share)/[\w./]+)`", page.read_text(encoding="utf-8"))
    assert len(listed) >= 6
    for name in listed:
        assert (prefix / name).exists(), name


@pytest.fixture
def example(tmp_path: Path) -> Path:
    """Return a copy of the example in C, in a folder with a space."""
    return Path(shutil.copytree(REPOSITORY / "examples/c", tmp_path / "an example"))


@pytest.fixture(scope="module")
def irradiance() -> str:
    """Return what the examples print: the irradiance of their light, by a formula of its own."""
    program = (
        "import numpy as np\nfrom renderlab.irradiance import projected_solid_angle\n"
        "value = projected_solid_angle(np.array([0, 0, 1]), np.array([3, 0, 0.5]), 1)\n"
        "print(f'irradiance {10 * value:.4f}')"
    )
    return run(sys.executable, "-c", program, folder=REPOSITORY, PYTHONPATH=str(REPOSITORY / "tools"))


def test_the_example_with_pkg_config(prefix: Path, example: Path, irradiance: str) -> None:
    """By its Makefile."""
    run("make", folder=example, PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig"), CFLAGS="-Wall -Wextra -Werror")
    assert run(example / "light", folder=example, LD_LIBRARY_PATH=str(prefix / "lib")) == irradiance


def test_the_example_with_cmake(prefix: Path, example: Path, irradiance: str) -> None:
    """By its CMakeLists.txt."""
    run("cmake", "-G", "Ninja", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", folder=example)
    run("cmake", "--build", "build", folder=example)
    assert run(example / "build/light", folder=example) == irradiance


def test_the_example_in_rust(irradiance: str) -> None:
    """By the command that it names."""
    (command,) = re.findall("`(cargo run [^`]*)`", (REPOSITORY / "examples/light.rs").read_text())
    assert run(*command.split(), "--locked", folder=REPOSITORY) == irradiance


def test_the_example_in_mitsuba(irradiance: str) -> None:
    """With the package that `make build` has completed."""
    package = {"PYTHONPATH": str(REPOSITORY / "mitsuba_plugin")}
    assert run(sys.executable, "examples/light.py", folder=REPOSITORY, **package) == irradiance


def test_the_readmes_lines_in_c(prefix: Path, tmp_path: Path) -> None:
    """They are part of a function."""
    (lines,) = blocks(REPOSITORY / "README.md", "c")
    program = "#include <spherecap.h>\nint main(void) {\nfloat u0 = 0.25f, u1 = 0.75f;\n"
    program += lines + "return !(status == SPHERECAP_STATUS_OK && sample.density.solid_angle > 0);\n}\n"
    (tmp_path / "program.c").write_text(program)
    flags = pkg_config(prefix, "--cflags", "--libs", "--static")
    run(CC, "-std=c99", "-Wall", "-Werror", "-static", "program.c", *flags, "-o", "program", folder=tmp_path)
    run(tmp_path / "program", folder=tmp_path)


def in_double_precision(program: str) -> str:
    """Return a program with `double` for `float`, and the names that go with it."""
    program = re.sub(r"\b(spherecap_(?!status)\w+?)(_t)?\b(?=[ (])", r"\1_f64\2", program)
    program = re.sub(r"\b(fabs|fmax|fmin|sqrt|cos|sin)f\b", r"\1", program)
    return re.sub(r"\bfloat\b", "double", program)


@pytest.mark.parametrize("precision", ["single", "double"])
@pytest.mark.parametrize(("compiler", "standard", "source"), [
    (CC, "-std=c99", "porting.c"), (os.environ.get("CXX", "c++"), "-std=c++17", "porting.cpp")
])  # fmt: skip
def test_the_page_on_porting(
    prefix: Path, tmp_path: Path, compiler: str, standard: str, source: str, precision: str
) -> None:
    """Its functions, in a host that checks what they give; and its numbers."""
    page = REPOSITORY / "docs/porting.md"
    functions = blocks(page, "c")
    assert len(functions) >= 7
    change = in_double_precision if precision == "double" else str
    (tmp_path / "porting.h").write_text(change("\n".join(functions)))
    (tmp_path / source).write_text(change((REPOSITORY / "tests/install/porting.c").read_text()))
    flags = pkg_config(prefix, "--cflags", "--libs", "--static")
    warnings = ("-pedantic", "-Wall", "-Wextra", "-Werror", "-Wl,--fatal-warnings")
    options = (standard, "-O2", *warnings, "-static", "-I.")
    run(compiler, *options, source, *flags, "-o", "program", folder=tmp_path)
    run(tmp_path / "program", folder=tmp_path)


def test_a_plugin_by_somebody_else(tmp_path: Path) -> None:
    """What docs/mitsuba_plugins.md shows, as it stands, where the package spherecap is installed."""
    page = REPOSITORY / "docs/mitsuba_plugins.md"
    folder = tmp_path / "a plugin"
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(blocks(page, "cmake")[0])
    (folder / "stripes.cpp").write_text(blocks(page, "cpp")[0])
    install, build = blocks(page, "sh")
    pins = (REPOSITORY / "requirements.txt").read_text().split()
    for package in install.split()[2:]:
        assert package in pins, "the page names the versions that are tested"
    package = {"PYTHONPATH": str(REPOSITORY / "mitsuba_plugin")}
    run("sh", "-ec", build, folder=folder, CMAKE_GENERATOR="Ninja", CMAKE_BUILD_PARALLEL_LEVEL="2", **package)
    program = (
        blocks(page, "python")[0]
        + """
for variant in ("scalar_rgb", "llvm_ad_spectral"):
    mi.set_variant(variant)
    texture = mi.load_dict({"type": "stripes", "count": 8.0})
    si = mi.SurfaceInteraction3f()
    for x, expected in ((0.01, 1), (0.07, 0), (0.13, 1)):
        si.uv = mi.Point2f(x, 0)
        assert float(texture.eval_1(si).array[0] if "llvm" in variant else texture.eval_1(si)) == expected
"""
    )
    # The package tells Dr.Jit where LLVM is.
    run(sys.executable, "-c", "import spherecap\n" + program, folder=folder, **package)
    symbols = run("readelf", "-W", "--dyn-syms", "plugins/stripes.so", folder=folder).splitlines()
    exported = [s for s in map(str.split, symbols) if len(s) >= 8 and s[4] == "GLOBAL" and s[6] != "UND"]
    assert [s[7] for s in exported] == ["init_plugin"]
