//! Case, and what kind of characters a text has.

use super::this;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::text::unicode;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// A new text made from the receiver's.
fn map(vm: &mut Vm<'_>, args: &Args<'_>, change: impl FnOnce(&str) -> String) -> R<Value> {
    let text = this(vm, args)?;
    let size = vm.heap[text].text.len();
    vm.charge(size as u64 / 16)?;
    vm.reserve(size.saturating_mul(3))?;
    let made = change(vm.text(text));
    Ok(vm.new_str(made))
}

/// Appends the lowercase of the character at `i`: a sigma at the end of a word is ς.
fn push_lower(out: &mut String, chars: &[char], i: usize) {
    // Marks and such within a word neither begin nor end it.
    let ignorable = |c: &char| matches!(c, '\'' | '.' | ':' | '^' | '`' | '\u{a8}' | '\u{ad}' | '\u{b7}' | '\u{300}'..='\u{36f}' | '\u{2019}' | '\u{200b}'..='\u{200f}');
    let c = chars[i];
    if c == 'Σ' {
        let before = chars[..i].iter().rev().find(|c| !ignorable(c)).is_some_and(|c| unicode::is_cased(*c));
        let after = chars[i + 1..].iter().find(|c| !ignorable(c)).is_some_and(|c| unicode::is_cased(*c));
        out.push(if before && !after { 'ς' } else { 'σ' });
    } else {
        out.extend(c.to_lowercase());
    }
}

pub(super) fn lower(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, str::to_lowercase)
}

pub(super) fn upper(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, str::to_uppercase)
}

pub(super) fn casefold(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |text| {
        let mut out = String::with_capacity(text.len());
        text.chars().for_each(|c| unicode::push_folded(&mut out, c));
        out
    })
}

pub(super) fn capitalize(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |text| {
        let chars: Vec<char> = text.chars().collect();
        let mut out = String::with_capacity(text.len());
        for (i, &c) in chars.iter().enumerate() {
            if i == 0 { unicode::push_title(&mut out, c) } else { push_lower(&mut out, &chars, i) }
        }
        out
    })
}

pub(super) fn title(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |text| {
        let chars: Vec<char> = text.chars().collect();
        let mut out = String::with_capacity(text.len());
        let mut within = false;
        for (i, &c) in chars.iter().enumerate() {
            if within {
                push_lower(&mut out, &chars, i)
            } else {
                unicode::push_title(&mut out, c)
            }
            within = unicode::is_cased(c);
        }
        out
    })
}

pub(super) fn swapcase(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |text| {
        let chars: Vec<char> = text.chars().collect();
        let mut out = String::with_capacity(text.len());
        for (i, &c) in chars.iter().enumerate() {
            if c.is_uppercase() {
                push_lower(&mut out, &chars, i);
            } else if c.is_lowercase() {
                out.extend(c.to_uppercase());
            } else {
                out.push(c);
            }
        }
        out
    })
}

/// Asks a question about the receiver's text.
fn ask(vm: &mut Vm<'_>, args: &Args<'_>, question: impl FnOnce(&str) -> bool) -> R<Value> {
    let text = this(vm, args)?;
    vm.charge(vm.heap[text].text.len() as u64 / 32)?;
    Ok(Value::Bool(question(vm.text(text))))
}

/// Whether there are characters, all of this kind.
fn all(text: &str, kind: impl Fn(char) -> bool) -> bool {
    !text.is_empty() && text.chars().all(kind)
}

pub(super) fn isalnum(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, |c| unicode::is_alpha(c) || unicode::is_digit(c) || unicode::is_numeric(c)))
}

pub(super) fn isalpha(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, unicode::is_alpha))
}

pub(super) fn isascii(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, str::is_ascii)
}

pub(super) fn isdecimal(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, |c| unicode::decimal(c).is_some()))
}

pub(super) fn isdigit(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, unicode::is_digit))
}

pub(super) fn isnumeric(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, unicode::is_numeric))
}

pub(super) fn isidentifier(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| {
        let mut chars = text.chars();
        chars.next().is_some_and(|c| c == '_' || unicode_ident::is_xid_start(c)) && chars.all(unicode_ident::is_xid_continue)
    })
}

pub(super) fn isprintable(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| text.chars().all(unicode::is_printable))
}

pub(super) fn isspace(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| all(text, unicode::is_space))
}

pub(super) fn islower(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| text.chars().any(char::is_lowercase) && !text.chars().any(|c| c.is_uppercase() || unicode::is_title(c)))
}

pub(super) fn isupper(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| text.chars().any(char::is_uppercase) && !text.chars().any(|c| c.is_lowercase() || unicode::is_title(c)))
}

pub(super) fn istitle(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |text| {
        let (mut within, mut cased) = (false, false);
        for c in text.chars() {
            let capital = c.is_uppercase() || unicode::is_title(c);
            if capital && within || c.is_lowercase() && !within {
                return false;
            }
            within = capital || c.is_lowercase();
            cased |= within;
        }
        cased
    })
}
