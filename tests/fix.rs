//! `psdl fix` as a user meets it: what it writes, what it leaves alone, and how it ends.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// A table that stands half a metre outside, in a room of 6 × 6 × 3.
const OUTSIDE: &str = "table = Object('Table', 1.0, 1.0, 1.0)\ntable.max.x = scene.max.x + 0.5\ntable.center.y = 0.0\n";
const INSIDE: &str = "table = Object('Table', 1.0, 1.0, 1.0)\ntable.max.x = scene.max.x + 0.0\ntable.center.y = 0.0\n";

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("a file");
    }
    folder
}

fn fix(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
    command.current_dir(folder).arg("fix").args(args).stdin(Stdio::null()).output().expect("psdl runs")
}

fn status(output: &Output) -> i32 {
    output.status.code().expect("an exit status")
}

fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn read(folder: &tempfile::TempDir, name: &str) -> String {
    std::fs::read_to_string(folder.path().join(name)).expect("a text")
}

#[test]
fn a_diff_is_shown_and_nothing_is_written() {
    let folder = folder(&[("a.psdl", OUTSIDE)]);
    let done = fix(folder.path(), &["a.psdl"]);
    assert_eq!(status(&done), 0, "{}", err(&done));
    let text = out(&done);
    assert!(text.contains("-table.max.x = scene.max.x + 0.5\n+table.max.x = scene.max.x + 0.0\n"), "{text}");
    assert!(text.contains("a.psdl:2: 0.5 → 0.0 clears 1 error and moves 1 object"), "{text}");
    assert_eq!(read(&folder, "a.psdl"), OUTSIDE);
}

#[test]
fn what_is_written_keeps_line_ends_the_mark_and_the_permissions() {
    let before = format!("\u{feff}{}", OUTSIDE.replace('\n', "\r\n"));
    let folder = folder(&[("a.psdl", &before)]);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let path = folder.path().join("a.psdl");
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o640)).expect("own file");
        assert_eq!(status(&fix(folder.path(), &["--write", "a.psdl"])), 0);
        assert_eq!(std::fs::metadata(&path).expect("the file").permissions().mode() & 0o777, 0o640);
    }
    #[cfg(not(unix))]
    assert_eq!(status(&fix(folder.path(), &["--write", "a.psdl"])), 0);
    assert_eq!(read(&folder, "a.psdl"), format!("\u{feff}{}", INSIDE.replace('\n', "\r\n")));
}

#[test]
fn the_corrected_program_can_be_printed() {
    let folder = folder(&[("a.psdl", OUTSIDE), ("b.psdl", OUTSIDE)]);
    assert_eq!(out(&fix(folder.path(), &["--stdout", "a.psdl"])), INSIDE);
    assert_eq!(status(&fix(folder.path(), &["--stdout", "a.psdl", "b.psdl"])), 2);
}

#[test]
fn json_tells_everything() {
    let folder = folder(&[("a.psdl", OUTSIDE)]);
    let done = fix(folder.path(), &["--format", "json", "--edits", "elementary", "a.psdl"]);
    let json: Value = serde_json::from_str(&out(&done)).expect("JSON");
    let file = &json["files"][0];
    assert_eq!((&file["errors"]["before"], &file["errors"]["after"], &file["objects_moved"]), (&1.into(), &0.into(), &1.into()));
    let edit = &file["edits"][0];
    assert_eq!((edit["old"].as_str(), edit["new"].as_str(), edit["line"].as_u64()), (Some("0.5"), Some("0.0"), Some(2)));
    let range = edit["start"].as_u64().zip(edit["end"].as_u64()).expect("a range");
    assert_eq!(&OUTSIDE[range.0 as usize..range.1 as usize], "0.5");
    assert!((file["displacement"].as_f64().expect("metres") - 0.5).abs() < 0.02);
    assert!(file["evaluations"].as_u64() >= file["replays"].as_u64().map(|replays| replays.min(1)));
    assert_eq!(file["written"], false);
}

#[test]
fn errors_that_are_left_and_programs_that_cannot_run_show_in_the_exit_status() {
    let stuck = "box = Object('Box', 9, 1, 1)\nbox.center.x = 0\nbox.center.y = 0\n";
    let folder = folder(&[("stuck.psdl", stuck), ("broken.psdl", "x = = 1\n"), ("ok.psdl", OUTSIDE)]);
    assert_eq!(status(&fix(folder.path(), &["stuck.psdl"])), 1);
    let done = fix(folder.path(), &["--write", "."]);
    assert_eq!(status(&done), 2);
    assert!(err(&done).contains("broken.psdl: what has errors cannot be run"), "{}", err(&done));
    assert_eq!(read(&folder, "ok.psdl"), INSIDE, "the others are corrected all the same");
    assert_eq!(status(&fix(folder.path(), &["missing.psdl"])), 2);
}

#[test]
fn a_program_that_raises_is_corrected_for_what_runs() {
    let folder = folder(&[("a.psdl", &format!("{OUTSIDE}print(1 / 0)\n"))]);
    let done = fix(folder.path(), &["--write", "a.psdl"]);
    assert_eq!(status(&done), 1);
    assert!(out(&done).contains("1 statement raised; only what ran was corrected"), "{}", out(&done));
    assert_eq!(read(&folder, "a.psdl"), format!("{INSIDE}print(1 / 0)\n"));
}

#[test]
fn kinds_lines_and_the_number_of_edits_can_be_limited() {
    let folder = folder(&[("a.psdl", OUTSIDE)]);
    let unchanged = |args: &[&str]| out(&fix(folder.path(), &[args, &["--stdout", "a.psdl"]].concat())) == OUTSIDE;
    assert!(unchanged(&["--only", "overlap"]) && unchanged(&["--lines", "3-3"]) && unchanged(&["--max-edits", "0"]));
    assert!(unchanged(&["--budget", "0"]));
    assert!(!unchanged(&["--only", "out-of-bounds", "--lines", "2", "--max-edits", "1", "--method", "paper", "--seed", "3"]));
}

#[test]
fn the_configuration_is_that_of_check() {
    let configuration = "exclude = [\"skipped.psdl\"]\n\n[check]\nweights.out-of-bounds = 0\n";
    let folder = folder(&[("a.psdl", OUTSIDE), ("skipped.psdl", OUTSIDE), ("psdl.toml", configuration)]);
    let done = fix(folder.path(), &["."]);
    assert_eq!(status(&done), 0, "{}", err(&done));
    assert_eq!(out(&done), "a.psdl: 0 errors before, 0 after 0 edits\n");
    assert!(out(&fix(folder.path(), &["--no-config", "."])).contains("skipped.psdl: 1 error before, 0 after 1 edit"));
}
