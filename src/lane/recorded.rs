//! The recorded lane: a node of somebody else's expression graph. Running a kernel on it builds the graph that computes
//! the kernel, of which every evaluation gives the scalar `f32` kernel's bits, if the graph's operations are IEEE's.
//!
//! A [`Backend`] makes nodes; a [`Tape`] owns every node that a kernel makes and releases them all when it is dropped, but
//! for those that were [kept](Tape::keep). Hence a [`Recorded`] can be `Copy`, as lanes are. Operations between literals
//! need no graph: they are carried out in `f32`, and only a literal that meets a node becomes one (once per tape).

use super::{Blend, Lane, Lit, Mask};
use crate::fits::{Fits, SINGLE};
use core::cell::Cell;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Number of a node, chosen by the backend; never 0.
pub(crate) type NodeId = u64;

/// What a node computes from its operands. Numbers are `f32`, rounded to nearest; comparisons give truth values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Op {
    Add,
    Sub,
    Mul,
    Div,
    /// `a * b + c`, rounded once.
    Fma,
    Neg,
    Abs,
    Sqrt,
    /// False where an operand is NaN, like `Le`.
    Lt,
    Le,
    And,
    Or,
    Not,
    /// The second operand where the first, a truth value, is true, else the third.
    Select,
    /// The number without its sign and its significand.
    PowerOfTwo,
    /// The bit pattern, read as a signed integer and converted to the nearest number.
    Bits,
    /// A number in [0, 2^31), truncated, as bit pattern.
    FloatOfBits,
}

/// A program that builds an expression graph.
pub(crate) trait Backend {
    /// A new node for a constant; `None` if that failed.
    fn literal(&self, value: f32) -> Option<NodeId>;
    /// A new node (or one more reference to an equal one) for an operation; `None` if that failed.
    fn op(&self, op: Op, operands: &[NodeId]) -> Option<NodeId>;
    /// Gives back what `literal` or `op` returned, once for each time.
    fn release(&self, node: NodeId);
}

/// Owns the nodes of one recording.
pub(crate) struct Tape<'b> {
    backend: &'b dyn Backend,
    // Cells that are emptied while they are looked at: no borrow can fail.
    owned: Cell<Vec<NodeId>>,
    literals: Cell<Vec<(u32, NodeId)>>,
    failed: Cell<bool>,
}

/// Stands for the result of an operation after a failure. It never reaches the backend.
const NOTHING: NodeId = 0;

impl<'b> Tape<'b> {
    pub(crate) fn new(backend: &'b dyn Backend) -> Self {
        Self {
            backend,
            owned: Cell::new(Vec::with_capacity(1024)),
            literals: Cell::new(Vec::with_capacity(64)),
            failed: Cell::new(false),
        }
    }

    /// Whether the backend has failed to make a node. All that was recorded since is void.
    pub(crate) fn has_failed(&self) -> bool {
        self.failed.get()
    }

    /// A lane for a node of the caller's, which stays the caller's.
    pub(crate) fn input(&self, node: NodeId) -> Recorded<'_> {
        Recorded::Node(Node { tape: self, id: node })
    }

    /// A node of its own for a lane, which the caller has to release.
    pub(crate) fn keep(&self, lane: Recorded<'_>) -> NodeId {
        let id = match lane {
            // Not the memo's: it may be met again.
            Recorded::Lit(_) if self.has_failed() => NOTHING,
            Recorded::Lit(value) => self.own(self.backend.literal(value)),
            Recorded::Node(node) => node.id,
        };
        self.keep_id(id, |id| self.op(Op::Mul, &[id, self.literal(1.0)]))
    }

    /// The same for a mask.
    pub(crate) fn keep_mask(&self, mask: RecordedMask<'_>) -> NodeId {
        let id = match mask {
            RecordedMask::Lit(value) => {
                let (zero, one) = (self.literal(0.0), self.literal(1.0));
                self.op(Op::Lt, &if value { [zero, one] } else { [one, zero] })
            }
            RecordedMask::Node(node) => node.id,
        };
        self.keep_id(id, |id| self.op(Op::And, &[id, id]))
    }

    /// Takes a node off the tape. One that is not on it (the caller's own, or kept before) is copied.
    fn keep_id(&self, id: NodeId, copy: impl Fn(NodeId) -> NodeId) -> NodeId {
        let take = |id| {
            let mut owned = self.owned.take();
            let found = owned.iter().rposition(|&other| other == id);
            if let Some(index) = found {
                owned.swap_remove(index);
            }
            self.owned.set(owned);
            found.is_some()
        };
        if id == NOTHING || take(id) {
            return id;
        }
        let id = copy(id);
        take(id);
        id
    }

    /// Releases a node that was kept.
    pub(crate) fn give_back(&self, id: NodeId) {
        if id != NOTHING {
            self.backend.release(id);
        }
    }

    fn own(&self, node: Option<NodeId>) -> NodeId {
        let Some(id) = node else {
            self.failed.set(true);
            return NOTHING;
        };
        let mut owned = self.owned.take();
        owned.push(id);
        self.owned.set(owned);
        id
    }

    fn literal(&self, value: f32) -> NodeId {
        if self.has_failed() {
            return NOTHING;
        }
        let mut literals = self.literals.take();
        let id = match literals.iter().find(|(bits, _)| *bits == value.to_bits()) {
            Some(&(_, id)) => id,
            None => {
                let id = self.own(self.backend.literal(value));
                literals.push((value.to_bits(), id));
                id
            }
        };
        self.literals.set(literals);
        id
    }

    fn op(&self, op: Op, operands: &[NodeId]) -> NodeId {
        if self.has_failed() || operands.contains(&NOTHING) {
            return NOTHING;
        }
        self.own(self.backend.op(op, operands))
    }
}

impl Drop for Tape<'_> {
    fn drop(&mut self) {
        for node in self.owned.take() {
            self.backend.release(node);
        }
    }
}

/// A node on a tape.
#[derive(Clone, Copy)]
pub(crate) struct Node<'t> {
    tape: &'t Tape<'t>,
    id: NodeId,
}

impl<'t> Node<'t> {
    fn then(self, op: Op, operands: &[NodeId]) -> Self {
        Self { tape: self.tape, id: self.tape.op(op, operands) }
    }
}

/// A number of the graph, or a constant that has not met one yet.
#[derive(Clone, Copy)]
pub(crate) enum Recorded<'t> {
    Lit(f32),
    Node(Node<'t>),
}
use Recorded::Lit as Constant;

impl<'t> Recorded<'t> {
    fn tape(self) -> Option<&'t Tape<'t>> {
        match self {
            Constant(_) => None,
            Self::Node(node) => Some(node.tape),
        }
    }

    fn id(self, tape: &Tape<'_>) -> NodeId {
        match self {
            Constant(value) => tape.literal(value),
            Self::Node(node) => node.id,
        }
    }

    /// The operation on constants, or else a node for it.
    fn apply<const N: usize>(op: Op, operands: [Self; N], fold: impl FnOnce([f32; N]) -> f32) -> Self {
        match operands.iter().find_map(|x| x.tape()) {
            Some(tape) => {
                Self::Node(Node { tape, id: tape.op(op, &operands.map(|operand| operand.id(tape))) })
            }
            None => Constant(fold(operands.map(Self::constant))),
        }
    }

    fn compare(op: Op, operands: [Self; 2], fold: impl FnOnce([f32; 2]) -> bool) -> RecordedMask<'t> {
        match operands.iter().find_map(|x| x.tape()) {
            Some(tape) => {
                RecordedMask::Node(Node { tape, id: tape.op(op, &operands.map(|operand| operand.id(tape))) })
            }
            None => RecordedMask::Lit(fold(operands.map(Self::constant))),
        }
    }

    /// The value of a constant; of a node, which has none, NaN.
    fn constant(self) -> f32 {
        match self {
            Constant(value) => value,
            Self::Node(_) => f32::NAN,
        }
    }

    fn is_same(self, other: Self) -> bool {
        match (self, other) {
            (Constant(a), Constant(b)) => a.to_bits() == b.to_bits(),
            (Self::Node(a), Self::Node(b)) => a.id == b.id,
            _ => false,
        }
    }
}

/// A truth value of the graph, or a constant.
#[derive(Clone, Copy)]
pub(crate) enum RecordedMask<'t> {
    Lit(bool),
    Node(Node<'t>),
}

impl Mask for RecordedMask<'_> {
    fn any(self) -> bool {
        !matches!(self, Self::Lit(false))
    }
    fn all(self) -> bool {
        matches!(self, Self::Lit(true))
    }
}

impl BitAnd for RecordedMask<'_> {
    type Output = Self;
    fn bitand(self, rhs: Self) -> Self {
        match (self, rhs) {
            (Self::Lit(true), other) | (other, Self::Lit(true)) => other,
            (Self::Lit(false), _) | (_, Self::Lit(false)) => Self::Lit(false),
            (Self::Node(a), Self::Node(b)) => Self::Node(a.then(Op::And, &[a.id, b.id])),
        }
    }
}

impl BitOr for RecordedMask<'_> {
    type Output = Self;
    fn bitor(self, rhs: Self) -> Self {
        match (self, rhs) {
            (Self::Lit(false), other) | (other, Self::Lit(false)) => other,
            (Self::Lit(true), _) | (_, Self::Lit(true)) => Self::Lit(true),
            (Self::Node(a), Self::Node(b)) => Self::Node(a.then(Op::Or, &[a.id, b.id])),
        }
    }
}

impl Not for RecordedMask<'_> {
    type Output = Self;
    fn not(self) -> Self {
        match self {
            Self::Lit(value) => Self::Lit(!value),
            Self::Node(a) => Self::Node(a.then(Op::Not, &[a.id])),
        }
    }
}

macro_rules! operators {
    ($($op:ident $method:ident),*) => {$(
        impl $op for Recorded<'_> {
            type Output = Self;
            fn $method(self, rhs: Self) -> Self {
                Self::apply(Op::$op, [self, rhs], |[a, b]| a.$method(b))
            }
        }
        impl $op<Lit> for Recorded<'_> {
            type Output = Self;
            fn $method(self, rhs: Lit) -> Self {
                self.$method(Self::lit(rhs.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Recorded<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::apply(Op::Neg, [self], |[a]| -a)
    }
}

impl<'t> Blend<RecordedMask<'t>> for Recorded<'t> {
    fn blank() -> Self {
        Constant(0.0)
    }
    fn blend(mask: RecordedMask<'t>, yes: Self, no: Self) -> Self {
        Self::select(mask, yes, no)
    }
}

impl<'t> Lane for Recorded<'t> {
    type Mask = RecordedMask<'t>;
    const FITS: Fits = SINGLE;
    const SIGNIFICAND_BITS: i32 = <f32 as Lane>::SIGNIFICAND_BITS;
    const EXPONENT_BIAS: i32 = <f32 as Lane>::EXPONENT_BIAS;
    const EPSILON: f64 = <f32 as Lane>::EPSILON;
    const MIN_POSITIVE: f64 = <f32 as Lane>::MIN_POSITIVE;
    const MAX: f64 = <f32 as Lane>::MAX;

    fn lit(value: f64) -> Self {
        Constant(f32::lit(value))
    }
    fn fma(self, factor: Self, addend: Self) -> Self {
        Self::apply(Op::Fma, [self, factor, addend], |[a, b, c]| a.mul_add(b, c))
    }
    fn sqrt(self) -> Self {
        Self::apply(Op::Sqrt, [self], |[a]| a.sqrt())
    }
    fn abs(self) -> Self {
        Self::apply(Op::Abs, [self], |[a]| a.abs())
    }
    // The minimum and maximum of graphs differ in what they do with NaN and zeros: selects do not.
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    fn max(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    fn lt(self, other: Self) -> RecordedMask<'t> {
        Self::compare(Op::Lt, [self, other], |[a, b]| a < b)
    }
    fn le(self, other: Self) -> RecordedMask<'t> {
        Self::compare(Op::Le, [self, other], |[a, b]| a <= b)
    }
    fn select(mask: RecordedMask<'t>, yes: Self, no: Self) -> Self {
        match mask {
            RecordedMask::Lit(mask) => {
                if mask {
                    yes
                } else {
                    no
                }
            }
            RecordedMask::Node(_) if yes.is_same(no) => yes,
            RecordedMask::Node(node) => {
                let operands = [node.id, yes.id(node.tape), no.id(node.tape)];
                Self::Node(node.then(Op::Select, &operands))
            }
        }
    }
    fn power_of_two(self) -> Self {
        Self::apply(Op::PowerOfTwo, [self], |[a]| a.power_of_two())
    }
    fn bits(self) -> Self {
        Self::apply(Op::Bits, [self], |[a]| Lane::bits(a))
    }
    fn float_of_bits(self) -> Self {
        Self::apply(Op::FloatOfBits, [self], |[a]| a.float_of_bits())
    }
}
