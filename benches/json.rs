//! What was measured, as JSON below `out`, with what it takes to repeat it.

use std::path::Path;
use std::process::Command;
use std::{fs, io};

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
pub fn quoted(text: &str) -> String {
    format!("{:?}", text.replace(|c: char| c.is_control(), " "))
}

/// Writes `out/NAME.json` as a whole or not at all: what it takes to repeat the figures, and the figures (`entries`, keys with JSON).
pub fn write_json(name: &str, command: &str, seed: u64, entries: &[(&str, String)]) -> io::Result<()> {
    let about = [
        ("machine", cpu()),
        ("commit", output("git", &["describe", "--always", "--dirty", "--abbrev=40"])),
        ("compiler", output("rustc", &["--version"])),
        ("command", command.into()),
        ("seed", seed.to_string()),
        ("date", output("date", &["-u", "+%Y-%m-%dT%H:%M:%SZ"])),
    ];
    let about = about.iter().map(|(key, value)| format!("  \"{key}\": {}", quoted(value)));
    let entries = entries.iter().map(|(key, json)| format!("  \"{key}\": {json}"));
    let json = format!("{{\n{}\n}}\n", about.chain(entries).collect::<Vec<_>>().join(",\n"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("out");
    fs::create_dir_all(&folder)?;
    let (draft, file) = (folder.join(format!("{name}.json.new")), folder.join(format!("{name}.json")));
    fs::write(&draft, json)?;
    fs::rename(&draft, &file)
}

/// A JSON array, a line for each entry.
pub fn list(entries: impl Iterator<Item = String>) -> String {
    format!("[\n    {}\n  ]", entries.collect::<Vec<_>>().join(",\n    "))
}
