"""What the Python package depends on, for pyproject.toml: just the Mitsuba that the plugin is built for."""

from importlib import metadata


def dynamic_metadata(settings: dict, project: dict) -> dict[str, list[str]]:
    """Return `project.dependencies`; scikit-build-core calls it."""
    try:
        mitsuba = metadata.version("mitsuba")
    except metadata.PackageNotFoundError:
        raise SystemExit(
            "There is no Mitsuba here to build spherecap for: install one (docs/mitsuba.md says how), "
            "or leave out --no-build-isolation."
        ) from None
    return {"dependencies": [f"mitsuba=={mitsuba}", "numpy", "tqdm"]}
