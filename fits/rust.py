"""Write the constants as a Rust source file, and read the numbers of such a file."""

import ast
import math
import re
import subprocess
from pathlib import Path

import numpy as np

from fits import crescent, segment

ROOT = Path(__file__).resolve().parent.parent
PATH = ROOT / "src" / "fits.rs"

HEADER = """\
//! The fitted constants, made by `python -m fits`: do not edit.
//!
//! `fits/README.md` says how. All errors below are the worst ones on dense grids, of exact arithmetic with
//! the rounded coefficients: rounding in a polynomial's evaluation comes on top.

/// Polynomials for one precision; each has its coefficients in ascending order.
///
/// ```
/// use spherecap::{Fits, Lane};
///
/// let [single, double]: [Fits; 2] = [f32::FITS, f64::FITS];
/// assert!(single.shape.len() < double.shape.len());
/// ```
pub struct Fits {
    /// H(x) = (a - sin a cos a) / sin^3 a with a = acos x, for x in [0, 1], in powers of x - 1/2. Best in the
    /// relative error of d/dx (x H), which bounds the relative errors of H and of
    /// H(t) + e (H(t) - H(e)) / (t - e).
    pub shape: &'static [f64],
    /// A(h) = (segment(h) / c)^(2/3) / h with c = 4 sqrt(2) / 3, for h in [0, 1], in powers of h: the area of
    /// the segment of height h of the unit disk is c (h A)^(3/2). Best in the relative error.
    pub area: &'static [f64],
    /// P(k) = h / k, the inverse of k = h A(h), for h in [0, 1], in powers of k. Best in the relative error
    /// of the density of segments' heights h = k P(k) that samples with a uniform k^(3/2) have.
    pub height: &'static [f64],
    /// R(r) = ((1 - r)^(-1/3) - 1) / r, for |r| <= 0.1021, in powers of r. Best in the relative error of
    /// 1 + r R(r).
    pub root: &'static [f64],
}
"""

SET = """
/// For `{precision}`: each decimal is the shortest that reads as the number of that type that is meant.
///
/// Worst errors: shape {shape}, area {area}, height {height}, root {root}.
pub const {name}: Fits = Fits {{
    shape: &[{shape_coefficients}],
    area: &[{area_coefficients}],
    height: &[{height_coefficients}],
    root: &[{root_coefficients}],
}};
"""

CRESCENT = """
/// The marginal of a crescent, in both precisions: `CRESCENT[j][a][b]` is the coefficient of rho^a y^b in
/// beta_j, with V = sqrt(1 - u^2), which is u_bar in docs/mathematics.md, and
///
/// B(V) = B0 + (B1 - B0) V + rho V (1 - V) (sum over j of beta_j V^j), rho = B1 / B0 - 1, y = 1 - B1.
///
/// Best in the relative error of the density of the slices, for all crescents; worst error: {error}. It has
/// {terms} terms; a zero stands for a term that is not used.
pub const CRESCENT: [&[&[f64]]; {powers}] = [{coefficients}];
"""


def source():
    """The whole file."""
    text = HEADER
    text += _set("SINGLE", "f32", segment.single, _single)
    text += _set("DOUBLE", "f64", segment.double, repr)
    coefficients, error = crescent.fitted()
    powers = 1 + max(j for j, _, _ in coefficients)
    text += CRESCENT.format(
        error=rounded_up(error),
        terms=len(coefficients),
        powers=powers,
        coefficients=", ".join(_table(coefficients, j) for j in range(powers)),
    )
    command = ["rustfmt", "--edition", "2021", "--config-path", ROOT / "rustfmt.toml"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def rounded_up(error):
    """Two digits, rounded up: this makes up for what a dense grid misses of the worst error."""
    unit = 10.0 ** (math.floor(math.log10(error)) - 1)
    return f"{math.ceil(error / unit) * unit:.1e}"


def _set(name, precision, fit, decimal):
    values = {"name": name, "precision": precision}
    for polynomial in ("shape", "area", "height", "root"):
        fitted = fit(polynomial)
        values[polynomial] = rounded_up(fitted.error)
        values[f"{polynomial}_coefficients"] = ", ".join(decimal(c) for c in fitted.coefficients)
    return SET.format(**values)


def _single(value):
    """The shortest decimal that reads as this binary32 number, also if it is read as binary64 first."""
    text = str(np.float32(value))
    assert np.float32(float(text)) == value
    return text


def _table(coefficients, power):
    """Nested arrays, each only as long as its last coefficient needs."""
    terms = {(a, b): c for (j, a, b), c in coefficients.items() if j == power}
    rows = []
    for row in range(1 + max(a for a, _ in terms)):
        length = 1 + max((b for a, b in terms if a == row), default=-1)
        rows.append("&[" + ", ".join(repr(terms.get((row, b), 0.0)) for b in range(length)) + "]")
    return "&[" + ", ".join(rows) + "]"


NUMBER = r"-?\d+\.\d+(?:e-?\d+)?"


def numbers(text, name):
    """The coefficients of one polynomial of a file, such as "SINGLE.shape", as text."""
    constant, field = name.split(".")
    body = re.search(rf"pub const {constant}: .*?{field}: &\[(.*?)\]", text, re.DOTALL)[1]
    return re.findall(NUMBER, body)


def crescent_table(text):
    """The crescent's coefficients in a file, as a dictionary from (j, a, b), and the file without them."""
    start = text.index("= [", text.index("pub const CRESCENT")) + 2
    end = text.index("];", start) + 1
    # Apart from the ampersands, Rust's arrays are Python's lists.
    nested = ast.literal_eval(text[start:end].replace("&", ""))
    table = {
        (j, a, b): value
        for j, rows in enumerate(nested)
        for a, row in enumerate(rows)
        for b, value in enumerate(row)
        if value
    }
    return table, text[:start] + text[end:]


def stated_error(text, name):
    """The worst error that a file states for a polynomial, such as "SINGLE.shape", or for "CRESCENT"."""
    constant, _, field = name.partition(".")
    comment = text[: text.index(f"pub const {constant}")].rpartition("\n\n")[2]
    return float(re.search(rf"{field or 'worst error:'} ({NUMBER})", comment)[1])
