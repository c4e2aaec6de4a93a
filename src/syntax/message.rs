//! CPython's words for the parser's errors.

use ruff_python_ast::token::TokenKind;
use ruff_python_parser::{
    InterpolatedStringErrorType, LexicalErrorType, ParseError, ParseErrorType, UnsupportedSyntaxError, UnsupportedSyntaxErrorKind,
};
use ruff_text_size::TextRange;

/// One sentence for an error of the parser.
pub(super) fn message(error: &ParseError, text: &str) -> String {
    use ParseErrorType as Type;
    let plain = match &error.error {
        Type::OtherError(message) => return plain_words(message),
        Type::ExpectedToken { expected, found } => return expected_token(*expected, *found),
        Type::Lexical(error) => return lexical(error),
        Type::FStringError(error) => return format!("f-string: {}", interpolated(error)),
        Type::TStringError(error) => return format!("t-string: {}", interpolated(error)),
        Type::InvalidAssignmentTarget => {
            return format!("cannot assign to {} here. Maybe you meant '==' instead of '='?", target(text, error.location));
        }
        Type::InvalidDeleteTarget => return format!("cannot delete {}", target(text, error.location)),
        Type::SimpleStatementsOnSameLine => return same_line(text, error.location),
        Type::InvalidNamedAssignmentTarget => return format!("cannot use assignment expressions with {}", target(text, error.location)),
        Type::InvalidAugmentedAssignmentTarget => {
            return format!("'{}' is an illegal expression for augmented assignment", target(text, error.location));
        }
        Type::InvalidAnnotatedAssignmentTarget => "illegal target for annotation",
        Type::PositionalAfterKeywordArgument => "positional argument follows keyword argument",
        Type::PositionalAfterKeywordUnpacking => "positional argument follows keyword argument unpacking",
        Type::InvalidArgumentUnpackingOrder => "iterable argument unpacking follows keyword argument unpacking",
        Type::UnexpectedIndentation => "unexpected indent",
        Type::NonDefaultParamAfterDefaultParam => "non-default argument follows default argument",
        Type::ParamAfterVarKeywordParam => "arguments cannot follow var-keyword argument",
        Type::VarParameterWithDefault => "var-positional argument cannot have default value",
        Type::ExpectedKeywordParam => "named arguments must follow bare *",
        Type::UnparenthesizedGeneratorExpression => "Generator expression must be parenthesized",
        Type::InvalidStarredExpressionUsage => "can't use starred expression here",
        Type::IterableUnpackingInComprehension => "iterable unpacking cannot be used in comprehension",
        Type::ExpectedExpression => "expected an expression",
        Type::EmptySlice => "expected an index or slice",
        Type::SimpleAndCompoundStatementOnSameLine => "invalid syntax: a compound statement must start on a line of its own",
        Type::UnexpectedIpythonEscapeCommand | Type::UnexpectedExpressionToken => "invalid syntax",
        other => return plain_words(&other.to_string()),
    };
    plain.to_string()
}

/// What stands where a target was expected.
fn target(text: &str, range: TextRange) -> &'static str {
    let text = text.get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default();
    match text {
        "None" => "None",
        "True" => "True",
        "False" => "False",
        "..." => "ellipsis",
        _ if text.starts_with('*') => "starred",
        _ if text.starts_with('(') && text.contains(',') => "tuple",
        _ if text.starts_with('[') && text.ends_with(']') && text.contains(" for ") => "list comprehension",
        _ if text.starts_with('[') && text.ends_with(']') => "list",
        _ if text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '\'' | '"')) => "literal",
        _ if text.ends_with(')') && !text.starts_with('(') => "function call",
        _ if text.starts_with("lambda") => "lambda",
        _ => "expression",
    }
}

fn expected_token(expected: TokenKind, found: TokenKind) -> String {
    let operand = matches!(found, TokenKind::Name | TokenKind::Int | TokenKind::Float | TokenKind::String | TokenKind::FStringStart);
    match (expected, found) {
        (TokenKind::Indent, _) => "expected an indented block".to_string(),
        (TokenKind::Newline, TokenKind::Dedent) => "invalid syntax".to_string(),
        (TokenKind::Colon, TokenKind::Newline | TokenKind::EndOfFile) => "expected ':'".to_string(),
        (TokenKind::Colon, TokenKind::Equal) => "invalid syntax. Maybe you meant '==' or ':=' instead of '='?".to_string(),
        (TokenKind::Else, _) => "expected 'else' after 'if' expression".to_string(),
        (TokenKind::Comma, _) if operand => "invalid syntax. Perhaps you forgot a comma?".to_string(),
        (expected, found) => format!("expected {}, found {}", token(expected), token(found)),
    }
}

/// Two things stand side by side as if they were two statements; what are they?
fn same_line(text: &str, range: TextRange) -> String {
    let before = text.get(..range.start().to_usize()).unwrap_or_default();
    let line = before.rsplit(['\n', '\r', ';']).next().unwrap_or_default().trim();
    if matches!(line, "print" | "exec") {
        return format!("Missing parentheses in call to '{line}'. Did you mean {line}(...)?");
    }
    let word = &before[before.trim_end_matches(|c: char| matches!(c, '_' | '.') || c.is_ascii_alphanumeric()).len()..];
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return "invalid decimal literal".to_string();
    }
    "invalid syntax: statements must be separated by newlines or semicolons".to_string()
}

/// A token in quotes that people read, not backticks.
fn token(kind: TokenKind) -> String {
    match kind {
        TokenKind::EndOfFile => "the end of the file".to_string(),
        TokenKind::Newline | TokenKind::NonLogicalNewline => "the end of the line".to_string(),
        TokenKind::Indent => "an indent".to_string(),
        TokenKind::Dedent => "a dedent".to_string(),
        TokenKind::Name => "a name".to_string(),
        TokenKind::Int | TokenKind::Float | TokenKind::Complex => "a number".to_string(),
        TokenKind::String | TokenKind::FStringStart | TokenKind::TStringStart => "a string".to_string(),
        TokenKind::Unknown => "something unreadable".to_string(),
        other => plain_words(&other.to_string()),
    }
}

fn lexical(error: &LexicalErrorType) -> String {
    match error {
        LexicalErrorType::UnclosedStringError => "unterminated string literal".to_string(),
        LexicalErrorType::IndentationError => "unindent does not match any outer indentation level".to_string(),
        LexicalErrorType::UnrecognizedToken { tok } if tok.is_ascii_graphic() => format!("invalid character '{tok}'"),
        LexicalErrorType::UnrecognizedToken { tok } => format!("invalid character '{}' (U+{:04X})", tok.escape_debug(), u32::from(*tok)),
        LexicalErrorType::LineContinuationError => "unexpected character after line continuation character".to_string(),
        LexicalErrorType::UnicodeError => "malformed or unknown escape sequence in a string".to_string(),
        LexicalErrorType::OtherError(message) if message.contains("ParseIntError") => "invalid number".to_string(),
        LexicalErrorType::OtherError(message) if message.eq_ignore_ascii_case("invalid syntax") => "invalid number".to_string(),
        LexicalErrorType::OtherError(message) if message.starts_with("Invalid decimal integer") => {
            "leading zeros in decimal integer literals are not permitted; use an 0o prefix for octal integers".to_string()
        }
        LexicalErrorType::FStringError(error) => format!("f-string: {}", interpolated(error)),
        LexicalErrorType::TStringError(error) => format!("t-string: {}", interpolated(error)),
        other => plain_words(&other.to_string()),
    }
}

fn interpolated(error: &InterpolatedStringErrorType) -> String {
    match error {
        InterpolatedStringErrorType::UnclosedLbrace => "expecting '}'".to_string(),
        InterpolatedStringErrorType::SingleRbrace => "single '}' is not allowed".to_string(),
        InterpolatedStringErrorType::UnterminatedString => "unterminated string literal".to_string(),
        other => plain_words(&other.to_string()),
    }
}

/// The parser's words with CPython's quotes and small first letter.
fn plain_words(message: &str) -> String {
    match message {
        "Expected a statement" => return "invalid syntax".to_string(),
        "Expected an identifier" => return "expected a name".to_string(),
        "Expected a parameter name" => return "expression cannot contain assignment, perhaps you meant \"==\"?".to_string(),
        _ => {}
    }
    let mut words = message.replace('`', "'");
    if let Some(first) = words.get(..1).map(str::to_ascii_lowercase)
        && !words.get(1..2).is_some_and(|second| second.chars().all(char::is_uppercase))
    {
        words.replace_range(..1, &first);
    }
    words
}

/// CPython 3.11's words for syntax that the newest Python has, or none any more.
pub(super) fn unsupported(error: &UnsupportedSyntaxError) -> Option<String> {
    use UnsupportedSyntaxErrorKind as Kind;
    Some(match error.kind {
        // Said by `resolve`, as for everything that PSDL leaves out.
        Kind::LazyImportStatement => return None,
        Kind::ParenthesizedKeywordArgumentName => "expression cannot contain assignment, perhaps you meant \"==\"?".to_string(),
        Kind::UnpackingInComprehension(_) if error.to_string().contains("dict") => {
            "dict unpacking cannot be used in dict comprehension".to_string()
        }
        Kind::UnpackingInComprehension(_) => "iterable unpacking cannot be used in comprehension".to_string(),
        _ => plain_words(&error.to_string()),
    })
}
