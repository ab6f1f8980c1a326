"""docs/speed.md, its pictures and the README are what was measured, and the kernels are those that were."""

import json
import re

import pytest
from renderlab.scenes import REPOSITORY

from report.speed_page import MEASURED, PAGE, block, files, kernels, page


@pytest.fixture
def measured() -> dict:
    """What `make speed` measured."""
    return json.loads((REPOSITORY / MEASURED).read_text())


def test_the_kernels_are_those_that_were_measured(measured: dict) -> None:
    """Who changes a formula, or how many operations it is, has all times measured again."""
    assert measured["kernels"] == kernels(), (
        "docs/speed.md was measured on other kernels: run `make speed`, with nothing else running"
    )


def test_the_pages_are_what_was_measured(measured: dict) -> None:
    """Text and pictures, to the byte."""
    for path, text in files(measured).items():
        assert (REPOSITORY / path).read_text() == text, f"{path} is stale: run `make speed-page`"


def test_the_pictures_are_small(measured: dict) -> None:
    """They are part of every clone."""
    pictures = [path for path in files(measured) if path.suffix == ".svg"]
    assert len(pictures) == 3
    assert sum((REPOSITORY / path).stat().st_size for path in pictures) < 300_000
    text = (REPOSITORY / PAGE).read_text()
    for path in pictures:
        assert f"]({path.relative_to(PAGE.parent)})" in text


def test_numbers_are_those_that_were_measured(measured: dict) -> None:
    """One of each kind, found again on the page and in the README."""
    (row,) = (
        row
        for row in measured["bench"]["rows"]
        if (row["set"], row["lane"], row["method"]) == ("mix", "f32", "published, cube root")
        and row["task"] == "prepare + 1 sample"
    )
    row["nanoseconds"] = 1234.5
    measured["lights"]["rows"][-1]["all"] = 0.125
    assert measured["lights"]["rows"][-1]["scene"] == "wall"
    for text in (page(measured), block(measured)):
        assert re.search(r"our cube root \| 1234\.5 \|", text)
        assert "takes 8.00 times as long as `area`" in text
