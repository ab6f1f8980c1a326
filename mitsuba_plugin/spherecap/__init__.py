"""Makes the emitter ``spherecap`` known to Mitsuba 3, in every variant::

    import mitsuba as mi
    import spherecap

    mi.set_variant("scalar_rgb")  # before or after the import
    mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}})

The import appends this folder, with the plugin in ``plugins/spherecap.so``, to Mitsuba's search path; nothing
is copied. For the ``mitsuba`` command the same is done by ``-a <this folder>``.
"""

from pathlib import Path

import mitsuba

__all__ = ["PLUGIN", "register"]

_FOLDER = Path(__file__).resolve().parent

#: The file that Mitsuba loads.
PLUGIN = _FOLDER / "plugins" / "spherecap.so"


def _built_for(plugin: Path) -> str:
    """Which Mitsuba a plugin was compiled for. The plugin itself carries it, so the two cannot disagree."""
    mark = b"spherecap plugin for Mitsuba "
    _, found, rest = plugin.read_bytes().partition(mark)
    if not found:
        raise ImportError(f"{plugin} is not the spherecap plugin: build it again ('make build').")
    return rest.partition(b"\0")[0].decode()


def register() -> None:
    """Add the plugin's folder to Mitsuba's search path.

    Done on import; to be done again after ``mi.set_file_resolver``. Raises ImportError if the plugin was not
    built, or was built for another version of Mitsuba.
    """
    if not PLUGIN.is_file():
        raise ImportError(f"The spherecap plugin is not built, {PLUGIN} is missing: run 'make build'.")
    version = _built_for(PLUGIN)
    if mitsuba.__version__ != version:
        raise ImportError(
            f"The spherecap plugin was built for Mitsuba {version}, but this is Mitsuba "
            f"{mitsuba.__version__}: install mitsuba=={version}, or build the plugin again ('make build')."
        )
    resolver = mitsuba.file_resolver()
    if str(_FOLDER) not in map(str, resolver):
        resolver.append(str(_FOLDER))


register()
