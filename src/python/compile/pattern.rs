//! `match`.
//!
//! A pattern takes its subject from the stack. What it captures waits in hidden locals, so that names are bound only when the whole
//! pattern has matched, as in CPython. Where it fails, what waits on the stack above the subject of the statement is dropped.

use ruff_text_size::{Ranged, TextRange};

use super::emit::narrow;
use super::{Compiled, Compiler, Label, RED_ZONE, STACK_PIECE, error};
use crate::python::code::{Const, Op};
use crate::python::value::{BinaryOp, CompareOp};
use crate::syntax::ast::{self, Identifier, Pattern, Singleton};

/// More names than anyone captures in one pattern.
const MAX_CAPTURES: usize = 1000;

/// One pattern under way.
struct Matching<'a> {
    /// Captured names, by hidden local.
    names: Vec<&'a Identifier>,
    /// Where to go on failure, by the number of operands to drop first.
    failed: Vec<Label>,
    /// The operands that are left on failure.
    depth: u32,
}

fn is_wildcard(pattern: &Pattern) -> bool {
    match pattern {
        Pattern::MatchAs(node) => node.pattern.is_none() && node.name.is_none(),
        Pattern::MatchStar(node) => node.name.is_none(),
        _ => false,
    }
}

impl<'a> Compiler<'a> {
    pub(super) fn match_statement(&mut self, node: &'a ast::StmtMatch) -> Compiled {
        self.expr(&node.subject)?;
        let end = self.label();
        for case in &node.cases {
            let last = case.guard.as_ref().map_or(case.pattern.end(), |guard| guard.end());
            let header = TextRange::new(case.start(), last);
            let mut matching = Matching { names: Vec::new(), failed: Vec::new(), depth: self.unit.emitter.depth() };
            self.unit.emitter.mark(header);
            self.emit(Op::Dup, header);
            self.pattern(&case.pattern, &mut matching)?;
            for (i, name) in matching.names.iter().enumerate() {
                let slot = self.hidden(i, name.range)?;
                self.emit(Op::LoadFast(slot), name.range);
                self.store_name(name, name.range);
            }
            if let Some(guard) = &case.guard {
                let failed = self.failure(&mut matching, 0);
                self.jump_if(guard, false, failed)?;
            }
            self.emit(Op::Pop, header);
            self.body(&case.body)?;
            self.jump(Op::Jump, end, header);
            self.fail_here(&matching, header);
        }
        self.emit(Op::Pop, node.subject.range());
        self.bind(end);
        Ok(())
    }

    fn hidden(&mut self, at: usize, range: TextRange) -> Result<u16, super::CompileError> {
        if at >= MAX_CAPTURES {
            return error(range, "too many names in one pattern");
        }
        self.unit.hidden = self.unit.hidden.max(at + 1);
        Ok(u16::try_from(self.scopes.get(self.unit.scope).locals.len() + at).unwrap_or(u16::MAX))
    }

    fn failure(&mut self, matching: &mut Matching<'a>, waiting: u32) -> Label {
        while matching.failed.len() <= waiting as usize {
            matching.failed.push(self.label());
        }
        matching.failed[waiting as usize]
    }

    /// Jumps to where the pattern has failed; `popped` operands go with the jump.
    fn fail(&mut self, matching: &mut Matching<'a>, make: fn(u32) -> Op, popped: u32, range: TextRange) {
        let waiting = self.unit.emitter.depth().saturating_sub(popped + matching.depth);
        let label = self.failure(matching, waiting);
        self.jump(make, label, range);
    }

    /// The place where a pattern has failed: drops what waits, and leaves the stack as before the pattern's subject was pushed.
    fn fail_here(&mut self, matching: &Matching<'a>, range: TextRange) {
        let count = narrow(matching.failed.len());
        self.unit.emitter.set_depth(matching.depth + count.saturating_sub(1));
        for (i, label) in matching.failed.iter().enumerate().rev() {
            self.bind(*label);
            if i > 0 {
                self.emit(Op::Pop, range);
            }
        }
    }

    fn capture(&mut self, name: &'a Identifier, matching: &mut Matching<'a>) -> Compiled {
        let at = matching.names.iter().position(|known| known.as_str() == name.as_str()).unwrap_or_else(|| {
            matching.names.push(name);
            matching.names.len() - 1
        });
        let slot = self.hidden(at, name.range)?;
        self.emit(Op::StoreFast(slot), name.range);
        Ok(())
    }

    /// subject →
    fn pattern(&mut self, pattern: &'a Pattern, matching: &mut Matching<'a>) -> Compiled {
        stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.plain_pattern(pattern, matching))
    }

    fn plain_pattern(&mut self, pattern: &'a Pattern, matching: &mut Matching<'a>) -> Compiled {
        let range = pattern.range();
        match pattern {
            Pattern::MatchValue(node) => {
                self.expr(&node.value)?;
                self.emit(Op::Compare(CompareOp::Eq), range);
                self.fail(matching, Op::PopJumpIfFalse, 1, range);
            }
            Pattern::MatchSingleton(node) => {
                let value = match node.value {
                    Singleton::None => Const::None,
                    Singleton::True => Const::Bool(true),
                    Singleton::False => Const::Bool(false),
                };
                self.constant(value, range);
                self.emit(Op::Is(false), range);
                self.fail(matching, Op::PopJumpIfFalse, 1, range);
            }
            Pattern::MatchSequence(node) => return self.sequence_pattern(&node.patterns, range, matching),
            Pattern::MatchMapping(node) => return self.mapping_pattern(node, matching),
            Pattern::MatchClass(node) => return self.class_pattern(node, matching),
            Pattern::MatchStar(node) => return self.capture_or_drop(node.name.as_ref(), range, matching),
            Pattern::MatchAs(node) => {
                if let Some(inner) = &node.pattern {
                    if node.name.is_some() {
                        self.emit(Op::Dup, range);
                    }
                    self.pattern(inner, matching)?;
                    if node.name.is_none() {
                        return Ok(());
                    }
                }
                return self.capture_or_drop(node.name.as_ref(), range, matching);
            }
            Pattern::MatchOr(node) => return self.or_pattern(node, matching),
        }
        Ok(())
    }

    fn capture_or_drop(&mut self, name: Option<&'a Identifier>, range: TextRange, matching: &mut Matching<'a>) -> Compiled {
        match name {
            Some(name) => self.capture(name, matching),
            None => {
                self.emit(Op::Pop, range);
                Ok(())
            }
        }
    }

    fn or_pattern(&mut self, node: &'a ast::PatternMatchOr, matching: &mut Matching<'a>) -> Compiled {
        let matched = self.label();
        let depth = self.unit.emitter.depth();
        for alternative in &node.patterns {
            let names = std::mem::take(&mut matching.names);
            let mut inner = Matching { names, failed: Vec::new(), depth };
            self.emit(Op::Dup, node.range);
            self.pattern(alternative, &mut inner)?;
            self.jump(Op::Jump, matched, node.range);
            self.fail_here(&inner, node.range);
            matching.names = inner.names;
        }
        self.emit(Op::Pop, node.range);
        self.fail(matching, Op::Jump, 0, node.range);
        self.bind(matched);
        self.emit(Op::Pop, node.range);
        Ok(())
    }

    fn check_length_of(&mut self, op: CompareOp, length: usize, range: TextRange, matching: &mut Matching<'a>) {
        self.emit(Op::GetLen, range);
        self.constant(Const::Int(i64::try_from(length).unwrap_or(i64::MAX)), range);
        self.emit(Op::Compare(op), range);
        self.fail(matching, Op::PopJumpIfFalse, 1, range);
    }

    fn sequence_pattern(&mut self, patterns: &'a [Pattern], range: TextRange, matching: &mut Matching<'a>) -> Compiled {
        let star = patterns.iter().position(Pattern::is_match_star);
        self.emit(Op::MatchSequence, range);
        self.fail(matching, Op::PopJumpIfFalse, 1, range);
        match star {
            None => self.check_length_of(CompareOp::Eq, patterns.len(), range, matching),
            Some(_) if patterns.len() > 1 => self.check_length_of(CompareOp::Ge, patterns.len() - 1, range, matching),
            Some(_) => {}
        }
        if patterns.iter().all(is_wildcard) {
            self.emit(Op::Pop, range);
            return Ok(());
        }
        match star {
            Some(star) if is_wildcard(&patterns[star]) => return self.indexed_patterns(patterns, star, range, matching),
            Some(star) => match (u16::try_from(star), u16::try_from(patterns.len() - star - 1)) {
                (Ok(before), Ok(after)) => self.emit(Op::UnpackEx { before, after }, range),
                _ => return error(range, "too many expressions in star-unpacking sequence pattern"),
            },
            None => self.emit(Op::Unpack(narrow(patterns.len())), range),
        }
        patterns.iter().try_for_each(|pattern| self.pattern(pattern, matching))
    }

    /// `[a, *_, b]`: only the items that are looked at.
    fn indexed_patterns(&mut self, patterns: &'a [Pattern], star: usize, range: TextRange, matching: &mut Matching<'a>) -> Compiled {
        let int = |n: usize| Const::Int(i64::try_from(n).unwrap_or(i64::MAX));
        for (i, pattern) in patterns.iter().enumerate().filter(|(_, pattern)| !is_wildcard(pattern)) {
            self.emit(Op::Dup, pattern.range());
            if i < star {
                self.constant(int(i), pattern.range());
            } else {
                self.emit(Op::GetLen, pattern.range());
                self.constant(int(patterns.len() - i), pattern.range());
                self.emit(Op::Binary(BinaryOp::Sub), pattern.range());
            }
            self.emit(Op::LoadSubscr, pattern.range());
            self.pattern(pattern, matching)?;
        }
        self.emit(Op::Pop, range);
        Ok(())
    }

    fn mapping_pattern(&mut self, node: &'a ast::PatternMatchMapping, matching: &mut Matching<'a>) -> Compiled {
        let range = node.range;
        self.emit(Op::MatchMapping, range);
        self.fail(matching, Op::PopJumpIfFalse, 1, range);
        if node.keys.is_empty() && node.rest.is_none() {
            self.emit(Op::Pop, range);
            return Ok(());
        }
        if !node.keys.is_empty() {
            self.check_length_of(CompareOp::Ge, node.keys.len(), range, matching);
        }
        for key in &node.keys {
            self.expr(key)?;
        }
        self.emit(Op::BuildTuple(narrow(node.keys.len())), range);
        self.emit(Op::MatchKeys, range);
        self.emit(Op::Dup, range);
        self.fail(matching, Op::PopJumpIfNone, 1, range);
        self.emit(Op::Unpack(narrow(node.keys.len())), range);
        node.patterns.iter().try_for_each(|pattern| self.pattern(pattern, matching))?;
        match &node.rest {
            Some(rest) => {
                self.emit(Op::MatchRest, range);
                self.capture(rest, matching)
            }
            None => {
                self.emit(Op::Pop, range);
                self.emit(Op::Pop, range);
                Ok(())
            }
        }
    }

    fn class_pattern(&mut self, node: &'a ast::PatternMatchClass, matching: &mut Matching<'a>) -> Compiled {
        let range = node.range;
        let (positional, keywords) = (&node.arguments.patterns, &node.arguments.keywords);
        self.expr(&node.cls)?;
        let names = keywords.iter().map(|keyword| Const::Str(keyword.attr.as_str().into())).collect();
        self.constant(Const::Tuple(names), range);
        self.emit(Op::MatchClass(narrow(positional.len())), range);
        self.emit(Op::Dup, range);
        self.fail(matching, Op::PopJumpIfNone, 1, range);
        self.emit(Op::Unpack(narrow(positional.len() + keywords.len())), range);
        positional.iter().chain(keywords.iter().map(|keyword| &keyword.pattern)).try_for_each(|pattern| self.pattern(pattern, matching))
    }
}
