//! The program as people and CI use it: through its arguments, streams and exit status.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const OVERLAP: &str = "a = Object('A', 1, 1, 1)\nb = Object('B', 1, 1, 1)\na.center = (0, 0, 0.5)\nb.center = (0.5, 0, 0.5)\n";
const CLEAN: &str = "a = Object('A', 1, 1, 1)\na.center = (0, 0, 0.5)\n";

fn psdl(folder: &Path, args: &[&str]) -> Output {
    fed(folder, args, b"")
}

fn fed(folder: &Path, args: &[&str], input: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
    command.args(args).current_dir(folder).env_remove("NO_COLOR").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("psdl starts");
    // A command that reads no input closes it.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    child.wait_with_output().expect("psdl ends")
}

fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("psdl was not killed")
}

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("in a folder")).expect("folders can be made");
        std::fs::write(path, text).expect("files can be written");
    }
    folder
}

#[test]
fn the_exit_status_says_what_was_found() {
    let folder = folder(&[("clean.psdl", CLEAN), ("wrong.psdl", OVERLAP), ("note.psdl", &format!("{CLEAN}gap = 0.4\n"))]);
    let status = |args: &[&str]| code(&psdl(folder.path(), args));
    assert_eq!(status(&["check", "clean.psdl"]), 0);
    assert_eq!(status(&["check", "wrong.psdl"]), 1);
    assert_eq!(status(&["check", "."]), 1);
    assert_eq!(status(&["check", "--exit-zero", "."]), 0);
    assert_eq!(status(&["check", "note.psdl"]), 0, "notes never make a run fail");
    assert_eq!(status(&["check", "--ignore", "overlap", "wrong.psdl"]), 0);
    assert_eq!(status(&["check", "--select", "standing,mounted", "wrong.psdl"]), 0);
    assert_eq!(status(&["check", "none.psdl"]), 2);
    assert_eq!(status(&["check"]), 2);
    assert_eq!(status(&["chekc", "clean.psdl"]), 2);
    assert_eq!(status(&[]), 2);
}

#[test]
fn a_finding_underlines_the_statement_to_blame() {
    let folder = folder(&[("wrong.psdl", OVERLAP)]);
    let report = out(&psdl(folder.path(), &["check", "wrong.psdl"]));
    assert!(report.contains("error[overlap]: b overlaps a by 0.50 m\n --> wrong.psdl:4:1\n"), "{report}");
    assert!(report.contains("4 | b.center = (0.5, 0, 0.5)\n  | ^^^^^^^^^^^^^^^^^^^^^^^^\n"), "{report}");
    assert!(report.ends_with("1 error in 1 of 1 file, weighted loss 79\n1 overlap\n"), "{report}");
    assert!(!report.contains('\u{1b}'));
    assert!(out(&psdl(folder.path(), &["check", "--color", "always", "wrong.psdl"])).contains('\u{1b}'));
}

#[test]
fn a_file_that_cannot_be_read_is_reported_and_the_others_are_checked() {
    let folder = folder(&[("a.psdl", OVERLAP), ("z.psdl", OVERLAP)]);
    std::fs::write(folder.path().join("latin.psdl"), b"# \xe9\n").expect("it can be written");
    let output = psdl(folder.path(), &["check", "a.psdl", "none.psdl", "latin.psdl", "z.psdl"]);
    let report = out(&output);
    assert_eq!(code(&output), 2);
    assert_eq!(report.matches("error[overlap]").count(), 2, "{report}");
    assert!(report.contains("error[unreadable]: the file could not be read: "), "{report}");
    assert!(report.contains("error[unreadable]: the file is not UTF-8: the byte at offset 2"), "{report}");
    assert!(report.contains(" --> latin.psdl:1:3"), "{report}");
}

#[test]
fn the_order_is_that_of_the_names_whatever_ends_first() {
    let names: Vec<String> = (0..600).map(|n| format!("d{}/s{n:03}.psdl", n % 7)).collect();
    let files: Vec<(&str, &str)> =
        names.iter().enumerate().map(|(n, name)| (name.as_str(), if n % 3 == 0 { OVERLAP } else { CLEAN })).collect();
    let folder = folder(&files);
    let report = out(&psdl(folder.path(), &["check", "--format", "jsonl", "."]));
    let lines: Vec<serde_json::Value> = report.lines().map(|line| serde_json::from_str(line).expect("it is JSON")).collect();
    let paths: Vec<&str> = lines.iter().filter_map(|line| line["path"].as_str()).collect();
    let mut sorted = paths.clone();
    sorted.sort_unstable();
    assert_eq!(paths.len(), 200);
    assert_eq!(paths, sorted);
    assert_eq!(lines.last().expect("a summary")["files"], 600);
}

#[test]
fn every_format_is_written() {
    let folder = folder(&[("a.psdl", OVERLAP), ("b.psdl", CLEAN), ("c.psdl", OVERLAP)]);
    for format in ["text", "json", "jsonl", "sarif", "github", "gitlab", "junit"] {
        let output = psdl(folder.path(), &["check", "--format", format, "."]);
        assert_eq!(code(&output), 1, "{format}");
        assert!(out(&output).matches("overlaps a by").count() > 1, "{format}");
        assert!(err(&output).is_empty(), "{format}");
    }
    let document: serde_json::Value =
        serde_json::from_slice(&psdl(folder.path(), &["check", "--format", "json", "."]).stdout).expect("JSON");
    assert_eq!(document["files"].as_array().map(Vec::len), Some(2));
    assert_eq!(document["summary"]["files"], 3);
}

#[test]
fn standard_input_is_a_file_with_a_name() {
    let folder = folder(&[(
        "room.template.json",
        r#"{"width": 4, "depth": 4, "height": 3, "objects": [{"id": "a", "name": "A", "width": 9, "depth": 1, "height": 1}]}"#,
    )]);
    let output = fed(folder.path(), &["check", "-"], OVERLAP.as_bytes());
    assert_eq!(code(&output), 1);
    assert!(out(&output).contains(" --> <stdin>:4:1"), "{}", out(&output));
    let output = fed(folder.path(), &["check", "-", "--stdin-filename", "room.psdl"], b"a.center = (0, 0, 0.5)\n");
    assert!(out(&output).contains("error[out-of-bounds]"), "{}", out(&output));
    assert!(out(&output).contains("room.template.json:1:"), "{}", out(&output));
}

#[test]
fn run_prints_as_python_does_and_shows_the_traceback() {
    let program = "def fail(d):\n    return d['b']\n\nprint('one', 1.0)\nfail({'a': 1})\nprint('two')\n";
    let folder = folder(&[("p.py", program)]);
    let output = psdl(folder.path(), &["run", "p.py"]);
    assert_eq!((code(&output), out(&output).as_str()), (1, "one 1.0\n"));
    let traceback = err(&output);
    assert!(traceback.starts_with("Traceback (most recent call last):\n  File \"p.py\", line 5, in <module>\n"), "{traceback}");
    assert!(traceback.contains("  File \"p.py\", line 2, in fail\n    return d['b']\n           ^^^^^^\n"), "{traceback}");
    assert!(traceback.ends_with("KeyError: 'b'\n"), "{traceback}");
    let output = fed(folder.path(), &["run", "-"], b"print(sum(range(5)))");
    assert_eq!((code(&output), out(&output).as_str()), (0, "10\n"));
    assert_eq!(code(&fed(folder.path(), &["run", "-"], b"raise SystemExit")), 0);
    assert_eq!(code(&fed(folder.path(), &["run", "-"], b"print(")), 1);
    assert_eq!(code(&psdl(folder.path(), &["run", "none.py"])), 2);
}

#[test]
fn run_ends_a_loop_without_an_end() {
    let folder = folder(&[]);
    for program in ["while True: pass", "def f(): f()\nf()", "x = [0] * 10**12", "print('a' * 10**12)", "while True: print('x' * 1000)"] {
        let output = fed(folder.path(), &["run", "-"], program.as_bytes());
        assert_eq!(code(&output), 1, "{program}");
        assert!(!err(&output).is_empty(), "{program}");
    }
}

#[test]
fn a_reader_that_goes_away_ends_the_command_quietly() {
    let folder = folder(&[]);
    let program = "for i in range(3000):\n    print('x' * 300)\n";
    let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
    command.args(["run", "-"]).current_dir(folder.path()).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("psdl starts");
    drop(child.stdout.take());
    child.stdin.take().expect("a pipe").write_all(program.as_bytes()).expect("it reads the program");
    let output = child.wait_with_output().expect("psdl ends");
    assert_eq!((code(&output), err(&output).as_str()), (0, ""));
}

#[test]
fn export_writes_the_layout_or_nothing() {
    let folder = folder(&[("a.psdl", OVERLAP), ("bad.psdl", "a = Object('A', 1, 1, 1)\na.center.x = 1 / 0\n")]);
    let output = psdl(folder.path(), &["export", "--to", "layout", "a.psdl"]);
    let layout: serde_json::Value = serde_json::from_slice(&output.stdout).expect("it is JSON");
    assert_eq!(layout["objects"][1]["path"], "b");
    assert_eq!(layout["violations"][0]["kind"], "overlap");
    assert_eq!(code(&psdl(folder.path(), &["export", "--to", "layout", "a.psdl", "-o", "out.json"])), 0);
    assert_eq!(std::fs::read(folder.path().join("out.json")).expect("it was written"), output.stdout);
    let output = psdl(folder.path(), &["export", "--to", "layout", "bad.psdl", "-o", "none.json"]);
    assert_eq!(code(&output), 1);
    assert!(err(&output).contains("ZeroDivisionError"), "{}", err(&output));
    assert!(!folder.path().join("none.json").exists());
}

#[test]
fn explain_knows_every_kind_and_what_was_meant() {
    let folder = folder(&[]);
    let output = psdl(folder.path(), &["explain", "overlap"]);
    assert!(out(&output).starts_with("# overlap\n"), "{}", out(&output));
    assert_eq!(out(&psdl(folder.path(), &["explain"])).lines().count(), psdl::check::codes::all().count());
    let output = psdl(folder.path(), &["explain", "overlpa"]);
    assert_eq!((code(&output), err(&output).contains("did you mean `overlap`?")), (2, true));
}

#[test]
fn the_version_says_what_a_bug_report_needs() {
    let folder = folder(&[]);
    assert_eq!(out(&psdl(folder.path(), &["--version"])), format!("psdl {}\n", env!("CARGO_PKG_VERSION")));
    let verbose = out(&psdl(folder.path(), &["--version", "--verbose"]));
    for line in ["commit: ", "built for: ", "built by: rustc ", "language: Python 3.11"] {
        assert!(verbose.contains(line), "{verbose}");
    }
}

/// Every page of `psdl explain` shows a program that has the finding, and the same program without it.
#[test]
fn the_examples_of_the_findings_have_them() {
    for info in psdl::check::codes::all().filter(|info| !info.example.is_empty()) {
        let mut files = vec![("scene.psdl", info.example)];
        files.extend(info.template.map(|template| ("scene.template.json", template)));
        let codes = |text: &str| {
            let folder = folder(&files);
            std::fs::write(folder.path().join("scene.psdl"), text).expect("it can be written");
            let output = psdl(folder.path(), &["check", "--format", "jsonl", "scene.psdl"]);
            let lines = out(&output).lines().map(|line| serde_json::from_str(line).expect("JSON")).collect::<Vec<serde_json::Value>>();
            let mut codes: Vec<String> = lines.iter().filter_map(|line| line["code"].as_str().map(str::to_string)).collect();
            codes.dedup();
            codes
        };
        assert_eq!(codes(info.example), [info.name], "the example");
        if !info.fixed.is_empty() {
            assert_eq!(codes(info.fixed), [""; 0], "the example of {} without it", info.name);
        }
    }
}

#[test]
fn the_configuration_holds_for_what_stands_below_it() {
    let folder = folder(&[
        ("psdl.toml", "exclude = [\"old/\"]\n[[override]]\npaths = [\"drafts/\"]\nseverity.overlap = \"info\"\n"),
        ("a.psdl", OVERLAP),
        ("drafts/b.psdl", OVERLAP),
        ("old/c.psdl", OVERLAP),
    ]);
    let report = out(&psdl(folder.path(), &["check", "."]));
    assert!(report.contains("error[overlap]") && report.contains("info[overlap]") && !report.contains("old/c.psdl"), "{report}");
    assert_eq!(code(&psdl(folder.path(), &["check", "drafts"])), 0);
    assert_eq!(code(&psdl(folder.path(), &["check", "--no-config", "drafts"])), 1);
    assert_eq!(code(&psdl(folder.path(), &["check", "old/c.psdl"])), 1, "what is named is checked");
    let shown = out(&psdl(folder.path(), &["config", "drafts/b.psdl"]));
    assert!(shown.contains("overlap = \"info\"") && shown.contains("# psdl.toml:4"), "{shown}");
    let schema: serde_json::Value = serde_json::from_slice(&psdl(folder.path(), &["config", "--schema"]).stdout).expect("JSON");
    assert_eq!(schema["title"], "psdl.toml");
}

#[test]
fn a_wrong_configuration_is_shown_at_its_place_and_nothing_is_checked() {
    let folder = folder(&[("psdl.toml", "[check]\ntolerence = 0.1\n"), ("a.psdl", OVERLAP)]);
    for args in [["check", "a.psdl"], ["run", "a.psdl"], ["config", "a.psdl"]] {
        let output = psdl(folder.path(), &args);
        assert_eq!((code(&output), out(&output).as_str()), (2, ""), "{args:?}");
        let report = err(&output);
        assert!(
            report.contains("there is no setting \"tolerence\" in \"check\"; did you mean \"tolerance\"?\n --> psdl.toml:2:1"),
            "{report}"
        );
    }
}

#[test]
fn a_baseline_forgives_what_is_known_even_where_lines_moved() {
    let folder = folder(&[("a.psdl", OVERLAP), ("b.psdl", OVERLAP)]);
    let check = || psdl(folder.path(), &["check", "--baseline", "known.json", "."]);
    assert_eq!(code(&psdl(folder.path(), &["check", "--write-baseline", "known.json", "."])), 0);
    assert_eq!(code(&check()), 0);
    std::fs::write(folder.path().join("a.psdl"), format!("# moved\n\n{OVERLAP}")).expect("it can be written");
    assert_eq!(code(&check()), 0, "{}", out(&check()));
    std::fs::write(folder.path().join("a.psdl"), format!("{OVERLAP}c = Object('C', 1, 1, 1)\nc.center = (9, 0, 0.5)\n"))
        .expect("it can be written");
    let output = check();
    assert_eq!(code(&output), 1);
    assert!(out(&output).contains("out-of-bounds") && !out(&output).contains("[overlap]"), "{}", out(&output));
    std::fs::write(folder.path().join("b.psdl"), CLEAN).expect("it can be written");
    assert!(err(&check()).contains("fixed since the baseline: b.psdl: overlap: b overlaps a"), "{}", err(&check()));
    std::fs::write(folder.path().join("known.json"), "{}").expect("it can be written");
    assert_eq!(code(&check()), 2);
}

#[test]
fn only_what_changed_since_a_revision_is_checked() {
    let folder = folder(&[("a.psdl", OVERLAP), ("b.psdl", OVERLAP), ("sub/t.psdl", "a.center = (9, 0, 0.5)\n")]);
    let git = |args: &[&str]| {
        let mut command = Command::new("git");
        command.args(["-c", "user.name=a", "-c", "user.email=a@b"]).args(args).current_dir(folder.path());
        command.output().is_ok_and(|output| output.status.success())
    };
    if !git(&["init", "-q"]) {
        return; // without git there is nothing to compare with
    }
    assert!(git(&["add", "."]) && git(&["commit", "-q", "-m", "first"]));
    let paths = || {
        let output = psdl(folder.path(), &["check", "--changed-since", "HEAD", "--format", "jsonl", "."]);
        let lines = out(&output).lines().map(|line| serde_json::from_str(line).expect("JSON")).collect::<Vec<serde_json::Value>>();
        let mut paths: Vec<String> = lines.iter().filter_map(|line| line["path"].as_str().map(str::to_string)).collect();
        paths.dedup();
        paths
    };
    assert_eq!(paths(), [""; 0]);
    std::fs::write(folder.path().join("b.psdl"), format!("# x\n{OVERLAP}")).expect("it can be written");
    std::fs::write(folder.path().join("new.psdl"), OVERLAP).expect("it can be written");
    let template = r#"{"width": 4, "depth": 4, "height": 3, "objects": [{"id": "a", "name": "A", "width": 1, "depth": 1, "height": 1}]}"#;
    std::fs::write(folder.path().join("sub/t.template.json"), template).expect("it can be written");
    assert_eq!(paths(), ["b.psdl", "new.psdl", "sub/t.psdl"]);
    assert_eq!(code(&psdl(folder.path(), &["check", "--changed-since", "nonsense", "."])), 2);
}

#[test]
fn watching_checks_again_after_a_change() {
    let folder = folder(&[("a.psdl", OVERLAP)]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
    command
        .args(["check", "--watch", "--format", "jsonl", "a.psdl"])
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().expect("psdl starts");
    let (send, summaries) = std::sync::mpsc::channel();
    let stdout = child.stdout.take().expect("a pipe");
    let reader = std::thread::spawn(move || {
        let lines = std::io::BufRead::lines(std::io::BufReader::new(stdout)).map_while(Result::ok);
        for line in lines.filter(|line| line.contains("\"summary\"")) {
            let _ = send.send(serde_json::from_str::<serde_json::Value>(&line).expect("JSON"));
        }
    });
    let patience = std::time::Duration::from_secs(60);
    assert_eq!(summaries.recv_timeout(patience).expect("a first report")["errors"], 1);
    // The first report may come a moment before the look-out is asked; what changes until then is told all the same.
    std::fs::write(folder.path().join("a.psdl"), CLEAN).expect("it can be written");
    let mut last = summaries.recv_timeout(patience).expect("a second report");
    while last["errors"] != 0 {
        last = summaries.recv_timeout(patience).expect("another report");
    }
    child.kill().expect("it runs until it is ended");
    let _ = child.wait();
    reader.join().expect("it ends with the command");
}

#[test]
fn completions_and_man_pages_know_every_command() {
    let folder = folder(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = out(&psdl(folder.path(), &["completions", shell]));
        assert!(script.contains("changed-since"), "{shell}");
        assert!(script.contains("out-of-bounds") || matches!(shell, "powershell" | "elvish"), "{shell}");
    }
    assert_eq!(code(&psdl(folder.path(), &["man", "man1"])), 0);
    for page in ["psdl", "psdl-check", "psdl-run", "psdl-export", "psdl-explain", "psdl-config"] {
        let text = std::fs::read_to_string(folder.path().join(format!("man1/{page}.1"))).expect("the page is there");
        assert!(text.contains(".SH NAME"), "{page}");
    }
}

#[test]
fn a_check_may_suggest_how_to_clear_each_error() {
    let text = OVERLAP.replace("(0.5, 0, 0.5)", "(0.5 * 1, 0, 0.5)");
    let folder = folder(&[("wrong.psdl", &text)]);
    let title = "Change 0.5 → 1.0: clears 1 overlap, moves b";
    let check = |args: &[&str]| {
        let report = psdl(folder.path(), &[&["check", "wrong.psdl"], args].concat());
        assert_eq!(code(&report), 1);
        out(&report)
    };
    assert!(check(&["--suggest"]).contains(&format!("help: {title}")), "{}", check(&["--suggest"]));
    assert!(!check(&[]).contains("help: "));
    let json: serde_json::Value = serde_json::from_str(&check(&["--suggest", "--format", "json"])).expect("JSON");
    let suggestion = &json["files"][0]["findings"][0]["suggestion"];
    assert_eq!((&suggestion["title"], &suggestion["edits"][0]["text"]), (&title.into(), &"1.0".into()));
    let sarif: serde_json::Value = serde_json::from_str(&check(&["--suggest", "--format", "sarif"])).expect("JSON");
    let fix = &sarif["runs"][0]["results"][0]["fixes"][0];
    assert_eq!(fix["artifactChanges"][0]["replacements"][0]["insertedContent"]["text"], "1.0", "{fix}");
}
