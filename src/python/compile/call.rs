//! Calls.

use ruff_text_size::{Ranged, TextRange};

use super::collection::Sequence;
use super::emit::narrow;
use super::{Compiled, Compiler};
use crate::python::code::{Const, Op};
use crate::syntax::ast::{self, Arguments, Expr, Keyword};

/// More arguments than this are collected in a tuple and a dict.
const MOST_ON_STACK: usize = 200;

fn is_simple(arguments: &Arguments) -> bool {
    arguments.args.len() + arguments.keywords.len() <= MOST_ON_STACK
        && !arguments.args.iter().any(Expr::is_starred_expr)
        && arguments.keywords.iter().all(|keyword| keyword.arg.is_some())
}

/// Unlike attributes, keywords of a call are never mangled.
fn keyword_name(name: &ast::Identifier) -> Const {
    Const::Str(name.as_str().into())
}

impl<'a> Compiler<'a> {
    pub(super) fn call(&mut self, node: &'a ast::ExprCall) -> Compiled {
        let range = node.range();
        match node.func.as_ref() {
            Expr::Attribute(attribute) if is_simple(&node.arguments) => {
                self.expr(&attribute.value)?;
                let name = self.attribute(&attribute.attr);
                self.emit(Op::LoadMethod(name), attribute.range);
                self.simple_arguments(0, &node.arguments, true, range)
            }
            function => {
                self.expr(function)?;
                self.arguments(0, &node.arguments, range)
            }
        }
    }

    /// Calls the callee on the stack, which `waiting` arguments follow, with more arguments.
    pub(super) fn arguments(&mut self, waiting: u16, arguments: &'a Arguments, range: TextRange) -> Compiled {
        if is_simple(arguments) {
            self.simple_arguments(waiting, arguments, false, range)
        } else {
            self.collected_arguments(waiting, arguments, range)
        }
    }

    fn simple_arguments(&mut self, waiting: u16, arguments: &'a Arguments, method: bool, range: TextRange) -> Compiled {
        for argument in &arguments.args {
            self.expr(argument)?;
        }
        let mut names = Vec::new();
        for keyword in &arguments.keywords {
            self.expr(&keyword.value)?;
            names.extend(keyword.arg.as_ref().map(keyword_name));
        }
        let count = waiting.saturating_add(u16::try_from(arguments.args.len() + names.len()).unwrap_or(u16::MAX));
        let op = if names.is_empty() {
            if method { Op::CallMethod(count.into()) } else { Op::Call(count.into()) }
        } else {
            let names = self.unit.emitter.constant(Const::Tuple(names));
            if method { Op::CallMethodKw { count, names } } else { Op::CallKw { count, names } }
        };
        self.emit(op, range);
        Ok(())
    }

    fn collected_arguments(&mut self, waiting: u16, arguments: &'a Arguments, range: TextRange) -> Compiled {
        match arguments.args.as_ref() {
            [Expr::Starred(only)] if waiting == 0 => self.expr(&only.value)?,
            args => self.sequence(Sequence::Tuple, waiting.into(), args, range)?,
        }
        let keywords = arguments.keywords.as_slice();
        if !keywords.is_empty() {
            self.collected_keywords(keywords, range)?;
        }
        self.emit(Op::CallEx(!keywords.is_empty()), range);
        Ok(())
    }

    /// Leaves a new dict of the keyword arguments on the stack, above the callee and the positional arguments.
    fn collected_keywords(&mut self, mut keywords: &'a [Keyword], range: TextRange) -> Compiled {
        let mut begun = false;
        while let Some((first, rest)) = keywords.split_first() {
            let named = keywords.iter().take_while(|keyword| keyword.arg.is_some()).take(MOST_ON_STACK).count();
            if !begun || named > 0 {
                for keyword in &keywords[..named] {
                    if let Some(name) = &keyword.arg {
                        self.constant(keyword_name(name), keyword.range);
                    }
                    self.expr(&keyword.value)?;
                }
                self.emit(Op::BuildDict(narrow(named)), range);
                if begun {
                    self.emit(Op::DictMerge(2), range);
                }
                begun = true;
                keywords = &keywords[named..];
            } else {
                self.expr(&first.value)?;
                self.emit(Op::DictMerge(2), range);
                keywords = rest;
            }
        }
        Ok(())
    }
}
