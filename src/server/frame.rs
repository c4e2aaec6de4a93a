//! Messages on a stream of bytes: `Content-Length: N`, a blank line, N bytes.
//!
//! What is no message is refused, and reading goes on at the next header, wherever in a line it stands.

use std::io::{self, BufRead, Read, Write};

/// Longer messages are refused: programs and templates are much shorter.
pub(super) const MAX_BODY: u64 = 64 << 20;
/// So much of a line is looked at in one piece.
const MAX_LINE: u64 = 8 << 10;
const LENGTH: &[u8] = b"content-length:";

/// What came.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Frame {
    /// The bytes of a message.
    Body(Vec<u8>),
    /// Bytes that are no message.
    Refused(&'static str),
}

/// Takes messages from a stream.
#[derive(Debug)]
pub(super) struct FrameReader<R> {
    input: R,
}

impl<R: BufRead> FrameReader<R> {
    pub(super) fn new(input: R) -> FrameReader<R> {
        FrameReader { input }
    }

    /// The next message; `None` at the end of the stream.
    pub(super) fn next(&mut self) -> io::Result<Option<Frame>> {
        let mut length: Option<Result<u64, ()>> = None;
        let mut noise = false;
        let mut line = Vec::new();
        loop {
            // A line that is too long to be a header is looked at piece by piece; a header may stand across two of them.
            let kept = if line.ends_with(b"\n") { 0 } else { line.len().min(LENGTH.len() + 20) };
            line.drain(..line.len() - kept);
            if self.input.by_ref().take(MAX_LINE).read_until(b'\n', &mut line)? == 0 {
                return Ok(None);
            }
            if !line.ends_with(b"\n") {
                noise = true;
                continue;
            }
            match (line.trim_ascii().is_empty(), length) {
                (true, Some(Ok(length))) => return self.body(length),
                (true, Some(Err(()))) => return Ok(Some(Frame::Refused("the Content-Length is no number that can be"))),
                (true, None) if noise => return Ok(Some(Frame::Refused("a message begins with its Content-Length"))),
                (true, None) => {}
                (false, _) => match content_length(&line) {
                    Some(found) => length = Some(found),
                    None => noise = true,
                },
            }
        }
    }

    fn body(&mut self, length: u64) -> io::Result<Option<Frame>> {
        let mut body = Vec::new();
        self.input.by_ref().take(length).read_to_end(&mut body)?;
        Ok((body.len() as u64 == length).then_some(Frame::Body(body)))
    }
}

/// The length that a line tells, if it tells one: of two in a line the last, for the first was cut off.
fn content_length(line: &[u8]) -> Option<Result<u64, ()>> {
    let at = line.windows(LENGTH.len()).rposition(|part| part.eq_ignore_ascii_case(LENGTH))?;
    let value = std::str::from_utf8(&line[at + LENGTH.len()..]).ok().and_then(|value| value.trim().parse().ok());
    Some(value.filter(|length| *length <= MAX_BODY).ok_or(()))
}

/// Writes a message.
pub(super) fn write_frame(output: &mut impl Write, body: &[u8]) -> io::Result<()> {
    write!(output, "Content-Length: {}\r\n\r\n", body.len())?;
    output.write_all(body)?;
    output.flush()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(bytes: &[u8], piece: usize) -> Vec<Frame> {
        let mut reader = FrameReader::new(io::BufReader::with_capacity(piece, bytes));
        std::iter::from_fn(|| reader.next().unwrap()).collect()
    }

    fn body(text: &str) -> Frame {
        Frame::Body(text.as_bytes().to_vec())
    }

    #[test]
    fn reading_goes_on_at_the_next_header() {
        let refused = |found: &Frame| matches!(found, Frame::Refused(_));
        let frames = read(b"Content-Length: x\r\n\r\n{}Content-Length: 2\r\n\r\nab\r\n\r\nhello\r\n\r\ncontent-length:1\n\nc", 64);
        assert_eq!(frames.len(), 4, "{frames:?}");
        assert!(refused(&frames[0]) && refused(&frames[2]), "{frames:?}");
        assert_eq!((&frames[1], &frames[3]), (&body("ab"), &body("c")));
    }

    #[test]
    fn what_claims_to_be_too_long_is_not_waited_for() {
        let frames = read(b"Content-Length: 99999999999\r\n\r\n{}\r\nContent-Length: 1\r\n\r\nx", 64);
        assert_eq!(frames.len(), 2, "{frames:?}");
        assert_eq!(frames[1], body("x"));
    }

    #[test]
    fn a_header_after_a_long_line_of_noise_is_found() {
        for noise in (8150..8250).chain([40_000]) {
            let mut bytes = vec![b'n'; noise];
            bytes.extend(b"Content-Length: 3\r\n\r\nabc");
            assert_eq!(read(&bytes, 4096).last(), Some(&body("abc")), "{noise}");
        }
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_in_whatever_pieces(texts in prop::collection::vec(".{0,40}", 0..6), piece in 1usize..50) {
            let mut bytes = Vec::new();
            for text in &texts {
                write_frame(&mut bytes, text.as_bytes()).unwrap();
            }
            prop_assert_eq!(read(&bytes, piece), texts.iter().map(|text| body(text)).collect::<Vec<_>>());
        }

        #[test]
        fn no_bytes_hang_it(bytes in prop::collection::vec(any::<u8>(), 0..300), piece in 1usize..50) {
            read(&bytes, piece);
        }
    }
}
