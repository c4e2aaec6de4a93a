//! What of a program may be rewritten to correct its layout: float constants and directions.
//!
//! A *constant* is a float literal with its sign. A *direction* is a literal that names a cardinal,
//! or the whole right-hand side of an assignment to `.facing`. Everything here can be told from the
//! text alone; whether a constant moves anything, or sizes something, is for a run to say.

use ruff_text_size::{TextRange, TextSize};

use super::ast::Ranged;
use super::error::Edit;
use super::parse::Parsed;

mod find;

/// A constant of a program: its place in [`Tuning::constants`], in the order of the text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct ConstantId(pub u32);

/// A direction of a program: its place in [`Tuning::directions`], in the order of the text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct DirectionId(pub u32);

/// Why a constant is left alone whatever it does.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Excluded {
    /// It stands in an argument of `Object(…)`, `set_size(…)` or another call of the template.
    Template,
    /// It begins with `3.14`.
    Pi,
    /// It overflows to infinity.
    Infinite,
}

/// A float literal with its sign.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Constant {
    /// The literal, and the sign where one is applied to it directly.
    pub range: TextRange,
    /// Its value, sign included.
    pub value: f64,
    /// A negative number here needs parentheses (`0.5 ** n`, `0.5.real`).
    pub needs_parens: bool,
    /// A word ends right before it (`return-0.5`): a number without a sign needs a blank.
    pub glued: bool,
    /// Why it is left alone, where it is.
    pub excluded: Option<Excluded>,
}

impl Constant {
    /// The change that gives it another value.
    pub fn edit(&self, value: f64) -> Edit {
        let text = format_constant(value, self.needs_parens);
        let blank = if self.glued && text.starts_with(|c: char| c.is_ascii_digit()) { " " } else { "" };
        (self.range, format!("{blank}{text}"))
    }

    /// As the program writes it.
    pub fn text<'t>(&self, program: &'t str) -> &'t str {
        program.get(self.range.start().to_usize()..self.range.end().to_usize()).unwrap_or_default()
    }
}

/// An integer literal with its sign: never rewritten, but worth a remark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Integer {
    /// The literal, and the sign where one is applied to it directly.
    pub range: TextRange,
    /// It stands in an argument of a call of the template.
    pub in_template: bool,
}

/// One of the four horizontal directions; the number is PSDL's.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
#[repr(u8)]
pub enum Cardinal {
    /// `X_MAX`, right.
    XMax = 0,
    /// `Y_MAX`, away.
    YMax = 1,
    /// `X_MIN`, left.
    XMin = 2,
    /// `Y_MIN`, towards the viewer.
    YMin = 3,
}

impl Cardinal {
    /// All four, by number.
    pub const ALL: [Cardinal; 4] = [Cardinal::XMax, Cardinal::YMax, Cardinal::XMin, Cardinal::YMin];

    /// The cardinal that a global name of PSDL means.
    pub fn from_name(name: &str) -> Option<Cardinal> {
        Some(match name {
            "X_MAX" | "X_POS" | "RIGHT_WALL" => Cardinal::XMax,
            "Y_MAX" | "Y_POS" | "TOP_WALL" => Cardinal::YMax,
            "X_MIN" | "X_NEG" | "LEFT_WALL" => Cardinal::XMin,
            "Y_MIN" | "Y_NEG" | "BOTTOM_WALL" => Cardinal::YMin,
            _ => return None,
        })
    }
}

/// What stands at a direction.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum DirectionKind {
    /// A literal that names a cardinal; also where it is all that is assigned.
    Literal(Cardinal),
    /// Any other expression that is assigned to a `.facing`.
    Rhs,
}

/// A place where a cardinal stands or may stand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Direction {
    /// The literal or the whole expression.
    pub range: TextRange,
    /// Which of the two.
    pub kind: DirectionKind,
    /// A word begins right behind it (`0if a else 1`): a name needs a blank.
    pub glued: bool,
}

/// How a file spells cardinals.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default, PartialOrd, Ord)]
pub enum Spelling {
    /// `X_MAX`.
    #[default]
    Max,
    /// `X_POS`.
    Pos,
    /// `Facing.X_MAX`.
    FacingMax,
    /// `Facing.X_POS`.
    FacingPos,
    /// `0`.
    Number,
}

impl Spelling {
    /// A cardinal as text.
    pub fn spell(self, cardinal: Cardinal) -> &'static str {
        let spellings: [&str; 4] = match self {
            Spelling::Max => ["X_MAX", "Y_MAX", "X_MIN", "Y_MIN"],
            Spelling::Pos => ["X_POS", "Y_POS", "X_NEG", "Y_NEG"],
            Spelling::FacingMax => ["Facing.X_MAX", "Facing.Y_MAX", "Facing.X_MIN", "Facing.Y_MIN"],
            Spelling::FacingPos => ["Facing.X_POS", "Facing.Y_POS", "Facing.X_NEG", "Facing.Y_NEG"],
            Spelling::Number => ["0", "1", "2", "3"],
        };
        spellings[cardinal as usize]
    }
}

/// All that may be rewritten in one program.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Tuning {
    /// In the order of the text.
    pub constants: Vec<Constant>,
    /// In the order of the text; those that are directions are not among them.
    pub integers: Vec<Integer>,
    /// In the order of the text, the outer before the inner where both start together.
    pub directions: Vec<Direction>,
    /// As most of the file's directions are spelled.
    pub spelling: Spelling,
}

/// Finds the constants and directions of a program. `program` is the text that was parsed.
pub fn tune(parsed: &Parsed, program: &str) -> Tuning {
    parsed.with_stack(|| find::find(parsed, program))
}

impl Tuning {
    /// The constant that covers exactly this range: of a float literal, or of a sign and its literal.
    pub fn constant_at(&self, range: TextRange) -> Option<ConstantId> {
        let at = self.constants.binary_search_by_key(&key(range), |constant| key(constant.range)).ok()?;
        u32::try_from(at).ok().map(ConstantId)
    }

    /// The direction that covers exactly this range.
    pub fn direction_at(&self, range: TextRange) -> Option<DirectionId> {
        let at = self.directions.binary_search_by_key(&key(range), |direction| key(direction.range)).ok()?;
        u32::try_from(at).ok().map(DirectionId)
    }

    /// A constant by its id.
    pub fn constant(&self, id: ConstantId) -> Option<&Constant> {
        self.constants.get(id.0 as usize)
    }

    /// A direction by its id.
    pub fn direction(&self, id: DirectionId) -> Option<&Direction> {
        self.directions.get(id.0 as usize)
    }

    /// The change that makes a direction this cardinal.
    pub fn turn(&self, direction: &Direction, cardinal: Cardinal) -> Edit {
        let blank = if direction.glued { " " } else { "" };
        (direction.range, format!("{}{blank}", self.spelling.spell(cardinal)))
    }
}

/// The order of sites: by start, outer before inner.
fn key(range: TextRange) -> (TextSize, std::cmp::Reverse<TextSize>) {
    (range.start(), std::cmp::Reverse(range.end()))
}

/// The shortest Python literal that reads as exactly this number, always a float (with a dot or an
/// exponent). Infinity is written as an overflowing literal; what is no number, which has no literal, as zero.
pub fn format_constant(value: f64, needs_parens: bool) -> String {
    let text = match value {
        _ if value.is_nan() => "0.0".to_string(),
        _ if value.is_infinite() => if value > 0.0 { "1e999" } else { "-1e999" }.to_string(),
        _ => format!("{value:?}"),
    };
    if needs_parens && text.starts_with('-') { format!("({text})") } else { text }
}

/// The text right before a place, and right behind it.
fn neighbours(program: &str, range: TextRange) -> (&str, &str) {
    (program.get(..range.start().to_usize()).unwrap_or_default(), program.get(range.end().to_usize()..).unwrap_or_default())
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

impl Ranged for Constant {
    fn range(&self) -> TextRange {
        self.range
    }
}

impl Ranged for Direction {
    fn range(&self) -> TextRange {
        self.range
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse;

    /// What a program offers for rewriting, as text: constants, then directions.
    fn sites(program: &str) -> (Vec<&str>, Vec<&str>) {
        let tuning = tune(&parse(program), program);
        let free = tuning.constants.iter().filter(|constant| constant.excluded.is_none());
        (
            free.map(|constant| constant.text(program)).collect(),
            tuning.directions.iter().map(|direction| &program[direction.range]).collect(),
        )
    }

    /// Gives the first constant another value.
    fn rewrite(program: &str, value: f64) -> String {
        let tuning = tune(&parse(program), program);
        let (range, text) = tuning.constants[0].edit(value);
        let mut program = program.to_string();
        program.replace_range(range.start().to_usize()..range.end().to_usize(), &text);
        program
    }

    #[test]
    fn constants_come_with_their_sign() {
        assert_eq!(sites("x = a - 0.5 + -1.25e-1 - +.5 - (-(2.)) * 3").0, ["0.5", "-1.25e-1", "+.5", "2."]);
        assert_eq!(sites("x = -0.5 ** 2 + 1j + 3.14159 + 4").0, ["0.5"]);
        assert_eq!(sites("x = f'{y + 0.5:.2f}'").0, ["0.5"]);
    }

    #[test]
    fn arguments_of_the_template_are_left_alone() {
        let program = "set_size(4.5, 2 * 2.5)\nb = [Object('b', w * 0.5, 1.0, 1.0) for w in (1.5, 2.5)]\ndoor = Door('d', width=0.9)";
        assert_eq!(sites(program).0, ["1.5", "2.5"]);
        let tuning = tune(&parse(program), program);
        assert_eq!(tuning.constants[0].excluded, Some(Excluded::Template));
    }

    #[test]
    fn new_constants_keep_the_expression() {
        assert_eq!(rewrite("x = 0.5 ** 2", -0.25), "x = (-0.25) ** 2");
        assert_eq!(rewrite("x = (0.5) ** 2", -0.25), "x = (-0.25) ** 2");
        assert_eq!(rewrite("x = (-0.5) ** 2", 0.25), "x = (0.25) ** 2");
        assert_eq!(rewrite("x = 2 ** 0.5", -0.25), "x = 2 ** -0.25");
        assert_eq!(rewrite("x = a-0.5", -0.25), "x = a--0.25");
        assert_eq!(rewrite("x = 0.5.real", -2.0), "x = (-2.0).real");
        assert_eq!(rewrite("lambda: not-0.5", 3.0), "lambda: not 3.0");
        assert_eq!([0.1, 1e22, -0.0, 5e-324, 100.0].map(|value| format_constant(value, false)), ["0.1", "1e22", "-0.0", "5e-324", "100.0"]);
    }

    #[test]
    fn directions() {
        assert_eq!(sites("a.facing = X_MAX").1, ["X_MAX"]);
        assert_eq!(sites("a.facing = b").1, ["b"]);
        assert_eq!(sites("a.facing = Facing.X_NEG if c else 2").1, ["Facing.X_NEG if c else 2", "Facing.X_NEG", "2"]);
        assert_eq!(sites("a.facing, b.facing = Y_MIN, c").1, ["Y_MIN", "c"]);
        assert_eq!(sites("def put(o, n, facing=1): o.facing = facing\nput(a, 2, facing=3)").1, ["1", "facing", "3"]);
        assert_eq!(sites("for o, d in zip(chairs, [X_MIN, RIGHT_WALL]): o.n = d").1, ["X_MIN", "RIGHT_WALL"]);
        assert_eq!(sites("row = {'facing': 2, 'n': 3}").1, ["2"]);
        assert_eq!(sites("X_MAX = 9\na.n = X_MAX").1, [""; 0]);
    }

    #[test]
    fn directions_are_spelled_as_in_the_file() {
        let turned = |program: &str| {
            let tuning = tune(&parse(program), program);
            tuning.turn(&tuning.directions[0], Cardinal::YMin).1
        };
        assert_eq!(turned("a.facing = b"), "Y_MIN");
        assert_eq!(turned("a.facing = X_NEG"), "Y_NEG");
        assert_eq!(turned("a.facing = Facing.X_POS"), "Facing.Y_NEG");
        assert_eq!(turned("a.facing = 0if c else 1\nb.facing = 2"), "3");
        assert_eq!(turned("a.facing = 2\nb.facing = X_MAX\nc.facing = X_MIN"), "Y_MIN");
        assert_eq!(turned("a.facing = X_MAX\nY_MIN = 0"), "Y_NEG");
    }

    #[test]
    fn integers_are_listed() {
        let program = "x = 3 + -4\na.facing = 1\nObject('b', 2, 2, 2)";
        let tuning = tune(&parse(program), program);
        let texts: Vec<_> = tuning.integers.iter().map(|integer| (&program[integer.range], integer.in_template)).collect();
        assert_eq!(texts, [("3", false), ("-4", false), ("2", true), ("2", true), ("2", true)]);
    }
}
