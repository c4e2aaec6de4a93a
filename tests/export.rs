//! What `psdl export` writes is read back by readers that know nothing of psdl, and what `psdl import` reads comes out again.
//! `tests/foreign/run` does the same with the programs that the formats are made for.

#[path = "export/readers.rs"]
mod readers;
#[path = "export/round_trips.rs"]
mod round_trips;
#[path = "export/shell.rs"]
mod shell;

use psdl::analysis::{Analysis, Input, Options, analyse};
use psdl::export::{Exported, Format, Subject, export};
use psdl::scene::{Layout, Placed};
use psdl::syntax::LineIndex;
use std::path::{Path, PathBuf};

/// A program, run.
pub struct Scene {
    /// Its text.
    pub text: String,
    analysis: Analysis,
}

impl Scene {
    /// Runs a program with its template.
    pub fn run(text: &str, template: Option<&str>) -> Scene {
        let analysis = analyse(&Input { text, template }, &Options::default(), None);
        assert!(analysis.layout.is_some() && !analysis.partial, "{:?}\n{text}", analysis.findings);
        Scene { text: text.to_owned(), analysis }
    }

    /// Runs a file.
    pub fn load(path: &Path) -> Scene {
        let text = std::fs::read_to_string(path).expect("a readable file");
        let template = std::fs::read_to_string(path.with_extension("template.json")).ok();
        Scene::run(&text, template.as_deref())
    }

    /// Where everything is.
    pub fn layout(&self) -> &Layout {
        self.analysis.layout.as_ref().expect("a layout")
    }

    /// Writes it, as into a file `scene`.
    pub fn export(&self, format: Format) -> Exported {
        let lines = LineIndex::new(&self.text);
        let line_of = |offset| lines.line(offset) as usize + 1;
        let constants = self.analysis.prepared.tuning.constants.len();
        let (layout, findings) = (self.layout(), &self.analysis.findings);
        let subject = Subject { layout, verdict: &self.analysis.verdict, findings, constants, line_of: &line_of };
        export(format, &subject, Some("scene"))
    }

    /// The same for formats that are text.
    pub fn text_of(&self, format: Format) -> String {
        String::from_utf8(self.export(format).bytes).expect("UTF-8")
    }

    /// The objects that formats which draw can show.
    pub fn drawn(&self) -> Vec<&Placed> {
        let fits = |object: &&Placed| {
            let (min, max) = (object.body.min, object.body.max);
            object.body.is_placed() && (0..3).all(|k| min[k].abs() <= 1e9 && max[k].abs() <= 1e9 && max[k] - min[k] >= 1e-6)
        };
        self.layout().objects.iter().filter(fits).collect()
    }
}

/// The programs in some folders.
fn programs(folders: &[PathBuf]) -> Vec<PathBuf> {
    let files = |folder: &PathBuf| std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = folders.iter().flat_map(files).map(|entry| entry.expect("an entry").path());
    let mut programs: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|end| end == "psdl")).collect();
    programs.sort();
    programs
}

/// The examples, scenes that are hard on the formats, and the folders of `PSDL_CORPUS`.
pub fn all() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let more = std::env::var_os("PSDL_CORPUS").unwrap_or_default();
    let more = std::env::split_paths(&more).filter(|path| !path.as_os_str().is_empty());
    programs(&[root.join("examples"), root.join("tests/foreign/scenes")].into_iter().chain(more).collect::<Vec<_>>())
}

/// A scene that is hard on the formats.
pub fn hard(name: &str) -> Scene {
    Scene::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/foreign/scenes/{name}.psdl")))
}
