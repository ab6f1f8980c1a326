"""`python -m fits` writes src/fits.rs anew; with --check it compares what it would write to what is there."""

import argparse
import sys

from fits import rust
from fits.crescent import REPRODUCIBLE


def differences(new, old):
    """What differs between two source files, in words; nothing if they are the same.

    The polynomials of one variable are made in multiple precision, which is the same on every machine: they,
    and all else, must agree to the letter. The crescent's table is made in binary64 by a linear algebra
    library that sums in an order of its own, and may differ a little.
    """
    new_table, new_rest = rust.crescent_table(new)
    old_table, old_rest = rust.crescent_table(old)
    if new_rest != old_rest:
        lines = zip(new_rest.splitlines(), old_rest.splitlines(), strict=False)
        unlike = next(((a, b) for a, b in lines if a != b), ("the end", "the end"))
        yield f"first differing lines, as made and as found:\n  {unlike[0].strip()}\n  {unlike[1].strip()}"
    if new_table.keys() != old_table.keys():
        yield f"CRESCENT's terms differ: {sorted(new_table.keys() ^ old_table.keys())}"
    else:
        term = max(new_table, key=lambda term: abs(new_table[term] - old_table[term]))
        if abs(new_table[term] - old_table[term]) > REPRODUCIBLE:
            yield f"CRESCENT's term {term} is made as {new_table[term]}, found as {old_table[term]}"


def main():
    """Write or check."""
    parser = argparse.ArgumentParser(prog="python -m fits", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only compare; exit status 1 if different")
    arguments = parser.parse_args()
    new = rust.source()
    if not arguments.check:
        rust.PATH.write_text(new)
        return
    found = list(differences(new, rust.PATH.read_text()))
    if found:
        sys.exit("\n".join(["src/fits.rs is not what `python -m fits` makes:", *found]))


if __name__ == "__main__":
    main()
