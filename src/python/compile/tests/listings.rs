//! Listings of small programs.

use super::code;
use insta::assert_snapshot;

#[test]
fn statements_of_the_module_begin_with_an_empty_stack_and_their_number() {
    assert_snapshot!(code("a = b = 1\na, b = b, a\nprint(*a, sep='')"), @r#"
    Module <module>()
       0 Statement(0)
       1 Const(0) 1
       2 Dup
       3 StoreGlobal(0) a
       4 StoreGlobal(1) b
       5 Statement(1)
       6 LoadGlobal(1) b
       7 LoadGlobal(0) a
       8 Swap
       9 StoreGlobal(0) a
      10 StoreGlobal(1) b
      11 Statement(2)
      12 LoadGlobal(2) print
      13 LoadGlobal(0) a
      14 Const(1) "sep"
      15 Const(2) ""
      16 BuildDict(1)
      17 CallEx(true)
      18 Pop
      19 Const(3) None
      20 Return
    "#);
}

#[test]
fn tunable_literals_keep_their_sign_and_their_number() {
    assert_snapshot!(code("chair.min.x = table.max.x + -0.5\nlamp.facing = X_MAX if tall else opposite(bed.facing)"), @r#"
    Module <module>()
       0 Statement(0)
       1 LoadGlobal(0) table
       2 LoadAttr(0) max
       3 LoadAttr(1) x
       4 BinaryConst { op: Add, constant: 0 } -0.5 tunable 0
       5 LoadGlobal(1) chair
       6 LoadAttr(2) min
       7 StoreAttr(1) x
       8 Statement(1)
       9 LoadGlobal(2) tall
      10 PopJumpIfFalse(14)
      11 LoadGlobal(3) X_MAX
      12 Direction(DirectionId(1))
      13 Jump(18)
      14 LoadGlobal(4) opposite
      15 LoadGlobal(5) bed
      16 LoadAttr(3) facing
      17 Call(1)
      18 Direction(DirectionId(0))
      19 LoadGlobal(6) lamp
      20 StoreAttr(3) facing
      21 Const(1) None
      22 Return
    "#);
}

#[test]
fn loops_keep_a_counter_beside_the_iterator() {
    assert_snapshot!(code("def f(xs):\n    for i, x in enumerate(xs):\n        if 0 < x.n <= 3: continue\n        if i: break\n    else:\n        return i * x + 2"), @r#"
    Module <module>()
       0 Statement(0)
       1 MakeFunction { child: 0, flags: 0 } f
       2 StoreGlobal(0) f
       3 Const(0) None
       4 Return
    Function f(xs i x)
       0 LoadGlobal(1) enumerate
       1 LoadFast(0) xs
       2 Call(1)
       3 StartLoop
       4 ForIter(24)
       5 Unpack(2)
       6 StoreFast(1) i
       7 StoreFast(2) x
       8 Const(0) 0
       9 LoadFastAttr { slot: 2, name: 0 } x.n
      10 Dup
      11 Rot3
      12 CompareJump { op: Lt, target: 15 }
      13 CompareConstJump { op: Le, constant: 1, target: 18 } 3
      14 Jump(17)
      15 Pop
      16 Jump(18)
      17 JumpBack(4)
      18 LoadFast(1) i
      19 PopJumpIfFalse(23)
      20 Pop
      21 Pop
      22 Jump(27)
      23 JumpBack(4)
      24 BinaryFastFast { op: Mul, a: 1, b: 2 } i x
      25 BinaryConst { op: Add, constant: 2 } 2
      26 Return
      27 Const(3) None
      28 Return
      4..24 loops over "i" depth 0
    "#);
}

#[test]
fn comprehensions_are_functions_of_the_iterator() {
    assert_snapshot!(code("def f(xs, k):\n    return {x: y for x in xs for y in x if y > k}"), @r#"
    Module <module>()
       0 Statement(0)
       1 MakeFunction { child: 0, flags: 0 } f
       2 StoreGlobal(0) f
       3 Const(0) None
       4 Return
    Function f(xs k)
      cell k from 1
       0 LoadClosure(2) k
       1 BuildTuple(1)
       2 MakeFunction { child: 0, flags: 8 } f.<locals>.<dictcomp>
       3 LoadFast(0) xs
       4 GetIter
       5 Call(1)
       6 Return
    Comprehension f.<locals>.<dictcomp>(.0 x y)
      free k
       0 BuildDict(0)
       1 LoadFast(0) .0
       2 Const(0) 0
       3 ForIter(16)
       4 StoreFast(1) x
       5 LoadFast(1) x
       6 StartLoop
       7 ForIter(15)
       8 StoreFast(2) y
       9 LoadFast(2) y
      10 LoadDeref(3) k
      11 CompareJump { op: Gt, target: 14 }
      12 LoadFastFast { a: 1, b: 2 } x y
      13 DictAdd(4)
      14 JumpBack(7)
      15 JumpBack(3)
      16 Return
      7..15 loops over "y" depth 3
      3..16 loops over "x" depth 1
    "#);
}

#[test]
fn a_return_runs_finally_and_exit_outside_their_regions() {
    assert_snapshot!(code("def f(a):\n    for x in a:\n        try:\n            with a as b: return g(b)\n        finally: print(x)"), @r#"
    Module <module>()
       0 Statement(0)
       1 MakeFunction { child: 0, flags: 0 } f
       2 StoreGlobal(0) f
       3 Const(0) None
       4 Return
    Function f(a x b)
       0 LoadFast(0) a
       1 StartLoop
       2 ForIter(43)
       3 StoreFast(1) x
       4 LoadFast(0) a
       5 BeforeWith
       6 StoreFast(2) b
       7 LoadGlobal(1) g
       8 LoadFast(2) b
       9 Call(1)
      10 Swap
      11 Const(0) None
      12 Const(0) None
      13 Const(0) None
      14 Call(3)
      15 Pop
      16 LoadGlobal(2) print
      17 LoadFast(1) x
      18 Call(1)
      19 Pop
      20 Rot3
      21 Pop
      22 Pop
      23 Return
      24 PushExc
      25 WithExcept
      26 PopJumpIfTrue(28)
      27 Reraise
      28 Pop
      29 PopExc
      30 Pop
      31 LoadGlobal(2) print
      32 LoadFast(1) x
      33 Call(1)
      34 Pop
      35 Jump(42)
      36 PushExc
      37 LoadGlobal(2) print
      38 LoadFast(1) x
      39 Call(1)
      40 Pop
      41 Reraise
      42 JumpBack(2)
      43 Const(0) None
      44 Return
      6..10 raises to 24 depth 3 handling 0
      4..16 raises to 36 depth 2 handling 0
      24..31 raises to 36 depth 2 handling 0
      2..20 loops over "x" depth 0
      24..43 loops over "x" depth 0
    "#);
}

#[test]
fn except_clauses_forget_their_name_on_every_way_out() {
    assert_snapshot!(code("def f():\n    try: g()\n    except (A, B) as e: h(e)\n    else: return 1"), @r#"
    Module <module>()
       0 Statement(0)
       1 MakeFunction { child: 0, flags: 0 } f
       2 StoreGlobal(0) f
       3 Const(0) None
       4 Return
    Function f(e)
       0 LoadGlobal(1) g
       1 Call(0)
       2 Pop
       3 Const(0) 1
       4 Return
       5 PushExc
       6 LoadGlobal(2) A
       7 LoadGlobal(3) B
       8 BuildTuple(2)
       9 ExcMatch
      10 PopJumpIfFalse(26)
      11 StoreFast(0) e
      12 LoadGlobal(4) h
      13 LoadFast(0) e
      14 Call(1)
      15 Pop
      16 PopExc
      17 Const(1) None
      18 StoreFast(0) e
      19 DeleteFast(0) e
      20 Jump(25)
      21 Const(1) None
      22 StoreFast(0) e
      23 DeleteFast(0) e
      24 Reraise
      25 Jump(27)
      26 Reraise
      27 Const(1) None
      28 Return
      0..3 raises to 5 depth 0 handling 0
      12..16 raises to 21 depth 0 handling 0
    "#);
}

#[test]
fn except_star_collects_what_is_left() {
    assert_snapshot!(code("try: f()\nexcept* A as e: g(e)"), @r#"
    Module <module>()
       0 Statement(0)
       1 LoadGlobal(0) f
       2 Call(0)
       3 Pop
       4 Jump(39)
       5 PushExc
       6 Dup
       7 BuildList(0)
       8 Swap
       9 LoadGlobal(1) A
      10 ExcGroupMatch
      11 Dup
      12 PopJumpIfNone(29)
      13 PushExc
      14 StoreGlobal(2) e
      15 LoadGlobal(3) g
      16 LoadGlobal(2) e
      17 Call(1)
      18 Pop
      19 PopExc
      20 Const(0) None
      21 StoreGlobal(2) e
      22 DeleteGlobal(2) e
      23 Jump(30)
      24 Const(0) None
      25 StoreGlobal(2) e
      26 DeleteGlobal(2) e
      27 ListAppend(1)
      28 Jump(30)
      29 Pop
      30 ListAppend(0)
      31 ExcGroupFinish
      32 Dup
      33 PopJumpIfNone(36)
      34 PopExc
      35 Reraise
      36 Pop
      37 PopExc
      38 Jump(39)
      39 Const(0) None
      40 Return
      1..4 raises to 5 depth 0 handling 0
      15..19 raises to 24 depth 3 handling 1
    "#);
}

#[test]
fn classes_fill_a_namespace() {
    assert_snapshot!(code("class K(Base, metaclass=M):\n    'doc'\n    n: int = 1\n    def m(self): return super().m()"), @r#"
    Module <module>()
       0 Statement(0)
       1 BuildClass
       2 MakeFunction { child: 0, flags: 0 } K
       3 Const(0) "K"
       4 LoadGlobal(0) Base
       5 LoadGlobal(1) M
       6 CallKw { count: 4, names: 1 } ("metaclass")
       7 StoreGlobal(2) K
       8 Const(2) None
       9 Return
    Class K()
      cell __class__
       0 LoadGlobal(7) __name__
       1 StoreName(0) __module__
       2 Const(0) "K"
       3 StoreName(1) __qualname__
       4 BuildDict(0)
       5 StoreName(2) __annotations__
       6 Const(1) "doc"
       7 StoreName(3) __doc__
       8 Const(2) 1
       9 StoreName(4) n
      10 LoadName(5) int
      11 LoadName(2) __annotations__
      12 Const(3) "n"
      13 StoreSubscr
      14 LoadClosure(0) __class__
      15 BuildTuple(1)
      16 MakeFunction { child: 0, flags: 8 } K.m
      17 StoreName(6) m
      18 LoadClosure(0) __class__
      19 StoreName(7) __classcell__
      20 Const(4) None
      21 Return
    Function K.m(self)
      free __class__
       0 LoadGlobal(6) super
       1 Call(0)
       2 LoadMethod(0) m
       3 CallMethod(0)
       4 Return
    "#);
}

#[test]
fn generators_and_calls_with_everything() {
    assert_snapshot!(code("def f(a, *b, c=1, **d) -> int:\n    x = yield a\n    yield from f(*b, c=x, **d)\n    return lambda: (a, x)"), @r#"
    Module <module>()
       0 Statement(0)
       1 Const(0) "c"
       2 Const(1) 1
       3 BuildDict(1)
       4 Const(2) "return"
       5 LoadGlobal(0) int
       6 BuildDict(1)
       7 MakeFunction { child: 0, flags: 6 } f
       8 StoreGlobal(1) f
       9 Const(3) None
      10 Return
    Function generator f(a c b d)
      cell a from 0
      cell x
       0 LoadDeref(4) a
       1 Yield
       2 StoreDeref(5) x
       3 LoadGlobal(1) f
       4 LoadFast(2) b
       5 Const(0) "c"
       6 LoadDeref(5) x
       7 BuildDict(1)
       8 LoadFast(3) d
       9 DictMerge(2)
      10 CallEx(true)
      11 GetIter
      12 Const(1) None
      13 YieldFrom
      14 Pop
      15 LoadClosure(4) a
      16 LoadClosure(5) x
      17 BuildTuple(2)
      18 MakeFunction { child: 0, flags: 8 } f.<locals>.<lambda>
      19 Return
    Lambda f.<locals>.<lambda>()
      free a x
       0 LoadDeref(0) a
       1 LoadDeref(1) x
       2 BuildTuple(2)
       3 Return
    "#);
}

#[test]
fn patterns_bind_when_all_of_them_matched() {
    assert_snapshot!(code("match p:\n    case [K(z=1, w=a) | [_, a], *_] if a: f(a)\n    case {'k': v, **r}: g(v, r)"), @r#"
    Module <module>(.match0 .match1)
       0 Statement(0)
       1 LoadGlobal(0) p
       2 Dup
       3 MatchSequence
       4 PopJumpIfFalse(44)
       5 GetLen
       6 CompareConstJump { op: Ge, constant: 0, target: 44 } 1
       7 Dup
       8 LoadSubscrConst(1) 0
       9 Dup
      10 LoadGlobal(1) K
      11 Const(2) ("z", "w")
      12 MatchClass(0)
      13 Dup
      14 PopJumpIfNone(19)
      15 Unpack(2)
      16 CompareConstJump { op: Eq, constant: 0, target: 19 } 1
      17 StoreFast(0) .match0
      18 Jump(32)
      19 Pop
      20 Dup
      21 MatchSequence
      22 PopJumpIfFalse(29)
      23 GetLen
      24 CompareConstJump { op: Eq, constant: 3, target: 29 } 2
      25 Unpack(2)
      26 Pop
      27 StoreFast(0) .match0
      28 Jump(32)
      29 Pop
      30 Pop
      31 Jump(44)
      32 Pop
      33 Pop
      34 LoadFast(0) .match0
      35 StoreGlobal(2) a
      36 LoadGlobal(2) a
      37 PopJumpIfFalse(45)
      38 Pop
      39 LoadGlobal(3) f
      40 LoadGlobal(2) a
      41 Call(1)
      42 Pop
      43 Jump(74)
      44 Pop
      45 Dup
      46 MatchMapping
      47 PopJumpIfFalse(72)
      48 GetLen
      49 CompareConstJump { op: Ge, constant: 0, target: 72 } 1
      50 Const(4) "k"
      51 BuildTuple(1)
      52 MatchKeys
      53 Dup
      54 PopJumpIfNone(70)
      55 Unpack(1)
      56 StoreFast(0) .match0
      57 MatchRest
      58 StoreFast(1) .match1
      59 LoadFast(0) .match0
      60 StoreGlobal(4) v
      61 LoadFast(1) .match1
      62 StoreGlobal(5) r
      63 Pop
      64 LoadGlobal(6) g
      65 LoadGlobal(4) v
      66 LoadGlobal(5) r
      67 Call(2)
      68 Pop
      69 Jump(74)
      70 Pop
      71 Pop
      72 Pop
      73 Pop
      74 Const(5) None
      75 Return
    "#);
}

#[test]
fn texts_with_values() {
    assert_snapshot!(code("f'{a!r:>{b}}' ' and ' f'{c=}'"), @r#"
    Module <module>()
       0 Statement(0)
       1 LoadGlobal(0) a
       2 Const(0) ">"
       3 LoadGlobal(1) b
       4 Format { conversion: 0, spec: false }
       5 BuildString(2)
       6 Format { conversion: 114, spec: true }
       7 Const(1) " and c="
       8 LoadGlobal(2) c
       9 Format { conversion: 114, spec: false }
      10 BuildString(3)
      11 Pop
      12 Const(2) None
      13 Return
    "#);
}

#[test]
fn only_the_last_display_of_a_comparison_is_folded() {
    assert_snapshot!(code("1 in [1] in [[1], 2]\nx in {1, 2}"), @r#"
    Module <module>()
       0 Statement(0)
       1 Const(0) 1
       2 Const(0) 1
       3 BuildList(1)
       4 Dup
       5 Rot3
       6 In(false)
       7 JumpIfFalseOrPop(14)
       8 Const(0) 1
       9 BuildList(1)
      10 Const(1) 2
      11 BuildList(2)
      12 In(false)
      13 Jump(16)
      14 Swap
      15 Pop
      16 Pop
      17 Statement(1)
      18 LoadGlobal(0) x
      19 Const(2) frozenset(1, 2)
      20 In(false)
      21 Pop
      22 Const(3) None
      23 Return
    "#);
}
