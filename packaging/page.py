"""The package's page on PyPI, for pyproject.toml: addresses, and the README with links that work there."""

import re
from pathlib import Path

#: What a page shows, and so wants as a file, not as a page about the file.
PICTURES = (".png", ".svg")


def dynamic_metadata(settings: dict, project: dict) -> dict:
    """Return `project.readme` and `project.urls`; scikit-build-core calls it."""
    manifest = Path("Cargo.toml").read_text(encoding="utf-8")
    repository = re.search(r'^repository = "(.*)"$', manifest, re.MULTILINE)[1]
    tag = f"v{project['version']}"

    def absolute(link: re.Match[str]) -> str:
        before, path, after = link.groups()
        return f"{before}{repository}/{'raw' if path.endswith(PICTURES) else 'blob'}/{tag}/{path}{after}"

    text = Path("README.md").read_text(encoding="utf-8")
    for before, after in ((r"\]\(\s*", r"\s*\)"), (r"(?:src|href)=\"", r"\"")):
        text = re.sub(rf"({before})(?!https?:|#)([^)\s\"]+)({after})", absolute, text)
    return {
        "readme": {"content-type": "text/markdown", "text": text},
        "urls": {
            "Repository": repository,
            "Documentation": f"{repository}/blob/{tag}/docs/mitsuba.md",
            "Changelog": f"{repository}/blob/{tag}/CHANGELOG.md",
            "Issues": f"{repository}/issues",
        },
    }
