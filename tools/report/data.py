"""What the figures are drawn from, with what it takes to repeat it."""

import json
import platform
import subprocess
from datetime import datetime, timezone
from pathlib import Path

from renderlab.scenes import REPOSITORY
from spherecap_command.errors import UserError


def read(folder: Path, name: str) -> dict:
    """Return the JSON that one of the Rust programs wrote, or say which command writes it."""
    file = folder / f"{name}.json"
    if not file.exists():
        raise UserError(f"{file} is missing: run `make out/{name}.json`")
    return json.loads(file.read_text())


def about(command: str, seed: str) -> dict[str, str]:
    """Return machine, commit, command, seed and date, under the names that the Rust programs use."""
    git = subprocess.run(
        ["git", "describe", "--always", "--dirty", "--abbrev=40"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
    )
    return {
        "machine": machine(),
        "commit": git.stdout.strip() or "unknown",
        "command": command,
        "seed": seed,
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
    }


def machine() -> str:
    """Return the name of the CPU."""
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text().splitlines() if cpuinfo.exists() else []
    names = [line.partition(": ")[2] for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or "unknown"


def rows_by(rows: list[dict], *keys: str) -> dict[tuple, dict]:
    """Return rows by the values of some of their columns."""
    return {tuple(row[key] for key in keys): row for row in rows}
