//! What a kernel does, remembered, and then played to a program that builds an expression graph of it.
//!
//! Playing it later allows conditionals: which values leave a side of a branch, and which sides are worth a jump, is known only
//! at the end. What no result needs is not played.

use core::cell::RefCell;

/// Number of a node, chosen by the backend; never 0.
pub(crate) type NodeId = u64;

/// What a node computes from its operands. Numbers are `f32`, rounded to nearest; comparisons give truth values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
    /// A new node (or one more reference to an equal one) for an operation; `None` if that failed. Where its rounding counts it
    /// must not be fused with others or put in another order, even if other operations may.
    fn op(&self, op: Op, operands: &[NodeId], is_rounded: bool) -> Option<NodeId>;
    /// Says what an operation's node is called where people read it.
    fn name(&self, _: NodeId, _: &'static str) {}
    /// Sides of branches with fewer operations than this are no conditionals.
    fn fewest(&self) -> usize {
        FEWEST
    }
    /// Begins a conditional: the operations until its end are needed only where the mask is true. `None` if the graph will
    /// have none here.
    fn begin_if(&self, mask: NodeId) -> Option<Conditional>;
    /// Ends the conditional that was begun last. Replaces its nodes that are read afterwards by new ones, equal to them where
    /// the mask is true, and anything elsewhere. `None` if that failed.
    fn end_if(&self, conditional: Conditional, nodes: &mut [NodeId]) -> Option<()>;
    /// Gives back what `literal`, `op` or `end_if` returned, once for each time.
    fn release(&self, node: NodeId);
}

/// The backend's name for a conditional.
#[derive(Clone, Copy)]
pub(crate) struct Conditional(pub u64);

/// A side of a branch with fewer operations is computed everywhere: a conditional costs a test, a jump, and a merge of each of
/// its results. With Dr.Jit on LLVM the time of renders is the same for anything from 4 to 20, but that of compilation grows
/// with the number of conditionals.
const FEWEST: usize = 20;

/// Place on a tape.
pub(super) type Index = usize;

#[derive(Clone, Copy)]
enum Entry {
    Input(NodeId),
    Literal(f32),
    /// Unused operands are 0.
    Op(Op, [Index; 3]),
}

/// Entries that matter only where the mask is true: a side of a branch.
#[derive(Clone, Copy)]
struct Side {
    mask: Index,
    start: Index,
    end: Index,
}

/// A lane's value that [`Tape::play`] shall make a node of.
pub(crate) struct Wanted(Index);

/// What a kernel did, in order.
#[derive(Default)]
pub(crate) struct Tape {
    // Borrowed only within the functions below, none of which calls another while it holds it.
    entries: RefCell<Vec<Entry>>,
    sides: RefCell<Sides>,
    /// The operations on no side that has ended.
    known: RefCell<Vec<Index>>,
    /// Bit patterns of literals, and where they are.
    literals: RefCell<Vec<(u32, Index)>>,
    /// The operations whose rounding counts.
    rounded: RefCell<Vec<Index>>,
    names: RefCell<Vec<(Index, &'static str)>>,
    wanted: RefCell<Vec<Index>>,
}

#[derive(Default)]
struct Sides {
    /// In the order of their starts, an outer one before those in it.
    all: Vec<Side>,
    /// Which of them have not ended.
    open: Vec<usize>,
}

impl Tape {
    fn push(&self, entry: Entry) -> Index {
        let mut entries = self.entries.borrow_mut();
        entries.push(entry);
        entries.len() - 1
    }

    pub(super) fn push_input(&self, node: NodeId) -> Index {
        self.push(Entry::Input(node))
    }

    /// An operation: the same entry for the same on the same operands, unless it is on a side that has ended.
    pub(super) fn push_op<const N: usize>(&self, op: Op, operands: [Index; N]) -> Index {
        let mut padded = [0; 3];
        padded[..N].copy_from_slice(&operands);
        let is_same = |&&known: &&Index| matches!(self.entries.borrow()[known], Entry::Op(other, others) if other == op && others == padded);
        // It comes after all that it reads.
        let newest = operands.into_iter().max();
        let is_after = |&&known: &&Index| Some(known) > newest;
        let known = self.known.borrow().iter().rev().take_while(is_after).find(is_same).copied();
        known.unwrap_or_else(|| {
            let index = self.push(Entry::Op(op, padded));
            self.known.borrow_mut().push(index);
            index
        })
    }

    /// The same as an entry that no other operation reads.
    pub(super) fn push_copy<const N: usize>(&self, op: Op, operands: [Index; N]) -> Index {
        let mut padded = [0; 3];
        padded[..N].copy_from_slice(&operands);
        self.push(Entry::Op(op, padded))
    }

    /// The literal of this value, one for all that use it.
    pub(super) fn literal(&self, value: f32) -> Index {
        let bits = value.to_bits();
        let known = self.literals.borrow().iter().find(|known| known.0 == bits).copied();
        known.map_or_else(
            || {
                let index = self.push(Entry::Literal(value));
                self.literals.borrow_mut().push((bits, index));
                index
            },
            |(_, index)| index,
        )
    }

    pub(super) fn keep_rounding(&self, index: Index) {
        self.rounded.borrow_mut().push(index);
    }

    pub(super) fn name(&self, index: Index, name: &'static str) {
        self.names.borrow_mut().push((index, name));
    }

    pub(super) fn begin_side(&self, mask: Index) {
        let start = self.entries.borrow().len();
        let mut sides = self.sides.borrow_mut();
        let number = sides.all.len();
        sides.open.push(number);
        sides.all.push(Side { mask, start, end: start });
    }

    pub(super) fn end_side(&self) {
        let end = self.entries.borrow().len();
        let mut sides = self.sides.borrow_mut();
        if let Some(number) = sides.open.pop() {
            sides.all[number].end = end;
            let start = sides.all[number].start;
            self.known.borrow_mut().retain(|&index| index < start);
        }
    }

    /// Wants a constant. Every result is another node: not the one that other operations use.
    pub(super) fn want_literal(&self, value: f32) -> Wanted {
        Wanted(self.push(Entry::Literal(value)))
    }

    /// Wants an operation; or, if it is none or already wanted, the copy.
    pub(super) fn want(&self, index: Index, copy: impl FnOnce() -> Index) -> Wanted {
        let is_op = matches!(self.entries.borrow()[index], Entry::Op(..));
        let is_new = is_op && !self.wanted.borrow().contains(&index);
        let index = if is_new { index } else { copy() };
        self.wanted.borrow_mut().push(index);
        Wanted(index)
    }

    /// Builds the graph: nodes for what is wanted, each of which the caller has to release. `None` if the backend failed;
    /// then no node is left.
    pub(crate) fn play<const N: usize>(
        &self,
        backend: &dyn Backend,
        wanted: [Wanted; N],
    ) -> Option<[NodeId; N]> {
        let mut nodes = [0; N];
        self.play_into(backend, &wanted, &mut nodes).map(|()| nodes)
    }

    /// The same for any number of nodes.
    pub(crate) fn play_into(
        &self,
        backend: &dyn Backend,
        wanted: &[Wanted],
        results: &mut [NodeId],
    ) -> Option<()> {
        let (entries, rounded, names) = (self.entries.borrow(), self.rounded.borrow(), self.names.borrow());
        let wanted = wanted.iter().map(|&Wanted(index)| index);
        let last_uses = last_uses(&entries, wanted.clone().map(|index| (index, entries.len())));
        let mut player = Player {
            backend,
            entries: &entries,
            rounded: &rounded,
            names: &names,
            last_uses,
            nodes: vec![0; entries.len()],
            owned: Vec::with_capacity(entries.len()),
        };
        let is_played = player.play(&self.sides.borrow().all);
        let Player { nodes, mut owned, .. } = player;
        if is_played.is_some() {
            for (result, index) in results.iter_mut().zip(wanted) {
                *result = nodes[index];
                if let Some(place) = owned.iter().rposition(|other| other == result) {
                    owned.swap_remove(place);
                }
            }
        }
        owned.into_iter().for_each(|node| backend.release(node));
        is_played
    }
}

/// For each entry the last one that reads it, given pairs of entries that are needed and where: 0 if none does.
fn last_uses(entries: &[Entry], needed: impl IntoIterator<Item = (Index, Index)>) -> Vec<Index> {
    let mut last = vec![0; entries.len()];
    for (index, user) in needed {
        last[index] = user.max(last[index]);
    }
    for (index, entry) in entries.iter().enumerate().rev() {
        if let (Entry::Op(op, operands), true) = (entry, last[index] > 0) {
            for &operand in op.used(operands) {
                last[operand] = index.max(last[operand]);
            }
        }
    }
    last
}

/// A tape being played.
struct Player<'a> {
    backend: &'a dyn Backend,
    entries: &'a [Entry],
    rounded: &'a [Index],
    names: &'a [(Index, &'static str)],
    last_uses: Vec<Index>,
    /// The node of each entry; 0 where there is none yet.
    nodes: Vec<NodeId>,
    /// What has to be released.
    owned: Vec<NodeId>,
}

impl Player<'_> {
    fn own(&mut self, index: Index, node: NodeId) {
        self.nodes[index] = node;
        self.owned.push(node);
    }

    /// The operations from `start` to `end` that something at `user` or later reads.
    fn operations(&self, side: Side, user: Index) -> impl Iterator<Item = Index> + '_ {
        let is_op = |&index: &Index| matches!(self.entries[index], Entry::Op(..));
        (side.start..side.end).filter(is_op).filter(move |&index| self.last_uses[index] >= user)
    }

    fn play(&mut self, sides: &[Side]) -> Option<()> {
        let mut sides = sides.to_vec();
        sides.retain(|&side| self.operations(side, 1).count() >= self.backend.fewest());
        // Conditionals need their masks, too.
        let known = self.last_uses.iter().copied().enumerate();
        let masks = sides.iter().map(|side| (side.mask, side.start));
        self.last_uses = last_uses(self.entries, known.chain(masks));

        // Before any conditional: a literal that is met within one may be met again after it.
        for (index, &entry) in self.entries.iter().enumerate() {
            match entry {
                Entry::Input(node) => self.nodes[index] = node,
                Entry::Literal(value) if self.last_uses[index] > 0 => {
                    let node = self.backend.literal(value)?;
                    self.own(index, node);
                }
                _ => {}
            }
        }
        let mut sides = sides.into_iter().peekable();
        let mut open: Vec<(Side, Conditional)> = Vec::new();
        for (index, &entry) in self.entries.iter().enumerate() {
            while let Some((side, conditional)) = open.pop_if(|(side, _)| side.end == index) {
                self.end_if(side, conditional)?;
            }
            while let Some(side) = sides.next_if(|side| side.start == index) {
                let conditional = self.backend.begin_if(self.nodes[side.mask]);
                open.extend(conditional.map(|conditional| (side, conditional)));
            }
            if let (Entry::Op(op, operands), true) = (entry, self.last_uses[index] > 0) {
                let operands = operands.map(|operand| self.nodes[operand]);
                let node = self.backend.op(op, op.used(&operands), self.rounded.contains(&index))?;
                self.own(index, node);
                self.name(index);
            }
        }
        while let Some((side, conditional)) = open.pop() {
            self.end_if(side, conditional)?;
        }
        Some(())
    }

    fn end_if(&mut self, side: Side, conditional: Conditional) -> Option<()> {
        let read_later: Vec<Index> = self.operations(side, side.end).collect();
        let mut nodes: Vec<NodeId> = read_later.iter().map(|&index| self.nodes[index]).collect();
        self.backend.end_if(conditional, &mut nodes)?;
        for (index, node) in read_later.into_iter().zip(nodes) {
            self.own(index, node);
            self.name(index);
        }
        Some(())
    }

    /// Tells what the number there is called, if it has a name.
    fn name(&self, index: Index) {
        for (_, name) in self.names.iter().filter(|(named, _)| *named == index) {
            self.backend.name(self.nodes[index], name);
        }
    }
}

impl Op {
    /// Those of three operands that it has.
    fn used<T>(self, operands: &[T; 3]) -> &[T] {
        let count = match self {
            Self::Neg | Self::Abs | Self::Sqrt | Self::Not => 1,
            Self::PowerOfTwo | Self::Bits | Self::FloatOfBits => 1,
            Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Lt | Self::Le | Self::And | Self::Or => 2,
            Self::Fma | Self::Select => 3,
        };
        &operands[..count]
    }
}
