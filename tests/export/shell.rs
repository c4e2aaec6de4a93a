//! `psdl export` and `psdl import` in a shell.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const PROGRAM: &str = "a = Object('A', 1, 1, 1, color='4169E1')\na.center = (0, 0, 0.5)\n";

fn psdl(folder: &Path, args: &[&str], input: &str) -> (i32, Output) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_psdl"));
    command.args(args).current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("psdl starts");
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("psdl ends");
    (output.status.code().expect("psdl was not killed"), output)
}

#[test]
fn a_file_is_written_with_what_belongs_to_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, _) = psdl(folder.path(), &["export", "--to", "obj", "-", "-o", "my scene.obj"], PROGRAM);
    assert_eq!(code, 0);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("it was written");
    assert!(read("my scene.obj").contains("\nmtllib my_scene.mtl\n") && read("my_scene.mtl").contains("newmtl 4169E1"));
    // Standard output is one file: nothing can lie beside it.
    let (_, output) = psdl(folder.path(), &["export", "--to", "obj", "-"], PROGRAM);
    assert!(!String::from_utf8_lossy(&output.stdout).contains("mtl"));
    let (_, output) = psdl(folder.path(), &["export", "--to", "glb", "-"], PROGRAM);
    assert!(output.stdout.starts_with(b"glTF"), "a pipe takes what is no text");
}

#[test]
fn a_program_that_raises_is_not_exported() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, output) = psdl(folder.path(), &["export", "--to", "glb", "-", "-o", "a.glb"], "Object('A', 1, 1, 1)\n1 / 0\n");
    assert_eq!((code, folder.path().join("a.glb").exists()), (1, false));
    assert!(String::from_utf8_lossy(&output.stderr).contains("division by zero"));
}

#[test]
fn what_was_exported_is_imported() {
    let folder = tempfile::tempdir().expect("a folder");
    for format in ["layout", "visualizer"] {
        let (_, exported) = psdl(folder.path(), &["export", "--to", format, "-"], PROGRAM);
        let text = String::from_utf8(exported.stdout).expect("UTF-8");
        let (code, imported) = psdl(folder.path(), &["import", "-", "-o", "b.psdl"], &text);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&imported.stderr));
        let (_, again) = psdl(folder.path(), &["export", "--to", format, "b.psdl"], "");
        let boxes = |text: &str| {
            let root: serde_json::Value = serde_json::from_str(text).expect("JSON");
            let object = &root["objects"][0];
            [object["center"].clone(), object["position"].clone(), object["color"].clone()]
        };
        assert_eq!(boxes(&text), boxes(&String::from_utf8(again.stdout).expect("UTF-8")));
    }
}

#[test]
fn a_file_that_cannot_be_read_says_where_and_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, output) = psdl(folder.path(), &["import", "-"], "bed {\n  length: 2m; width: 0m;\n}\n");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((code, output.stdout.len()), (2, 0));
    assert!(said.contains("<stdin>:2:15: width must be positive, not 0m"), "{said}");
    let (code, output) = psdl(folder.path(), &["import", "-"], "{\"a\": 1}");
    assert_eq!(code, 2);
    assert!(String::from_utf8_lossy(&output.stderr).contains("none of the formats"));
}
