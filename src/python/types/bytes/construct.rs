//! Making bytes: constructors, encodings, hexadecimal.

use super::{buffer, byte, content, make, this};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::{Ref, Str};
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::text::codec::{self, CodecError, Encoding, Handler};
use crate::python::types::containers;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// `bytes(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if let (&[same @ Value::Bytes(_)], []) = (args.pos, args.kw) {
        return Ok(same);
    }
    let data = from_arguments(vm, args, "bytes")?;
    Ok(make(vm, data, false))
}

/// `bytearray(...)`
pub fn construct_array(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let data = from_arguments(vm, args, "bytearray")?;
    Ok(make(vm, data, true))
}

fn from_arguments(vm: &mut Vm<'_>, args: Args<'_>, class: &str) -> R<Vec<u8>> {
    let [source, encoding, errors] = vm.bind(class, args, ["source", "encoding", "errors"], 0)?;
    let text = source.and_then(|source| match vm.plain(source) {
        Value::Str(s) => Some(s),
        _ => None,
    });
    if encoding.is_some() || errors.is_some() {
        let Some(text) = text else {
            let what = if encoding.is_some() { "encoding" } else { "errors" };
            return Err(vm.type_error(format!("{what} without a string argument")));
        };
        if encoding.is_none() {
            return Err(vm.type_error("string argument without an encoding"));
        }
        return encode_with(vm, text, encoding, errors, class);
    }
    if text.is_some() {
        return Err(vm.type_error("string argument without an encoding"));
    }
    let Some(source) = source else { return Ok(Vec::new()) };
    if class == "bytes"
        && matches!(source, Value::Instance(_))
        && let Some(method) = vm.special(source, sym::BYTES)
    {
        return by_method(vm, method);
    }
    let plain = vm.plain(source);
    let sized = numbers::int_value(plain).is_some() || matches!(plain, Value::Instance(_)) && vm.special(plain, sym::INDEX).is_some();
    if sized {
        let big = vm.index_big(plain)?;
        let Ok(size) = i64::try_from(&big) else {
            let name = vm.type_name(source);
            return Err(vm.error(Builtin::OverflowError, format!("cannot fit '{name}' into an index-sized integer")));
        };
        let Ok(size) = usize::try_from(size) else { return Err(vm.value_error("negative count")) };
        vm.pin(plain);
        vm.reserve(size)?;
        vm.charge(size as u64 / 64)?;
        return Ok(vec![0; size]);
    }
    collect(vm, source, class)
}

fn by_method(vm: &mut Vm<'_>, method: Value) -> R<Vec<u8>> {
    let made = vm.call(method, &[])?;
    match vm.plain(made) {
        Value::Bytes(r) => Ok(vm.heap[r].0.to_vec()),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("__bytes__ returned non-bytes (type {name})")))
        }
    }
}

/// The bytes of a bytes-like object, or of an iterable of ints; `class` is the type that is made, for messages.
pub fn collect(vm: &mut Vm<'_>, source: Value, class: &str) -> R<Vec<u8>> {
    let plain = vm.plain(source);
    if let Some(data) = content(vm, plain) {
        let data = data.to_vec();
        vm.charge(data.len() as u64 / 64)?;
        return Ok(data);
    }
    if let (Value::Instance(_), Some(method)) = (source, vm.special(source, sym::BYTES)) {
        return by_method(vm, method);
    }
    let items = if matches!(plain, Value::Str(_)) { None } else { containers::try_collect(vm, source)? };
    let Some(items) = items else {
        let name = vm.type_name(source);
        return Err(vm.type_error(format!("cannot convert '{name}' object to {class}")));
    };
    let what = if class == "bytes" { "bytes" } else { "byte" };
    items.into_iter().map(|item| byte(vm, item, what)).collect()
}

/// The encoding and the error handler that two arguments of `function` name.
fn codec_of(vm: &mut Vm<'_>, encoding: Option<Value>, errors: Option<Value>, function: &str) -> R<(Encoding, Option<Handler>)> {
    let mut name = |value: Option<Value>, argument: &str| match value.map(|v| vm.plain(v)) {
        None => Ok(None),
        Some(Value::Str(s)) => Ok(Some(vm.text(s).to_string())),
        Some(other) => {
            let class = vm.type_name(other);
            Err(vm.type_error(format!("{function}() argument '{argument}' must be str, not {class}")))
        }
    };
    let encoding = name(encoding, "encoding")?;
    let errors = name(errors, "errors")?;
    let handler = errors.map_or(Some(Handler::Strict), |errors| Handler::by_name(&errors));
    let name = encoding.unwrap_or_else(|| "utf-8".into());
    match Encoding::by_name(&name) {
        Some(encoding) => Ok((encoding, handler)),
        None => Err(vm.error(Builtin::LookupError, format!("unknown encoding: {name}"))),
    }
}

fn codec_error(vm: &mut Vm<'_>, error: CodecError, class: Builtin, object: Value, errors: Option<Value>) -> Raise {
    match error {
        CodecError::Unicode { codec, start, end, reason } => {
            let (codec, reason) = (vm.new_str(codec), vm.new_str(reason));
            let args = vm.new_tuple([codec, object, Value::int(start as i64), Value::int(end as i64), reason].as_slice());
            Raise::Exception(vm.heap.exception(class.class(), args))
        }
        CodecError::Type(message) => vm.type_error(message),
        CodecError::Handler => {
            let name = match errors.map(|e| vm.plain(e)) {
                Some(Value::Str(s)) => vm.text(s).to_string(),
                _ => String::new(),
            };
            vm.error(Builtin::LookupError, format!("unknown error handler name '{name}'"))
        }
    }
}

/// `text.encode(encoding, errors)`; `function` says who asks, for messages.
pub fn encode_with(vm: &mut Vm<'_>, text: Ref<Str>, encoding: Option<Value>, errors: Option<Value>, function: &str) -> R<Vec<u8>> {
    let (codec, handler) = codec_of(vm, encoding, errors, function)?;
    let size = vm.heap[text].text.len();
    vm.charge(size as u64 / 16)?;
    vm.reserve(size.saturating_mul(5))?;
    codec::encode(vm.text(text), codec, handler).map_err(|e| codec_error(vm, e, Builtin::UnicodeEncodeError, Value::Str(text), errors))
}

/// `bytes.decode(encoding, errors)`; `function` says who asks, for messages.
pub fn decode_with(vm: &mut Vm<'_>, object: Value, encoding: Option<Value>, errors: Option<Value>, function: &str) -> R<Value> {
    let (codec, handler) = codec_of(vm, encoding, errors, function)?;
    let data = buffer(vm, object)?;
    vm.charge(data.len() as u64 / 16)?;
    vm.reserve(data.len().saturating_mul(4))?;
    match codec::decode(&data, codec, handler) {
        Ok(text) => Ok(vm.new_str(text)),
        Err(e) => Err(codec_error(vm, e, Builtin::UnicodeDecodeError, object, errors)),
    }
}

pub(super) fn decode(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [encoding, errors] = vm.bind("decode", Args { pos: &args.pos[1..], kw: args.kw }, ["encoding", "errors"], 0)?;
    decode_with(vm, args.at(0), encoding, errors, "decode")
}

pub(super) fn fromhex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Str(s) = vm.plain(args.at(1)) else {
        let class = vm.type_name(args.at(1));
        return Err(vm.type_error(format!("fromhex() argument must be str, not {class}")));
    };
    vm.charge(vm.heap[s].text.len() as u64 / 16)?;
    let data = match unhex(vm.text(s)) {
        Ok(data) => data,
        Err(at) => return Err(vm.value_error(format!("non-hexadecimal number found in fromhex() arg at position {at}"))),
    };
    let class = args.at(0);
    if class.is(Builtin::ByteArray.value()) {
        return Ok(make(vm, data, true));
    }
    let made = make(vm, data, false);
    if class.is(Builtin::Bytes.value()) { Ok(made) } else { vm.call(class, &[made]) }
}

/// The bytes of pairs of hexadecimal digits, with blanks between; or the character that is wrong.
fn unhex(text: &str) -> Result<Vec<u8>, usize> {
    let chars: Vec<char> = text.chars().collect();
    let mut data = Vec::with_capacity(chars.len() / 2);
    let mut at = 0;
    while at < chars.len() {
        if matches!(chars[at], ' ' | '\t'..='\r') {
            at += 1;
            continue;
        }
        let digit = |i: usize| chars.get(i).and_then(|c| c.to_digit(16)).ok_or(i);
        data.push((digit(at)? * 16 + digit(at + 1)?) as u8);
        at += 2;
    }
    Ok(data)
}

pub(super) fn hex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let [separator, group] = vm.bind("hex", Args { pos: &args.pos[1..], kw: args.kw }, ["sep", "bytes_per_sep"], 0)?;
    let separator = match separator {
        None => None,
        Some(separator) => {
            let plain = vm.plain(separator);
            let text = match plain {
                Value::Str(s) => vm.text(s).to_string(),
                _ => match content(vm, plain) {
                    Some(data) => super::latin1(data),
                    None => {
                        vm.len(separator)?;
                        return Err(vm.type_error("sep must be str or bytes."));
                    }
                },
            };
            let mut chars = text.chars();
            match (chars.next(), chars.next()) {
                (Some(c), None) if c.is_ascii() => Some(c),
                (Some(_), None) => return Err(vm.value_error("sep must be ASCII.")),
                _ => return Err(vm.value_error("sep must be length 1.")),
            }
        }
    };
    let group = match group {
        Some(group) => vm.index(group)?,
        None => 1,
    };
    vm.charge(receiver.data.len() as u64 / 8)?;
    vm.reserve(receiver.data.len() * 3)?;
    let text = to_hex(&receiver.data, separator.filter(|_| group != 0), group);
    Ok(vm.new_str(text))
}

/// Hexadecimal digits, in groups counted from the right, or from the left where `group` is negative.
fn to_hex(data: &[u8], separator: Option<char>, group: i64) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let size = usize::try_from(group.unsigned_abs()).unwrap_or(usize::MAX);
    let mut out = String::with_capacity(data.len() * 3);
    for (i, byte) in data.iter().enumerate() {
        let before = if group < 0 { i } else { data.len() - i };
        if let Some(separator) = separator
            && i > 0
            && before % size == 0
        {
            out.push(separator);
        }
        out.push(char::from(DIGITS[usize::from(byte >> 4)]));
        out.push(char::from(DIGITS[usize::from(byte & 15)]));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{to_hex, unhex};

    #[test]
    fn bytes_pass_through_hexadecimal() {
        assert_eq!(to_hex(b"abcde", Some(':'), 2), "61:6263:6465");
        assert_eq!(to_hex(b"abcde", Some(':'), -2), "6162:6364:65");
        assert_eq!(to_hex(b"\x00\xff", None, 1), "00ff");
        assert_eq!(unhex("aA bb"), Ok(vec![0xaa, 0xbb]));
        assert_eq!(unhex("a"), Err(1));
        assert_eq!(unhex("a a"), Err(1));
        assert_eq!(unhex("zz"), Err(0));
    }
}
