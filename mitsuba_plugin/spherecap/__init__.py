"""Makes the emitter ``spherecap`` known to Mitsuba 3, in every variant::

    import spherecap
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}})

The import appends this folder, with the plugin in ``plugins/spherecap.so``, to Mitsuba's search path; nothing
is copied. For the ``mitsuba`` command the same is done by ``-a <this folder>``.

The ``llvm_*`` variants need a shared library of LLVM. If the package ``karellen-llvm-core`` is installed and
the environment does not say otherwise (``DRJIT_LIBLLVM_PATH``), its library is used. Dr.Jit looks for it when
it is imported: for that, ``spherecap`` must come before ``mitsuba``. For all else the order does not matter.
"""

import os
from importlib import metadata
from pathlib import Path


def _offer_llvm() -> None:
    """Tell Dr.Jit where the LLVM of this Python environment is, unless the user has told it."""
    if "DRJIT_LIBLLVM_PATH" in os.environ:
        return
    try:
        package = metadata.distribution("karellen-llvm-core")
    except metadata.PackageNotFoundError:
        return  # Dr.Jit looks for one of the system's
    # "libLLVM.so.23.1"; other names of the file are links or depend on it.
    for file in package.files or ():
        if file.name.startswith("libLLVM.so."):
            os.environ["DRJIT_LIBLLVM_PATH"] = str(Path(package.locate_file(file)).resolve())


_offer_llvm()

import mitsuba  # noqa: E402 (which loads LLVM)

__all__ = ["BUILT_FOR", "PLUGIN", "register"]

_FOLDER = Path(__file__).resolve().parent

#: The file that Mitsuba loads.
PLUGIN = _FOLDER / "plugins" / "spherecap.so"


def _about(plugin: Path) -> tuple[str, str]:
    """Which Mitsuba a plugin was compiled for, and what to do elsewhere.

    The plugin itself carries both, so that it cannot disagree.
    """
    if not plugin.is_file():
        raise ImportError(f"The spherecap plugin is not built, {plugin} is missing: run 'make build'.")
    mark = b"spherecap plugin for Mitsuba "
    _, found, rest = plugin.read_bytes().partition(mark)
    if not found:
        raise ImportError(f"{plugin} is not the spherecap plugin: build it again ('make build').")
    version, remedy = rest.split(b"\0", 2)[:2]
    return version.decode(), remedy.decode()


#: The version of Mitsuba that the plugin was compiled for.
BUILT_FOR, _REMEDY = _about(PLUGIN)


def register() -> None:
    """Add the plugin's folder to Mitsuba's search path.

    Done on import; to be done again after ``mi.set_file_resolver``. Raises ImportError if the plugin was
    built for another version of Mitsuba.
    """
    if mitsuba.__version__ != BUILT_FOR:
        raise ImportError(
            f"The spherecap plugin was built for Mitsuba {BUILT_FOR}, but this is Mitsuba "
            f"{mitsuba.__version__}: {_REMEDY}"
        )
    resolver = mitsuba.file_resolver()
    if str(_FOLDER) not in map(str, resolver):
        resolver.append(str(_FOLDER))


register()
