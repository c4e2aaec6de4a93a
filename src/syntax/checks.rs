//! The parser crate's own checks of what a grammar cannot say, and CPython's words for them.

use std::cell::RefCell;

use ruff_python_ast::{IrrefutablePatternKind, PythonVersion};
use ruff_python_parser::semantic_errors::{LazyImportContext, SemanticSyntaxContext, SemanticSyntaxError, SemanticSyntaxErrorKind};
use ruff_text_size::TextRange;

use super::error::SyntaxError;
use super::scope::ScopeKind;

/// Where the walk stands.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) kind: ScopeKind,
    /// In the body of a loop of the current scope.
    pub(super) in_loop: bool,
    /// In an `except*` handler of the current scope, and in no loop inside it.
    pub(super) in_star_handler: bool,
    /// In a loop inside an `except*` handler of the current scope.
    pub(super) in_star_handler_loop: bool,
    /// Directly in a class body, or in comprehensions that are.
    pub(super) in_class_body: bool,
}

impl Place {
    /// At the start of a scope that is written here.
    pub(super) fn inside(self, kind: ScopeKind) -> Place {
        let in_class_body = kind == ScopeKind::Class || (kind.is_comprehension() && self.in_class_body);
        Place { kind, in_loop: false, in_star_handler: false, in_star_handler_loop: false, in_class_body }
    }

    /// In the body of a loop that is written here.
    pub(super) fn looped(self) -> Place {
        let in_star_handler_loop = self.in_star_handler || self.in_star_handler_loop;
        Place { in_loop: true, in_star_handler: false, in_star_handler_loop, ..self }
    }
}

/// The place of the walk as the parser crate's checker asks for it, and what it found.
pub(super) struct Checks<'a> {
    pub(super) source: &'a str,
    pub(super) place: Place,
    pub(super) errors: RefCell<Vec<SyntaxError>>,
}

impl<'a> Checks<'a> {
    pub(super) fn new(source: &'a str) -> Checks<'a> {
        let kind = ScopeKind::Module;
        let place = Place { kind, in_loop: false, in_star_handler: false, in_star_handler_loop: false, in_class_body: false };
        Checks { source, place, errors: RefCell::default() }
    }

    pub(super) fn report(&self, error: SyntaxError) {
        self.errors.borrow_mut().push(error);
    }
}

/// Names, `yield` and `async` are checked by the walk itself (`resolve`), which knows the scopes: here
/// those questions get the answer that keeps the checker silent.
impl SemanticSyntaxContext for Checks<'_> {
    fn future_annotations_or_stub(&self) -> bool {
        false
    }
    fn lazy_import_context(&self) -> Option<LazyImportContext> {
        None
    }
    fn python_version(&self) -> PythonVersion {
        PythonVersion::PY311
    }
    fn source(&self) -> &str {
        self.source
    }
    fn global(&self, _name: &str) -> Option<TextRange> {
        None
    }
    fn has_nonlocal_binding(&self, _name: &str) -> bool {
        true
    }
    fn in_async_context(&self) -> bool {
        false
    }
    fn in_await_allowed_context(&self) -> bool {
        true
    }
    fn in_yield_allowed_context(&self) -> bool {
        true
    }
    fn in_sync_comprehension(&self) -> bool {
        false
    }
    fn in_class_body_comprehension(&self) -> bool {
        self.place.in_class_body
    }
    fn in_module_scope(&self) -> bool {
        self.place.kind == ScopeKind::Module
    }
    fn in_function_scope(&self) -> bool {
        self.place.kind.is_function_like()
    }
    fn in_generator_context(&self) -> bool {
        false
    }
    fn in_notebook(&self) -> bool {
        false
    }
    fn in_loop_context(&self) -> bool {
        self.place.in_loop
    }
    fn is_bound_parameter(&self, _name: &str) -> bool {
        false
    }
    fn report_semantic_error(&self, error: SemanticSyntaxError) {
        if let Some(message) = message(&error) {
            self.report(SyntaxError::new(error.range, message));
        }
    }
}

/// CPython's words; `None` for what `resolve` says itself.
fn message(error: &SemanticSyntaxError) -> Option<String> {
    use SemanticSyntaxErrorKind as Kind;
    Some(match &error.kind {
        Kind::AwaitOutsideAsyncFunction(_)
        | Kind::YieldOutsideFunction(_)
        | Kind::YieldFromInAsyncFunction
        | Kind::ReturnInGenerator
        | Kind::LateFutureImport
        | Kind::FutureFeatureNotDefined(_)
        | Kind::LazyFutureImport
        | Kind::LazyImportStar
        | Kind::LazyImportNotAllowed { .. } => return None,
        Kind::ReturnOutsideFunction => "'return' outside function".to_string(),
        Kind::BreakOutsideLoop => "'break' outside loop".to_string(),
        Kind::ContinueOutsideLoop => "'continue' not properly in loop".to_string(),
        Kind::DuplicateParameter(name) => format!("duplicate argument '{name}' in function definition"),
        Kind::DuplicateKeywordArgument(name) => format!("keyword argument repeated: {name}"),
        Kind::MultipleCaseAssignment(name) => format!("multiple assignments to name '{name}' in pattern"),
        Kind::IrrefutableCasePattern(IrrefutablePatternKind::Name(name)) => {
            format!("name capture '{name}' makes remaining patterns unreachable")
        }
        Kind::DuplicateMatchClassAttribute(name) => format!("attribute name repeated in class pattern: {name}"),
        Kind::WriteToDebug(_) => "cannot assign to __debug__".to_string(),
        Kind::InvalidStarExpression => "can't use starred expression here".to_string(),
        Kind::MultipleStarredExpressions => "multiple starred expressions in assignment".to_string(),
        Kind::NonModuleImportStar(_) => "import * only allowed at module level".to_string(),
        Kind::ReboundComprehensionVariable => "assignment expression cannot rebind comprehension iteration variable".to_string(),
        _ => error.to_string(),
    })
}
