"""What the Python package depends on, for pyproject.toml: just the Mitsuba that the plugin is built for."""

from importlib import metadata


def dynamic_metadata(field: str, settings: dict) -> list[str]:
    """Return the value of `project.dependencies`."""
    try:
        mitsuba = metadata.version("mitsuba")
    except metadata.PackageNotFoundError:
        raise SystemExit(
            "There is no Mitsuba here to build spherecap for: install one (docs/mitsuba.md says how), "
            "or leave out --no-build-isolation."
        ) from None
    return [f"mitsuba=={mitsuba}", "numpy", "tqdm"]
