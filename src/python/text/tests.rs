//! Against what CPython answered.

use super::codec::{CodecError, Encoding, Handler, decode, decode_message, encode, encode_message};
use super::*;
use crate::python::heap::Complex;
use crate::python::recorded::{float, int, rows};

fn shown(result: Result<String, FormatError>) -> String {
    match result {
        Ok(text) => text,
        Err(FormatError::Value(message)) => format!("ValueError: {message}"),
        Err(FormatError::Overflow(message)) => format!("OverflowError: {message}"),
    }
}

fn formatted(class: &str, value: &str, spec: &str) -> Result<String, FormatError> {
    let parse = |kind, align| Spec::parse(spec, class, kind, align);
    match class {
        "int" => format_big(&int(value), &parse('d', '>')?, class),
        "float" => format_float(float(value), &parse('\0', '>')?, class),
        "complex" => {
            let (re, im) = value.split_once(' ').expect("two parts");
            format_complex(Complex { re: float(re), im: float(im) }, &parse('\0', '>')?)
        }
        _ => format_str(value, &parse('s', '<')?),
    }
}

#[test]
fn every_value_takes_every_spec_as_in_cpython() {
    for (class, value, spec, expected) in rows::<(String, String, String, String)>(include_str!("../recorded/format.json")) {
        assert_eq!(shown(formatted(&class, &value, &spec)), expected, "format({class} {value}, {spec:?})");
        if let ("int", Ok(small)) = (class.as_str(), value.parse()) {
            let spec = Spec::parse(&spec, &class, 'd', '>');
            assert_eq!(shown(spec.and_then(|spec| format_int(small, &spec, "int"))), expected);
        }
    }
}

#[test]
#[allow(clippy::excessive_precision)]
fn floats_read_back() {
    for (x, expected) in rows::<(String, String)>(include_str!("../recorded/float_repr.json")) {
        assert_eq!(float_repr(float(&x)), expected);
    }
    assert_eq!(float_repr(1000000000000000.25), "1000000000000000.2");
    assert_eq!(complex_repr(Complex { re: -0.0, im: 1.0 }), "(-0+1j)");
    assert_eq!(complex_repr(Complex { re: 0.0, im: -0.0 }), "-0j");
    assert_eq!(complex_repr(Complex { re: 1e16, im: f64::NAN }), "(1e+16+nanj)");
}

#[test]
fn strings_are_quoted() {
    for (text, repr, ascii_repr) in rows::<(String, String, String)>(include_str!("../recorded/repr.json")) {
        assert_eq!(repr_str(&text), repr);
        assert_eq!(ascii(&repr_str(&text)), ascii_repr);
    }
    assert_eq!(repr_bytes(b"it's \"\n\x00\xff\\"), r#"b'it\'s "\n\x00\xff\\'"#);
}

#[test]
fn characters_have_their_kinds() {
    type Row = (String, [bool; 7], String, String);
    for (text, kinds, title, folded) in rows::<Row>(include_str!("../recorded/characters.json")) {
        let c = text.chars().next().expect("one character");
        let ours = [
            unicode::is_alpha(c),
            unicode::decimal(c).is_some(),
            unicode::is_digit(c),
            unicode::is_numeric(c),
            unicode::is_space(c),
            unicode::is_printable(c),
            unicode::is_title(c),
        ];
        assert_eq!(ours, kinds, "{c:?}");
        let (mut ours, mut fold) = (String::new(), String::new());
        unicode::push_title(&mut ours, c);
        unicode::push_folded(&mut fold, c);
        assert_eq!((ours, fold), (title, folded), "{c:?}");
    }
}

#[test]
fn what_cannot_be_encoded_is_told_or_replaced() {
    let narrow = |handler| encode("aé😀", Encoding::Ascii, Handler::by_name(handler));
    let reason = "ordinal not in range(128)".to_string();
    assert_eq!(narrow("strict"), Err(CodecError::Unicode { codec: "ascii", start: 1, end: 3, reason }));
    assert_eq!(narrow("ignore"), Ok(b"a".to_vec()));
    assert_eq!(narrow("xmlcharrefreplace"), Ok(b"a&#233;&#128512;".to_vec()));
    assert_eq!(narrow("backslashreplace"), Ok(b"a\\xe9\\U0001f600".to_vec()));
    assert_eq!(narrow("unheard of"), Err(CodecError::Handler));
}

#[test]
fn what_cannot_be_decoded_is_told_or_replaced() {
    let utf8 = Encoding::Utf8 { mark: false };
    let told = |bytes: &[u8], name: &str| decode(bytes, Encoding::by_name(name).expect("known"), Some(Handler::Strict));
    let error = |codec, start, end, reason: &str| Err(CodecError::Unicode { codec, start, end, reason: reason.into() });
    assert_eq!(told(b"\xff", "utf-8"), error("utf-8", 0, 1, "invalid start byte"));
    assert_eq!(told(b"a\xe2\x82A", "utf8"), error("utf-8", 1, 3, "invalid continuation byte"));
    assert_eq!(told(b"\xe2\x82", "U8"), error("utf-8", 0, 2, "unexpected end of data"));
    assert_eq!(told(b"\0\xd8a\0", "utf-16-le"), error("utf-16-le", 0, 2, "illegal UTF-16 surrogate"));
    assert_eq!(decode_message("utf-8", Some(0xff), 0, 1, "bad"), "'utf-8' codec can't decode byte 0xff in position 0: bad");
    assert_eq!(encode_message("ascii", Some('é'), 0, 2, "bad"), "'ascii' codec can't encode characters in position 0-1: bad");
    assert_eq!(decode(b"\xe2\x82A", utf8, Some(Handler::Replace)), Ok("\u{fffd}A".into()));
    for name in ["utf-8", "utf-8-sig", "utf-16", "utf-16-be", "utf-32", "utf_32_le"] {
        let encoding = Encoding::by_name(name).expect("known");
        let bytes = encode("né😀", encoding, Some(Handler::Strict)).expect("all of Unicode");
        assert_eq!(decode(&bytes, encoding, Some(Handler::Strict)), Ok("né😀".into()), "{name}");
    }
}
