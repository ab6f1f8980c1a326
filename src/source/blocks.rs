//! Makes blocks as a person would write them: nothing that is not needed, one conditional for both sides of a question, and in each
//! side what that side alone needs.

use super::graph::{Def, Graph, If, Item, Kind, Merge, Value};
use crate::lane::recorded::Op;
use std::collections::{HashMap, HashSet};

/// Sides of at most so many cheap operations are computed everywhere: a choice of two numbers reads better than a conditional, and
/// costs no jump.
const FEW: usize = 4;

impl Graph {
    /// Takes values for parameters from here on: `value` for the one at `place`.
    pub(super) fn cut(&mut self, parameters: &HashMap<Value, usize>) {
        fn cut(items: &mut Vec<Item>, parameters: &HashMap<Value, usize>) {
            items.retain(|item| !matches!(item, Item::Op(value) if parameters.contains_key(value)));
            for item in items {
                if let Item::If(conditional) = item {
                    conditional.merges.retain(|merge| !parameters.contains_key(&merge.out));
                    conditional.sides.iter_mut().for_each(|side| cut(side, parameters));
                }
            }
        }
        cut(&mut self.items, parameters);
        for (&value, &place) in parameters {
            self.values[value].kind = Kind::Input(place);
            self.values[value].operands.clear();
        }
    }

    /// Keeps what these values need, and puts it in order.
    pub(super) fn tidy(&mut self, outputs: &[Value]) {
        let mut items = std::mem::take(&mut self.items);
        let mut needed: HashSet<Value> = outputs.iter().copied().collect();
        self.prune(&mut items, &mut needed);
        self.arrange(&mut items, outputs);
        // What became an alias or a choice may need less.
        let mut needed: HashSet<Value> = outputs.iter().copied().collect();
        self.prune(&mut items, &mut needed);
        self.items = items;
    }

    /// Drops what nothing needs, backwards.
    fn prune(&self, items: &mut Vec<Item>, needed: &mut HashSet<Value>) {
        let mut kept = Vec::new();
        for item in std::mem::take(items).into_iter().rev() {
            match item {
                Item::Op(value) => {
                    if needed.contains(&value) {
                        needed.extend(&self.values[value].operands);
                        kept.push(Item::Op(value));
                    }
                }
                Item::If(mut conditional) => {
                    conditional.merges.retain(|merge| needed.contains(&merge.out));
                    if conditional.merges.is_empty() {
                        continue;
                    }
                    needed.extend(conditional.merges.iter().flat_map(|merge| merge.sides).flatten());
                    for side in &mut conditional.sides {
                        self.prune(side, needed);
                    }
                    needed.insert(conditional.mask);
                    kept.push(Item::If(conditional));
                }
            }
        }
        kept.reverse();
        *items = kept;
    }

    /// Calls a function with all that items read.
    pub(super) fn each_read(&self, items: &[Item], add: &mut impl FnMut(Value)) {
        items.iter().for_each(|item| self.reads(item, add));
    }

    /// What an item reads, also within it.
    fn reads(&self, item: &Item, add: &mut impl FnMut(Value)) {
        match item {
            Item::Op(value) => self.values[*value].operands.iter().for_each(|&operand| add(operand)),
            Item::If(If { mask, sides, merges }) => {
                add(*mask);
                for side in 0..2 {
                    self.side_reads(sides, merges, side, add);
                }
            }
        }
    }

    fn side_reads(&self, sides: &[Vec<Item>; 2], merges: &[Merge], side: usize, add: &mut impl FnMut(Value)) {
        sides[side].iter().for_each(|item| self.reads(item, add));
        merges.iter().filter_map(|merge| merge.sides[side]).for_each(add);
    }

    /// Which items of a block each one depends on, itself included.
    fn dependences(&self, items: &[Item]) -> Vec<HashSet<usize>> {
        let makers: HashMap<Value, usize> = items
            .iter()
            .enumerate()
            .flat_map(|(i, item)| gives(item).into_iter().map(move |v| (v, i)))
            .collect();
        let direct: Vec<HashSet<usize>> = (0..items.len())
            .map(|i| {
                let mut found = HashSet::new();
                self.reads(&items[i], &mut |value| {
                    found.extend(makers.get(&value).filter(|&&maker| maker != i));
                });
                found
            })
            .collect();
        (0..items.len())
            .map(|i| {
                let (mut seen, mut open) = (HashSet::from([i]), vec![i]);
                while let Some(next) = open.pop() {
                    open.extend(direct[next].iter().filter(|&&other| seen.insert(other)));
                }
                seen
            })
            .collect()
    }

    /// Puts a block in order; `outputs` are read after it.
    fn arrange(&mut self, items: &mut Vec<Item>, outputs: &[Value]) {
        while self.join(items) || self.choose(items) {}
        self.sort(items);
        while self.sink(items, outputs) {}
        for item in items.iter_mut() {
            if let Item::If(If { sides, merges, .. }) = item {
                for (side, items) in sides.iter_mut().enumerate() {
                    let read: Vec<Value> = merges.iter().filter_map(|merge| merge.sides[side]).collect();
                    self.arrange(items, &read);
                }
            }
        }
        self.flatten(items);
    }

    /// Joins two conditionals on one mask, of which neither needs the other.
    fn join(&self, items: &mut Vec<Item>) -> bool {
        let depends = self.dependences(items);
        for first in 0..items.len() {
            let Item::If(If { mask, .. }) = items[first] else { continue };
            let is_partner = |&second: &usize| {
                matches!(items[second], Item::If(If { mask: other, .. }) if mask == other)
                    && !depends[second].contains(&first)
                    && !depends[first].contains(&second)
            };
            if let Some(second) = (first + 1..items.len()).find(is_partner) {
                let Item::If(If { sides, merges, .. }) = items.remove(second) else { unreachable!() };
                let Item::If(joined) = &mut items[first] else { unreachable!() };
                let [yes, no] = sides;
                joined.sides[0].extend(yes);
                joined.sides[1].extend(no);
                joined.merges.extend(merges);
                self.sort(items);
                return true;
            }
        }
        false
    }

    /// Makes a choice between results of a conditional one of its results.
    fn choose(&self, items: &mut Vec<Item>) -> bool {
        let depends = self.dependences(items);
        let makers: HashMap<Value, usize> = items
            .iter()
            .enumerate()
            .flat_map(|(i, item)| gives(item).into_iter().map(move |v| (v, i)))
            .collect();
        for place in 0..items.len() {
            let Item::If(conditional) = &items[place] else { continue };
            let inner = |value: Value, side: usize| -> Option<Option<Value>> {
                if let Some(merge) = conditional.merges.iter().find(|merge| merge.out == value) {
                    return Some(merge.sides[side]);
                }
                let is_apart = makers.get(&value).is_none_or(|&maker| !depends[maker].contains(&place));
                is_apart.then_some(Some(value))
            };
            let chosen = items.iter().enumerate().find_map(|(i, item)| {
                let Item::Op(out) = *item else { return None };
                let Def { kind, operands, .. } = &self.values[out];
                let is_choice = *kind == Kind::Op(Op::Select) && operands[0] == conditional.mask;
                // What the sides read is no result of theirs.
                if !is_choice || depends[place].contains(&i) {
                    return None;
                }
                let sides = [inner(operands[1], 0)?, inner(operands[2], 1)?];
                Some((i, Merge { out, sides }))
            });
            if let Some((i, merge)) = chosen {
                let Item::If(conditional) = &mut items[place] else { unreachable!() };
                conditional.merges.push(merge);
                items.remove(i);
                self.sort(items);
                return true;
            }
        }
        false
    }

    /// What is needed first comes first; otherwise the order stays.
    fn sort(&self, items: &mut Vec<Item>) {
        let mut waiting: HashSet<Value> = items.iter().flat_map(gives).collect();
        let mut rest: Vec<Item> = std::mem::take(items);
        while !rest.is_empty() {
            let is_ready = |item: &Item| {
                let own = gives(item);
                let mut ready = true;
                self.reads(item, &mut |value| ready &= !waiting.contains(&value) || own.contains(&value));
                ready
            };
            let next = rest.iter().position(is_ready).expect("nothing needs itself");
            let item = rest.remove(next);
            gives(&item).iter().for_each(|value| {
                waiting.remove(value);
            });
            items.push(item);
        }
    }

    /// Moves an item that one side of one conditional alone needs into it.
    fn sink(&self, items: &mut Vec<Item>, outputs: &[Value]) -> bool {
        for place in (0..items.len()).rev() {
            let given = gives(&items[place]);
            if given.iter().any(|value| outputs.contains(value)) {
                continue;
            }
            // Who reads it: the item, and the side if it is one's.
            let mut readers: HashSet<(usize, Option<usize>)> = HashSet::new();
            for (i, item) in items.iter().enumerate().skip(place + 1) {
                let mut note = |value: Value, side: Option<usize>| {
                    if given.contains(&value) {
                        readers.insert((i, side));
                    }
                };
                match item {
                    Item::If(If { mask, sides, merges }) => {
                        note(*mask, None);
                        for side in 0..2 {
                            self.side_reads(sides, merges, side, &mut |value| note(value, Some(side)));
                        }
                    }
                    Item::Op(_) => self.reads(item, &mut |value| note(value, None)),
                }
            }
            let mut readers = readers.into_iter();
            if let (Some((reader, Some(side))), None) = (readers.next(), readers.next()) {
                let item = items.remove(place);
                let Item::If(conditional) = &mut items[reader - 1] else { unreachable!() };
                conditional.sides[side].insert(0, item);
                return true;
            }
        }
        false
    }

    /// Makes choices of conditionals with small sides.
    fn flatten(&mut self, items: &mut Vec<Item>) {
        let mut flat = Vec::new();
        for item in std::mem::take(items) {
            match item {
                Item::If(If { mask, sides, merges }) if self.cost(&sides, &merges) <= FEW => {
                    let [yes, no] = sides;
                    flat.extend(yes);
                    flat.extend(no);
                    for Merge { out, sides } in merges {
                        let def = &mut self.values[out];
                        (def.kind, def.operands) = match sides {
                            [Some(yes), Some(no)] if yes != no => (Kind::Op(Op::Select), vec![mask, yes, no]),
                            // The only value that it can have.
                            [Some(value), _] | [None, Some(value)] => (Kind::Merge, vec![value]),
                            [None, None] => unreachable!("a result has a value on some side"),
                        };
                        flat.push(Item::Op(out));
                    }
                }
                item => flat.push(item),
            }
        }
        *items = flat;
    }

    fn cost(&self, sides: &[Vec<Item>; 2], merges: &[Merge]) -> usize {
        let of_item = |item: &Item| match item {
            Item::If(_) => FEW + 1,
            Item::Op(value) => match self.values[*value].kind {
                Kind::Op(Op::Div | Op::Sqrt) => 3,
                Kind::Op(Op::Neg | Op::Abs) => 0,
                _ => 1,
            },
        };
        merges.len() / 2 + sides.iter().flatten().map(of_item).sum::<usize>()
    }
}

/// What an item gives to others.
pub(super) fn gives(item: &Item) -> Vec<Value> {
    match item {
        Item::Op(value) => vec![*value],
        Item::If(conditional) => conditional.merges.iter().map(|merge| merge.out).collect(),
    }
}
