"""Every public item of the crate is shown in use: it appears in an example, and examples are doctests."""

import html
import re
import subprocess
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[1]


def test_every_public_item_is_in_a_doctest() -> None:
    """Asked of the pages that rustdoc makes: each page is an item, and lists its methods."""
    subprocess.run(["make", "doc"], cwd=REPOSITORY, check=True)
    items, methods, examples = set(), set(), ""
    for path in (REPOSITORY / "target/doc/spherecap").rglob("*.*.html"):
        page = path.read_text(encoding="utf-8")
        items.add(path.name.split(".")[1])
        # What follows implements traits, which have pages of their own or are of other crates.
        own = re.split(
            'id="(?:(?:trait|synthetic|blanket)-implementations|foreign-impls|implementors)"', page
        )[0]
        methods |= set(re.findall(r'id="(?:ty)?method\.(\w+)"', own))
    for path in (REPOSITORY / "target/doc/spherecap").rglob("*.html"):
        code = re.findall(r'<pre class="rust rust-example-rendered">(.*?)</pre>', path.read_text(), re.DOTALL)
        examples += html.unescape(re.sub("<.*?>", "", "\n".join(code)))
    assert {"Batch", "Lane", "Technique", "lit", "UNIT_TOLERANCE"} <= items
    assert {"sample", "pdf_on_sphere", "widest", "float_of_bits"} <= methods
    missing = {item for item in items if not re.search(rf"\b{item}\b", examples)}
    missing |= {method for method in methods if not re.search(rf"[.:]{method}\b", examples)}
    assert not missing, "these are in no doctest"
