//! What opens a scope: functions, classes, lambdas, comprehensions.

use ruff_python_ast::name::Name;
use ruff_python_ast::visitor::Visitor;
use ruff_python_ast::{self as ast, Expr};
use ruff_text_size::{Ranged, TextRange};

use super::{Resolver, Uses};
use crate::syntax::scope::{Role, ScopeKind};

impl<'a> Resolver<'a> {
    fn visit_parameter_defaults(&mut self, parameters: &'a ast::Parameters) {
        for parameter in parameters.iter_non_variadic_params() {
            if let Some(default) = &parameter.default {
                self.visit_expr(default);
            }
        }
        for parameter in parameters {
            if let Some(annotation) = &parameter.as_parameter().annotation {
                self.visit_expr(annotation);
            }
        }
    }

    /// In CPython's order: positional, keyword-only, `*args`, `**kwargs`.
    fn bind_parameters(&mut self, parameters: &ast::Parameters) {
        let plain = parameters.iter_non_variadic_params().map(|parameter| &parameter.parameter);
        for parameter in plain.chain(parameters.vararg.as_deref()).chain(parameters.kwarg.as_deref()) {
            self.note(&parameter.name.id, parameter.name.range, Role::Bind, Uses::PARAMETER);
        }
    }

    /// Newer than 3.11, and kept simple: type parameters are names of the scope around the definition.
    pub(super) fn bind_type_params(&mut self, type_params: Option<&'a ast::TypeParams>) {
        for parameter in type_params.into_iter().flat_map(|params| params.iter()) {
            self.bind(parameter.name());
            self.visit_type_param(parameter);
        }
    }

    pub(super) fn function(&mut self, node: &'a ast::StmtFunctionDef) {
        if node.is_async {
            let start = node.decorator_list.last().map_or(node.start(), Ranged::end);
            self.left_out(TextRange::new(start.max(node.start()), node.name.start()), "'async def' is");
        }
        for decorator in &node.decorator_list {
            self.visit_decorator(decorator);
        }
        self.bind_type_params(node.type_params.as_deref());
        self.visit_parameter_defaults(&node.parameters);
        if let Some(returns) = &node.returns {
            self.visit_expr(returns);
        }
        self.bind(&node.name);
        let outer = self.open(ScopeKind::Function, node.range, node.name.id.clone());
        self.bind_parameters(&node.parameters);
        self.visit_body(&node.body);
        self.close(outer);
    }

    pub(super) fn class(&mut self, node: &'a ast::StmtClassDef) {
        for decorator in &node.decorator_list {
            self.visit_decorator(decorator);
        }
        self.bind_type_params(node.type_params.as_deref());
        if let Some(arguments) = &node.arguments {
            self.visit_arguments(arguments);
        }
        self.bind(&node.name);
        let outer = self.open(ScopeKind::Class, node.range, node.name.id.clone());
        self.visit_body(&node.body);
        self.close(outer);
    }

    pub(super) fn lambda(&mut self, node: &'a ast::ExprLambda) {
        if let Some(parameters) = &node.parameters {
            self.visit_parameter_defaults(parameters);
        }
        let outer = self.open(ScopeKind::Lambda, node.range, Name::new_static("<lambda>"));
        if let Some(parameters) = &node.parameters {
            self.bind_parameters(parameters);
        }
        self.visit_expr(&node.body);
        self.close(outer);
    }

    pub(super) fn comprehension(
        &mut self,
        kind: ScopeKind,
        range: TextRange,
        generators: &'a [ast::Comprehension],
        elements: [Option<&'a Expr>; 2],
    ) {
        let name = match kind {
            ScopeKind::SetComp => "<setcomp>",
            ScopeKind::DictComp => "<dictcomp>",
            ScopeKind::Generator => "<genexpr>",
            _ => "<listcomp>",
        };
        if let Some(first) = generators.first() {
            self.visit_expr(&first.iter);
        }
        let outer = self.open(kind, range, Name::new_static(name));
        let hidden = self.intern(&Name::new_static(".0"));
        let scope = self.current;
        self.entry(scope, hidden).uses.add(Uses::PARAMETER);
        for (i, generator) in generators.iter().enumerate() {
            if generator.is_async {
                self.left_out(Self::keyword(generator.range, "async"), "'async for' is");
            }
            if i > 0 {
                self.visit_expr(&generator.iter);
            }
            self.visit_expr(&generator.target);
            for test in &generator.ifs {
                self.visit_expr(test);
            }
        }
        for element in elements.into_iter().flatten() {
            self.visit_expr(element);
        }
        self.close(outer);
    }
}
