//! `psdl render`: pictures of scenes.

use super::Outcome;
use super::args::ConfigOptions;
use super::configuration::Configuration;
use super::files::{self, Loaded, Program};
use super::film;
use super::output::{self, Failure, counted};
use crate::analysis::{Analysis, Input, analyse};
use crate::check::finding::Code;
use crate::render::{Drawing, Labels, Options, Picture, SIZES, Theme, View, draw};
use crate::report::{FileReport, Printer};
use clap::{ValueEnum, ValueHint};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// `psdl render`
#[derive(clap::Args, Debug)]
#[command(after_help = "Exit status: 0 if all was drawn, 1 if a program has an error or raised (then what could be placed is drawn), \
                        2 if the work could not be done.")]
pub struct RenderArgs {
    /// The programs, or folders of them; `-` is standard input.
    #[arg(required = true, value_name = "FILE", value_hint = ValueHint::AnyPath)]
    files: Vec<PathBuf>,

    /// Where to write: a file ending in .png or .svg, a folder for several programs, or `-` for standard output.
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::AnyPath, required_unless_present = "animate")]
    output: Option<PathBuf>,

    /// Film the correction of one program, edit by edit, to a file ending in .gif, .apng, .png or .webp.
    #[arg(long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    animate: Option<PathBuf>,

    /// The format; without it the ending of OUT tells it, else it is png.
    #[arg(long, value_enum, value_name = "FORMAT")]
    format: Option<PictureFormat>,

    /// From where the scene is seen.
    #[arg(long, value_enum, default_value_t, value_name = "VIEW")]
    view: ViewName,

    /// Width and height in pixels.
    #[arg(long, value_parser = size, default_value = "1600x1000", value_name = "WxH")]
    size: (u32, u32),

    /// Draw the layout errors where they are, and list them, worst first; films always do.
    #[arg(long)]
    errors: bool,

    /// Which objects are named.
    #[arg(long, value_enum, default_value_t, value_name = "WHICH")]
    labels: LabelsName,

    /// The colours of the page.
    #[arg(long, value_enum, default_value_t, value_name = "THEME")]
    theme: ThemeName,

    /// Point out this object, as the program names it.
    #[arg(long, value_name = "OBJECT")]
    highlight: Option<String>,

    /// Also write OUT.ids.png: at each pixel the number of the object that is seen there, from 1 in the order of declaration, as a 16-bit grey.
    #[arg(long)]
    id_mask: bool,

    #[allow(missing_docs)]
    #[command(flatten)]
    options: ConfigOptions,
}

/// The formats of pictures.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum PictureFormat {
    /// Pixels.
    Png,
    /// Vectors; each object is a group with its number.
    Svg,
}

/// The views.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum ViewName {
    /// A plan.
    Top,
    /// From the front right.
    Perspective,
    /// Both.
    #[default]
    Both,
}

/// Which objects are named.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum LabelsName {
    /// None.
    None,
    /// Those with room for it, and those with errors.
    #[default]
    Some,
    /// All that find a place for it.
    All,
}

/// The themes.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
enum ThemeName {
    /// Dark on white.
    #[default]
    Light,
    /// Light on near black.
    Dark,
}

/// Reads `1600x1000`.
fn size(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once(['x', 'X', '×']);
    match parts.map(|(width, height)| (width.trim().parse(), height.trim().parse())) {
        Some((Ok(width), Ok(height))) if SIZES.contains(&width) && SIZES.contains(&height) => Ok((width, height)),
        _ => Err(format!("a size looks like 1600x1000, each number from {} to {}", SIZES.start(), SIZES.end())),
    }
}

pub(super) fn render(args: &RenderArgs, color: bool) -> Result<Outcome, Failure> {
    let programs = files::programs(&args.files, None, &|_| Ok(false))?;
    let configuration = Configuration::new(&args.options, color);
    if args.animate.is_some() && programs.len() != 1 {
        return Err(Failure::new("--animate takes one program"));
    }
    let target = Target::of(args, &programs)?;
    let (mut outcome, mut failed) = (Outcome::Clean, 0);
    for program in &programs {
        match render_one(args, program, &configuration, &target, color) {
            Ok(Outcome::Clean) => {}
            Ok(Outcome::Findings) => outcome = Outcome::Findings,
            Err(failure) if programs.len() == 1 => return Err(failure),
            Err(failure) => {
                // The other programs are drawn all the same.
                output::complain(&failure);
                failed += 1;
            }
        }
    }
    match failed {
        0 => Ok(outcome),
        _ => Err(Failure::new(format!("{} could not be drawn", counted(failed, "program")))),
    }
}

fn render_one(
    args: &RenderArgs,
    program: &Program,
    configuration: &Configuration,
    target: &Target,
    color: bool,
) -> Result<Outcome, Failure> {
    let loaded = program.load();
    let (text, template) = loaded.texts()?;
    let options = configuration.options(program.path())?;
    let input = Input { text, template: template.map(|(_, text)| text) };
    let analysis = analyse(&input, &options, None);
    let mut outcome = Outcome::Clean;
    if analysis.partial || analysis.layout.is_none() {
        outcome = Outcome::Findings;
        complain(&loaded, &analysis, color)?;
    }
    let Some(layout) = &analysis.layout else { return Ok(outcome) };
    let picture_options = args.options(&analysis)?;
    if let Some(path) = &args.animate {
        film::film(path, &input, &options, &picture_options)?;
    }
    let path = match target {
        Target::Nothing => return Ok(outcome),
        Target::Stdout => None,
        Target::File(path) => Some(path.clone()),
        Target::Folder(folder) => Some(folder.join(name_in_folder(program.path(), args))),
    };
    let picture = Picture { layout, verdict: &analysis.verdict, rules: &options.rules };
    write(args, &draw(&picture, &picture_options), path.as_deref())?;
    Ok(outcome)
}

/// Where pictures go.
enum Target {
    Nothing,
    Stdout,
    File(PathBuf),
    Folder(PathBuf),
}

impl Target {
    fn of(args: &RenderArgs, programs: &[Program]) -> Result<Target, Failure> {
        let Some(path) = &args.output else { return Ok(Target::Nothing) };
        let stdout = path.as_os_str() == "-";
        let picture = path.extension().is_some_and(|end| ["png", "svg"].iter().any(|known| end.eq_ignore_ascii_case(known)));
        if programs.len() > 1 && (stdout || path.is_file() || picture && !path.is_dir()) {
            return Err(Failure::new(format!("several programs need a folder to write to, and {} is none", path.display())));
        }
        if stdout && args.id_mask {
            return Err(Failure::new("--id-mask needs a file to write beside"));
        }
        if stdout {
            return Ok(Target::Stdout);
        }
        if programs.len() == 1 && !path.is_dir() {
            return Ok(Target::File(path.clone()));
        }
        tell_apart(args, programs, path)?;
        std::fs::create_dir_all(path).map_err(|error| Failure::at(path, &error))?;
        Ok(Target::Folder(path.clone()))
    }
}

/// Whether each program has a picture of its own in a folder: none is written over another.
fn tell_apart(args: &RenderArgs, programs: &[Program], folder: &Path) -> Result<(), Failure> {
    let mut taken: HashMap<PathBuf, &Path> = HashMap::new();
    for program in programs {
        let name = name_in_folder(program.path(), args);
        if let Some(other) = taken.insert(name.clone(), program.path()) {
            let (one, two, path) = (other.display(), program.path().display(), folder.join(name));
            return Err(Failure::new(format!("{one} and {two} would both be written to {}", path.display())));
        }
    }
    Ok(())
}

/// `NAME.png` for `NAME.psdl`.
fn name_in_folder(program: &Path, args: &RenderArgs) -> PathBuf {
    let stem = program.file_stem().filter(|_| program.extension().is_some()).unwrap_or("picture".as_ref());
    let ending = if args.format == Some(PictureFormat::Svg) { "svg" } else { "png" };
    let mut name = stem.to_os_string();
    name.push(".");
    name.push(ending);
    name.into()
}

impl RenderArgs {
    fn options(&self, analysis: &Analysis) -> Result<Options, Failure> {
        let highlight = match &self.highlight {
            None => None,
            Some(path) => {
                let objects = analysis.layout.iter().flat_map(|layout| &layout.objects);
                let index = objects.clone().position(|object| object.path == *path);
                let index = index.ok_or_else(|| Failure::new(format!("there is no object {path}")))?;
                Some(crate::scene::ObjectId(index as u32))
            }
        };
        let view = match self.view {
            ViewName::Top => View::Top,
            ViewName::Perspective => View::Perspective,
            ViewName::Both => View::Both,
        };
        let labels = match self.labels {
            LabelsName::None => Labels::None,
            LabelsName::Some => Labels::Some,
            LabelsName::All => Labels::All,
        };
        let theme = if self.theme == ThemeName::Dark { Theme::Dark } else { Theme::Light };
        let errors = self.errors || self.animate.is_some();
        Ok(Options { view, size: self.size, theme, labels, errors, captions: true, highlight })
    }

    fn format(&self, path: Option<&Path>) -> Result<PictureFormat, Failure> {
        let ending = path.and_then(Path::extension).map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        match (self.format, ending.as_deref()) {
            (Some(format), _) => Ok(format),
            (None, Some("svg")) => Ok(PictureFormat::Svg),
            (None, Some("png") | None) => Ok(PictureFormat::Png),
            (None, Some(other)) => Err(Failure::new(format!("{other} is no format for pictures; write to .png or .svg, or say --format"))),
        }
    }
}

fn write(args: &RenderArgs, drawing: &Drawing, path: Option<&Path>) -> Result<(), Failure> {
    let bytes = match args.format(path)? {
        PictureFormat::Png => drawing.to_png(),
        PictureFormat::Svg => drawing.to_svg().into_bytes(),
    };
    let Some(path) = path else {
        return output::write(&bytes).map(|_| ());
    };
    output::write_file(path, &bytes)?;
    if args.id_mask {
        output::write_file(&path.with_extension("ids.png"), &drawing.id_mask_png())?;
    }
    Ok(())
}

/// Says why a program could not be run, or not to its end.
fn complain(loaded: &Loaded, analysis: &Analysis, color: bool) -> Result<(), Failure> {
    let (text, template) = loaded.texts()?;
    let findings: Vec<_> = analysis.findings.iter().filter(|finding| finding.code < Code::OutOfBounds).cloned().collect();
    let objects = analysis.object_names();
    let file = FileReport { path: &loaded.path, text, template, findings: &findings, objects: &objects };
    output::report_error(&Printer { color, ..Printer::default() }.file(&file));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_numbers() {
        assert_eq!(size("320x240"), Ok((320, 240)));
        assert!(["320", "0x10", "9x", "100000x10", "-5x5"].iter().all(|text| size(text).is_err()));
    }
}
