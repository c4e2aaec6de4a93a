//! What names mean, and what the compiler refuses.

use crate::syntax::scope::{Capture, NameKind, Role, ScopeId, ScopeKind, Scopes};
use crate::syntax::{ErrorKind, parse};

fn scopes(program: &str) -> Scopes {
    let parsed = parse(program);
    assert_eq!(parsed.errors, [], "{program}");
    parsed.scopes
}

/// The scope of that (qualified) name.
fn find(scopes: &Scopes, name: &str) -> ScopeId {
    scopes.iter().map(|(id, _)| id).find(|id| scopes.qualified_name(*id) == name).unwrap_or_else(|| panic!("no scope {name}"))
}

/// How each name is reached in a scope, as short words.
fn kinds(program: &str, scope: &str, names: &str) -> String {
    let scopes = scopes(program);
    let id = find(&scopes, scope);
    let word = |name| match scopes.lookup(id, name) {
        None => "-".to_string(),
        Some(NameKind::Local(i)) => format!("local{i}"),
        Some(NameKind::Cell(i)) => format!("cell{i}"),
        Some(NameKind::Free(i)) => format!("free{i}"),
        Some(NameKind::GlobalExplicit(_)) => "global!".to_string(),
        Some(NameKind::GlobalImplicit(_)) => "global".to_string(),
        Some(NameKind::Class(_)) => "class".to_string(),
    };
    names.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// The only error of a program.
fn refused(program: &str) -> String {
    let parsed = parse(program);
    let messages: Vec<_> = parsed.errors.iter().map(|error| error.message.as_str()).collect();
    assert_eq!(messages.len(), 1, "{program}: {messages:?}");
    messages[0].to_string()
}

#[test]
fn locals_and_globals() {
    assert_eq!(kinds("x = 1\nprint(x)", "<module>", "x print y"), "global global -");
    assert_eq!(kinds("def f(a, *b, c, **d):\n  e = a\n  print(e)", "f", "a b c d e print"), "local0 local2 local1 local3 local4 global");
    assert_eq!(kinds("def f():\n  global x\n  x = 1", "f", "x"), "global!");
    assert_eq!(
        kinds("def f():\n  for i in range(3): pass\n  import a.b, c as d\n  with i as e: pass\n  del g\n", "f", "i a d e g"),
        "local0 local1 local2 local3 local4"
    );
    assert_eq!(
        kinds("def f(x):\n  match x:\n    case [a, *b] | {'k': a, **b}: pass\n    case C(y=c) as d: pass\n", "f", "a b c d"),
        "local1 local2 local3 local4"
    );
    assert_eq!(kinds("def f():\n  try: pass\n  except E as e: pass\n  x: int\n", "f", "E e x int"), "global local0 local1 global");
}

#[test]
fn closures_pass_variables_on() {
    let program = "def outer(p):\n  x = 1\n  def middle():\n    return lambda: x + p\n  return middle";
    assert_eq!(kinds(program, "outer", "p x middle"), "cell0 cell1 local1");
    let scopes = scopes(program);
    let outer = scopes.get(find(&scopes, "outer"));
    assert_eq!(outer.cells[0].parameter, Some(0));
    assert_eq!((outer.cells[1].parameter, outer.parameter_count), (None, 1));
    let middle = scopes.get(find(&scopes, "outer.<locals>.middle"));
    assert_eq!(
        middle.frees.iter().map(|free| (free.name.as_str(), free.from)).collect::<Vec<_>>(),
        [("x", Capture::Cell(1)), ("p", Capture::Cell(0))]
    );
    let inner = scopes.get(find(&scopes, "outer.<locals>.middle.<locals>.<lambda>"));
    assert_eq!(inner.frees[0].from, Capture::Free(0));
}

#[test]
fn class_bodies_are_not_seen_from_methods() {
    let program = "def f():\n  x = 1\n  class C:\n    x = 2\n    y = x\n    def m(self):\n      return x, y\n";
    assert_eq!(kinds(program, "f.<locals>.C", "x y"), "class class");
    assert_eq!(kinds(program, "f.<locals>.C.m", "x y self"), "free0 global local0");
    let scopes = scopes(program);
    assert_eq!(scopes.get(find(&scopes, "f.<locals>.C")).frees.len(), 1);
    assert_eq!(kinds("def f(a):\n  class C:\n    b = a", "f.<locals>.C", "a b"), "free0 class");
}

#[test]
fn super_needs_the_class() {
    let program = "class C:\n  def m(self): return super().m()\n  def n(self): return [__class__ for i in self]\n";
    let scopes = scopes(program);
    assert_eq!(scopes.get(find(&scopes, "C")).cells.iter().map(|cell| cell.name.as_str()).collect::<Vec<_>>(), ["__class__"]);
    assert_eq!(scopes.get(find(&scopes, "C.m")).frees[0].from, Capture::Cell(0));
    assert_eq!(scopes.get(find(&scopes, "C.n.<locals>.<listcomp>")).frees[0].from, Capture::Free(0));
    assert_eq!(kinds("def f(): return super", "f", "super __class__"), "global -");
}

#[test]
fn private_names_are_mangled() {
    let program = "class _Box:\n  __n = 1\n  def m(self, __a): return __a\n  def __dunder__(self): pass\n";
    let scopes = scopes(program);
    let class = find(&scopes, "_Box");
    assert_eq!(scopes.mangle(class, "__n"), "_Box__n");
    assert_eq!(scopes.mangle(class, "__dunder__"), "__dunder__");
    assert_eq!(scopes.get(find(&scopes, "_Box.m")).locals[1], "_Box__a");
    assert!(matches!(scopes.lookup(find(&scopes, "_Box.m"), "__a"), Some(NameKind::Local(1))));
}

#[test]
fn comprehensions_are_functions() {
    let program = "def f(n):\n  return [i + j + n for i in range(n) for j in range(i)]";
    assert_eq!(kinds(program, "f.<locals>.<listcomp>", ".0 i j n range"), "local0 local1 local2 free0 global");
    assert_eq!(kinds(program, "f", "n range i"), "cell0 global -");
    assert_eq!(kinds("x = [y := i for i in r]", "<listcomp>", "y i"), "global! local1");
    assert_eq!(kinds("def f(r):\n  [[y := i for i in r] for r in r]\n  return y", "f", "y"), "cell0");
    let scopes = scopes("a = sum(x for x in b)\nc = (sum((x for x in y) for y in z))");
    assert_eq!(scopes.iter().filter(|(_, scope)| scope.kind == ScopeKind::Generator && scope.is_generator).count(), 3);
}

#[test]
fn nodes_lead_to_their_scopes() {
    let program = "@d\ndef f(x=lambda: 1):\n  return {k: v for k, v in x}\n";
    let parsed = parse(program);
    let def = parsed.module.body[0].as_function_def_stmt().unwrap();
    let id = parsed.scopes.of(def.range).unwrap();
    assert_eq!(parsed.scopes.get(id).kind, ScopeKind::Function);
    let inside = u32::try_from(program.find("k, v").unwrap()).unwrap().into();
    assert_eq!(parsed.scopes.get(parsed.scopes.at(inside)).kind, ScopeKind::DictComp);
    assert!(!parsed.scopes.get(id).is_generator);
}

#[test]
fn every_occurrence_of_a_variable() {
    let program = "x = 1\ndef f():\n  global x\n  x = 2\n  return [x for _ in y]\ndef g(x): return x\n";
    let scopes = scopes(program);
    let name = scopes.name_id("x").unwrap();
    let module = scopes.variable(ScopeId::MODULE, name).unwrap();
    let same = scopes.occurrences().iter().filter(|o| o.name == name && scopes.variable(o.scope, name) == Some(module));
    assert_eq!(same.map(|o| o.role).collect::<Vec<_>>(), [Role::Bind, Role::Declare, Role::Bind, Role::Load]);
}

#[test]
fn what_the_compiler_refuses() {
    for (program, message) in [
        ("return 1", "'return' outside function"),
        ("class C:\n  yield 1", "'yield' outside function"),
        ("def f(): [(yield 1) for a in b]", "'yield' inside list comprehension"),
        ("break", "'break' outside loop"),
        ("for a in b:\n  def f(): continue", "'continue' not properly in loop"),
        ("nonlocal x", "nonlocal declaration not allowed at module level"),
        ("def f(): nonlocal x", "no binding for nonlocal 'x' found"),
        ("print(x)\nglobal x", "name 'x' is used prior to global declaration"),
        ("def f():\n  x = 1\n  global x", "name 'x' is assigned to before global declaration"),
        ("def f(x): global x", "name 'x' is parameter and global"),
        ("def f(x, x): pass", "duplicate argument 'x' in function definition"),
        ("f(a=1, a=2)", "keyword argument repeated: a"),
        ("f(a=1, b)", "positional argument follows keyword argument"),
        ("f() = 1", "cannot assign to function call here. Maybe you meant '==' instead of '='?"),
        ("del f()", "cannot delete function call"),
        ("a, *b, *c = d", "multiple starred expressions in assignment"),
        ("*a = b", "starred assignment target must be in a list or tuple"),
        ("*a", "can't use starred expression here"),
        ("try: pass\nexcept: pass\nexcept A: pass", "default 'except:' must be last"),
        ("[a := 1 for a in b]", "assignment expression cannot rebind comprehension iteration variable"),
        ("[a for a in (b := c)]", "assignment expression cannot be used in a comprehension iterable expression"),
        ("match x:\n  case a: pass\n  case 1: pass", "name capture 'a' makes remaining patterns unreachable"),
        ("match x:\n  case [a, a]: pass", "multiple assignments to name 'a' in pattern"),
        ("def f(): from math import *", "import * only allowed at module level"),
        ("if x = 1: pass", "invalid syntax. Maybe you meant '==' or ':=' instead of '='?"),
        ("print 'a'", "Missing parentheses in call to 'print'. Did you mean print(...)?"),
        ("x = [1 2]", "invalid syntax. Perhaps you forgot a comma?"),
    ] {
        assert_eq!(refused(program), message, "{program}");
    }
}

#[test]
fn what_psdl_leaves_out_is_named() {
    for (program, place, message) in [
        ("async def f(): pass", "async def ", "'async def' is not part of PSDL"),
        ("def f(): await x", "await", "'await' is not part of PSDL"),
        ("def f():\n  async for a in b: pass", "async", "'async for' is not part of PSDL"),
        ("from __future__ import annotations", "from __future__ import annotations", "'from __future__ import' is not part of PSDL"),
    ] {
        let parsed = parse(program);
        let error = &parsed.errors[0];
        assert_eq!((error.kind, &program[error.range], error.message.as_str()), (ErrorKind::LeftOut, place, message));
    }
}

#[test]
fn integers_longer_than_cpython_reads() {
    assert!(refused(&format!("x = {}", "1".repeat(4301))).starts_with("Exceeds the limit (4300 digits)"));
    assert!(parse(&format!("x = 0x{}", "1".repeat(5000))).is_complete());
    assert!(parse(&format!("x = {}", "1".repeat(4300))).is_complete());
}
