//! One page that shows the scene in 3D, with everything that it needs in it: it asks no server for anything, and its policy forbids it to.
//!
//! The page is three constants (frame, style, script) and data. Data is JSON in a block that is no script; the policy names the
//! style and the script by their hashes, so that nothing else can run, whatever names the program has.

use super::Subject;
use super::colour::Rgb;
use super::pieces::Pieces;
use crate::check::finding::{Finding, Severity};
use crate::markup::xml;
use crate::scene::{Body, Source};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use sha2::{Digest, Sha256};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

#[derive(Serialize)]
struct Page<'a> {
    title: &'a str,
    /// Width, depth, height; absent where the scene's box cannot be drawn.
    size: Option<[f64; 3]>,
    interior: bool,
    floor: String,
    wall: String,
    objects: Vec<Object<'a>>,
    findings: Vec<Listed<'a>>,
    #[serde(rename = "leftOut")]
    left_out: Vec<LeftOut<'a>>,
}

#[derive(Serialize)]
struct Object<'a> {
    name: &'a str,
    path: &'a str,
    r#type: &'a str,
    support: &'a str,
    facing: usize,
    center: [f64; 3],
    size: [f64; 3],
    colour: String,
    line: Option<usize>,
}

#[derive(Serialize)]
struct Listed<'a> {
    code: &'a str,
    severity: &'a str,
    message: &'a str,
    line: Option<usize>,
    /// Among the objects of the page.
    objects: Vec<usize>,
    /// What two boxes share.
    shared: Option<[[f64; 3]; 2]>,
}

#[derive(Serialize)]
struct LeftOut<'a> {
    path: &'a str,
    reason: &'a str,
}

/// To a hundredth of a millimetre: no eye sees more, and the page stays small.
fn short(values: [f64; 3]) -> [f64; 3] {
    values.map(|value| libm::round(value * 1e5) / 1e5)
}

fn css(colour: Rgb) -> String {
    format!("#{}", colour.hex())
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "info",
    }
}

fn shared(a: &Body, b: &Body) -> Option<[[f64; 3]; 2]> {
    let (min, max) = ([0, 1, 2].map(|k| a.min[k].max(b.min[k])), [0, 1, 2].map(|k| a.max[k].min(b.max[k])));
    (0..3).all(|k| min[k] < max[k]).then(|| [short(min), short(max)])
}

fn listed<'a>(subject: &Subject<'a>, finding: &'a Finding, places: &[Option<usize>]) -> Listed<'a> {
    let bodies: Vec<&Body> = finding.objects.iter().filter_map(|index| Some(&subject.layout.objects.get(*index)?.body)).collect();
    let is_overlap = finding.code == crate::check::finding::Code::Overlap;
    Listed {
        code: finding.code.name(),
        severity: severity(finding.severity),
        message: &finding.message,
        line: (finding.place.source == Source::Program).then(|| (subject.line_of)(finding.place.range.start())),
        objects: finding.objects.iter().filter_map(|index| *places.get(*index)?).collect(),
        shared: match bodies[..] {
            [a, b] if is_overlap => shared(a, b),
            _ => None,
        },
    }
}

pub(super) fn page(subject: &Subject, pieces: &Pieces) -> String {
    let scene = &subject.layout.scene;
    let mut places = vec![None; subject.layout.objects.len()];
    let mut objects = Vec::with_capacity(pieces.shown.len());
    for piece in &pieces.shown {
        let body = &piece.object.body;
        places[piece.index] = Some(objects.len());
        objects.push(Object {
            name: &piece.object.name,
            path: &piece.object.path,
            r#type: body.kind.name(),
            support: body.support.name(),
            facing: body.turn.index(),
            center: short(body.center),
            size: short(body.size()),
            colour: css(piece.colour),
            line: subject.line_of_object(piece.object),
        });
    }
    let mut worst: Vec<&Finding> = subject.findings.iter().collect();
    worst.sort_by_key(|finding| (finding.severity, std::cmp::Reverse(finding.loss)));
    let colour_of = |name: &str| pieces.surfaces.iter().find(|surface| surface.name == name).map(|surface| css(surface.colour));
    let data = Page {
        title: &scene.title,
        size: (!pieces.surfaces.is_empty()).then(|| scene.size()),
        interior: scene.interior,
        floor: colour_of("floor").unwrap_or_default(),
        wall: colour_of("top_wall").unwrap_or_default(),
        objects,
        findings: worst.into_iter().map(|finding| listed(subject, finding, &places)).collect(),
        left_out: pieces.hidden.iter().map(|(object, hidden)| LeftOut { path: &object.path, reason: hidden.reason() }).collect(),
    };
    assemble(&scene.title, &serde_json::to_string(&data).unwrap_or_default())
}

fn assemble(title: &str, data: &str) -> String {
    // None of these stands in JSON outside of strings, where the escape means the same.
    let data = data.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026");
    let hash = |text: &str| STANDARD.encode(Sha256::digest(text.as_bytes()));
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data:; base-uri 'none'; form-action 'none'",
        hash(SCRIPT),
        hash(STYLE)
    );
    let title = if title.is_empty() { "Scene".to_owned() } else { xml(title) };
    include_str!("page.html")
        .replace("{policy}", &policy)
        .replace("{style}", STYLE)
        .replace("{script}", SCRIPT)
        // Last, and the later place first, so that nothing in a name or a title is taken for a place to fill.
        .replacen("{data}", &data, 1)
        .replacen("{title}", &title, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_program_says_ends_no_element_and_fills_no_place() {
        let page = assemble("</title>{data}<script>", r#"{"title":"</script><!--{script}"}"#);
        assert_eq!(page.matches("</script>").count(), 2);
        assert!(page.contains("<title>&lt;/title&gt;{data}&lt;script&gt;</title>"));
        assert!(page.contains(r#"{"title":"\u003c/script\u003e\u003c!--{script}"}"#));
    }

    #[test]
    fn the_policy_names_what_is_in_the_page() {
        let page = assemble("", "{}");
        let between = |a: &str, b: &str| page.split_once(a).and_then(|(_, rest)| rest.split_once(b)).map_or("", |(found, _)| found);
        for (kind, text) in [("script-src", between("<script>", "</script>")), ("style-src", between("<style>", "</style>"))] {
            let hash = STANDARD.encode(Sha256::digest(text.as_bytes()));
            assert!(page.contains(&format!("{kind} 'sha256-{hash}'")), "{kind}");
        }
        assert!(!page.contains("unsafe") && !page.contains("http:") && !page.contains("https:"));
    }
}
