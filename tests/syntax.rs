//! Whatever the text, the syntax room answers: no panic, no place outside the text, no statement lost
//! that stands whole before the one that is being typed.

use proptest::prelude::*;
use psdl::syntax::ast::{Ranged, TextRange};
use psdl::syntax::{Encoding, LineIndex, MAX_DEPTH, Parsed, parse, tune};

/// A program that uses most of the language.
const PROGRAM: &str = include_str!("../src/syntax/testdata/tour.psdl");

/// Parses, and checks what holds for every text.
fn read(text: &str) -> Parsed {
    let parsed = parse(text);
    let inside = |range: TextRange| {
        assert!(text.get(range.start().to_usize()..range.end().to_usize()).is_some(), "{range:?} in {text:?}");
    };
    for error in &parsed.errors {
        inside(error.range);
        assert!(!error.message.is_empty());
        error.fix.iter().flat_map(|fix| &fix.edits).for_each(|(range, _)| inside(*range));
    }
    parsed.module.body.iter().for_each(|stmt| inside(stmt.range()));
    parsed.scopes.occurrences().iter().for_each(|occurrence| inside(occurrence.range));
    let tuning = tune(&parsed, text);
    tuning.constants.iter().for_each(|constant| inside(constant.range));
    tuning.directions.iter().for_each(|direction| inside(direction.range));
    assert!(parsed.depth() <= MAX_DEPTH);
    assert_eq!(parsed.is_complete(), parsed.whole_statements().count() == parsed.module.body.len() && parsed.errors.is_empty());
    parsed
}

/// Every constant with another value, and every direction turned: still a program, with the same sites.
fn rewrite(program: &str) {
    let parsed = read(program);
    if !parsed.is_complete() {
        return;
    }
    let tuning = tune(&parsed, program);
    let mut edits: Vec<(TextRange, String)> =
        tuning.constants.iter().enumerate().map(|(i, c)| c.edit(if i % 2 == 0 { -1.5 } else { 0.25 })).collect();
    // Of sites inside each other, the innermost direction; and no constant that goes with one.
    let inner = |range: TextRange| tuning.directions.iter().any(|other| other.range != range && range.contains_range(other.range));
    let turned: Vec<_> = tuning.directions.iter().filter(|direction| !inner(direction.range)).collect();
    edits.retain(|(range, _)| !turned.iter().any(|direction| direction.range.contains_range(*range)));
    edits.extend(turned.iter().map(|direction| tuning.turn(direction, tune::Cardinal::XMin)));
    let gone = tuning.constants.len() + turned.len() - edits.len();
    edits.sort_by_key(|(range, _)| range.start());
    let mut changed = program.to_string();
    for (range, text) in edits.into_iter().rev() {
        changed.replace_range(range.start().to_usize()..range.end().to_usize(), &text);
    }
    let again = read(&changed);
    assert_eq!(again.errors, [], "{changed}");
    assert_eq!(tune(&again, &changed).constants.len(), tuning.constants.len() - gone, "{changed}");
}

/// The programs of the project, and of the corpus where there is one.
fn programs() -> Vec<String> {
    let mut programs = vec![PROGRAM.to_string()];
    let folders = [Some("examples".into()), std::env::var_os("PSDL_CORPUS").map(std::path::PathBuf::from)];
    for folder in folders.into_iter().flatten() {
        let Ok(entries) = std::fs::read_dir(folder) else { continue };
        let paths = entries.flatten().map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|kind| kind == "psdl"));
        programs.extend(paths.filter_map(|path| std::fs::read_to_string(path).ok()));
    }
    programs
}

#[test]
fn programs_are_complete() {
    for program in programs() {
        assert_eq!(read(&program).errors, [], "{program}");
        rewrite(&program);
    }
}

#[test]
fn a_half_typed_program_keeps_its_whole_statements() {
    for program in programs() {
        let statements: Vec<TextRange> = parse(&program).module.body.iter().map(Ranged::range).collect();
        let step = 1 + program.len() / 400;
        for cut in (0..program.len()).filter(|cut| cut % step == 0 && program.is_char_boundary(*cut)) {
            let parsed = read(&program[..cut]);
            let kept: Vec<TextRange> = parsed.whole_statements().map(Ranged::range).collect();
            // The statement that the cut goes through may be whole as it stands, or not.
            let before: Vec<TextRange> = statements.iter().copied().take_while(|range| range.end().to_usize() < cut).collect();
            let before = &before[..before.len().saturating_sub(1)];
            assert!(before.iter().all(|range| kept.contains(range)), "cut at {cut}: {:?}", parsed.errors);
        }
    }
}

#[test]
fn line_ends_do_not_matter() {
    let errors = |text: &str| {
        let parsed = read(text);
        let index = LineIndex::new(text);
        parsed.errors.iter().map(|error| (index.line(error.range.start()), error.message.clone())).collect::<Vec<_>>()
    };
    let program = "a = 1\nb = (2\nc = = 3\nif a:\n    d = 'x\n  e = 5\n";
    let expected = errors(program);
    assert!(expected.len() > 2, "{expected:?}");
    assert_eq!(errors(&program.replace('\n', "\r\n")), expected);
    assert_eq!(errors(&program.replace('\n', "\r")), expected);
    assert_eq!(errors(&format!("\u{feff}{program}")), expected);
}

fn token() -> impl Strategy<Value = String> {
    let words = "( ) [ ] { } , : ; . = == := + - * ** / @ -> ... not in is and or if elif else for while def class return yield lambda with as try except \
                 finally import from global nonlocal pass break continue del raise assert match case None True 1 0.5 3.14 'a' f'{x}' f'{x:{y}}' ' \" \
                 f' ''' \"\"\" f\"\"\" x y super X_MAX a.facing Object( set_size( ``` ```python # \\ ? $ ! ` é 😀 \u{0} \u{feff} \u{c} async await type lazy";
    let words: Vec<String> = words.split_whitespace().map(str::to_string).collect();
    let breaks = ["\n", "\n    ", "\n  ", "\n\t", "\r\n", "\r", " ", ""].map(str::to_string).to_vec();
    prop_oneof![4 => prop::sample::select(words), 2 => prop::sample::select(breaks)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        read(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_tokens(tokens in prop::collection::vec(token(), 0..120), glue in prop::sample::select(vec!["", " "])) {
        rewrite(&tokens.join(glue));
    }

    #[test]
    fn repeated_tokens(tokens in prop::collection::vec(token(), 1..5), glue in prop::sample::select(vec!["", " "]), times in 1usize..3000) {
        read(&tokens.join(glue).repeat(times));
    }

    #[test]
    fn a_program_with_slips(at in any::<prop::sample::Index>(), length in 0usize..12, token in token(), deleted in any::<bool>()) {
        let start = PROGRAM.floor_char_boundary(at.index(PROGRAM.len()));
        let end = if deleted { PROGRAM.ceil_char_boundary((start + length).min(PROGRAM.len())) } else { start };
        rewrite(&format!("{}{token}{}", &PROGRAM[..start], &PROGRAM[end..]));
    }

    #[test]
    fn places_and_back(text in "[a-zé😀\r\n]{0,60}", at in any::<prop::sample::Index>()) {
        let index = LineIndex::new(&text);
        let at = text.floor_char_boundary(at.index(text.len() + 1));
        // Between CR and LF there is no place of its own.
        prop_assume!(!text[at..].starts_with('\n') || !text[..at].ends_with('\r'));
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            let offset = u32::try_from(at).unwrap().into();
            let place = index.line_column(offset, &text, encoding);
            prop_assert_eq!(index.offset(place, &text, encoding), offset);
        }
    }
}
