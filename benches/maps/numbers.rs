//! Numbers as JSON.

/// A JSON array of numbers; what is not finite is null.
pub fn numbers(values: impl Iterator<Item = f64>) -> String {
    let text = |x: f64| if x.is_finite() { format!("{x:.6e}") } else { "null".into() };
    format!("[{}]", values.map(text).collect::<Vec<_>>().join(","))
}
