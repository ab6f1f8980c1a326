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

import math
import os
from collections.abc import Sequence
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

__all__ = ["BUILT_FOR", "PLUGIN", "register", "sun"]

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


# How far away a sun is, in radii of the scene's bounding sphere. Over the scene the direction towards it then
# changes by 1e-6, and its irradiance by twice that.
_SUN_DISTANCE = 1e6


def sun(
    direction: Sequence[float],
    angular_diameter: float,
    irradiance: float | Sequence[float],
    scene: "mitsuba.Scene",
) -> dict:
    """Return a light that stands for a sun: a far sphere, as a dictionary for ``mitsuba.load_dict``.

    direction: towards the sun, of any length. angular_diameter: how large it is seen, in degrees, from 1e-4
    to 179 (that of the Earth's sun is .533). irradiance: of a plane that faces it, power per unit area: a
    number, or three for red, green and blue. scene: what it shall light, loaded without it::

        world = {"type": "scene", ...}
        world["sun"] = spherecap.sun([1, 0, 2], 0.533, 1000, mitsuba.load_dict(world))

    The sphere is a million times as far away as the scene is large, and illuminates it alike everywhere, to
    2e-6 of the irradiance. A camera sees it if its ``far_clip`` is further away still. Raises ValueError for
    other values than these, and for a scene without shapes.
    """
    length = math.hypot(*direction)
    if len(direction) != 3 or not 0 < length < math.inf:
        raise ValueError(f"The direction towards the sun is three numbers, not all 0; not {list(direction)}.")
    if not 1e-4 <= angular_diameter <= 179:
        raise ValueError(f"A sun is seen 1e-4 to 179 degrees large, not {angular_diameter}.")
    colour = [float(value) for value in (irradiance if hasattr(irradiance, "__len__") else [irradiance])]
    if len(colour) not in (1, 3) or not all(0 <= value < math.inf for value in colour):
        raise ValueError(f"The irradiance of a sun is one number from 0, or three, not {irradiance}.")
    box = scene.bbox()
    if not box.valid():
        raise ValueError("The scene has no shapes that a sun could light: load it with them.")
    distance = _SUN_DISTANCE * float(box.bounding_sphere().radius)
    sine = math.sin(math.radians(angular_diameter / 2))
    # A sphere of radiance L gives a plane that faces it the irradiance pi L sin^2.
    radiance = [value / (math.pi * sine * sine) for value in colour]
    return {
        "type": "sphere",
        "center": [
            float(m) + distance * float(d) / length for m, d in zip(box.center(), direction, strict=True)
        ],
        "radius": distance * sine,
        "emitter": {
            "type": "spherecap",
            "radiance": {"type": "rgb", "value": radiance if len(radiance) == 3 else radiance[0]},
        },
    }


register()
