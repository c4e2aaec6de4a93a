//! One code object under construction: instructions, labels, constants, and the height of the operand stack.
//!
//! Jumps name a [`Label`] until [`Emitter::finish`]. Common neighbours are fused as they are emitted, never across a place that
//! something else refers to (a label, a statement, the edge of a region).

use ruff_text_size::TextRange;
use rustc_hash::FxHashMap;

use super::effect::{effect, target_mut};
use crate::python::code::{Code, CodeKind, Const, Handler, Loop, Op, Params, Slot};

/// A place in the code, known or still to come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Label(u32);

#[derive(Clone, Copy, Default)]
struct Place {
    pc: Option<u32>,
    depth: Option<i32>,
    /// Some way leads there that is not dead.
    reached: bool,
}

/// The constants that may be shared.
#[derive(PartialEq, Eq, Hash)]
enum Key {
    None,
    Ellipsis,
    Bool(bool),
    Int(i64),
    Float(u64),
    Str(Box<str>),
    Bytes(Box<[u8]>),
}

impl Key {
    fn of(value: &Const) -> Option<Key> {
        Some(match value {
            Const::None => Key::None,
            Const::Ellipsis => Key::Ellipsis,
            Const::Bool(b) => Key::Bool(*b),
            Const::Int(i) => Key::Int(*i),
            Const::Float(f, None) => Key::Float(f.to_bits()),
            Const::Str(s) => Key::Str(s.clone()),
            Const::Bytes(b) => Key::Bytes(b.clone()),
            Const::Float(_, Some(_)) | Const::Big(_) | Const::Complex(..) | Const::Tuple(_) | Const::FrozenSet(_) => return None,
        })
    }
}

/// See the module's text.
#[derive(Default)]
pub(super) struct Emitter {
    ops: Vec<Op>,
    ranges: Vec<TextRange>,
    labels: Vec<Place>,
    /// Instructions before this one are referred to by their number: they stay as they are.
    barrier: usize,
    /// The ranges of the two halves of a `LoadFastFast` that stands last.
    pair: (TextRange, TextRange),
    depth: i32,
    /// Nothing leads here: what follows is not emitted.
    dead: bool,
    consts: Vec<Const>,
    const_index: FxHashMap<Key, u32>,
    names: Vec<Box<str>>,
    name_index: FxHashMap<Box<str>, u32>,
    /// With the nesting of the block that each belongs to; targets are labels.
    handlers: Vec<(usize, Handler)>,
    loops: Vec<Loop>,
    statements: Vec<(u32, TextRange)>,
}

/// What a code object has beside its instructions.
pub(super) struct Frame {
    pub name: Box<str>,
    pub qualname: Box<str>,
    pub kind: CodeKind,
    pub generator: bool,
    pub params: Params,
    pub locals: Vec<Box<str>>,
    pub cells: Vec<(Box<str>, Option<u16>)>,
    pub frees: Vec<Box<str>>,
    pub children: Vec<u32>,
    pub doc: Option<Box<str>>,
}

pub(super) fn narrow(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

impl Emitter {
    /// Whether nothing leads here.
    pub fn is_dead(&self) -> bool {
        self.dead
    }

    /// How many operands are on the stack here.
    pub fn depth(&self) -> u32 {
        u32::try_from(self.depth).unwrap_or(0)
    }

    /// Goes on as if that many operands were there: what follows is reached by a jump only.
    pub fn set_depth(&mut self, depth: u32) {
        self.depth = i32::try_from(depth).unwrap_or(i32::MAX);
    }

    /// The number of the next instruction, to be kept.
    pub fn here(&mut self) -> u32 {
        self.barrier = self.ops.len();
        narrow(self.ops.len())
    }

    /// A new label, not yet placed.
    pub fn label(&mut self) -> Label {
        self.labels.push(Place::default());
        Label(narrow(self.labels.len() - 1))
    }

    /// Places a label here. The stack is as high as where the jumps to it begin.
    pub fn bind(&mut self, label: Label) {
        let pc = self.here();
        let depth = self.depth;
        let Some(place) = self.labels.get_mut(label.0 as usize) else { return };
        place.pc = Some(pc);
        self.dead &= !place.reached;
        self.depth = *place.depth.get_or_insert(depth);
    }

    /// The machine may begin here, though no instruction leads here.
    pub fn entry(&mut self) {
        self.dead = false;
    }

    /// Says how high the stack is at a label that only an exception reaches.
    pub fn expect_depth(&mut self, label: Label, depth: u32) {
        if let Some(place) = self.labels.get_mut(label.0 as usize) {
            place.depth = i32::try_from(depth).ok();
            place.reached |= !self.dead;
        }
    }

    /// Emits a jump: `make` gets the number of the label.
    pub fn jump(&mut self, make: fn(u32) -> Op, label: Label, range: TextRange) {
        self.emit(make(label.0), range);
    }

    /// Emits an instruction.
    pub fn emit(&mut self, op: Op, range: TextRange) {
        let (next, jumped) = effect(op);
        let mut jump = op;
        if let Some(label) = target_mut(&mut jump).map(|target| *target as usize)
            && let Some(place) = self.labels.get_mut(label)
        {
            let depth = self.depth + jumped;
            let expected = *place.depth.get_or_insert(depth);
            debug_assert_eq!(expected, depth, "two ways to a label leave stacks of different height");
            place.reached |= !self.dead;
        }
        self.depth += next;
        debug_assert!(self.depth >= 0, "{op:?} takes more than there is");
        if self.dead {
            return;
        }
        self.fuse(op, range);
        self.dead = matches!(op, Op::Jump(_) | Op::JumpBack(_) | Op::Return | Op::Raise(_) | Op::Reraise);
    }

    fn drop_last(&mut self, count: usize) {
        let left = self.ops.len().saturating_sub(count);
        self.ops.truncate(left);
        self.ranges.truncate(left);
    }

    fn push(&mut self, op: Op, range: TextRange) {
        self.ops.push(op);
        self.ranges.push(range);
    }

    /// Pushes an instruction, with the ones before it where one instruction does the same.
    fn fuse(&mut self, op: Op, range: TextRange) {
        let free = self.ops.get(self.barrier..).unwrap_or_default();
        let (before, last) = match free {
            [.., before, last] => (Some(*before), *last),
            [last] => (None, *last),
            [] => return self.push(op, range),
        };
        match (last, op) {
            (Op::Dup, Op::Pop) => self.drop_last(1),
            (Op::LoadFast(a), Op::LoadFast(b)) => {
                let first = self.ranges.last().copied().unwrap_or(range);
                self.pair = (first, range);
                self.drop_last(1);
                self.push(Op::LoadFastFast { a, b }, first.cover(range));
            }
            (Op::LoadFast(slot), Op::LoadAttr(name)) => {
                self.drop_last(1);
                self.push(Op::LoadFastAttr { slot, name }, range);
            }
            (Op::LoadFastFast { a, b }, Op::LoadAttr(name)) => {
                self.drop_last(1);
                self.push(Op::LoadFast(a), self.pair.0);
                self.push(Op::LoadFastAttr { slot: b, name }, range);
            }
            (Op::LoadFastFast { a, b }, Op::Binary(op)) => {
                self.drop_last(1);
                self.push(Op::BinaryFastFast { op, a, b }, range);
            }
            (Op::LoadFast(b), Op::Binary(op)) => {
                self.drop_last(1);
                self.push(Op::BinaryFast { op, b }, range);
            }
            (Op::Const(constant), Op::Binary(op)) if u16::try_from(constant).is_ok() => {
                let constant = u16::try_from(constant).unwrap_or_default();
                if let Some(Op::LoadFast(a)) = before {
                    self.drop_last(2);
                    self.push(Op::BinaryFastConst { op, a, constant }, range);
                } else {
                    self.drop_last(1);
                    self.push(Op::BinaryConst { op, constant }, range);
                }
            }
            (Op::Compare(op), Op::PopJumpIfFalse(target)) => {
                let range = self.ranges.last().copied().unwrap_or(range);
                self.drop_last(1);
                self.fuse(Op::CompareJump { op, target }, range);
            }
            (Op::Const(constant), Op::CompareJump { op, target }) if u16::try_from(constant).is_ok() => {
                let constant = u16::try_from(constant).unwrap_or_default();
                self.drop_last(1);
                self.push(Op::CompareConstJump { op, constant, target }, range);
            }
            (Op::Const(constant), Op::LoadSubscr) => {
                self.drop_last(1);
                self.push(Op::LoadSubscrConst(constant), range);
            }
            _ => self.push(op, range),
        }
    }

    /// The number of a constant.
    pub fn constant(&mut self, value: Const) -> u32 {
        let next = narrow(self.consts.len());
        if let Some(key) = Key::of(&value) {
            let at = *self.const_index.entry(key).or_insert(next);
            if at != next {
                return at;
            }
        }
        self.consts.push(value);
        next
    }

    /// The number of a name.
    pub fn name(&mut self, name: &str) -> u32 {
        if let Some(at) = self.name_index.get(name) {
            return *at;
        }
        let at = narrow(self.names.len());
        self.names.push(name.into());
        self.name_index.insert(name.into(), at);
        at
    }

    /// A statement, or the header of one, begins here.
    pub fn mark(&mut self, range: TextRange) {
        if self.dead {
            return;
        }
        let pc = self.here();
        match self.statements.last_mut() {
            Some((last, at)) if *last == pc => *at = range,
            _ => self.statements.push((pc, range)),
        }
    }

    /// Adds a piece of a region, from `start` to here.
    pub fn handler(&mut self, nesting: usize, start: u32, target: Label, depth: u32, handling: u32) {
        let end = self.here();
        if start < end {
            self.handlers.push((nesting, Handler { start, end, target: target.0, depth, handling }));
        }
    }

    /// Adds a piece of a loop.
    pub fn add_loop(&mut self, piece: Loop) {
        if piece.start < piece.end {
            self.loops.push(piece);
        }
    }

    fn pc(&self, label: u32) -> u32 {
        self.labels.get(label as usize).and_then(|place| place.pc).unwrap_or(0)
    }

    /// Turns labels into numbers of instructions, and cells into slots behind the locals.
    pub fn finish(mut self, frame: Frame) -> Code {
        let first_cell = u16::try_from(frame.locals.len()).unwrap_or(u16::MAX);
        for at in 0..self.ops.len() {
            let mut op = self.ops[at];
            match &mut op {
                Op::LoadDeref(slot) | Op::StoreDeref(slot) | Op::DeleteDeref(slot) | Op::LoadClosure(slot) => *slot += first_cell,
                Op::LoadClassDeref { slot, .. } => *slot += first_cell,
                _ => {}
            }
            if let Some(target) = target_mut(&mut op) {
                *target = self.pc(*target);
            }
            self.ops[at] = op;
        }
        for piece in &mut self.loops {
            if let Some((_, Slot::Deref(slot))) = &mut piece.variable {
                *slot += first_cell;
            }
        }
        let mut handlers = std::mem::take(&mut self.handlers);
        handlers.sort_by_key(|(nesting, _)| std::cmp::Reverse(*nesting));
        let handlers = handlers.into_iter().map(|(_, handler)| Handler { target: self.pc(handler.target), ..handler }).collect();
        let Frame { name, qualname, kind, generator, params, locals, cells, frees, children, doc } = frame;
        Code {
            name,
            qualname,
            kind,
            generator,
            params,
            locals,
            cells,
            frees,
            ops: self.ops,
            ranges: self.ranges,
            consts: self.consts,
            names: self.names,
            children,
            handlers,
            loops: self.loops,
            statements: self.statements,
            doc,
        }
    }
}
