//! A graph as statements of a language.

use super::blocks::gives;
use super::graph::{Def, Graph, If, Item, Kind, Merge, Value};
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

/// A vector as some languages write it.
#[derive(Clone)]
enum Vector {
    Named(String),
    Parts([Value; 3]),
    Scaled(Box<Vector>, Value),
    Sum(Box<Vector>, Box<Vector>),
    Cross(Box<Vector>, Box<Vector>),
}

pub(super) struct Printer<'a> {
    language: &'a Language,
    graph: &'a Graph,
    /// Parameters, by their places.
    inputs: &'a [String],
    uses: HashMap<Value, usize>,
    /// What sums and differences read.
    summands: HashSet<Value>,
    /// What an || reads: an && there gets a variable, as compilers for GPUs jump over the right side of a nested one.
    alternatives: HashSet<Value>,
    /// Expressions that have to be part of a `precise` variable.
    precise: HashSet<Value>,
    texts: HashMap<Value, (String, Binding)>,
    /// Values that are printed as part of a vector.
    absorbed: HashSet<Value>,
    /// Vectors, by their first components; a variable's has its name.
    vectors: HashMap<Value, (Vector, Option<String>)>,
    /// Components of variables that are vectors.
    components: HashMap<Value, String>,
    /// Products of two vectors.
    dots: HashMap<Value, [Vector; 2]>,
    /// Variables that values are stored in where they are computed.
    places: HashMap<Value, String>,
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
        let read_by = |ops: &[Op]| {
            let is_one = |def: &&Def| ops.iter().any(|op| def.kind == Kind::Op(*op));
            graph.values.iter().filter(is_one).flat_map(|def| &def.operands).copied().collect()
        };
        let (summands, alternatives) = (read_by(&[Op::Add, Op::Sub]), read_by(&[Op::Or]));
        let (precise, places) = (HashSet::new(), HashMap::new());
        let (absorbed, vectors, components) = (HashSet::new(), HashMap::new(), HashMap::new());
        let dots = HashMap::new();
        let mut printer = Self {
            language,
            graph,
            inputs,
            summands,
            alternatives,
            precise,
            uses,
            texts,
            places,
            absorbed,
            vectors,
            components,
            dots,
            taken,
            count: 0,
            lines,
            indent: 1,
        };
        if language.has_vectors() {
            printer.find_variables(&graph.items);
            printer.find_dots();
        }
        printer
    }

    /// Finds components that follow each other, with the names of a vector's.
    fn find_variables(&mut self, items: &[Item]) {
        for window in items.windows(3) {
            let &[Item::Op(x), Item::Op(y), Item::Op(z)] = window else { continue };
            let name = |value| self.graph.names.get(&value).map_or("", String::as_str);
            let Some(stem) = name(x).strip_suffix("_x") else { continue };
            let is_vector =
                name(y).strip_suffix("_y") == Some(stem) && name(z).strip_suffix("_z") == Some(stem);
            let is_free = !self.taken.contains(stem);
            if let Some(vector) = self.scaled_parts([x, y, z]).filter(|_| is_vector && is_free) {
                let stem = stem.to_owned();
                for (value, end) in [(x, "x"), (y, "y"), (z, "z")] {
                    self.components.insert(value, format!("{stem}.{end}"));
                }
                self.vectors.insert(x, (vector, Some(stem)));
            }
        }
        for item in items {
            if let Item::If(If { sides, .. }) = item {
                sides.iter().for_each(|side| self.find_variables(side));
            }
        }
    }

    /// Finds sums of three products that are those of two vectors.
    fn find_dots(&mut self) {
        for value in 0..self.graph.values.len() {
            let (Some([x0, x1, rest]), true) = (self.parts(value, Op::Fma), self.uses.contains_key(&value))
            else {
                continue;
            };
            let Some([y0, y1, last]) = self.parts(rest, Op::Fma) else { continue };
            let Some([z0, z1, _]) = self.parts(last, Op::Mul) else { continue };
            let mut inner = vec![rest, last];
            let vectors = [[x0, y0, z0], [x1, y1, z1]].map(|parts| self.vector_of(parts, &mut inner));
            if let ([Some(a), Some(b)], true) = (vectors, inner.iter().all(|value| self.is_own(*value))) {
                self.dots.insert(value, [a, b]);
                self.absorbed.extend(inner);
            }
        }
    }

    /// The operands of an operation whose rounding does not count; the last one again where there are fewer than three.
    fn parts(&self, value: Value, op: Op) -> Option<[Value; 3]> {
        let Def { kind, operands, is_rounded, .. } = &self.graph.values[value];
        let last = *operands.last()?;
        (*kind == Kind::Op(op) && !is_rounded)
            .then(|| [0, 1, 2].map(|i| operands.get(i).copied().unwrap_or(last)))
    }

    fn is_own(&self, value: Value) -> bool {
        self.uses.get(&value) == Some(&1)
    }

    /// The vector that has these components, if they are of one shape; and the values that it has in it.
    fn vector_of(&self, components: [Value; 3], inner: &mut Vec<Value>) -> Option<Vector> {
        let all = |op| {
            let [x, y, z] = components.map(|value| self.parts(value, op));
            Some([x?, y?, z?])
        };
        let transposed = |all: [[Value; 3]; 3]| [0, 1, 2].map(|i| all.map(|parts| parts[i]));
        let is_number = |[x, y, z]: [Value; 3]| x == y && y == z;
        if let Some(stem) = self.stem(components) {
            return Some(Vector::Named(stem));
        }
        inner.extend(components);
        let scaled = |[a, b]: [[Value; 3]; 2], inner: &mut Vec<Value>| {
            let (vector, number) = if is_number(a) { (b, a) } else { (a, b) };
            let vector = self.vector_of(vector, inner).filter(|_| is_number(number))?;
            Some(Vector::Scaled(Box::new(vector), number[0]))
        };
        if let Some(products) = all(Op::Mul) {
            let [a, b, _] = transposed(products);
            return scaled([a, b], inner);
        }
        let [a, b, c] = transposed(all(Op::Fma)?);
        if let Some(cross) = self.cross_of([a, b, c], inner) {
            return Some(cross);
        }
        let product = scaled([a, b], inner)?;
        Some(Vector::Sum(Box::new(product), Box::new(self.vector_of(c, inner)?)))
    }

    /// `a x b` from `a_y b_z - a_z b_y` and so on: the factors first, and what is added.
    fn cross_of(&self, [a, b, rest]: [[Value; 3]; 3], inner: &mut Vec<Value>) -> Option<Vector> {
        let [x, y, z] = rest.map(|value| {
            let [product, ..] = self.parts(value, Op::Neg)?;
            self.parts(product, Op::Mul).map(|factors| (product, factors))
        });
        let products = [x?, y?, z?];
        let ([ay, az, ax], [bz, bx, by]) = (a, b);
        let is_cross = [[az, by], [ax, bz], [ay, bx]]
            .iter()
            .zip(&products)
            .all(|(expected, (_, factors))| expected[..] == factors[..2]);
        let (a, b) = (self.stem([ax, ay, az])?, self.stem([bx, by, bz])?);
        inner.extend(rest);
        inner.extend(products.map(|(product, _)| product));
        is_cross.then(|| Vector::Cross(Box::new(Vector::Named(a)), Box::new(Vector::Named(b))))
    }

    /// Any components that have a factor in common.
    fn scaled_parts(&self, components: [Value; 3]) -> Option<Vector> {
        let [x, y, z] = components.map(|value| self.parts(value, Op::Mul));
        let [x, y, z] = [x?, y?, z?];
        (x[1] == y[1] && y[1] == z[1])
            .then(|| Vector::Scaled(Box::new(Vector::Parts([x[0], y[0], z[0]])), x[1]))
    }

    /// The vector that these are the components of, by its name.
    fn stem(&self, components: [Value; 3]) -> Option<String> {
        let texts = components.map(|value| match self.graph.values[value].kind {
            Kind::Input(place) => self.inputs[place].as_str(),
            _ => self.components.get(&value).map_or("", String::as_str),
        });
        let stem = texts[0].strip_suffix(".x")?;
        (texts[1].strip_suffix(".y") == Some(stem) && texts[2].strip_suffix(".z") == Some(stem))
            .then(|| stem.to_owned())
    }

    /// Takes these for the components of a vector that `vector` will give.
    pub(super) fn absorb(&mut self, components: [Value; 3]) {
        if self.vectors.contains_key(&components[0]) {
            return;
        }
        let mut inner = Vec::new();
        let vector = self.vector_of(components, &mut inner).or_else(|| {
            inner = components.to_vec();
            self.scaled_parts(components)
        });
        if let Some(vector) = vector.filter(|_| self.language.has_vectors()) {
            if inner.iter().all(|&value| self.is_own(value)) {
                self.absorbed.extend(inner);
                self.vectors.insert(components[0], (vector, None));
            }
        }
    }

    /// The expression for a vector.
    pub(super) fn vector(&mut self, components: [Value; 3]) -> String {
        match self.vectors.get(&components[0]) {
            Some((_, Some(name))) => name.clone(),
            Some((vector, None)) => self.written(&vector.clone()),
            None => match self.stem(components).filter(|_| !self.language.is_c) {
                Some(stem) => stem,
                None => {
                    let components = components.map(|value| self.whole(value));
                    self.language.vector(components)
                }
            },
        }
    }

    fn written(&mut self, vector: &Vector) -> String {
        match vector {
            Vector::Named(name) => name.clone(),
            Vector::Parts(parts) => {
                let parts = parts.map(|value| self.whole(value));
                self.language.vector(parts)
            }
            Vector::Scaled(vector, number) => {
                let (text, number) = (self.written(vector), self.text(*number, Sign));
                match **vector {
                    Vector::Sum(..) => format!("({text}) * {number}"),
                    _ => format!("{text} * {number}"),
                }
            }
            Vector::Sum(a, b) => format!("{} + {}", self.written(a), self.written(b)),
            Vector::Cross(a, b) => format!("cross({}, {})", self.written(a), self.written(b)),
        }
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
        if self.absorbed.contains(&value) {
            return;
        }
        if let Some(component) = self.components.get(&value) {
            self.texts.insert(value, (component.clone(), Whole));
            if let Some((vector, Some(name))) = self.vectors.get(&value).cloned() {
                self.taken.insert(name.clone());
                let text = self.written(&vector);
                let line = self.language.vector_constant(&name, &text);
                self.line(&line);
            }
            return;
        }
        let (text, binding) = self.expression(value);
        let def = &self.graph.values[value];
        // What is `precise` is so with all that it is made of.
        let is_precise = |operand| self.precise.contains(operand);
        let is_function = matches!(def.kind, Kind::Op(Op::Fma));
        let is_guarded = self.language.guard == Guard::Precise
            && (def.is_rounded && !is_function || def.operands.iter().any(is_precise));
        let is_alias = matches!(def.kind, Kind::Merge) || is_sign_of_name(&text);
        let is_alternative = def.kind == Kind::Op(Op::And) && self.alternatives.contains(&value);
        let is_folded = self.uses[&value] == 1 && text.len() <= LONGEST && !is_alternative;
        let is_part_of_sum = self.summands.contains(&value);
        if is_alias || is_folded && (!is_guarded || is_part_of_sum) {
            if is_guarded {
                self.precise.insert(value);
            }
            self.texts.insert(value, (text, binding));
            return;
        }
        // What is stored in a `precise` variable would have to be so on both sides.
        let place = self.places.get(&value).filter(|_| !is_guarded).cloned();
        let name = place.clone().unwrap_or_else(|| self.name(value));
        let line = match place {
            Some(place) => format!("{place} = {text};"),
            None => self.language.constant(&name, is_mask(self.graph, value), is_guarded, &text),
        };
        self.line(&line);
        self.texts.insert(value, (name, Whole));
    }

    fn conditional(&mut self, If { mask, sides, merges }: &If) {
        let mut variables = Vec::new();
        let mut stores_zero = HashSet::new();
        // Those with names first, so that what they give is computed under its name.
        let mut merges: Vec<&Merge> = merges.iter().collect();
        merges.sort_by_key(|merge| !self.graph.names.contains_key(&merge.out));
        let first =
            |merge: &Merge| merges.iter().find(|other| other.sides == merge.sides).expect("itself").out;
        let (merges, twins): (Vec<&Merge>, Vec<&Merge>) =
            merges.iter().copied().partition(|merge| first(merge) == merge.out);
        for &merge in &merges {
            let name = match self.places.get(&merge.out) {
                Some(place) => place.clone(),
                None => {
                    let name = self.name(merge.out);
                    let is_zero = |side: &Option<Value>| side.is_none_or(|value| is_zero(self.graph, value));
                    let starts_at_zero = merge.sides.iter().any(is_zero);
                    if starts_at_zero {
                        stores_zero.insert(merge.out);
                    }
                    variables.push((name.clone(), is_mask(self.graph, merge.out), starts_at_zero));
                    name
                }
            };
            self.texts.insert(merge.out, (name, Whole));
        }
        for twin in twins {
            let first = merges.iter().find(|merge| merge.sides == twin.sides).expect("it has a twin");
            self.texts.insert(twin.out, self.texts[&first.out].clone());
        }
        for line in self.language.variables(&variables) {
            self.line(&line);
        }
        let mask = self.text(*mask, Choice);
        self.line(&format!("if ({mask}) {{"));
        for (side, items) in sides.iter().enumerate() {
            let before = std::mem::take(&mut self.lines);
            self.indent += 1;
            let made: HashSet<Value> = items.iter().flat_map(gives).collect();
            for &merge in &merges {
                if let Some(value) = merge.sides[side].filter(|value| made.contains(value)) {
                    let place = self.texts[&merge.out].0.clone();
                    self.places.entry(value).or_insert(place);
                }
            }
            self.block(items);
            for &merge in &merges {
                let Some(value) = merge.sides[side] else { continue };
                let (name, text) = (self.text(merge.out, Whole), self.text(value, Choice));
                let is_stored =
                    name == text || is_zero(self.graph, value) && stores_zero.contains(&merge.out);
                if !is_stored {
                    self.line(&format!("{name} = {text};"));
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
        if let Some([a, b]) = self.dots.get(&value).cloned() {
            return (format!("dot({}, {})", self.written(&a), self.written(&b)), Whole);
        }
        let adds_zero = operands.get(2).is_some_and(|&value| is_zero(self.graph, value));
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
                Op::And | Op::Or => {
                    let (symbol, binding) = if op == Op::And { ("&&", And) } else { ("||", Or) };
                    let mut sides = [text(0, binding), text(1, binding)];
                    // Where a variable is on the right, compilers for GPUs do not jump over it.
                    let is_short = |side: &str| is_name(side.trim_start_matches('!'));
                    if is_short(&sides[0]) && !is_short(&sides[1]) {
                        sides.reverse();
                    }
                    (sides.join(&format!(" {symbol} ")), binding)
                }
                Op::Not => (format!("!{}", text(0, Whole)), Sign),
                Op::Select if language.has_question_mark => {
                    let mask = text(0, Or);
                    (format!("{mask} ? {} : {}", text(1, Or), text(2, Choice)), Choice)
                }
                Op::Select => {
                    let [no, yes, mask] = [2, 1, 0].map(|i| text(i, Choice));
                    (format!("select({no}, {yes}, {mask})"), Whole)
                }
                // But for the sign of a zero.
                Op::Fma if adds_zero && !language.is_c_like() => {
                    (infix("*", text(0, Product), text(1, Sign)), Product)
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
                if kind != Kind::Lost && !language.is_c_like() {
                    // Theirs give the first one where neither is less.
                    arguments.reverse();
                }
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

fn is_name(text: &str) -> bool {
    text.chars().all(|c| c.is_alphanumeric() || "_.".contains(c))
}

fn is_sign_of_name(text: &str) -> bool {
    text.strip_prefix(['-', '!']).is_some_and(is_name)
}

fn is_zero(graph: &Graph, value: Value) -> bool {
    graph.values[value].kind == Kind::Number(0)
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
