//! A graph as statements of a language.

use super::graph::{Def, Graph, If, Item, Kind, Value};
use super::language::{Guard, Language};
use crate::lane::recorded::Op;
use std::collections::{HashMap, HashSet};

/// Longer expressions get variables for their parts.
const LONGEST: usize = 72;

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Choice,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Sign,
    Whole,
}
use Binding::{And, Choice, Comparison, Or, Product, Sign, Sum, Whole};

pub(super) struct Printer<'a> {
    language: &'a Language,
    graph: &'a Graph,
    /// Parameters, by their places.
    inputs: &'a [String],
    uses: HashMap<Value, usize>,
    /// What sums and differences read.
    summands: HashSet<Value>,
    /// Expressions that have to be part of a `precise` variable.
    precise: HashSet<Value>,
    texts: HashMap<Value, (String, Binding)>,
    taken: HashSet<String>,
    count: usize,
    pub lines: String,
    indent: usize,
}

impl<'a> Printer<'a> {
    pub(super) fn new(
        language: &'a Language,
        graph: &'a Graph,
        inputs: &'a [String],
        outputs: &[Value],
    ) -> Self {
        let mut uses = HashMap::new();
        count(graph, &graph.items, &mut uses);
        for &output in outputs {
            *uses.entry(output).or_default() += 1;
        }
        let taken = inputs.iter().map(|input| input.split(['.', '[']).next().unwrap_or(input).to_owned());
        let taken = taken.chain(["radius", "normal", "centre"].map(String::from)).collect();
        let (texts, lines) = (HashMap::new(), String::new());
        let is_sum = |def: &&Def| matches!(def.kind, Kind::Op(Op::Add | Op::Sub));
        let summands = graph.values.iter().filter(is_sum).flat_map(|def| &def.operands).copied().collect();
        let precise = HashSet::new();
        Self { language, graph, inputs, summands, precise, uses, texts, taken, count: 0, lines, indent: 1 }
    }

    pub(super) fn line(&mut self, text: &str) {
        self.lines.push_str(&"    ".repeat(self.indent));
        self.lines.push_str(text);
        self.lines.push('\n');
    }

    pub(super) fn run(&mut self) {
        let graph = self.graph;
        self.block(&graph.items);
    }

    /// The expression for a value, for an argument or an assignment.
    pub(super) fn whole(&mut self, value: Value) -> String {
        self.text(value, Choice)
    }

    fn name(&mut self, value: Value) -> String {
        if let Some(wish) = self.graph.names.get(&value) {
            if self.taken.insert(wish.clone()) {
                return wish.clone();
            }
        }
        self.count += 1;
        format!("t{}", self.count)
    }

    fn block(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Op(value) => self.operation(*value),
                Item::If(conditional) => self.conditional(conditional),
            }
        }
    }

    fn operation(&mut self, value: Value) {
        let (text, binding) = self.expression(value);
        let def = &self.graph.values[value];
        // What is `precise` is so with all that it is made of.
        let is_precise = |operand| self.precise.contains(operand);
        let is_function = matches!(def.kind, Kind::Op(Op::Fma));
        let is_guarded = self.language.guard == Guard::Precise
            && (def.is_rounded && !is_function || def.operands.iter().any(is_precise));
        let is_alias = matches!(def.kind, Kind::Merge) || is_sign_of_name(&text);
        let is_folded = self.uses[&value] == 1 && text.len() <= LONGEST;
        let is_part_of_sum = self.summands.contains(&value);
        if is_alias || is_folded && (!is_guarded || is_part_of_sum) {
            if is_guarded {
                self.precise.insert(value);
            }
            self.texts.insert(value, (text, binding));
            return;
        }
        let name = self.name(value);
        let (language, is_mask) = (self.language, is_mask(self.graph, value));
        self.line(&language.constant(&name, is_mask, is_guarded, &text));
        self.texts.insert(value, (name, Whole));
    }

    fn conditional(&mut self, If { mask, sides, merges }: &If) {
        for merge in merges {
            let name = self.name(merge.out);
            let language = self.language;
            self.line(&language.variable(&name, is_mask(self.graph, merge.out)));
            self.texts.insert(merge.out, (name, Whole));
        }
        let mask = self.text(*mask, Choice);
        self.line(&format!("if ({mask}) {{"));
        for (side, items) in sides.iter().enumerate() {
            let before = std::mem::take(&mut self.lines);
            self.indent += 1;
            self.block(items);
            let zero = self.language.number(0);
            for merge in merges {
                if let Some(value) = merge.sides[side] {
                    let (name, text) = (self.text(merge.out, Whole), self.text(value, Choice));
                    // Which they are at first.
                    if text != zero {
                        self.line(&format!("{name} = {text};"));
                    }
                }
            }
            self.indent -= 1;
            let lines = std::mem::replace(&mut self.lines, before);
            if side == 1 && !lines.is_empty() {
                self.line("} else {");
            }
            self.lines += &lines;
        }
        self.line("}");
    }

    /// The text of a value as an operand that binds at least so tightly.
    fn text(&mut self, value: Value, least: Binding) -> String {
        let (text, binding) = match self.graph.values[value].kind {
            Kind::Input(place) => (self.inputs[place].clone(), Whole),
            Kind::Number(bits) => {
                let text = self.language.number(bits);
                let binding = if text.starts_with('-') { Sign } else { Whole };
                (text, binding)
            }
            Kind::Truth(truth) => (truth.to_string(), Whole),
            _ => self.texts[&value].clone(),
        };
        // && within || gets parentheses, which some languages demand.
        if binding < least || binding == And && least == Or {
            format!("({text})")
        } else {
            text
        }
    }

    fn expression(&mut self, value: Value) -> (String, Binding) {
        let Def { kind, operands, is_rounded, .. } = self.graph.values[value].clone();
        let language = self.language;
        let mut text = |i: usize, least| self.text(operands[i], least);
        let infix = |symbol: &str, left: String, right: String| format!("{left} {symbol} {right}");
        let (text, binding) = match kind {
            Kind::Op(op) => match op {
                Op::Add => (infix("+", text(0, Sum), text(1, Product)), Sum),
                Op::Sub => (infix("-", text(0, Sum), text(1, Product)), Sum),
                Op::Mul => (infix("*", text(0, Product), text(1, Sign)), Product),
                Op::Div => (infix("/", text(0, Product), text(1, Sign)), Product),
                Op::Neg => (format!("-{}", text(0, Whole)), Sign),
                Op::Lt => (infix("<", text(0, Sum), text(1, Sum)), Comparison),
                Op::Le => (infix("<=", text(0, Sum), text(1, Sum)), Comparison),
                Op::And => (infix("&&", text(0, And), text(1, And)), And),
                Op::Or => (infix("||", text(0, Or), text(1, Or)), Or),
                Op::Not => (format!("!{}", text(0, Whole)), Sign),
                Op::Select if language.has_question_mark => {
                    let mask = text(0, Or);
                    (format!("{mask} ? {} : {}", text(1, Or), text(2, Choice)), Choice)
                }
                Op::Select => {
                    let [no, yes, mask] = [2, 1, 0].map(|i| text(i, Choice));
                    (format!("select({no}, {yes}, {mask})"), Whole)
                }
                Op::Fma | Op::Abs | Op::Sqrt | Op::PowerOfTwo | Op::Bits | Op::FloatOfBits => {
                    let name = language.function(kind);
                    let arguments: Vec<String> = (0..operands.len()).map(|i| text(i, Choice)).collect();
                    (format!("{name}({})", arguments.join(", ")), Whole)
                }
            },
            Kind::Min | Kind::Max | Kind::Lost => {
                let name = language.function(kind);
                let mut arguments: Vec<String> = (0..operands.len()).map(|i| text(i, Choice)).collect();
                if kind == Kind::Lost && language.guard == Guard::UnknownZero {
                    arguments.push("unknown_zero".to_owned());
                }
                (format!("{name}({})", arguments.join(", ")), Whole)
            }
            Kind::Merge => return self.alias(operands[0]),
            Kind::Input(_) | Kind::Number(_) | Kind::Truth(_) => unreachable!("these are no operations"),
        };
        if !is_rounded {
            return (text, binding);
        }
        match (language.guard, kind) {
            (Guard::Intrinsics, Kind::Op(op @ (Op::Add | Op::Sub | Op::Mul))) => {
                let name = match op {
                    Op::Add => "__fadd_rn",
                    Op::Sub => "__fsub_rn",
                    _ => "__fmul_rn",
                };
                let [a, b] = [0, 1].map(|i| self.text(operands[i], Choice));
                (format!("{name}({a}, {b})"), Whole)
            }
            (_, Kind::Op(Op::Fma)) => {
                let [a, b, c] = [0, 1, 2].map(|i| self.text(operands[i], Choice));
                let zero = if language.guard == Guard::UnknownZero { ", unknown_zero" } else { "" };
                (format!("{}({a}, {b}, {c}{zero})", language.fused), Whole)
            }
            (Guard::UnknownZero, _) => (format!("spherecap_keep({text}, unknown_zero)"), Whole),
            _ => (text, binding),
        }
    }

    fn alias(&mut self, value: Value) -> (String, Binding) {
        let least = Choice;
        let text = self.text(value, least);
        let binding = self.texts.get(&value).map_or(Sign, |(_, binding)| *binding);
        (text, binding)
    }
}

fn is_sign_of_name(text: &str) -> bool {
    text.strip_prefix(['-', '!'])
        .is_some_and(|name| name.chars().all(|c| c.is_alphanumeric() || "_.".contains(c)))
}

fn is_mask(graph: &Graph, value: Value) -> bool {
    let Def { kind, operands, .. } = &graph.values[value];
    match kind {
        Kind::Truth(_) => true,
        Kind::Op(op) => matches!(op, Op::Lt | Op::Le | Op::And | Op::Or | Op::Not),
        Kind::Merge => operands.first().is_some_and(|&value| is_mask(graph, value)),
        _ => false,
    }
}

fn count(graph: &Graph, items: &[Item], uses: &mut HashMap<Value, usize>) {
    let mut add = |value: Value| *uses.entry(value).or_default() += 1;
    for item in items {
        match item {
            Item::Op(value) => graph.values[*value].operands.iter().for_each(|&operand| add(operand)),
            Item::If(If { mask, merges, .. }) => {
                add(*mask);
                merges.iter().flat_map(|merge| merge.sides).flatten().for_each(&mut add);
            }
        }
    }
    for item in items {
        if let Item::If(If { sides, .. }) = item {
            sides.iter().for_each(|side| count(graph, side, uses));
        }
    }
}
