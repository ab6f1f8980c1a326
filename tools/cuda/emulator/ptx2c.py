"""Translates a kernel with all functions of its module from PTX, as Dr.Jit writes it, to C.

    ptx2c.py MODULE.ptx ENTRY OUT.c

OUT.c includes ptx.h, which says how numbers are computed, and has one function for stub.c to call, `launch`.
A register is an integer of 64 bits that is read and written as the type that an instruction names.
"""

import os
import re
import sys
from collections import Counter
from pathlib import Path

#: A grid and blocks have one dimension here, and a thread runs after the other.
SPECIAL = {"%tid.x": "thread", "%ntid.x": "threads", "%ctaid.x": "block", "%nctaid.x": "blocks"}

TYPE = r"[busf](8|16|32|64)|pred"

#: Modifiers that are treated apart, or change nothing here. Any other changes what an instruction computes.
IGNORED = ["ftz", "rn", "rzi", "lo", "wide", "to", "global"]

COMPARISONS = {"eq": "==", "ne": "!=", "lt": "<", "lo": "<", "le": "<=", "gt": ">", "ge": ">="}

#: What instructions compute, in C, of operands {0}, {1}, {2} of their type. `div` and its kin are of ptx.h.
VALUES = {
    **dict.fromkeys(["mov", "cvta", "cvt"], "{0}"),
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "mad": "{0} * {1} + {2}",
    "and": "{0} & {1}",
    "or": "{0} | {1}",
    "xor": "{0} ^ {1}",
    "shl": "{0} << {1}",
    "shr": "{0} >> {1}",
    "neg": "-{0}",
    "not": "~{0}",
    "not.pred": "!{0}",
    "div.u32": "{0} / {1}",
    "min": "{0} < {1} ? {0} : {1}",
    "max": "{0} > {1} ? {0} : {1}",
    "min.f32": "min_f32({0}, {1})",
    "max.f32": "max_f32({0}, {1})",
    "min.NaN.f32": "isunordered({0}, {1}) ? NAN : min_f32({0}, {1})",
    "max.NaN.f32": "isunordered({0}, {1}) ? NAN : max_f32({0}, {1})",
    "fma.f32": "fmaf({0}, {1}, {2})",
    "abs.f32": "fabsf({0})",
    "copysign.f32": "copysignf({1}, {0})",
    **{f"{op}.approx.f32": f"{op}_approx({{0}})" for op in ("rcp", "sqrt", "rsqrt")},
    "div.approx.f32": "div_approx({0}, {1})",
}

LAUNCH = """
void launch(void **parameters, u32 grid, u32 size) {
    blocks = grid, threads = size;
    for (block = 0; block < blocks; ++block)
        for (thread = 0; thread < threads; ++thread)
            %s;
}"""


def identifier(name):
    """A name of PTX as one of C."""
    return re.sub(r"[%$.]", "_", name)


def split(text):
    """What is between commas that are not in brackets."""
    return [x.strip() for x in re.split(r",(?![^({\[]*[)}\]])", text) if x.strip()]


def fused(statements):
    """Fuse products into sums as ptxas does: those that are used by nothing but sums. Or all, if asked to."""
    fuses_all = os.environ.get("STUB_FUSE") == "all"
    product, writes, uses, sums = {}, Counter(), Counter(), Counter()
    for s in statements:
        found = re.findall(r"%[a-z]+\d+", re.sub(r"^@\S+", "", s))
        if found and not s.startswith("st."):
            writes[found.pop(0)] += 1
        uses.update(found)
        if m := re.fullmatch(r"(mul|add|sub)\.ftz\.f32 (\S+), (\S+), (\S+)", s):
            if m[1] == "mul":
                product[m[2]] = m[3], m[4]
            else:
                sums.update(set(found))
        elif (m := re.fullmatch(r"neg\.ftz\.f32 (\S+), (\S+)", s)) and m[2] in product and fuses_all:
            x, y = product[m[2]]
            product[m[1]] = f"-{x}".replace("--", ""), y
    # Registers that are written once mean the same everywhere.
    ready = {
        p
        for p, xy in product.items()
        if (fuses_all or uses[p] == sums[p]) and all(writes[r.lstrip("-")] == 1 for r in (p, *xy))
    }
    for s in statements:
        m = re.fullmatch(r"(add|sub)\.ftz\.f32 (\S+), (\S+), (\S+)", s)
        minus = "-" if m and m[1] == "sub" else ""
        if m and m[4] in ready:
            x, y = product[m[4]]
            yield f"fma.rn.ftz.f32 {m[2]}, {minus}{x}, {y}, {m[3]}".replace("--", "")
        elif m and m[3] in ready:
            x, y = product[m[3]]
            yield f"fma.rn.ftz.f32 {m[2]}, {x}, {y}, {minus}{m[4]}"
        else:
            yield s


class Function:
    """A function or an entry. Memory is passed to it by its address; so are the parameters of an entry."""

    def __init__(self, head, body):
        """Translate what is before its opening brace, and what follows."""
        results, self.name, parameters = re.search(
            r"(?:\(([^()]*)\)\s*)?([\w$]+)\s*\(([^()]*)\)\s*$", head
        ).groups()
        self.parameters = [
            f"u64 {words[-1]}" if words[0] == ".reg" else f"u8 *{words[-1].partition('[')[0]}"
            for words in (x.split() for x in split(f"{results or ''},{parameters}"))
        ]
        self.registers = set()
        # Labels, braces of scopes, and what ends with a semicolon, with braces of vectors.
        tokens = r"\s*([\w$]+:(?!\s*\.)|[{}]|(?:[^;{}]|\{\s*%[^{}]*\})+;)"
        statements = [" ".join(s.rstrip(";").split()) for s in re.findall(tokens, body)]
        self.lines = [self.statement(s) for s in fused(statements)]

    def signature(self):
        """Its declaration, without the semicolon."""
        return f"static void {identifier(self.name)}({', '.join(self.parameters)})"

    def definition(self):
        """All of it."""
        registers = [f"u64 {register} = 0;" for register in sorted(self.registers)]
        return "\n".join([self.signature() + " {", *registers, *self.lines, "}"])

    def statement(self, s):
        """A statement in C."""
        if s in "{}":
            return s
        if s.endswith(":"):
            return f"{identifier(s)};"
        if s.startswith(".param"):
            return f"u8 {s.split()[-1]} __attribute__((aligned(16)));"
        if s.startswith((".reg", ".pragma")) or ".callprototype" in s:
            return ""
        guard, _, unguarded = s.partition(" ") if s.startswith("@") else ("", "", s)
        name, _, operands = unguarded.partition(" ")
        op, *modifiers = name.split(".")
        try:
            code = self.instruction(op, modifiers, split(operands))
        except (KeyError, IndexError, ValueError):
            raise NotImplementedError(f"ptx2c.py does not know this instruction: {s}") from None
        if guard:
            inverted = "!" if guard[1] == "!" else ""
            return f"if ({inverted}{self.read(guard.lstrip('@!'), 'pred')}) {{ {code} }}"
        return code

    def instruction(self, op, modifiers, operands):
        """A statement for an instruction."""
        if op == "ret":
            return "return;"
        if op == "bra":
            return f"goto {identifier(operands[0])};"
        if op == "call":
            return self.call(*operands)
        types = [x for x in modifiers if re.fullmatch(TYPE, x)]
        if op in ("ld", "ldu"):
            return " ".join(self.write(x, types[0], place) for x, place in self.memory(*operands, types[0]))
        if op == "st":
            stores = self.memory(operands[1], operands[0], types[0])
            return " ".join(f"{place} = {self.read(x, types[0])};" for x, place in stores)
        # A conversion names the result's type first.
        type_, result = types[-1], types[0]
        value = self.value(op, modifiers, type_, operands[1:])
        if op == "setp":
            result = "pred"
        elif "wide" in modifiers:
            result = type_[0] + str(2 * int(type_[1:]))
        elif op == "cvt" and type_ == "f32":
            value = f"{result}_rzi({value})"
        return self.write(
            operands[0], result, f"ftz({value})" if "ftz" in modifiers and result == "f32" else value
        )

    def value(self, op, modifiers, type_, operands):
        """What an instruction computes, before it is flushed."""
        if op == "selp":
            chosen, other = (self.read(x, type_) for x in operands[:2])
            return f"{self.read(operands[2], 'pred')} ? {chosen} : {other}"
        wide = f"({type_[0]}{2 * int(type_[1:])}) " if "wide" in modifiers else ""
        x = [wide + self.read(operand, type_) for operand in operands]
        if "ftz" in modifiers:
            x = [f"ftz({operand})" for operand in x]
        untyped = [m for m in modifiers if not re.fullmatch(TYPE, m)]
        if op == "setp":
            comparison = ".".join(m for m in untyped if m != "ftz")
            if comparison == "nan":
                return f"isunordered({x[0]}, {x[1]})"
            value = f"{x[0]} {COMPARISONS[comparison]} {x[1]}"
            # Nothing is so of NaN, not even `ne`.
            return f"({value}) && !isunordered({x[0]}, {x[1]})" if type_ == "f32" else value
        if op == "mad" and wide:
            x[2] = self.read(operands[2], wide[1:-2])
        name = ".".join([op, *(m for m in untyped if m not in IGNORED)])
        typed = f"{name}.{type_}"
        return VALUES[typed if typed in VALUES else name].format(*x)

    def call(self, results, function, arguments, *_prototype):
        """A call of the function that has this name, or that a register points to."""
        given = [self.read(x, "u64") for x in split(results.strip("()")) + split(arguments.strip("()"))]
        return f"((void (*)()) {self.read(function, 'u64')})({', '.join(given)});"

    def read(self, x, type_):
        """An operand as an expression of a type."""
        if x.startswith("{"):
            low, high = (self.read(half, "u32") for half in split(x.strip("{}")))
            return f"(({type_}) ((u64) {high} << 32 | {low}))"
        if x.startswith("-%"):
            return f"-{self.read(x[1:], type_)}"
        if x.startswith("%") and x not in SPECIAL:
            self.registers.add(identifier(x))
        x = SPECIAL.get(x, identifier(x))
        return f"f32_of({x})" if type_ == "f32" else f"(({type_}) {x})"

    def write(self, x, type_, value):
        """A statement that gives a register a value. Its upper bits are zero."""
        self.registers.add(identifier(x))
        bits = f"bits_of({value})" if type_ == "f32" else f"({type_.replace('s', 'u')}) ({value})"
        return f"{identifier(x)} = {bits};"

    def memory(self, registers, address, type_):
        """Pairs of a register and its place in memory, for one or for a vector."""
        array, base, offset = re.fullmatch(r"(\w*)\[([\w%$]+)(?:\+(\d+))?\]", address).groups()
        start = self.read(base, "u64")
        if array:  # of pointers, which are addressed by an index
            start = f"(u64) {array} + 8 * {start}"
        for i, register in enumerate(split(registers.strip("{}"))):
            yield register, f"*({type_} *) ({start} + {int(offset or 0) + i * int(type_[1:]) // 8})"


def functions(text):
    """Heads and bodies of the functions and entries of a module."""
    for m in re.finditer(r"\.(?:entry|func)\b([^{;]*)\{", text):
        depth, end = 1, m.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        yield m[0].startswith(".entry"), m[1], text[m.end() : end - 1]


def main(module, entry, out):
    """Translate an entry of a module."""
    text = re.sub(r"//[^\n]*", "", Path(module).read_text())
    table = re.search(r"callables\[\d+\] = \{([^}]*)\}", text)
    translated = [
        Function(head, body)
        for is_entry, head, body in functions(text)
        if not is_entry or re.search(rf"\b{re.escape(entry)}\s*\(", head)
    ]
    parts = ['#include "ptx.h"', *(f"{function.signature()};" for function in translated)]
    if table:
        parts.append(f"static void *callables[] = {{{table[1]}}};")
    parts += [function.definition() for function in translated]
    (kernel,) = (function for function in translated if function.name == entry)
    arguments = ", ".join(f"parameters[{i}]" for i in range(len(kernel.parameters)))
    parts.append(LAUNCH % f"{identifier(entry)}({arguments})")
    Path(out).write_text("\n".join(parts) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
