//! f-strings.

use ruff_text_size::{Ranged, TextRange};

use super::emit::narrow;
use super::{Compiled, Compiler};
use crate::python::code::{Const, Op};
use crate::syntax::ast::{self, ConversionFlag, FStringPart, InterpolatedStringElement};

/// The parts of an f-string so far: how many are on the stack, and literal text still to be put there.
#[derive(Default)]
struct Parts {
    count: usize,
    text: String,
}

impl<'a> Compiler<'a> {
    pub(super) fn fstring(&mut self, node: &'a ast::ExprFString) -> Compiled {
        let mut parts = Parts::default();
        for part in &node.value {
            match part {
                FStringPart::Literal(literal) => parts.text.push_str(&literal.value),
                FStringPart::FString(fstring) => self.elements(&mut parts, &fstring.elements)?,
            }
        }
        self.join(parts, node.range);
        Ok(())
    }

    fn flush(&mut self, parts: &mut Parts, range: TextRange) {
        if !parts.text.is_empty() {
            let text = std::mem::take(&mut parts.text);
            self.constant(Const::Str(text.into()), range);
            parts.count += 1;
        }
    }

    fn join(&mut self, mut parts: Parts, range: TextRange) {
        self.flush(&mut parts, range);
        match parts.count {
            0 => self.constant(Const::Str("".into()), range),
            1 => {}
            count => self.emit(Op::BuildString(narrow(count)), range),
        }
    }

    fn elements(&mut self, parts: &mut Parts, elements: &'a ast::InterpolatedStringElements) -> Compiled {
        for element in elements {
            match element {
                InterpolatedStringElement::Literal(literal) => parts.text.push_str(&literal.value),
                InterpolatedStringElement::Interpolation(node) => self.interpolation(parts, node)?,
            }
        }
        Ok(())
    }

    fn interpolation(&mut self, parts: &mut Parts, node: &'a ast::InterpolatedElement) -> Compiled {
        if let Some(debug) = &node.debug_text {
            parts.text.push_str(debug.as_str());
        }
        self.flush(parts, node.range);
        self.expr(&node.expression)?;
        let conversion = match node.conversion {
            ConversionFlag::Str => b's',
            ConversionFlag::Repr => b'r',
            ConversionFlag::Ascii => b'a',
            ConversionFlag::None if node.debug_text.is_some() && node.format_spec.is_none() => b'r',
            ConversionFlag::None => 0,
        };
        if let Some(spec) = &node.format_spec {
            let mut inner = Parts::default();
            self.elements(&mut inner, &spec.elements)?;
            self.join(inner, spec.range());
        }
        self.emit(Op::Format { conversion, spec: node.format_spec.is_some() }, node.expression.range());
        parts.count += 1;
        Ok(())
    }
}
