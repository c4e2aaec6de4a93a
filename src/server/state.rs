//! What the server knows: the open documents, and for each program what is to be done and what came of it.
//!
//! There is one [`State`], behind one lock, held for moments only: never while a program runs, never across a wait.

use super::client::Client;
use super::document::{Document, Role, program_of, template_of};
use super::moved::TextChange;
use super::run::{Job, Kept, Open, Outcome};
use super::settings::Settings;
use crate::check::finding::Source;
use crate::config::Resolver;
use crate::ide::Scene;
use crate::repair::Watch;
use ropey::Rope;
use rustc_hash::FxHashMap;
use std::collections::VecDeque;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Weak};
use tokio::sync::oneshot;
use tower_lsp_server::ls_types::{ProgressToken, TraceValue, Uri};

/// What a unit of work is called: a file by its path, whatever the client calls it; anything else by its name.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Key {
    Path(Arc<Path>),
    Name(Arc<str>),
}

/// A program with its template, or a configuration: what is looked at as one.
#[derive(Debug)]
pub(super) struct Unit {
    pub role: Role,
    /// The document, while it is open.
    pub uri: Option<Uri>,
    /// Counts what was asked for; unlike that of any other unit.
    pub wanted: u64,
    /// The run that is under way.
    pub running: Option<Arc<AtomicBool>>,
    /// Whether it stands in the queue, or will as soon as the run that is under way has ended.
    pub queued: bool,
    /// What came of the last run, and what it was asked for as.
    pub latest: Option<(u64, Arc<Outcome>)>,
    /// The findings of the last run that came to something, moved along with the texts.
    pub kept: Vec<Kept>,
    /// The scene of that run.
    pub scene: Option<Arc<Scene>>,
    /// Who waits for the next outcome.
    pub waiting: Vec<Waiting>,
    /// Work for requests about the text as it is.
    pub asked: Vec<Weak<Watch>>,
}

/// One who waits for an outcome; gets `None` where the run failed.
pub(super) type Waiting = oneshot::Sender<Option<Arc<Outcome>>>;

/// Work that the client can end by the token of its progress.
#[derive(Debug)]
pub(super) struct Cancellable {
    pub token: ProgressToken,
    pub watch: Weak<Watch>,
    /// The client has ended it.
    pub ended: bool,
}

/// Everything.
pub(super) struct State {
    pub client: Client,
    pub trace: TraceValue,
    pub settings: Settings,
    pub roots: Vec<PathBuf>,
    pub documents: FxHashMap<Uri, Document>,
    pub units: FxHashMap<Key, Unit>,
    pub queue: VecDeque<Key>,
    pub resolver: Arc<Resolver<'static>>,
    /// What was last published unasked about documents that are not programs.
    pub published: FxHashMap<Uri, (Option<i32>, String)>,
    /// Work that ends when its progress is cancelled.
    pub tokens: Vec<Cancellable>,
    count: u64,
}

impl Key {
    pub(super) fn of(uri: &Uri, path: Option<&Path>) -> Key {
        path.map_or_else(|| Key::Name(uri.as_str().into()), |path| Key::Path(path.into()))
    }

    fn path(&self) -> Option<&Path> {
        match self {
            Key::Path(path) => Some(path),
            Key::Name(_) => None,
        }
    }
}

impl Default for State {
    fn default() -> State {
        State {
            client: Client::default(),
            trace: TraceValue::Off,
            settings: Settings::default(),
            roots: Vec::new(),
            documents: FxHashMap::default(),
            units: FxHashMap::default(),
            queue: VecDeque::new(),
            resolver: Arc::new(Resolver::new(read_config)),
            published: FxHashMap::default(),
            tokens: Vec::new(),
            count: 0,
        }
    }
}

impl State {
    /// The unit that a document belongs to, and whether it is its template.
    pub(super) fn unit_of(&self, document: &Document) -> Option<(Key, Source)> {
        let path = document.path.as_deref();
        match document.role {
            Role::Program | Role::Config => Some((Key::of(&document.uri, path), Source::Program)),
            Role::Template => self.unit_of_template(path?).map(|key| (key, Source::Template)),
            Role::Other => None,
        }
    }

    /// The program of a template: one that is open, or else the file beside it.
    fn unit_of_template(&self, template: &Path) -> Option<Key> {
        let beside = |key: &&Key| key.path().is_some_and(|path| template_of(path) == template);
        let open = self.units.iter().filter(|(_, unit)| unit.role == Role::Program && unit.uri.is_some());
        let open = open.map(|(key, _)| key).find(beside).cloned();
        open.or_else(|| program_of(template).map(|path| Key::Path(path.into())))
    }

    /// The document of the template of a unit, if it is open.
    pub(super) fn open_template(&self, key: &Key) -> Option<&Document> {
        let template = template_of(key.path()?);
        self.documents.values().find(|document| document.role == Role::Template && document.path.as_deref() == Some(&*template))
    }

    /// The unit under that name, made if there is none.
    pub(super) fn unit(&mut self, key: &Key, role: Role) -> &mut Unit {
        self.units.entry(key.clone()).or_insert_with(|| Unit {
            role,
            uri: None,
            wanted: 0,
            running: None,
            queued: false,
            latest: None,
            kept: Vec::new(),
            scene: None,
            waiting: Vec::new(),
            asked: Vec::new(),
        })
    }

    /// A number that was not given yet.
    pub(super) fn number(&mut self) -> u64 {
        self.count += 1;
        self.count
    }

    /// Asks for a new run and cancels the one that is under way. What is asked for in a hurry goes before the rest.
    pub(super) fn schedule(&mut self, key: &Key, hurry: bool) {
        let wanted = self.number();
        let Some(unit) = self.units.get_mut(key) else { return };
        unit.wanted = wanted;
        for watch in unit.asked.drain(..).filter_map(|asked| asked.upgrade()) {
            watch.cancelled.store(true, Ordering::Relaxed);
        }
        if let Some(running) = &unit.running {
            running.store(true, Ordering::Relaxed);
        }
        if unit.running.is_some() || (unit.queued && !hurry) {
            unit.queued = true;
            return;
        }
        if std::mem::replace(&mut unit.queued, true) {
            self.queue.retain(|queued| queued != key);
        }
        if hurry { self.queue.push_front(key.clone()) } else { self.queue.push_back(key.clone()) }
    }

    /// Forgets the configuration and asks for a run of everything.
    pub(super) fn configure(&mut self) {
        let open = self.documents.values().filter(|document| document.role == Role::Config);
        let open: FxHashMap<PathBuf, Rope> = open.filter_map(|document| Some((document.path.clone()?, document.text.clone()))).collect();
        self.resolver = Arc::new(Resolver::new(move |path| match open.get(path) {
            Some(text) => Ok(Some(text.to_string())),
            None => read_config(path),
        }));
        let keys: Vec<Key> = self.units.keys().cloned().collect();
        keys.iter().for_each(|key| self.schedule(key, false));
    }

    /// Takes the unit off the list and ends its run.
    pub(super) fn forget(&mut self, key: &Key) {
        if let Some(Unit { running: Some(running), .. }) = self.units.remove(key) {
            running.store(true, Ordering::Relaxed);
        }
        self.queue.retain(|queued| queued != key);
    }

    /// Carries the findings of a unit along with a change.
    pub(super) fn carry(&mut self, key: &Key, source: Source, change: &TextChange) {
        if let Some(unit) = self.units.get_mut(key) {
            unit.kept.retain_mut(|kept| change.carry(source, &mut kept.finding));
        }
    }

    /// The next thing to do, and what it was asked for as.
    pub(super) fn next(&mut self) -> Option<(Key, u64, Job)> {
        while let Some(key) = self.queue.pop_front() {
            let open = |document: &Document| Open { uri: document.uri.clone(), version: document.version, text: document.text.clone() };
            let template = self.open_template(&key).map(open);
            let unnamed = self.roots.first().map(|root| root.join("untitled.psdl"));
            let Some(unit) = self.units.get_mut(&key) else { continue };
            let cancel = Arc::new(AtomicBool::new(false));
            unit.queued = false;
            unit.running = Some(cancel.clone());
            let document = unit.uri.as_ref().and_then(|uri| self.documents.get(uri)).map(open);
            let job = Job {
                path: key.path().map(Path::to_path_buf).or(unnamed),
                role: unit.role,
                on_disk: key.path().is_some(),
                document,
                template,
                resolver: self.resolver.clone(),
                client: self.client,
                kept: unit.kept.clone(),
                cancel,
            };
            return Some((key, unit.wanted, job));
        }
        None
    }

    /// The job of looking at a program that is not open.
    pub(super) fn job_of_file(&self, path: PathBuf) -> Job {
        let key = Key::Path(path.as_path().into());
        let template = self.open_template(&key);
        Job {
            template: template.map(|document| Open { uri: document.uri.clone(), version: document.version, text: document.text.clone() }),
            path: Some(path),
            role: Role::Program,
            on_disk: true,
            document: None,
            resolver: self.resolver.clone(),
            client: self.client,
            kept: Vec::new(),
            cancel: Arc::default(),
        }
    }

    /// Takes back a run. Returns whether what came of it is what is wanted, and whether there is more to do.
    pub(super) fn done(&mut self, key: &Key, wanted: u64, cancel: &Arc<AtomicBool>) -> (bool, bool) {
        let Some(unit) = self.units.get_mut(key).filter(|unit| unit.running.as_ref().is_some_and(|run| Arc::ptr_eq(run, cancel))) else {
            return (false, false);
        };
        unit.running = None;
        let current = unit.wanted == wanted;
        if unit.queued {
            self.queue.push_front(key.clone());
            return (current, true);
        }
        (current, false)
    }
}

/// A configuration on the disk.
fn read_config(path: &Path) -> io::Result<Option<String>> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => Ok(None),
        Err(error) => Err(error),
    }
}
