//! What the languages differ in.

use super::graph::Kind;
use crate::lane::recorded::Op;

/// How a language is told that a rounding counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Guard {
    /// It does as it is told.
    None,
    /// Variables that are `precise`.
    Precise,
    /// CUDA's functions for single operations.
    Intrinsics,
    /// Bits that the compiler cannot know to be zero are put into the number.
    UnknownZero,
}

/// A type of a parameter, a field or a result.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    Number,
    Truth,
    Vector,
    /// A struct, by the end of its name.
    Struct(&'static str),
}

pub(super) struct Language {
    pub file: &'static str,
    /// What is before everything, and what after.
    pub head: &'static str,
    pub tail: &'static str,
    /// What names of functions and types begin with.
    pub prefix: &'static str,
    /// What a function's definition begins with.
    pub function: &'static str,
    pub guard: Guard,
    pub has_question_mark: bool,
    /// Whether the name of a struct makes one of its fields' values.
    pub has_constructors: bool,
    /// Whether constants may be computed when the program runs: in GLSL not before 4.20.
    pub has_late_constants: bool,
    pub suffix: &'static str,
    pub vector: &'static str,
    pub fma: &'static str,
    /// The same, rounded once in every implementation.
    pub fused: &'static str,
    pub sqrt: &'static str,
    pub abs: &'static str,
    pub is_wgsl: bool,
    pub is_c: bool,
}

impl Language {
    pub(super) fn number(&self, bits: u32) -> String {
        let value = f32::from_bits(bits);
        assert!(value.is_finite(), "constants are finite");
        format!("{value:?}{}", self.suffix)
    }

    /// C, C++ and CUDA, whose `min` and `max` give a number where the other is none.
    pub(super) fn is_c_like(&self) -> bool {
        self.is_c || self.guard == Guard::Intrinsics
    }

    /// Whether vectors can be multiplied and added.
    pub(super) fn has_vectors(&self) -> bool {
        !self.is_c_like()
    }

    pub(super) fn function(&self, kind: Kind) -> String {
        let own = |name| format!("{}{name}", self.prefix);
        match kind {
            Kind::Op(Op::Fma) => self.fma.to_owned(),
            Kind::Op(Op::Sqrt) => self.sqrt.to_owned(),
            Kind::Op(Op::Abs) => self.abs.to_owned(),
            Kind::Op(Op::PowerOfTwo) => own("power_of_two"),
            Kind::Op(Op::Bits) => own("bits"),
            Kind::Op(Op::FloatOfBits) => own("float_of_bits"),
            Kind::Min if self.is_c_like() => own("min"),
            Kind::Max if self.is_c_like() => own("max"),
            Kind::Min => "min".to_owned(),
            Kind::Max => "max".to_owned(),
            Kind::Lost => own("lost"),
            _ => unreachable!("this is no function"),
        }
    }

    fn plain(&self, of: Type) -> String {
        match of {
            Type::Number if self.is_wgsl => "f32".to_owned(),
            Type::Number => "float".to_owned(),
            Type::Truth => "bool".to_owned(),
            Type::Vector if self.is_c => "float".to_owned(),
            Type::Vector => self.vector.trim_start_matches("make_").to_owned(),
            Type::Struct(name) => format!("{}{name}", self.prefix),
        }
    }

    /// A variable that keeps its value.
    pub(super) fn constant(&self, name: &str, is_mask: bool, is_precise: bool, value: &str) -> String {
        let of = self.plain(if is_mask { Type::Truth } else { Type::Number });
        if self.is_wgsl {
            format!("let {name} = {value};")
        } else if is_precise {
            format!("precise {of} {name} = {value};")
        } else if self.has_late_constants {
            format!("const {of} {name} = {value};")
        } else {
            format!("{of} {name} = {value};")
        }
    }

    /// One that is a vector.
    pub(super) fn vector_constant(&self, name: &str, value: &str) -> String {
        if self.is_wgsl {
            format!("let {name} = {value};")
        } else {
            format!("{} {name} = {value};", self.plain(Type::Vector))
        }
    }

    /// Those that do not: each with its name, whether it is true or false, and whether it starts at zero.
    pub(super) fn variables(&self, variables: &[(String, bool, bool)]) -> Vec<String> {
        let mut lines = Vec::new();
        for (is_mask, starts_at_zero) in [(false, false), (false, true), (true, false), (true, true)] {
            let of = self.plain(if is_mask { Type::Truth } else { Type::Number });
            let zero = if is_mask { "false".to_owned() } else { self.number(0) };
            let alike =
                variables.iter().filter(|(_, mask, zero)| [*mask, *zero] == [is_mask, starts_at_zero]);
            let names = alike.map(|(name, ..)| match (starts_at_zero, self.is_wgsl) {
                (true, _) => format!("{name} = {zero}"),
                (false, true) => format!("{name}: {of}"),
                (false, false) => name.clone(),
            });
            if self.is_wgsl {
                lines.extend(names.map(|name| format!("var {name};")));
            } else {
                lines.extend(filled(names, 90).into_iter().map(|names| format!("{of} {names};")));
            }
        }
        lines
    }

    /// Statements that return a struct with these values.
    pub(super) fn returned(&self, of: &'static str, values: Vec<String>) -> Vec<String> {
        let of = self.plain(Type::Struct(of));
        let values = filled(values.into_iter(), 100).join(",\n        ");
        if self.has_constructors {
            vec![format!("return {of}("), format!("    {values}"), ");".to_owned()]
        } else {
            let constant = if self.has_late_constants { "const " } else { "" };
            let first = format!("{constant}{of} result = {{");
            vec![first, format!("    {values}"), "};".to_owned(), "return result;".to_owned()]
        }
    }

    /// A vector.
    pub(super) fn vector(&self, [x, y, z]: [String; 3]) -> String {
        if self.is_c {
            format!("{{{x}, {y}, {z}}}")
        } else {
            format!("{}({x}, {y}, {z})", self.vector)
        }
    }

    /// The first line of a function.
    pub(super) fn signature(&self, name: &str, parameters: &[(&str, Type)], result: Type) -> String {
        let parameter = |(name, of): &(&str, Type)| {
            let plain = self.plain(*of);
            match of {
                _ if self.is_wgsl => format!("{name}: {plain}"),
                Type::Vector if self.is_c => format!("const float {name}[3]"),
                Type::Struct(_) if self.is_c => format!("const {plain} *{name}"),
                _ => format!("{plain} {name}"),
            }
        };
        let parameters: Vec<String> = parameters.iter().map(parameter).collect();
        let (parameters, prefix, result) = (parameters.join(", "), self.prefix, self.plain(result));
        if self.is_wgsl {
            format!("fn {prefix}{name}({parameters}) -> {result} {{")
        } else {
            format!("{}{result} {prefix}{name}({parameters})", self.function)
                + if self.is_c { "\n{" } else { " {" }
        }
    }

    /// The definition of a struct.
    pub(super) fn structure(&self, name: &str, fields: &[(String, Type)]) -> String {
        let name = format!("{}{name}", self.prefix);
        let field = |(field, of): &(String, Type)| {
            let plain = self.plain(*of);
            match of {
                _ if self.is_wgsl => format!("    {field}: {plain},\n"),
                Type::Vector if self.is_c => format!("    float {field}[3];\n"),
                _ => format!("    {plain} {field};\n"),
            }
        };
        let fields: String = fields.iter().map(field).collect();
        if self.is_c {
            format!("typedef struct {name} {{\n{fields}}} {name};\n")
        } else if self.is_wgsl {
            format!("struct {name} {{\n{fields}}}\n")
        } else {
            format!("struct {name} {{\n{fields}}};\n")
        }
    }

    /// How a function reads a component of a vector, and a field of a struct.
    pub(super) fn component(&self, vector: &str, i: usize) -> String {
        if self.is_c {
            format!("{vector}[{i}]")
        } else {
            format!("{vector}.{}", ["x", "y", "z"][i])
        }
    }

    pub(super) fn field(&self, parameter: &str, field: &str) -> String {
        format!("{parameter}{}{field}", if self.is_c { "->" } else { "." })
    }

    /// The bits that nobody knows to be zero: a radius is positive, or the light is refused.
    pub(super) fn unknown_zero(&self) -> &'static str {
        if self.is_wgsl {
            "let unknown_zero = bitcast<u32>(radius) & 0x80000000u;"
        } else {
            "uint unknown_zero = asuint(radius) & 0x80000000u;"
        }
    }
}

/// Lists of at most so many characters, unless one item alone is longer.
fn filled(items: impl Iterator<Item = String>, width: usize) -> Vec<String> {
    let mut lines = Vec::<String>::new();
    for item in items {
        match lines.last_mut() {
            Some(line) if line.len() + item.len() + 2 <= width => *line = format!("{line}, {item}"),
            _ => lines.push(item),
        }
    }
    lines
}

const C: Language = Language {
    file: "spherecap_inline.h",
    head: include_str!("heads/c.h"),
    tail: "\n#endif\n",
    prefix: "spherecap_inline_",
    function: "static inline ",
    guard: Guard::None,
    has_question_mark: true,
    has_constructors: false,
    has_late_constants: true,
    suffix: "f",
    vector: "",
    fma: "fmaf",
    fused: "fmaf",
    sqrt: "sqrtf",
    abs: "fabsf",
    is_wgsl: false,
    is_c: true,
};

const GLSL: Language = Language {
    file: "spherecap.glsl",
    head: include_str!("heads/glsl.glsl"),
    prefix: "spherecap_",
    function: "",
    guard: Guard::Precise,
    has_constructors: true,
    has_late_constants: false,
    suffix: "",
    vector: "vec3",
    fma: "fma",
    fused: "spherecap_fused",
    sqrt: "sqrt",
    abs: "abs",
    is_c: false,
    ..C
};

const HLSL: Language = Language {
    file: "spherecap.hlsl",
    head: include_str!("heads/hlsl.hlsl"),
    has_constructors: false,
    vector: "float3",
    fma: "mad",
    ..GLSL
};

const CUDA: Language = Language {
    file: "spherecap.cuh",
    head: include_str!("heads/cuda.cuh"),
    prefix: "spherecap_",
    function: "static __device__ inline ",
    guard: Guard::Intrinsics,
    vector: "make_float3",
    is_c: false,
    ..C
};

const WGSL: Language = Language {
    file: "spherecap.wgsl",
    head: include_str!("heads/wgsl.wgsl"),
    tail: "",
    guard: Guard::UnknownZero,
    has_question_mark: false,
    vector: "vec3f",
    is_wgsl: true,
    ..GLSL
};

const SLANG: Language = Language {
    file: "spherecap.slang",
    head: include_str!("heads/slang.slang"),
    guard: Guard::UnknownZero,
    ..HLSL
};

pub(super) const LANGUAGES: [&Language; 6] = [&C, &CUDA, &GLSL, &HLSL, &WGSL, &SLANG];
