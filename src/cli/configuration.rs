//! What holds for a program: `psdl.toml` on the disk, asked through the one resolver.

use super::Outcome;
use super::args::{ConfigArgs, ConfigOptions};
use super::files::shown;
use super::output::{self, Failure};
use crate::analysis::Options;
use crate::config::{self, ConfigError, Resolved, Resolver};
use crate::report::{FileReport, Printer};
use std::io;
use std::path::{Path, PathBuf};

/// Answers what holds for a program.
pub(super) struct Configuration {
    /// None: nothing but the defaults.
    resolver: Option<Resolver<'static>>,
    color: bool,
}

impl Configuration {
    pub(super) fn new(options: &ConfigOptions, color: bool) -> Configuration {
        let resolver = match &options.config {
            _ if options.no_config => None,
            Some(path) => Some(Resolver::fixed(absolute(path), read)),
            None => Some(Resolver::new(read)),
        };
        Configuration { resolver, color }
    }

    /// Forgets what was read: some file has changed.
    pub(super) fn forget(&self) {
        self.resolver.iter().for_each(Resolver::forget);
    }

    fn resolve(&self, program: &Path) -> Result<Resolved, Failure> {
        let Some(resolver) = &self.resolver else { return Ok(Resolved::default()) };
        resolver.resolve(&absolute(program)).map_err(|error| self.failure(&error))
    }

    pub(super) fn options(&self, program: &Path) -> Result<Options, Failure> {
        self.resolve(program).map(|resolved| resolved.options)
    }

    /// Whether a program is left out when a folder is searched.
    pub(super) fn excludes(&self, program: &Path) -> Result<bool, Failure> {
        self.resolve(program).map(|resolved| resolved.excluded)
    }

    /// The problems of a configuration, underlined in its text.
    fn failure(&self, error: &ConfigError) -> Failure {
        let findings = error.findings();
        let path = relative(&error.path);
        let file = FileReport { path: &path, text: &error.text, template: None, findings: &findings, objects: &[] };
        let report = Printer { color: self.color, ..Printer::default() }.file(&file);
        Failure::with_report(report, "the configuration cannot be used")
    }
}

/// `psdl config`
pub(super) fn show(args: &ConfigArgs, color: bool) -> Result<Outcome, Failure> {
    if args.schema {
        let schema = serde_json::to_string_pretty(&config::schema()).unwrap_or_default();
        return output::print(&(schema + "\n"));
    }
    let configuration = Configuration::new(&args.options, color);
    // A folder stands for a program in it.
    let program = if args.file.is_dir() { args.file.join("scene.psdl") } else { args.file.clone() };
    let mut resolved = configuration.resolve(&program)?;
    resolved.origins.resize(config::settings::all().len(), None);
    output::print(&config::show(&resolved, &|path| relative(path)))
}

fn read(path: &Path) -> io::Result<Option<String>> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => Ok(None),
        Err(error) => Err(error),
    }
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf())
}

/// A path below the working folder is shown from there.
fn relative(path: &Path) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    shown(path.strip_prefix(&here).unwrap_or(path))
}
