//! From a path to what holds for it: the nearest `psdl.toml` above, what it extends, and what it overrides for the path.

use super::parse::{Assigned, Parsed, Problem, parse};
use super::settings::{Setting, all};
use super::show::Origin;
use crate::analysis::Options;
use crate::check::finding::{Code, Finding, Place};
use crate::syntax::LineIndex;
use ignore::gitignore::{Gitignore, GitignoreBuilder};
use rustc_hash::FxHashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// What the files are called.
pub const FILE_NAME: &str = "psdl.toml";
/// Files extend each other at most so far.
const MAX_EXTENDS: usize = 16;

/// A configuration that cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigError {
    /// The file.
    pub path: PathBuf,
    /// What stands in it.
    pub text: String,
    /// What is wrong with it.
    pub problems: Vec<Problem>,
}

/// What holds for a program.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Resolved {
    /// The options.
    pub options: Options,
    /// Where each setting got its value, in the order of [`all`]; `None` is the default.
    pub origins: Vec<Option<Origin>>,
    /// The files that were read, the nearest last.
    pub files: Vec<PathBuf>,
    /// Whether the program is left out when a folder is searched.
    pub excluded: bool,
}

/// Reads a file: `None` where there is none.
type Read<'a> = dyn Fn(&Path) -> io::Result<Option<String>> + Send + Sync + 'a;

/// Answers what holds for a program. Remembers what it read until it is told to [`forget`](Resolver::forget).
pub struct Resolver<'a> {
    read: Box<Read<'a>>,
    fixed: Option<PathBuf>,
    settings: Vec<Setting>,
    folders: Mutex<FxHashMap<PathBuf, Known>>,
}

/// What was found in a folder, or under a name.
type Known = Result<Option<Arc<Chain>>, Arc<ConfigError>>;

/// A file with those that it extends, the farthest first.
struct Chain {
    layers: Vec<Layer>,
}

struct Layer {
    path: PathBuf,
    lines: LineIndex,
    parsed: Parsed,
    exclude: Gitignore,
    overrides: Vec<Gitignore>,
}

impl<'a> Resolver<'a> {
    /// A resolver that looks for the nearest file above each program.
    pub fn new(read: impl Fn(&Path) -> io::Result<Option<String>> + Send + Sync + 'a) -> Resolver<'a> {
        Resolver { read: Box::new(read), fixed: None, settings: all(), folders: Mutex::default() }
    }

    /// A resolver that takes this file for all programs.
    pub fn fixed(path: PathBuf, read: impl Fn(&Path) -> io::Result<Option<String>> + Send + Sync + 'a) -> Resolver<'a> {
        Resolver { fixed: Some(path), ..Resolver::new(read) }
    }

    /// Forgets what was read: some configuration has changed.
    pub fn forget(&self) {
        self.folders.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// What holds for a program, given its absolute path.
    ///
    /// # Errors
    /// A file on the way cannot be read or used.
    pub fn resolve(&self, program: &Path) -> Result<Resolved, Arc<ConfigError>> {
        let program = &normal(program);
        let chain = match &self.fixed {
            Some(path) => self.known(path, |path| self.chain(path).map(Some))?,
            None => match program.parent() {
                Some(folder) => self.nearest(folder)?,
                None => None,
            },
        };
        let mut resolved = Resolved { origins: vec![None; self.settings.len()], ..Resolved::default() };
        for layer in chain.iter().flat_map(|chain| &chain.layers) {
            self.apply(&mut resolved, layer, program);
        }
        Ok(resolved)
    }

    fn known(&self, path: &Path, find: impl FnOnce(&Path) -> Result<Option<Chain>, ConfigError>) -> Known {
        if let Some(known) = self.folders.lock().unwrap_or_else(PoisonError::into_inner).get(path) {
            return known.clone();
        }
        let found = find(path).map(|chain| chain.map(Arc::new)).map_err(Arc::new);
        self.folders.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_path_buf(), found.clone());
        found
    }

    /// The file of the folder, or of the nearest one above that has one.
    fn nearest(&self, folder: &Path) -> Known {
        for folder in folder.ancestors() {
            let found = self.known(folder, |folder| {
                let path = folder.join(FILE_NAME);
                match (self.read)(&path) {
                    Ok(None) => Ok(None),
                    Ok(Some(text)) => self.layers(path, text).map(Some),
                    Err(error) => Err(ConfigError::plain(path, format!("the configuration could not be read: {error}"))),
                }
            })?;
            if found.is_some() {
                return Ok(found);
            }
        }
        Ok(None)
    }

    fn chain(&self, path: &Path) -> Result<Chain, ConfigError> {
        match (self.read)(path) {
            Ok(Some(text)) => self.layers(path.to_path_buf(), text),
            Ok(None) => Err(ConfigError::plain(path.to_path_buf(), "there is no such file".into())),
            Err(error) => Err(ConfigError::plain(path.to_path_buf(), format!("the configuration could not be read: {error}"))),
        }
    }

    fn layers(&self, path: PathBuf, text: String) -> Result<Chain, ConfigError> {
        let mut layers = Vec::new();
        let mut seen = vec![path.clone()];
        let mut next = Some((path, text));
        while let Some((path, text)) = next.take() {
            let layer = Layer::new(path, &text)?;
            if let Some((extended, range)) = layer.parsed.extend.clone() {
                let wrong = |message: String| ConfigError {
                    path: layer.path.clone(),
                    text: text.clone(),
                    problems: vec![Problem { range, message }],
                };
                let other = normal(&layer.path.parent().unwrap_or(Path::new("")).join(extended));
                if seen.contains(&other) || seen.len() >= MAX_EXTENDS {
                    return Err(wrong("files extend each other in a circle".into()));
                }
                match (self.read)(&other) {
                    Ok(Some(text)) => next = Some((other.clone(), text)),
                    Ok(None) => return Err(wrong(format!("{} does not exist", other.display()))),
                    Err(error) => return Err(wrong(format!("{}: {error}", other.display()))),
                }
                seen.push(other);
            }
            layers.push(layer);
        }
        layers.reverse();
        Ok(Chain { layers })
    }

    fn apply(&self, resolved: &mut Resolved, layer: &Layer, program: &Path) {
        resolved.files.push(layer.path.clone());
        resolved.excluded |= matches(&layer.exclude, program);
        let holding = layer.overrides.iter().zip(&layer.parsed.overrides).filter(|(paths, _)| matches(paths, program));
        let assigned = layer.parsed.assigned.iter().chain(holding.flat_map(|(_, one)| &one.assigned));
        for Assigned { setting, value, range } in assigned {
            self.settings[*setting].set(&mut resolved.options, *value);
            let line = layer.lines.line(range.start()).saturating_add(1);
            resolved.origins[*setting] = Some(Origin { path: layer.path.clone(), line });
        }
    }
}

impl Layer {
    fn new(path: PathBuf, text: &str) -> Result<Layer, ConfigError> {
        let wrong = |problems| ConfigError { path: path.clone(), text: text.to_string(), problems };
        let parsed = parse(text).map_err(wrong)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut problems = Vec::new();
        let exclude = patterns(folder, &parsed.exclude, &mut problems);
        let overrides = parsed.overrides.iter().map(|one| patterns(folder, &one.paths, &mut problems)).collect();
        if !problems.is_empty() {
            return Err(wrong(problems));
        }
        let lines = LineIndex::new(text);
        Ok(Layer { lines, parsed, exclude, overrides, path })
    }
}

impl ConfigError {
    /// The problems as findings about the text.
    pub fn findings(&self) -> Vec<Finding> {
        let finding = |problem: &Problem| Finding::new(Code::Config, Place::program(problem.range), problem.message.clone());
        self.problems.iter().map(finding).collect()
    }

    fn plain(path: PathBuf, message: String) -> ConfigError {
        ConfigError { path, text: String::new(), problems: vec![Problem { range: ruff_text_size::TextRange::default(), message }] }
    }
}

/// Patterns as in a `.gitignore` that stands beside the file.
fn patterns(folder: &Path, globs: &[(String, ruff_text_size::TextRange)], problems: &mut Vec<Problem>) -> Gitignore {
    let mut builder = GitignoreBuilder::new(folder);
    for (glob, range) in globs {
        if let Err(error) = builder.add_line(None, glob) {
            problems.push(Problem { range: *range, message: format!("this is no pattern: {error}") });
        }
    }
    builder.build().unwrap_or_else(|error| {
        problems.push(Problem { range: ruff_text_size::TextRange::default(), message: error.to_string() });
        Gitignore::empty()
    })
}

fn matches(patterns: &Gitignore, program: &Path) -> bool {
    // A pattern says nothing about what lies outside of its folder.
    program.starts_with(patterns.path()) && patterns.matched_path_or_any_parents(program, false).is_ignore()
}

/// The path without `.` and `..`, as far as that can be said without looking at the disk.
fn normal(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut normal, component| {
        match component {
            std::path::Component::CurDir => {}
            std::path::Component::ParentDir if normal.file_name().is_some() => {
                normal.pop();
            }
            other => normal.push(other),
        }
        normal
    })
}
