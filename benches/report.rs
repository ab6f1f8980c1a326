//! What was measured, as a table and as JSON, with what it takes to repeat it.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::{fs, io};

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

/// What a program prints, or "unknown" where there is no such program.
fn output(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output();
    let text = output.ok().filter(|output| output.status.success()).map(|output| output.stdout);
    text.map_or("unknown".into(), |text| String::from_utf8_lossy(&text).trim().to_owned())
}

fn cpu() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    line.and_then(|line| line.split_once(": ")).map_or("unknown".into(), |(_, name)| name.to_owned())
}

/// A JSON string. (Debug's escapes are JSON's, for what has no control characters.)
fn quoted(text: &str) -> String {
    format!("{:?}", text.replace(|c: char| c.is_control(), " "))
}

/// Writes `out/bench.json` as a whole or not at all.
pub fn write_json(rows: &[Row], seed: u64) -> io::Result<()> {
    let about = [
        ("machine", cpu()),
        ("commit", output("git", &["describe", "--always", "--dirty", "--abbrev=40"])),
        ("compiler", output("rustc", &["--version"])),
        ("command", "make bench".into()),
        ("seed", seed.to_string()),
        ("date", output("date", &["-u", "+%Y-%m-%dT%H:%M:%SZ"])),
    ];
    let about: Vec<_> = about.iter().map(|(key, value)| format!("  \"{key}\": {}", quoted(value))).collect();
    let rows: Vec<_> = rows
        .iter()
        .map(|Row { set, lane, method, task, nanoseconds, ratio }| {
            let [set, lane, method, task] = [set, &**lane, method, task].map(quoted);
            format!(
                "    {{\"set\": {set}, \"lane\": {lane}, \"method\": {method}, \"task\": {task}, \
                 \"nanoseconds\": {nanoseconds:.3}, \"ratio\": {ratio:.4}}}"
            )
        })
        .collect();
    let json = format!("{{\n{},\n  \"rows\": [\n{}\n  ]\n}}\n", about.join(",\n"), rows.join(",\n"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("out");
    fs::create_dir_all(&folder)?;
    let (draft, file) = (folder.join("bench.json.new"), folder.join("bench.json"));
    fs::write(&draft, json)?;
    fs::rename(&draft, &file)
}
