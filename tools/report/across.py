"""The comparison with other renderers, if it has been made."""

from pathlib import Path

from cross.page import section as cross_section

from report.page import Section


def section(folder: Path) -> Section:
    """Return what `make cross` found."""
    if not (folder / "results.json").exists():
        body = "<p>Not in this report: <code>make cross</code> has not been run.</p>"
    else:
        body = cross_section(folder)
    return Section("cross", "Across renderers", body)
