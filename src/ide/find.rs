//! Where in the tree a place of the text is.

use super::program::View;
use crate::syntax::ast::visitor::source_order::{SourceOrderVisitor, TraversalSignal, walk_expr, walk_node};
use crate::syntax::ast::{self, AnyNodeRef, Expr, Ranged as _};
use crate::syntax::scope::{Occurrence, Variable};
use ruff_text_size::{TextRange, TextSize};

/// The nodes that hold a place or end at it, the outermost first. Where one ends and another begins there, both are there.
pub(super) fn nodes_at<'a>(view: &View<'a>, offset: TextSize) -> Vec<AnyNodeRef<'a>> {
    struct Visitor<'a> {
        offset: TextSize,
        found: Vec<AnyNodeRef<'a>>,
    }
    impl<'a> SourceOrderVisitor<'a> for Visitor<'a> {
        fn enter_node(&mut self, node: AnyNodeRef<'a>) -> TraversalSignal {
            if !node.range().contains_inclusive(self.offset) {
                return TraversalSignal::Skip;
            }
            self.found.push(node);
            TraversalSignal::Traverse
        }
    }
    let mut visitor = Visitor { offset, found: Vec::new() };
    view.with_stack(|| walk_node(&mut visitor, AnyNodeRef::from(&view.program.parsed.module)));
    visitor.found
}

/// The expressions that hold a place or end at it, the outermost first.
pub(super) fn expressions_at<'a>(view: &View<'a>, offset: TextSize) -> Vec<&'a Expr> {
    struct Visitor<'a> {
        offset: TextSize,
        found: Vec<&'a Expr>,
    }
    impl<'a> SourceOrderVisitor<'a> for Visitor<'a> {
        fn enter_node(&mut self, node: AnyNodeRef<'a>) -> TraversalSignal {
            if node.range().contains_inclusive(self.offset) { TraversalSignal::Traverse } else { TraversalSignal::Skip }
        }
        fn visit_expr(&mut self, expr: &'a Expr) {
            if expr.range().contains_inclusive(self.offset) {
                self.found.push(expr);
                walk_expr(self, expr);
            }
        }
    }
    let mut visitor = Visitor { offset, found: Vec::new() };
    view.with_stack(|| walk_node(&mut visitor, AnyNodeRef::from(&view.program.parsed.module)));
    visitor.found
}

/// Every node of the program, in the order of the text.
pub(super) fn for_each_node<'a>(view: &View<'a>, visit: &mut dyn FnMut(AnyNodeRef<'a>)) {
    struct Visitor<'v, 'a>(&'v mut dyn FnMut(AnyNodeRef<'a>));
    impl<'a> SourceOrderVisitor<'a> for Visitor<'_, 'a> {
        fn enter_node(&mut self, node: AnyNodeRef<'a>) -> TraversalSignal {
            (self.0)(node);
            TraversalSignal::Traverse
        }
    }
    view.with_stack(|| walk_node(&mut Visitor(visit), AnyNodeRef::from(&view.program.parsed.module)));
}

/// The innermost statement at a place.
pub(super) fn statement_at<'a>(nodes: &[AnyNodeRef<'a>]) -> Option<AnyNodeRef<'a>> {
    nodes.iter().rev().find(|node| node.is_statement()).copied()
}

/// The name of a variable that stands at a place, and what is done with it. A name that begins there goes before one that ends there.
pub(super) fn occurrence_at<'a>(view: &View<'a>, offset: TextSize) -> Option<&'a Occurrence> {
    let occurrences = view.program.parsed.scopes.occurrences();
    let touching = occurrences.iter().filter(|found| found.range.contains_inclusive(offset) && !found.range.is_empty());
    touching.max_by_key(|found| found.range.start())
}

/// The variable that a name means.
pub(super) fn variable_of(view: &View, occurrence: &Occurrence) -> Option<Variable> {
    view.program.parsed.scopes.variable(occurrence.scope, occurrence.name)
}

/// Every occurrence of a variable, in the order of the text.
pub(super) fn occurrences_of<'a>(view: &View<'a>, variable: Variable) -> Vec<&'a Occurrence> {
    let scopes = &view.program.parsed.scopes;
    let named = scopes.occurrences().iter().filter(|found| found.name == variable.name);
    let mut found: Vec<_> = named.filter(|found| scopes.variable(found.scope, found.name) == Some(variable)).collect();
    found.sort_by_key(|found| found.range.start());
    found.dedup_by_key(|found| found.range);
    found
}

/// An attribute's name that stands at a place: `o.min` at `min`.
pub(super) fn attribute_at<'a>(nodes: &[AnyNodeRef<'a>], offset: TextSize) -> Option<&'a ast::ExprAttribute> {
    nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::ExprAttribute(attribute) if attribute.attr.range.contains_inclusive(offset) => Some(*attribute),
        _ => None,
    })
}

/// The name of a keyword argument that stands at a place, with the call.
pub(super) fn keyword_at<'a>(nodes: &[AnyNodeRef<'a>], offset: TextSize) -> Option<(&'a ast::Keyword, &'a ast::ExprCall)> {
    let keyword = nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::Keyword(keyword) if keyword.arg.as_ref().is_some_and(|name| name.range.contains_inclusive(offset)) => Some(*keyword),
        _ => None,
    })?;
    let call = nodes.iter().rev().find_map(|node| match node {
        AnyNodeRef::ExprCall(call) if call.arguments.keywords.iter().any(|known| std::ptr::eq(known, keyword)) => Some(*call),
        _ => None,
    })?;
    Some((keyword, call))
}

/// The name at the root of `o[1].min.x`, and the expression before the first attribute of geometry.
pub(super) fn root(expr: &Expr) -> Option<&ast::ExprName> {
    let mut at = expr;
    loop {
        at = match at {
            Expr::Name(name) => return Some(name),
            Expr::Attribute(attribute) => &attribute.value,
            Expr::Subscript(subscript) => &subscript.value,
            Expr::Starred(starred) => &starred.value,
            _ => return None,
        };
    }
}

/// The targets of a statement that assigns.
pub(super) fn targets(node: AnyNodeRef<'_>) -> Vec<&Expr> {
    fn parts<'a>(target: &'a Expr, found: &mut Vec<&'a Expr>) {
        match target {
            Expr::Tuple(tuple) => tuple.elts.iter().for_each(|part| parts(part, found)),
            Expr::List(list) => list.elts.iter().for_each(|part| parts(part, found)),
            Expr::Starred(starred) => parts(&starred.value, found),
            _ => found.push(target),
        }
    }
    let mut found = Vec::new();
    match node {
        AnyNodeRef::StmtAssign(assign) => assign.targets.iter().for_each(|target| parts(target, &mut found)),
        AnyNodeRef::StmtAugAssign(assign) => parts(&assign.target, &mut found),
        AnyNodeRef::StmtAnnAssign(assign) => parts(&assign.target, &mut found),
        _ => {}
    }
    found
}

/// Every `def`, inner ones too, in the order of the text.
pub(super) fn functions<'a>(view: &View<'a>) -> Vec<&'a ast::StmtFunctionDef> {
    let mut found = Vec::new();
    for_each_node(view, &mut |node| {
        if let AnyNodeRef::StmtFunctionDef(def) = node {
            found.push(def);
        }
    });
    found
}

/// The function that a call calls by its name, where the name means only that function.
pub(super) fn callee<'a>(
    view: &View<'a>,
    call: &ast::ExprCall,
    functions: &[&'a ast::StmtFunctionDef],
) -> Option<&'a ast::StmtFunctionDef> {
    let Expr::Name(name) = call.func.as_ref() else { return None };
    named_function(view, name.range, functions)
}

/// The function that a name means, where it means only that.
pub(super) fn named_function<'a>(
    view: &View<'a>,
    name: TextRange,
    functions: &[&'a ast::StmtFunctionDef],
) -> Option<&'a ast::StmtFunctionDef> {
    let scopes = &view.program.parsed.scopes;
    let occurrence = scopes.occurrences().iter().find(|found| found.range == name)?;
    let variable = variable_of(view, occurrence)?;
    let mut bindings = occurrences_of(view, variable).into_iter().filter(|found| found.role == crate::syntax::scope::Role::Bind);
    let binding = bindings.next().filter(|_| bindings.next().is_none())?;
    functions.iter().find(|def| def.name.range == binding.range).copied()
}
