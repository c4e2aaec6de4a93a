//! A finding: one thing that a person should read about a program, tied to a place in its text.

use ruff_text_size::TextRange;

pub use crate::scene::Source;

/// What a finding is about. The name is what people select, ignore and configure.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Code {
    /// The configuration is wrong at a place.
    Config,
    /// The file could not be read, or is no UTF-8.
    Unreadable,
    /// The text is not a program.
    SyntaxError,
    /// Markdown fences stand around the program.
    MarkdownFence,
    /// The sidecar template is wrong at a place.
    Template,
    /// The program raised an exception.
    Exception,
    /// A limit (steps, memory, recursion, output) ended the run.
    Limit,
    /// A name that is neither Python's, PSDL's nor the program's.
    UnknownName,
    /// A box sticks out of the scene.
    OutOfBounds,
    /// Two boxes share volume.
    Overlap,
    /// A standing object floats or sinks.
    Standing,
    /// A mounted object hangs off the wall.
    Mounted,
    /// Something stands in the way of a door or window.
    Clearance,
    /// An object does not face what it was told to face.
    Facing,
    /// An object faces the wall it stands against.
    FacingWall,
    /// An object stands with its short side to the wall.
    ShortSide,
    /// An object whose x or y was never written.
    Unplaced,
    /// An object told to face itself.
    SelfFacing,
    /// A colour that is not RRGGBB.
    BadColor,
    /// An integer where a float could have been tuned.
    IntegerConstant,
    /// A tunable constant that moves nothing.
    UnusedConstant,
    /// A suppression comment that hides nothing.
    UnusedSuppression,
}

/// How much a finding weighs: only errors and warnings make a run fail.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Severity {
    /// The scene or the program is wrong.
    Error,
    /// Something is likely to be wrong.
    Warning,
    /// Worth knowing; never makes a run fail.
    Info,
}

/// A place in a text, in bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Place {
    /// The text.
    pub source: Source,
    /// The bytes.
    pub range: TextRange,
}

impl Place {
    /// A place in the program's own text.
    pub fn program(range: TextRange) -> Place {
        Place { source: Source::Program, range }
    }
}

/// A second place that explains a finding ("the table is placed here").
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Related {
    /// Where.
    pub place: Place,
    /// What stands there.
    pub message: String,
}

/// A change of the text that resolves a finding by itself (removes Markdown fences, say).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as a title.
    pub title: String,
    /// Byte ranges of the program and what replaces them; disjoint, in ascending order.
    pub edits: Vec<(TextRange, String)>,
}

/// One thing to say about a program, at one place. Errors that come from one statement are one finding.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding {
    /// What kind of thing.
    pub code: Code,
    /// How much it weighs.
    pub severity: Severity,
    /// The statement to blame.
    pub place: Place,
    /// One sentence, in plain words, with metres: `chairs[3] overlaps table by 0.32 m`.
    pub message: String,
    /// Other places that matter.
    pub related: Vec<Related>,
    /// Extra lines: "did you mean …", the loop iteration, a traceback.
    pub notes: Vec<String>,
    /// How many errors of the layout it stands for (0 for what is no layout error).
    pub count: usize,
    /// The worst of them in metres (0 where that has no meaning).
    pub metres: f64,
    /// The sum of their weighted losses.
    pub loss: u64,
    /// The objects of the worst one, as indices of the layout: culprit first.
    pub objects: Vec<usize>,
    /// A change of the text that resolves it, where one is known without search.
    pub fix: Option<Fix>,
    /// The best single edit (or pair) that lessens these errors, where one was looked for.
    pub suggestion: Option<Fix>,
    /// Another finding at `(place of) cause` makes this one doubtful: the run was partial.
    pub partial: bool,
}

impl Finding {
    /// A finding that is no error of the layout, with the usual severity of its code.
    pub fn new(code: Code, place: Place, message: impl Into<String>) -> Finding {
        Finding {
            code,
            severity: code.severity(),
            place,
            message: message.into(),
            related: Vec::new(),
            notes: Vec::new(),
            count: 0,
            metres: 0.0,
            loss: 0,
            objects: Vec::new(),
            fix: None,
            suggestion: None,
            partial: false,
        }
    }
}
