//! The recorded lane: a node of somebody else's expression graph. Running a kernel on it builds the graph that computes
//! the kernel, of which every evaluation gives the scalar `f32` kernel's bits, if the graph's operations are IEEE's.
//!
//! A [`Tape`] remembers what the kernel does, and is then played to a [`Backend`], which makes nodes. Operations between
//! literals need no graph: they are carried out in `f32`, and only a literal that meets a node becomes one (once per tape).
//! The sides of a [`branch!`](super::branch) become conditionals, where the graph has them and a side is long enough.

mod tape;

use super::{Blend, Lane, Lit, Mask};
use crate::fits::{Fits, SINGLE};
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use tape::Index;

pub(crate) use tape::{Backend, Conditional, NodeId, Op, Tape, Wanted};

/// A place on a tape.
#[derive(Clone, Copy)]
pub(crate) struct Node<'t> {
    tape: &'t Tape,
    // An `Index`, but small enough that a lane fits into two registers.
    index: u32,
}

impl<'t> Node<'t> {
    fn new(tape: &'t Tape, index: Index) -> Self {
        Self { tape, index: index as u32 }
    }

    fn index(self) -> Index {
        self.index as Index
    }

    fn then<const N: usize>(self, op: Op, operands: [Index; N]) -> Self {
        Self::new(self.tape, self.tape.push_op(op, operands))
    }
}

impl Tape {
    /// A lane for a node of the caller's, which stays the caller's.
    pub(crate) fn input(&self, node: NodeId) -> Recorded<'_> {
        Recorded::Node(Node::new(self, self.push_input(node)))
    }

    /// What [`Tape::play`] shall make a node of: a number.
    pub(crate) fn want_number(&self, lane: Recorded<'_>) -> Wanted {
        match lane {
            Recorded::Lit(value) => self.want_literal(value),
            Recorded::Node(node) => {
                let index = node.index();
                self.want(index, || self.push_copy(Op::Mul, [index, self.literal(1.0)]))
            }
        }
    }

    /// The same for a truth value.
    pub(crate) fn want_mask(&self, mask: RecordedMask<'_>) -> Wanted {
        let index = match mask {
            RecordedMask::Lit(value) => {
                let operands = if value { [0.0, 1.0] } else { [1.0, 0.0] };
                self.push_copy(Op::Lt, operands.map(|x| self.literal(x)))
            }
            RecordedMask::Node(node) => node.index(),
        };
        self.want(index, || self.push_copy(Op::And, [index, index]))
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
    fn node(self) -> Option<Node<'t>> {
        match self {
            Constant(_) => None,
            Self::Node(node) => Some(node),
        }
    }

    fn index(self, tape: &Tape) -> Index {
        match self {
            Constant(value) => tape.literal(value),
            Self::Node(node) => node.index(),
        }
    }

    /// The operation on constants, or else a node for it.
    fn apply<const N: usize>(op: Op, operands: [Self; N], fold: impl FnOnce([f32; N]) -> f32) -> Self {
        match operands.iter().find_map(|x| x.node()) {
            Some(node) => Self::Node(node.then(op, operands.map(|operand| operand.index(node.tape)))),
            None => Constant(fold(operands.map(Self::constant))),
        }
    }

    fn compare(op: Op, operands: [Self; 2], fold: impl FnOnce([f32; 2]) -> bool) -> RecordedMask<'t> {
        match operands.iter().find_map(|x| x.node()) {
            Some(node) => RecordedMask::Node(node.then(op, operands.map(|operand| operand.index(node.tape)))),
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
            (Self::Node(a), Self::Node(b)) => a.index == b.index,
            _ => false,
        }
    }
}

/// A place on the tape by its number: for `source.rs`, which reads those of a prepared sampler from here.
#[cfg(test)]
impl core::fmt::Debug for Recorded<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Constant(value) => write!(f, "{value:?}"),
            Self::Node(node) => write!(f, "#{}", node.index),
        }
    }
}

#[cfg(test)]
impl<'t> Recorded<'t> {
    /// The number at this place.
    pub(crate) fn at(tape: &'t Tape, place: u32) -> Self {
        Self::Node(Node { tape, index: place })
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
    fn begin_side(self, side: bool) {
        if let Self::Node(node) = if side { self } else { !self } {
            node.tape.begin_side(node.index());
        }
    }
    fn end_side(self) {
        if let Self::Node(node) = self {
            node.tape.end_side();
        }
    }
}

// Kernels consist of hundreds of calls of what follows. Inlined, they would be twice as large.

impl BitAnd for RecordedMask<'_> {
    type Output = Self;
    #[inline(never)]
    fn bitand(self, rhs: Self) -> Self {
        match (self, rhs) {
            (Self::Lit(true), other) | (other, Self::Lit(true)) => other,
            (Self::Lit(false), _) | (_, Self::Lit(false)) => Self::Lit(false),
            (Self::Node(a), Self::Node(b)) => Self::Node(a.then(Op::And, [a.index(), b.index()])),
        }
    }
}

impl BitOr for RecordedMask<'_> {
    type Output = Self;
    #[inline(never)]
    fn bitor(self, rhs: Self) -> Self {
        match (self, rhs) {
            (Self::Lit(false), other) | (other, Self::Lit(false)) => other,
            (Self::Lit(true), _) | (_, Self::Lit(true)) => Self::Lit(true),
            (Self::Node(a), Self::Node(b)) => Self::Node(a.then(Op::Or, [a.index(), b.index()])),
        }
    }
}

impl Not for RecordedMask<'_> {
    type Output = Self;
    #[inline(never)]
    fn not(self) -> Self {
        match self {
            Self::Lit(value) => Self::Lit(!value),
            Self::Node(a) => Self::Node(a.then(Op::Not, [a.index()])),
        }
    }
}

macro_rules! operators {
    ($($op:ident $method:ident),*) => {$(
        impl $op for Recorded<'_> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, rhs: Self) -> Self {
                Self::apply(Op::$op, [self, rhs], |[a, b]| a.$method(b))
            }
        }
        impl $op<Lit> for Recorded<'_> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, rhs: Lit) -> Self {
                self.$method(Self::lit(rhs.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Recorded<'_> {
    type Output = Self;
    #[inline(never)]
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
    const FORKS: bool = false;
    const FITS: Fits = SINGLE;
    const SIGNIFICAND_BITS: i32 = <f32 as Lane>::SIGNIFICAND_BITS;
    const EXPONENT_BIAS: i32 = <f32 as Lane>::EXPONENT_BIAS;
    const EPSILON: f64 = <f32 as Lane>::EPSILON;
    const MIN_POSITIVE: f64 = <f32 as Lane>::MIN_POSITIVE;
    const MAX: f64 = <f32 as Lane>::MAX;

    fn lit(value: f64) -> Self {
        Constant(f32::lit(value))
    }
    #[inline(never)]
    fn fma(self, factor: Self, addend: Self) -> Self {
        Self::apply(Op::Fma, [self, factor, addend], |[a, b, c]| a.mul_add(b, c))
    }
    #[inline(never)]
    fn rounded(self) -> Self {
        if let Self::Node(node) = self {
            node.tape.keep_rounding(node.index());
        }
        self
    }
    #[inline(never)]
    fn named(self, name: &'static str) -> Self {
        if let Self::Node(node) = self {
            node.tape.name(node.index(), name);
        }
        self
    }
    #[inline(never)]
    fn sqrt(self) -> Self {
        Self::apply(Op::Sqrt, [self], |[a]| a.sqrt())
    }
    #[inline(never)]
    fn abs(self) -> Self {
        Self::apply(Op::Abs, [self], |[a]| a.abs())
    }
    // The minimum and maximum of graphs differ in what they do with NaN and zeros: selects do not.
    #[inline(never)]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    #[inline(never)]
    fn max(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    #[inline(never)]
    fn lt(self, other: Self) -> RecordedMask<'t> {
        Self::compare(Op::Lt, [self, other], |[a, b]| a < b)
    }
    #[inline(never)]
    fn le(self, other: Self) -> RecordedMask<'t> {
        Self::compare(Op::Le, [self, other], |[a, b]| a <= b)
    }
    #[inline(never)]
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
                let operands = [node.index(), yes.index(node.tape), no.index(node.tape)];
                Self::Node(node.then(Op::Select, operands))
            }
        }
    }
    #[inline(never)]
    fn power_of_two(self) -> Self {
        Self::apply(Op::PowerOfTwo, [self], |[a]| a.power_of_two())
    }
    #[inline(never)]
    fn bits(self) -> Self {
        Self::apply(Op::Bits, [self], |[a]| Lane::bits(a))
    }
    #[inline(never)]
    fn float_of_bits(self) -> Self {
        Self::apply(Op::FloatOfBits, [self], |[a]| a.float_of_bits())
    }
}
