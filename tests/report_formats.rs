//! Every format on the same few findings: what it looks like (snapshots), and whether the official schemas accept it.

use psdl::check::finding::{Code, Finding, Fix, Place, Related, Source};
use psdl::report::{FileReport, Format, Printer};
use ruff_text_size::TextRange;

const PROGRAM: &str = "\
table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)
chairs = [Object(\"Chair\", width=0.5, depth=0.5, height=0.9) for _ in range(6)]

table.center = (0, 0, 0.375)
for i, chair in enumerate(chairs):
    chair.center.x = table.min.x + i * 0.3
    chair.center.y = table.max.y + 0.1
gap = 0.4
";

const TEMPLATE: &str = "{\"title\": \"Hall\", \"width\": -8}\n";

/// Names, paths and texts as an attacker would choose them.
const HOSTILE_PATH: &str = "a,b:c%d\u{1b}[31m\"<x>&'é/ö ö.psdl";
const HOSTILE: &str = "x = 'é😀' ; y\r\nz\rlamp.center = (1, 2) # \u{1b}]0;pwned\u{7} ]]> \u{202e}\n";

fn place(text: &str, part: &str) -> Place {
    let start = text.find(part).unwrap_or_else(|| panic!("{part} is not in the text"));
    Place::program(TextRange::at((start as u32).into(), (part.len() as u32).into()))
}

fn samples() -> Vec<Vec<Finding>> {
    let overlap = Finding {
        related: vec![
            Related { place: place(PROGRAM, "table.center = (0, 0, 0.375)"), message: "table is placed here".into() },
            Related {
                place: place(PROGRAM, "table = Object(\"Table\", width=1.6, depth=0.9, height=0.75)"),
                message: "table is declared here".into(),
            },
        ],
        notes: vec!["in the loop at line 5: i = 3".into()],
        count: 6,
        metres: 0.15,
        loss: 214,
        objects: vec![4, 0],
        ..Finding::new(
            Code::Overlap,
            place(PROGRAM, "chair.center.y = table.max.y + 0.1"),
            "chairs[3] overlaps table by 0.15 m (and 5 more from this line)",
        )
    };
    let unused = Finding { partial: true, ..Finding::new(Code::UnusedConstant, place(PROGRAM, "0.4"), "0.4 moves no object") };
    let template = Finding {
        place: Place { source: Source::Template, range: TextRange::new(27.into(), 29.into()) },
        ..Finding::new(Code::Template, Place::program(TextRange::default()), "width must be a positive number, not -8")
    };
    let hostile = Finding {
        notes: vec!["line one\nline two\r\n::error::forged".into(), "\u{1b}[2J".into()],
        fix: Some(Fix { title: "Say \u{1b}[1m`bold`".into(), edits: vec![(place(HOSTILE, "(1, 2)").range, "(1, 2, 0)".into())] }),
        objects: vec![0, 99],
        ..Finding::new(
            Code::Exception,
            place(HOSTILE, "lamp.center = (1, 2)"),
            "ValueError: <b>%0A\u{0}::set-output]]> & \"quoted\"\n::error::forged",
        )
    };
    vec![vec![overlap, unused, template], vec![], vec![hostile]]
}

fn report(format: Format) -> String {
    let findings = samples();
    let objects: Vec<Vec<String>> = vec![
        vec!["table".into(), "chairs[0]".into(), "chairs[1]".into(), "chairs[2]".into(), "chairs[3]".into()],
        vec![],
        vec!["la\u{1b}mp".into()],
    ];
    let file = |path, text, template, n: usize| FileReport { path, text, template, findings: &findings[n], objects: &objects[n] };
    let files = [
        file("scenes/hall.psdl", PROGRAM, Some(("scenes/hall.template.json", TEMPLATE)), 0),
        file("scenes/empty.psdl", "", None, 1),
        file(HOSTILE_PATH, HOSTILE, None, 2),
    ];
    Printer { format, color: false, statistics: false }.all(&files)
}

fn schema(name: &str) -> jsonschema::Validator {
    let path = format!("{}/tests/schemas/{name}", env!("CARGO_MANIFEST_DIR"));
    let schema = std::fs::read_to_string(&path).expect("the schema is in the repository");
    // A pattern of SARIF's schema has a bracket too many, which only lenient readers of regular expressions forgive.
    let schema = schema.replace("-[a-zA-Z]{2}]?$", "-[a-zA-Z]{2}?$");
    let schema: serde_json::Value = serde_json::from_str(&schema).expect("it is JSON");
    jsonschema::validator_for(&schema).expect("it is a schema")
}

fn assert_valid(validator: &jsonschema::Validator, document: &serde_json::Value) {
    let errors: Vec<String> = validator.iter_errors(document).map(|e| format!("{}: {e}", e.instance_path())).collect();
    assert!(errors.is_empty(), "{errors:#?}");
}

fn assert_no_control_characters(report: &str) {
    let bad: Vec<char> = report.chars().filter(|ch| ch.is_control() && !matches!(ch, '\n')).collect();
    assert!(bad.is_empty(), "{bad:?} in {report}");
}

#[test]
fn text() {
    let report = report(Format::Text);
    assert_no_control_characters(&report);
    insta::assert_snapshot!(report);
}

#[test]
fn json() {
    let report = report(Format::Json);
    assert_no_control_characters(&report);
    let document: serde_json::Value = serde_json::from_str(&report).expect("it is JSON");
    insta::assert_snapshot!(serde_json::to_string_pretty(&document).expect("it was JSON"));
}

#[test]
fn jsonl() {
    let report = report(Format::Jsonl);
    assert_no_control_characters(&report);
    for line in report.lines() {
        serde_json::from_str::<serde_json::Value>(line).expect("every line is JSON");
    }
    insta::assert_snapshot!(report);
}

#[test]
fn sarif() {
    let report = report(Format::Sarif);
    assert_no_control_characters(&report);
    let mut document: serde_json::Value = serde_json::from_str(&report).expect("it is JSON");
    assert_valid(&schema("sarif-2.1.0.json"), &document);
    // The rules are the table of codes; their texts have tests of their own.
    let rules = document["runs"][0]["tool"]["driver"]["rules"].take();
    assert!(rules.as_array().is_some_and(|rules| rules.iter().any(|rule| rule["id"] == "overlap")));
    for result in document["runs"][0]["results"].as_array_mut().expect("there are results") {
        let index = result["ruleIndex"].take().as_u64().expect("each names its rule") as usize;
        assert_eq!(rules[index]["id"], result["ruleId"]);
    }
    document["runs"][0]["tool"]["driver"]["version"] = "0.0.0".into();
    insta::assert_snapshot!(serde_json::to_string_pretty(&document).expect("it was JSON"));
}

#[test]
fn the_sarif_schema_refuses_what_is_no_sarif() {
    let mut document: serde_json::Value = serde_json::from_str(&report(Format::Sarif)).expect("it is JSON");
    document["runs"][0]["results"][0]["level"] = "terrible".into();
    assert!(!schema("sarif-2.1.0.json").is_valid(&document));
}

#[test]
fn github() {
    let report = report(Format::Github);
    assert_no_control_characters(&report);
    assert!(report.lines().all(|line| !line.starts_with("::error::")), "a message must not forge a command");
    insta::assert_snapshot!(report);
}

#[test]
fn gitlab() {
    let report = report(Format::Gitlab);
    assert_no_control_characters(&report);
    let document: serde_json::Value = serde_json::from_str(&report).expect("it is JSON");
    assert_valid(&schema("gitlab-code-quality.json"), &document);
    insta::assert_snapshot!(report);
}

#[test]
fn junit() {
    let report = report(Format::Junit);
    assert_no_control_characters(&report);
    let document = roxmltree::Document::parse(&report).expect("it is XML");
    let suites: Vec<_> = document.root_element().children().filter(|node| node.has_tag_name("testsuite")).collect();
    assert_eq!(suites.len(), 3, "a suite for each file, with findings or without");
    for suite in suites {
        let cases = suite.children().filter(|node| node.has_tag_name("testcase")).count();
        assert_eq!(suite.attribute("tests"), Some(cases.to_string().as_str()));
    }
    insta::assert_snapshot!(report);
}

/// Needs `xmllint`, which CI installs and names in `PSDL_XMLLINT`; without the variable the test above must do.
#[test]
fn junit_passes_the_schema_of_jenkins() {
    let Some(xmllint) = std::env::var_os("PSDL_XMLLINT") else { return };
    let folder = tempfile::tempdir().expect("a folder for the report");
    let path = folder.path().join("report.xml");
    std::fs::write(&path, report(Format::Junit)).expect("the report can be written");
    let schema = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/schemas/junit-10.xsd");
    let output = std::process::Command::new(xmllint).args(["--noout", "--schema", schema]).arg(&path).output().expect("xmllint runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn colours_are_only_added() {
    let findings = samples();
    let file = FileReport { path: "hall.psdl", text: PROGRAM, template: None, findings: &findings[0][..1], objects: &[] };
    let plain = Printer::default().all(&[file]);
    let colored = Printer { color: true, ..Printer::default() }.all(&[file]);
    assert_ne!(plain, colored);
    assert_eq!(anstream::adapter::strip_str(&colored).to_string(), plain);
}

#[test]
fn the_fingerprint_survives_moved_lines_and_tells_twins_apart() {
    let finding = |text| Finding::new(Code::Unplaced, place(text, "b.center.x"), "b has no y");
    let moved = format!("# a new line\n{PROGRAM}\nb.center.x  =  1");
    let (before, after) = ("b.center.x = 1", moved.as_str());
    let print = |text, n| {
        let findings = vec![finding(text); n];
        psdl::report::fingerprints(&FileReport { path: "a.psdl", text, template: None, findings: &findings, objects: &[] })
    };
    assert_eq!(print(before, 1), print(after, 1));
    assert_eq!(print(before, 2)[0], print(before, 1)[0]);
    assert_ne!(print(before, 2)[0], print(before, 2)[1]);
}

#[test]
fn a_finding_anywhere_in_any_text_is_rendered() {
    let texts = ["", "\n", "x", "é😀\r\n\rb", &"a".repeat(20_000), &"(\n".repeat(500)];
    for text in texts {
        let size = text.len() as u32;
        for (start, end) in [(0, 0), (0, size), (size, size), (size / 2, size)] {
            let place = Place::program(TextRange::new(start.into(), end.into()));
            let findings =
                [Finding { related: vec![Related { place, message: "here".into() }], ..Finding::new(Code::SyntaxError, place, "m") }];
            let file = FileReport { path: "a.psdl", text, template: None, findings: &findings, objects: &[] };
            for (format, name) in Format::ALL {
                assert!(Printer { format, ..Printer::default() }.all(&[file]).len() > 10, "{name}");
            }
        }
    }
}
