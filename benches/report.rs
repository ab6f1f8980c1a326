//! What was measured, as a table.

use std::fmt::Write;

/// One figure: the median time of a call, and its ratio to the same call of `solid_angle` in scalar f32 (the median of the ratios
/// within rounds).
pub struct Row {
    /// The set of caps.
    pub set: &'static str,
    /// "f32" or "f64", or the instructions of a batch.
    pub lane: String,
    pub method: &'static str,
    pub task: &'static str,
    pub nanoseconds: f64,
    pub ratio: f64,
}

/// A set's rows as a table: a line for each lane and method, a column for each task.
pub fn table(rows: &[Row], tasks: &[&str]) -> String {
    let mut table = format!("{}: nanoseconds (ratio to solid_angle, f32)\n{:30}", rows[0].set, "");
    tasks.iter().for_each(|task| write!(table, "{task:>22}").expect("memory suffices"));
    for line in rows.chunk_by(|a, b| (&a.lane, a.method) == (&b.lane, b.method)) {
        write!(table, "\n{:<10}{:<20}", line[0].lane, line[0].method).expect("memory suffices");
        for task in tasks {
            let cell = line.iter().find(|row| row.task == *task);
            let cell = cell.map(|row| format!("{:.1} ({:.2})", row.nanoseconds, row.ratio));
            write!(table, "{:>22}", cell.unwrap_or_default()).expect("memory suffices");
        }
    }
    table + "\n"
}
