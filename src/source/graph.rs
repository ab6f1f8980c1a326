//! A recording as nested blocks of operations, each made once: what is printed.

use super::Form;
use crate::lane::recorded::{Backend, Conditional, NodeId, Op};
use std::cell::RefCell;
use std::collections::HashMap;

/// Place in [`Graph::values`].
pub(super) type Value = usize;

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// A parameter of the function, by its place.
    Input(usize),
    /// A number, by its bits.
    Number(u32),
    Truth(bool),
    Op(Op),
    /// `a < b ? a : b`
    Min,
    /// `a > b ? a : b`
    Max,
    /// What rounding took off the product `a * b`; the third operand is the product.
    Lost,
    /// What a conditional gives.
    Merge,
}

#[derive(Clone, Debug)]
pub(super) struct Def {
    pub kind: Kind,
    pub operands: Vec<Value>,
    /// Whether its own rounding counts.
    pub is_rounded: bool,
    /// How many conditionals are around it.
    depth: usize,
}

#[derive(Clone, Debug)]
pub(super) enum Item {
    Op(Value),
    If(If),
}

/// A conditional with two sides, and what it gives.
#[derive(Clone, Debug)]
pub(super) struct If {
    pub mask: Value,
    pub sides: [Vec<Item>; 2],
    pub merges: Vec<Merge>,
}

/// A value that is one or another, or (`None`) anything: where the mask is true, and where it is false.
#[derive(Clone, Debug)]
pub(super) struct Merge {
    pub out: Value,
    pub sides: [Option<Value>; 2],
}

#[derive(Clone, Default)]
pub(super) struct Graph {
    pub values: Vec<Def>,
    pub items: Vec<Item>,
    /// What values are to be called.
    pub names: HashMap<Value, String>,
}

/// What the innermost conditional knows beside the outer ones.
#[derive(Default)]
struct Scope {
    items: Vec<Item>,
    made: HashMap<(Kind, Vec<Value>), Value>,
    facts: HashMap<Value, bool>,
}

/// The backend that makes a graph.
pub(super) struct Builder {
    state: RefCell<State>,
    /// It says how many conditionals, the first ones, are what is known of the input.
    form: Form,
}

struct State {
    graph: Graph,
    scopes: Vec<Scope>,
    /// Of each open conditional: is it one of the graph, or known?
    open: Vec<Opened>,
    assumptions: usize,
}

#[derive(Clone, Copy)]
enum Opened {
    /// The mask, and which side this is.
    Side(Value, usize),
    Always,
    Never,
}

impl State {
    fn fact(&self, mask: Value) -> Option<bool> {
        if let Kind::Truth(truth) = self.graph.values[mask].kind {
            return Some(truth);
        }
        self.scopes.iter().rev().find_map(|scope| scope.facts.get(&mask).copied())
    }

    /// Learns that a mask is so in the innermost scope, and what follows from it.
    fn learn(&mut self, mask: Value, truth: bool) {
        let scope = self.scopes.last_mut().expect("there is one");
        scope.facts.insert(mask, truth);
        let Def { kind, operands, .. } = self.graph.values[mask].clone();
        match (kind, truth) {
            (Kind::Op(Op::And), true) | (Kind::Op(Op::Or), false) => {
                operands.into_iter().for_each(|operand| self.learn(operand, truth));
            }
            (Kind::Op(Op::Not), _) => self.learn(operands[0], !truth),
            _ => {}
        }
    }

    fn kind(&self, value: Value) -> Kind {
        self.graph.values[value].kind
    }

    fn operands(&self, value: Value, op: Op) -> Option<Vec<Value>> {
        (self.kind(value) == Kind::Op(op)).then(|| self.graph.values[value].operands.clone())
    }

    fn is_number(&self, value: Value, number: f32) -> bool {
        self.kind(value) == Kind::Number(number.to_bits())
    }

    /// What a value is not below, if that is known: NaN counts as not below anything.
    fn least(&self, value: Value) -> Option<f32> {
        let Def { kind, operands, .. } = &self.graph.values[value];
        match kind {
            Kind::Number(bits) => Some(f32::from_bits(*bits)),
            Kind::Max => self.least(operands[1]),
            Kind::Min => Some(self.least(operands[0])?.min(self.least(operands[1])?)),
            _ => None,
        }
    }

    /// The value of this kind: a new one unless it is known here.
    fn make(&mut self, kind: Kind, operands: Vec<Value>) -> Value {
        let key = (kind, operands);
        if let Some(&value) = self.scopes.iter().find_map(|scope| scope.made.get(&key)) {
            return value;
        }
        let is_op = !matches!(kind, Kind::Input(_) | Kind::Number(_) | Kind::Truth(_));
        // What needs no operation is known everywhere.
        let depth = if is_op { self.scopes.len() - 1 } else { 0 };
        let value = self.graph.values.len();
        self.graph.values.push(Def { kind, operands: key.1.clone(), is_rounded: false, depth });
        let scope = &mut self.scopes[depth];
        if is_op {
            scope.items.push(Item::Op(value));
        }
        scope.made.insert(key, value);
        value
    }

    /// The value of an operation, by the rules that change no bit.
    fn op(&mut self, op: Op, operands: &[Value]) -> Value {
        let [a, b, c] = [0, 1, 2].map(|i| operands.get(i).copied().unwrap_or(0));
        match op {
            Op::Mul if self.is_number(b, 1.0) => return a,
            Op::Mul if self.is_number(a, 1.0) => return b,
            Op::Div if self.is_number(b, 1.0) => return a,
            Op::Sub if self.is_number(b, 0.0) => return a,
            Op::Add => {
                if let Some(negated) = self.operands(b, Op::Neg) {
                    return self.op(Op::Sub, &[a, negated[0]]);
                }
            }
            Op::Neg => {
                if let Some(negated) = self.operands(a, Op::Neg) {
                    return negated[0];
                }
            }
            Op::And | Op::Or => {
                let neutral = op == Op::And;
                for (x, y) in [(a, b), (b, a)] {
                    match self.fact(x) {
                        Some(truth) if truth == neutral => return y,
                        Some(truth) => return self.make(Kind::Truth(truth), vec![]),
                        None => {}
                    }
                }
                if a == b {
                    return a;
                }
            }
            Op::Not => {
                if let Some(truth) = self.fact(a) {
                    return self.make(Kind::Truth(!truth), vec![]);
                }
                if let Some(negated) = self.operands(a, Op::Not) {
                    return negated[0];
                }
            }
            Op::Lt | Op::Le => {
                // In a comparison one zero is as good as the other.
                for (i, x) in [a, b].into_iter().enumerate() {
                    if let Some(sum) = self.operands(x, Op::Add).filter(|sum| self.is_number(sum[1], 0.0)) {
                        let compared = if i == 0 { [sum[0], b] } else { [a, sum[0]] };
                        return self.op(op, &compared);
                    }
                }
                if let (Op::Lt, Some(least), Kind::Number(bits)) = (op, self.least(a), self.kind(b)) {
                    if f32::from_bits(bits) <= least {
                        return self.make(Kind::Truth(false), vec![]);
                    }
                }
                if let (Kind::Number(x), Kind::Number(y)) = (self.kind(a), self.kind(b)) {
                    let (x, y) = (f32::from_bits(x), f32::from_bits(y));
                    let truth = if op == Op::Lt { x < y } else { x <= y };
                    return self.make(Kind::Truth(truth), vec![]);
                }
            }
            Op::Select => {
                match self.fact(a) {
                    Some(true) => return b,
                    Some(false) => return c,
                    None if b == c => return b,
                    None => {}
                }
                if let Some(negated) = self.operands(a, Op::Not) {
                    return self.op(Op::Select, &[negated[0], c, b]);
                }
                // A number or what a scale makes of it: times 1 or the scale.
                if let Some(product) = self.operands(c, Op::Mul).filter(|product| product[0] == b) {
                    let one = self.make(Kind::Number(1.0_f32.to_bits()), vec![]);
                    let scale = self.op(Op::Select, &[a, one, product[1]]);
                    return self.op(Op::Mul, &[b, scale]);
                }
                if let Some(compared) = self.operands(a, Op::Lt) {
                    if compared == [b, c] {
                        return self.make(Kind::Min, vec![b, c]);
                    }
                    if compared == [c, b] {
                        return self.make(Kind::Max, vec![b, c]);
                    }
                }
            }
            Op::Fma => {
                // a b - (a b), and (-a) b + (a b).
                if let Some(product) = self.operands(c, Op::Neg) {
                    if self.operands(product[0], Op::Mul).is_some_and(|factors| factors == [a, b]) {
                        return self.make(Kind::Lost, vec![a, b, product[0]]);
                    }
                }
                if let Some(factor) = self.operands(a, Op::Neg) {
                    if self.operands(c, Op::Mul).is_some_and(|factors| factors == [factor[0], b]) {
                        let lost = self.make(Kind::Lost, vec![factor[0], b, c]);
                        return self.op(Op::Neg, &[lost]);
                    }
                }
            }
            _ => {}
        }
        self.make(Kind::Op(op), operands.to_vec())
    }
}

fn value(node: NodeId) -> Value {
    node as Value - 1
}

fn node(value: Value) -> NodeId {
    value as NodeId + 1
}

impl Builder {
    pub(super) fn new(form: Form) -> Self {
        let graph = Graph::default();
        let state = State { graph, scopes: vec![Scope::default()], open: vec![], assumptions: 0 };
        Self { state: RefCell::new(state), form }
    }

    /// The parameter at this place.
    pub(super) fn input(&self, place: usize) -> NodeId {
        node(self.state.borrow_mut().make(Kind::Input(place), vec![]))
    }

    pub(super) fn finish(self) -> Graph {
        let State { mut graph, mut scopes, .. } = self.state.into_inner();
        graph.items = scopes.pop().expect("there is one").items;
        assert!(scopes.is_empty(), "all conditionals have ended");
        graph
    }

    pub(super) fn value(node: NodeId) -> Value {
        value(node)
    }
}

impl Backend for Builder {
    fn literal(&self, value: f32) -> Option<NodeId> {
        Some(node(self.state.borrow_mut().make(Kind::Number(value.to_bits()), vec![])))
    }

    fn op(&self, op: Op, operands: &[NodeId], is_rounded: bool) -> Option<NodeId> {
        let state = &mut *self.state.borrow_mut();
        let operands: Vec<Value> = operands.iter().map(|&operand| value(operand)).collect();
        let value = state.op(op, &operands);
        state.graph.values[value].is_rounded |= is_rounded;
        Some(node(value))
    }

    fn name(&self, named: NodeId, name: &'static str) {
        self.state.borrow_mut().graph.names.entry(value(named)).or_insert_with(|| name.to_owned());
    }

    fn begin_if(&self, mask: NodeId) -> Option<Conditional> {
        let state = &mut *self.state.borrow_mut();
        let mask = value(mask);
        if state.assumptions < self.form.assumptions() {
            state.assumptions += 1;
            state.learn(mask, true);
        }
        let opened = match state.fact(mask) {
            Some(true) => Opened::Always,
            Some(false) => {
                state.scopes.push(Scope::default());
                Opened::Never
            }
            None => {
                state.scopes.push(Scope::default());
                state.learn(mask, true);
                match state.operands(mask, Op::Not) {
                    Some(negated) => Opened::Side(negated[0], 1),
                    None => Opened::Side(mask, 0),
                }
            }
        };
        state.open.push(opened);
        Some(Conditional(0))
    }

    fn end_if(&self, _: Conditional, nodes: &mut [NodeId]) -> Option<()> {
        let state = &mut *self.state.borrow_mut();
        match state.open.pop().expect("one is open") {
            Opened::Always => {}
            Opened::Never => {
                state.scopes.pop();
                for node_of in nodes {
                    *node_of = node(state.make(Kind::Number(0), vec![]));
                }
            }
            Opened::Side(mask, side) => {
                let Scope { items, .. } = state.scopes.pop().expect("one is open");
                let depth = state.scopes.len() - 1;
                let mut merges = Vec::new();
                for node_of in nodes {
                    let inner = value(*node_of);
                    if state.graph.values[inner].depth > depth {
                        let out = state.graph.values.len();
                        let kind = Kind::Merge;
                        state.graph.values.push(Def { kind, operands: vec![], is_rounded: false, depth });
                        let mut sides = [None; 2];
                        sides[side] = Some(inner);
                        merges.push(Merge { out, sides });
                        *node_of = node(out);
                    }
                }
                let mut sides = [vec![], vec![]];
                sides[side] = items;
                let scope = state.scopes.last_mut().expect("there is one");
                scope.items.push(Item::If(If { mask, sides, merges }));
            }
        }
        Some(())
    }

    fn release(&self, _: NodeId) {}
}
