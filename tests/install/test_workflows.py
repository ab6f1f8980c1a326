"""The workflows are such files as GitHub takes, and call this project's own make targets."""

import re
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((REPOSITORY / ".github/workflows").glob("*"))


def problems(*files: Path) -> str:
    """Return what the schema, which the checker brings along, has against workflows, if anything."""
    checker = (sys.executable, "-m", "check_jsonschema", "--builtin-schema", "vendor.github-workflows")
    done = subprocess.run([*checker, *files], capture_output=True, text=True, check=False)
    return done.stdout + done.stderr if done.returncode else ""


def test_they_follow_the_schema(tmp_path: Path) -> None:
    """And a misspelt word does not."""
    assert WORKFLOWS
    assert not problems(*WORKFLOWS)
    wrong = tmp_path / "wrong.yml"
    wrong.write_text(WORKFLOWS[0].read_text().replace("runs-on", "runs-at"))
    assert "runs-at" in problems(wrong)


def test_they_call_targets_of_make() -> None:
    """What a workflow does can be done by hand; besides, Rust is installed and files are moved."""
    targets = re.findall(r"^([a-z0-9-]+):", (REPOSITORY / "Makefile").read_text(), re.MULTILINE)
    called = set()
    for path in WORKFLOWS:
        text = path.read_text()
        lines = re.findall(r"^ +- run: (\w.*)$", text, re.MULTILINE)
        assert len(lines) == text.count("run:")
        for line in lines:
            word, *rest = line.split()
            assert word in ("make", "rustup", "curl", "echo", "gh"), f"{path.name}: {line}"
            if word == "make":
                called.add(rest[0])
    assert {"test", "msrv", "aarch64", "wheel"} <= called <= set(targets)
