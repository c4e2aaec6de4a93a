//! Pictures of scenes: as they should look, the same on every run, and harmless whatever the names are.
//!
//! `PSDL_BLESS=1 cargo test --test render` takes the pictures as they are now as those that are expected.

use psdl::analysis::{Analysis, Input, Options as Engine, analyse};
use psdl::render::{self, Drawing, Labels, Options, Picture, Theme, View, draw};
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn analysed(text: &str, template: Option<&str>) -> Analysis {
    analyse(&Input { text, template }, &Engine::default(), None)
}

fn picture_of(analysis: &Analysis, options: &Options) -> Drawing {
    let layout = analysis.layout.as_ref().expect("a program that runs");
    draw(&Picture { layout, verdict: &analysis.verdict, rules: &Engine::default().rules }, options)
}

fn example(name: &str) -> Analysis {
    let path = folder("examples").join(format!("{name}.psdl"));
    let text = std::fs::read_to_string(&path).expect("an example");
    let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
    analysed(&text, template.as_deref())
}

/// Width, height, and samples of eight bits.
fn decoded(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().expect("a PNG");
    let mut samples = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut samples).expect("a whole PNG");
    (info.width, info.height, samples)
}

/// How far two pictures are apart for an eye that sees no single pixels: the largest difference of the means of blocks of 6 × 6 pixels, and
/// the mean of all differences, both of 255.
fn apart(a: &[u8], b: &[u8], width: usize) -> (f64, f64) {
    const BLOCK: usize = 6;
    let height = a.len() / 3 / width;
    let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
    for top in (0..height).step_by(BLOCK) {
        for left in (0..width).step_by(BLOCK) {
            for channel in 0..3 {
                let (mut difference, mut pixels) = (0.0, 0.0);
                for y in top..(top + BLOCK).min(height) {
                    for x in left..(left + BLOCK).min(width) {
                        let at = 3 * (y * width + x) + channel;
                        difference += f64::from(a[at]) - f64::from(b[at]);
                        pixels += 1.0;
                    }
                }
                let mean: f64 = f64::abs(difference / pixels);
                worst = worst.max(mean);
                sum += mean;
                count += 1.0;
            }
        }
    }
    (worst, sum / count)
}

#[test]
fn pictures_look_as_they_should() {
    let options = |view, labels, theme| Options { view, size: (300, 220), theme, labels, ..Options::default() };
    let cases = [
        ("kitchen", options(View::Perspective, Labels::Some, Theme::Light)),
        ("attic", options(View::Top, Labels::All, Theme::Light)),
        ("gallery", options(View::Perspective, Labels::None, Theme::Dark)),
        ("harbour", options(View::Perspective, Labels::None, Theme::Light)),
        ("dwarven_forge", options(View::Both, Labels::Some, Theme::Light)),
        ("campsite", Options { size: (480, 320), ..options(View::Both, Labels::Some, Theme::Light) }),
    ];
    for (name, options) in cases {
        let png = picture_of(&example(name), &options).to_png();
        let path = folder("tests/render").join(format!("{name}.png"));
        if std::env::var_os("PSDL_BLESS").is_some() {
            std::fs::create_dir_all(folder("tests/render")).expect("a folder");
            std::fs::write(&path, &png).expect("a picture");
        }
        let ((width, height, is), expected) = (decoded(&png), decoded(&std::fs::read(&path).expect("a picture to compare with")));
        assert_eq!((width, height), (expected.0, expected.1), "{name}");
        let (worst, mean) = apart(&is, &expected.2, width as usize);
        assert!(worst < 12.0 && mean < 0.4, "{name}: blocks differ by up to {worst:.1}, on the mean by {mean:.2}");
    }
}

#[test]
fn the_measure_sees_a_box_that_has_moved() {
    let scene = |x: f64| {
        let text = format!("set_size(6, 6, 3)\na = Object(\"Box\", 0.4, 0.4, 0.4, color=\"4169E1\")\na.center.x = {x}\na.center.y = 0.0\n");
        picture_of(&analysed(&text, None), &Options { view: View::Top, size: (300, 220), ..Options::default() }).to_pixels().rgb
    };
    let (worst, _) = apart(&scene(0.0), &scene(0.3), 300);
    assert!(worst > 12.0, "{worst}");
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let options = Options { labels: Labels::All, ..Options::default() };
    let (one, other) = (picture_of(&example("mars_base"), &options), picture_of(&example("mars_base"), &options));
    assert_eq!(one.to_svg(), other.to_svg());
    assert_eq!(one.to_png(), other.to_png());
    assert_eq!(one.id_mask_png(), other.id_mask_png());
}

#[test]
fn every_object_is_a_group_of_the_svg_and_a_grey_of_the_mask() {
    let analysis = example("bedroom");
    let drawing = picture_of(&analysis, &Options { view: View::Top, size: (900, 900), ..Options::default() });
    let svg = drawing.to_svg();
    let document = roxmltree::Document::parse(&svg).expect("well-formed SVG");
    let objects = &analysis.layout.as_ref().expect("a layout").objects;
    let (_, _, mask) = decoded(&drawing.id_mask_png());
    let greys: std::collections::BTreeSet<u16> = mask.chunks_exact(2).map(|pixel| u16::from_be_bytes([pixel[0], pixel[1]])).collect();
    for (index, object) in objects.iter().enumerate() {
        let shown = index.to_string();
        let group = document.descendants().find(|node| node.attribute("data-object") == Some(shown.as_str())).expect("a group");
        assert_eq!(group.attribute("class"), Some("object"));
        assert_eq!(group.children().find(|node| node.has_tag_name("title")).and_then(|title| title.text()), Some(object.path.as_str()));
        assert!(greys.contains(&(index as u16 + 1)), "{}", object.path);
    }
    assert!(greys.contains(&0) && greys.len() == objects.len() + 1);
}

#[test]
fn no_name_breaks_a_picture() {
    let names = [
        "</script></title></svg>",
        "\\\"'&<>",
        "\\0\\x07\\x1b[31m\\n\\t",
        "\\u202eabc\\u2066",
        "\\u05e9\\u05dc\\u05d5\\u05dd",
        "😀👩‍👩‍👧",
        "\\ud7ff\\ufffe\\uffff",
    ];
    let long = "x".repeat(10_000);
    for name in names.into_iter().chain([long.as_str()]) {
        let text = format!(
            "set_title(\"{name}\")\nset_size(6, 6, 3)\nd = {{}}\nd[\"{name}\"] = Object(\"{name}\", 2.0, 2.0, 1.0)\n\
             e = Object(\"{name}\", 2.0, 2.0, 1.0)\nfor o in [d[\"{name}\"], e]:\n    o.center.x = 0.0\n    o.center.y = 0.0\n"
        );
        let analysis = analysed(&text, None);
        let drawing = picture_of(&analysis, &Options { labels: Labels::All, ..Options::default() });
        let svg = drawing.to_svg();
        let document = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{name:.20}: {error}"));
        assert!(
            document
                .descendants()
                .filter(|node| node.is_element())
                .all(|node| { ["svg", "title", "rect", "g", "path", "circle", "text"].contains(&node.tag_name().name()) })
        );
        assert!(!svg.chars().any(|c| (c.is_control() && c != '\n') || ('\u{202a}'..='\u{202e}').contains(&c)), "{name:.20}");
        assert!(svg.len() < 60_000, "{}", svg.len());
        assert_eq!(decoded(&drawing.to_png()).0, 1600);
    }
}

#[test]
fn hopeless_scenes_are_drawn_too() {
    let scenes = [
        // Larger than the scene, farther than anything, thinner than a hair, nowhere.
        "a = Object(\"A\", 1e6, 1e6, 1e6)\na.center.x = 0.0\na.center.y = 0.0\n",
        "a = Object(\"A\", 1.0, 1.0, 1.0)\na.center.x = 1e300\na.center.y = 0.0\n",
        "a = Object(\"A\", 1e-300, 1.0, 1e-9)\na.center.x = 0.0\na.center.y = 0.0\na.min.z = -5.0\n",
        "a = Object(\"A\", 1.0, 1.0, 1.0)\n",
        "set_size(1e-6, 1e9, 1.0)\na = Object(\"A\", 1.0, 1.0, 1.0)\na.center.x = 0.0\na.center.y = 0.0\n",
        "set_size(1e12, 1.0, 1e-3)\nd = Door(\"D\", 1.0, 0.1, 2.0)\nd.center.x = 0.0\nd.min.y = 0.0\n",
        "",
        "for i in range(3000):\n    o = Object(\"O\", 5.0, 5.0, 2.0)\n    o.center.x = 0.0\n    o.center.y = 0.0\n",
    ];
    for text in scenes {
        let analysis = analysed(text, None);
        for size in [(16, 16), (64, 2000), (400, 300)] {
            let drawing = picture_of(&analysis, &Options { size, labels: Labels::All, ..Options::default() });
            assert!(!drawing.to_png().is_empty(), "{text:.60}");
            roxmltree::Document::parse(&drawing.to_svg()).unwrap_or_else(|error| panic!("{text:.60}: {error}"));
        }
    }
}

#[test]
fn what_is_pointed_out_stands_out() {
    let analysis = example("bedroom");
    let options = |highlight| Options { size: (320, 240), highlight, ..Options::default() };
    let objects = &analysis.layout.as_ref().expect("a layout").objects;
    let bed = objects.iter().position(|object| object.path == "bed").expect("a bed");
    let plain = picture_of(&analysis, &options(None)).to_svg();
    let pointed = picture_of(&analysis, &options(Some(psdl::scene::ObjectId(bed as u32)))).to_svg();
    let colour = render::colour::objects(analysis.layout.as_ref().expect("a layout"))[bed].lit(1.04).hex();
    assert!(plain.contains(&colour) && pointed.contains(&colour));
    assert!(pointed.contains(&Theme::Light.ink().accent.hex()));
}

fn psdl(folder: &Path, args: &[&str]) -> std::process::Output {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_psdl"));
    command.args(args).current_dir(folder).env("COLORTERM", "truecolor").output().expect("psdl runs")
}

const TABLE: &str = "set_size(6, 6, 3)\na = Object(\"Table\", 1.0, 1.0, 1.0)\nb = Object(\"Chair\", 0.5, 0.5, 1.0)\n\
                     a.center.x = 0.5\na.center.y = 0.0\nb.center.x = 0.4\nb.center.y = 0.1\n";

#[test]
fn render_writes_pictures_masks_and_films() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("a.psdl"), TABLE).expect("a program");
    std::fs::write(at("b.psdl"), "x = 1\nset_size(1, 1, 1)\nraise ValueError\n").expect("a program");
    let run = |args: &[&str]| psdl(folder.path(), args);
    let code = |args: &[&str]| run(args).status.code();

    assert_eq!(code(&["render", "a.psdl", "-o", "a.png", "--size", "200x150", "--errors", "--id-mask"]), Some(0));
    let picture = std::fs::read(at("a.png")).expect("a picture");
    assert_eq!(decoded(&picture).0, 200);
    assert_eq!(decoded(&std::fs::read(at("a.ids.png")).expect("a mask")).1, 150);
    assert_eq!(run(&["render", "a.psdl", "-o", "-", "--size", "200x150", "--errors"]).stdout, picture);

    let output = run(&["render", "a.psdl", "b.psdl", "-o", "pictures", "--format", "svg"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("ValueError"));
    for name in ["pictures/a.svg", "pictures/b.svg"] {
        let svg = std::fs::read_to_string(at(name)).expect("a picture");
        roxmltree::Document::parse(&svg).expect("well-formed SVG");
    }

    // What cannot be read does not keep the others from being drawn; nothing is written over another program's picture.
    let output = run(&["render", "a.psdl", "missing.psdl", "-o", "more"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("missing.psdl"));
    assert!(at("more/a.png").is_file());
    std::fs::create_dir(at("other")).expect("a folder");
    std::fs::write(at("other/a.psdl"), TABLE).expect("a program");
    let output = run(&["render", "a.psdl", "other/a.psdl", "-o", "both"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("would both be written to both/a.png"));
    assert!(!at("both").exists());

    assert_eq!(code(&["render", "a.psdl", "--animate", "a.webp", "--size", "240x160"]), Some(0));
    let film = image_webp::WebPDecoder::new(std::io::Cursor::new(std::fs::read(at("a.webp")).expect("a film"))).expect("a film");
    assert!(film.is_animated() && film.num_frames() > 4);

    for wrong in [
        &["render", "a.psdl", "-o", "a.bmp"][..],
        &["render", "a.psdl"],
        &["render", "a.psdl", "b.psdl", "-o", "-"],
        &["render", "a.psdl", "b.psdl", "-o", "c.png"],
        &["render", "a.psdl", "-o", "x.png", "--highlight", "nothing"],
        &["render", "a.psdl", "--animate", "a.avi"],
        &["render", "a.psdl", "-o", "x.png", "--size", "1x1"],
    ] {
        assert_eq!(code(wrong), Some(2), "{wrong:?}");
    }
}

#[test]
fn check_shows_pictures_where_they_are_wanted() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("a.psdl"), TABLE).expect("a program");
    let shown = |args: &[&str]| String::from_utf8_lossy(&psdl(folder.path(), &[&["check", "a.psdl"], args].concat()).stdout).into_owned();
    assert!(!shown(&["--picture"]).contains('▀'), "no terminal, no picture");
    assert!(shown(&["--picture=always"]).contains("m▀"));
    assert!(shown(&["--picture=kitty"]).contains("\u{1b}_Ga=T,f=100"));
    assert!(!shown(&["--picture=always", "--format", "json"]).contains('▀'));
}
