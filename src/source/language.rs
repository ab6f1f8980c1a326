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

    pub(super) fn function(&self, kind: Kind) -> String {
        let own = |name| format!("{}{name}", self.prefix);
        match kind {
            Kind::Op(Op::Fma) => self.fma.to_owned(),
            Kind::Op(Op::Sqrt) => self.sqrt.to_owned(),
            Kind::Op(Op::Abs) => self.abs.to_owned(),
            Kind::Op(Op::PowerOfTwo) => own("power_of_two"),
            Kind::Op(Op::Bits) => own("bits"),
            Kind::Op(Op::FloatOfBits) => own("float_of_bits"),
            Kind::Min => own("min"),
            Kind::Max => own("max"),
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

    /// One that does not.
    pub(super) fn variable(&self, name: &str, is_mask: bool) -> String {
        let zero = if is_mask { "false".to_owned() } else { self.number(0) };
        if self.is_wgsl {
            format!("var {name} = {zero};")
        } else {
            format!("{} {name} = {zero};", self.plain(if is_mask { Type::Truth } else { Type::Number }))
        }
    }

    /// One of a struct.
    pub(super) fn result(&self, name: &str, of: &'static str) -> String {
        let of = self.plain(Type::Struct(of));
        if self.is_wgsl {
            format!("var {name}: {of};")
        } else {
            format!("{of} {name};")
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

    /// Statements that store a vector.
    pub(super) fn store(&self, place: &str, [x, y, z]: [String; 3]) -> Vec<String> {
        if self.is_c {
            let lines = [x, y, z].into_iter().enumerate();
            lines.map(|(i, value)| format!("{place}[{i}] = {value};")).collect()
        } else {
            vec![format!("{place} = {}({x}, {y}, {z});", self.vector)]
        }
    }
}

const C: Language = Language {
    file: "spherecap_inline.h",
    head: include_str!("heads/c.h"),
    tail: "\n#endif\n",
    prefix: "spherecap_inline_",
    function: "static inline ",
    guard: Guard::None,
    has_question_mark: true,
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
