//! The arguments. Help, completions and man pages are made from them.

use super::lsp::LspArgs;
use crate::check::finding::Code;
use crate::report::Format;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Parser, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;

/// Runs, checks and corrects PSDL scene programs.
#[derive(Parser, Debug)]
#[command(name = "psdl", disable_version_flag = true, max_term_width = 100, infer_long_args = true)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,

    /// Print the version; with --verbose all that a bug report needs.
    #[arg(short = 'V', long)]
    pub version: bool,

    /// Say more on standard error.
    #[arg(short, long, global = true)]
    pub verbose: bool,

    /// When to use colours.
    #[arg(long, global = true, value_enum, default_value_t, value_name = "WHEN")]
    pub color: ColorChoice,
}

/// What to do.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Find what is wrong with the layout of scene programs.
    Check(CheckArgs),
    /// Correct layout errors by rewriting a few constants and directions.
    Fix(super::fix::FixArgs),
    /// Run a program and print what it prints.
    Run(RunArgs),
    /// Draw scenes: from above, in perspective, with their errors where they are.
    Render(super::render::RenderArgs),
    /// Write the layout of a program in another format.
    Export(ExportArgs),
    /// Read a scene of another program, and write a flat program with the same scene.
    Import(ImportArgs),
    /// Explain a kind of finding.
    Explain(ExplainArgs),
    /// Show what holds for a program, and where each value came from.
    Config(ConfigArgs),
    /// Serve an editor: the language server protocol over standard input and output.
    Lsp(LspArgs),
    /// Print the completions for a shell.
    Completions(CompletionsArgs),
    /// Write the man pages into a folder.
    Man(ManArgs),
}

/// Where the configuration comes from.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct ConfigOptions {
    /// Take this configuration instead of the nearest psdl.toml above each program.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub config: Option<PathBuf>,

    /// Take no configuration at all.
    #[arg(long, conflicts_with = "config")]
    pub no_config: bool,
}

/// `psdl config`
#[derive(clap::Args, Debug)]
pub struct ConfigArgs {
    /// The program, or a folder.
    #[arg(value_name = "FILE", default_value = ".", value_hint = ValueHint::AnyPath)]
    pub file: PathBuf,

    /// Print the JSON schema of psdl.toml instead.
    #[arg(long)]
    pub schema: bool,

    #[allow(missing_docs)]
    #[command(flatten)]
    pub options: ConfigOptions,
}

/// `psdl completions`
#[derive(clap::Args, Debug)]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// `psdl man`
#[derive(clap::Args, Debug)]
pub struct ManArgs {
    /// The folder; it is made if it is not there.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,
}

/// `psdl check`
#[derive(clap::Args, Debug)]
#[command(after_help = "Exit status: 0 if nothing was found (notes do not count), 1 if something was, 2 if the work could not be done.")]
pub struct CheckArgs {
    /// Files and folders; `-` is standard input. Folders are searched for `.psdl` files, with the rules of .gitignore and .ignore.
    #[arg(required = true, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub paths: Vec<PathBuf>,

    /// The format of the report.
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    pub format: Format,

    /// Report these kinds only.
    #[arg(long, value_delimiter = ',', value_name = "KINDS", value_parser = code_parser())]
    pub select: Vec<Code>,

    /// Do not report these kinds.
    #[arg(long, value_delimiter = ',', value_name = "KINDS", value_parser = code_parser())]
    pub ignore: Vec<Code>,

    /// Exit with 0 even if something was found.
    #[arg(long)]
    pub exit_zero: bool,

    /// End the text report with a table of kinds.
    #[arg(long)]
    pub statistics: bool,

    /// Show a picture of each scene with findings, and of a scene that is checked alone; without a word, on terminals only.
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, default_missing_value = "auto", require_equals = true)]
    pub picture: Option<super::picture::PictureChoice>,

    /// The name of the program on standard input: its place decides about the template and the configuration.
    #[arg(long, value_name = "PATH", value_hint = ValueHint::FilePath)]
    pub stdin_filename: Option<PathBuf>,

    /// Say for each layout error which edit of a constant or direction clears it best.
    #[arg(long)]
    pub suggest: bool,

    /// Check again whenever something changes.
    #[arg(long)]
    pub watch: bool,

    /// Check only what differs from this revision of git.
    #[arg(long, value_name = "REV")]
    pub changed_since: Option<String>,

    /// Do not report the findings that this file knows; say which of them are fixed.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub baseline: Option<PathBuf>,

    /// Write all findings that count to this file, for --baseline.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with = "baseline")]
    pub write_baseline: Option<PathBuf>,

    #[allow(missing_docs)]
    #[command(flatten)]
    pub options: ConfigOptions,
}

/// `psdl run`
#[derive(clap::Args, Debug)]
pub struct RunArgs {
    /// The program; `-` is standard input.
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,

    #[allow(missing_docs)]
    #[command(flatten)]
    pub options: ConfigOptions,
}

/// `psdl export`
#[derive(clap::Args, Debug)]
pub struct ExportArgs {
    /// The format to write.
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub to: crate::export::Format,

    /// The program; `-` is standard input.
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,

    /// Where to write; `-`, the default, is standard output.
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,

    #[allow(missing_docs)]
    #[command(flatten)]
    pub options: ConfigOptions,
}

/// `psdl import`
#[derive(clap::Args, Debug)]
pub struct ImportArgs {
    /// The file; `-` is standard input.
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,

    /// The format of the file; told from what is in it if it is not said.
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub from: Option<crate::export::import::Source>,

    /// Where to write the program; `-`, the default, is standard output.
    #[arg(short, long, value_name = "OUT", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

/// `psdl explain`
#[derive(clap::Args, Debug)]
pub struct ExplainArgs {
    /// The kind of finding, as `overlap`; without one they are listed.
    #[arg(value_name = "KIND")]
    pub kind: Option<String>,
}

/// When to use colours.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ColorChoice {
    /// On a terminal that shows them, unless NO_COLOR is set.
    #[default]
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

impl ColorChoice {
    /// Tells the printing of errors about it.
    pub fn write_global(self) {
        match self {
            ColorChoice::Auto => anstream::ColorChoice::Auto,
            ColorChoice::Always => anstream::ColorChoice::Always,
            ColorChoice::Never => anstream::ColorChoice::Never,
        }
        .write_global();
    }

    /// Whether what is written to a stream is to have colours.
    pub fn resolve(self, stream: &impl anstream::stream::RawStream) -> bool {
        match self {
            ColorChoice::Auto => anstream::AutoStream::choice(stream) != anstream::ColorChoice::Never,
            ColorChoice::Always => true,
            ColorChoice::Never => false,
        }
    }
}

impl ValueEnum for crate::export::Format {
    fn value_variants<'a>() -> &'a [crate::export::Format] {
        const FORMATS: [crate::export::Format; 9] = {
            let mut formats = [crate::export::Format::Glb; 9];
            let mut i = 0;
            while i < formats.len() {
                formats[i] = crate::export::Format::ALL[i].0;
                i += 1;
            }
            formats
        };
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let known = crate::export::Format::ALL.iter().find(|(format, ..)| format == self);
        known.map(|(_, name, help)| PossibleValue::new(*name).help(*help))
    }
}

impl ValueEnum for crate::export::import::Source {
    fn value_variants<'a>() -> &'a [crate::export::import::Source] {
        use crate::export::import::Source::{Holodeck, Layout, LayoutGpt, Visualizer};
        &[Layout, Visualizer, Holodeck, LayoutGpt]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let known = crate::export::import::Source::ALL.iter().find(|(source, ..)| source == self);
        known.map(|(_, name, help)| PossibleValue::new(*name).help(*help))
    }
}

impl ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Format] {
        const FORMATS: [Format; 7] = {
            let mut formats = [Format::Text; 7];
            let mut i = 0;
            while i < formats.len() {
                formats[i] = Format::ALL[i].0;
                i += 1;
            }
            formats
        };
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Format::ALL.iter().find(|(format, _)| format == self).map(|(_, name)| PossibleValue::new(*name))
    }
}

/// Reads a kind; completions list all of them, errors name the nearest.
pub(super) fn code_parser() -> impl TypedValueParser<Value = Code> {
    let names = crate::check::codes::all().map(|info| PossibleValue::new(info.name).help(info.summary));
    PossibleValuesParser::new(names).try_map(|name| name.parse::<Code>())
}
