//! Prints the kernels as source of other languages, from their recordings: the files in `shaders`, which `make shaders` remakes.
//!
//! | file | what it does |
//! |---|---|
//! | `graph.rs` | takes the recording: each operation once, and what a condition says of what is within it |
//! | `blocks.rs` | arranges it in conditionals with two sides, and leaves out what is not needed |
//! | `print.rs` | writes statements |
//! | `language.rs`, `heads` | what the languages differ in |
//!
//! A prepared sampler becomes a struct of those of its numbers that sampling and densities read. They keep the names that they have
//! in the kernel.

mod blocks;
mod graph;
mod language;
mod print;

use crate::input::{is_unit, Input};
use crate::lane::recorded::{Recorded, RecordedMask, Tape, Wanted};
use crate::lane::{Lane, Mask};
use crate::sample::Sample;
use crate::sampling::Sampler;
use crate::strategy::{Hemispheres, Receiver, Strategy, Technique};
use crate::vec3::Vec3;
use graph::{Builder, Graph, Kind, Value};
use language::{Guard, Language, Type, LANGUAGES};
use print::Printer;
use std::collections::{BTreeSet, HashMap};
use std::{env, fs, path::Path};

/// What is known when a function is written, and what it is told when it runs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// A point on a surface whose normal has unit length, lit from the front.
    Surface,
    /// A normal of any length, or none, and a defensive fraction.
    Front,
    /// The same, and the surface is lit from both sides.
    Both,
}

const FORMS: [(Form, &str, &str); 3] = [
    (
        Form::Surface,
        "surface",
        "A point on a surface that is lit from the front. The normal must be of unit length to single precision.",
    ),
    (
        Form::Front,
        "front",
        "The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the\n\
         probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with\n\
         the normal.",
    ),
    (
        Form::Both,
        "both",
        "The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.",
    ),
];

impl Form {
    /// How many conditionals around a recording say what is known.
    fn assumptions(self) -> usize {
        usize::from(self == Self::Surface)
    }

    fn is_mixed(self) -> bool {
        self != Self::Surface
    }
}

const ABOUT: &str = "\
Samples spherical lights uniformly in projected solid angle. Version {version} of spherecap, MIT licence.
After C. Peters and C. Dachsbacher, Sampling Projected Spherical Caps in Real Time (2019). Generated from the
kernels of the library by `make shaders`: do not edit. docs/source.md and docs/mathematics.md explain.

{prefix}surface_prepare looks at a light from a shading point: normal is the surface's, centre the sphere's
centre minus the shading point, radius > 0 its radius, all in one unit of length. If is_sampled is false the
light gives nothing here, or the input is bad; then densities are 0. solid_angle is the light's, and
projected_solid_angle that above the horizon, in steradians; the other numbers are for the functions.
{prefix}surface_sample samples a direction by two random numbers in [0, 1]; _sample_once prepares, too.
{prefix}surface_pdf_direction is the density of a unit direction per steradian, 0 outside the light;
_pdf_on_sphere is for one that is known to meet it. _importance is what the light gives to the point, to
choose among lights by, in proportion to strength, its radiance. `surface` can be `front` or `both`, see below.";

// Places of parameters.
const NORMAL: usize = 0;
const CENTRE: usize = 3;
const RADIUS: usize = 6;
const DEFENSIVE: usize = 7;
const U: usize = 8;
const DIRECTION: usize = 10;
const STRENGTH: usize = 13;
const FIELDS: usize = 14;

/// A recording under way, with its parameters.
struct Session<'t> {
    tape: &'t Tape,
    builder: &'t Builder,
    sphere: Input<Recorded<'t>>,
    known: Option<RecordedMask<'t>>,
}

impl<'t> Session<'t> {
    fn new(tape: &'t Tape, builder: &'t Builder, form: Form) -> Self {
        let input = |place| tape.input(builder.input(place));
        let vector = |first| Vec3::new(input(first), input(first + 1), input(first + 2));
        let normal = vector(NORMAL);
        let hemispheres = if form == Form::Both { Hemispheres::Both } else { Hemispheres::Front };
        let defensive = if form.is_mixed() { input(DEFENSIVE) } else { Recorded::Lit(0.0) };
        let strategy = Strategy { technique: Technique::Projected, hemispheres, defensive };
        let known = (form == Form::Surface).then(|| {
            // As the kernel asks.
            let length2 = normal.dot(normal);
            let number = |value| Recorded::lit(value);
            let excess = length2 - crate::lane::lit(1.0);
            let is_unit = excess.abs().le(number(4.0 * f64::from(f32::EPSILON)));
            let known =
                is_unit & length2.le(number(2.0)) & number(0.0).lt(length2) & !length2.le(number(0.0));
            known.begin_side(true);
            known
        });
        let receiver = Receiver { normal, strategy };
        let sphere = Input { receiver, centre: vector(CENTRE), radius: input(RADIUS) };
        Self { tape, builder, sphere, known }
    }

    fn input(&self, place: usize) -> Recorded<'t> {
        self.tape.input(self.builder.input(place))
    }

    fn direction(&self) -> Vec3<Recorded<'t>> {
        Vec3::from([0, 1, 2].map(|i| self.input(DIRECTION + i)))
    }

    fn prepare(&self) -> (Sampler<Recorded<'t>>, RecordedMask<'t>) {
        self.sphere.prepare()
    }

    /// The values of what is wanted.
    fn play(self, wanted: Vec<Wanted>) -> Vec<Value> {
        if let Some(known) = self.known {
            known.end_side();
        }
        let mut nodes = vec![0; wanted.len()];
        self.tape.play_into(self.builder, &wanted, &mut nodes).expect("a graph can be built");
        nodes.into_iter().map(Builder::value).collect()
    }
}

/// The numbers of a prepared sampler, with their names, as its text for debugging has them.
fn fields<'t>(tape: &'t Tape, sampler: &Sampler<Recorded<'t>>) -> Vec<(String, Recorded<'t>)> {
    let text = format!("{sampler:?}");
    let (mut path, mut found) = (Vec::<(String, usize)>::new(), Vec::new());
    let mut word = String::new();
    for c in text.chars() {
        match c {
            '{' | '[' | '(' => {
                path.push((String::new(), 0));
                word.clear();
            }
            ':' => {
                path.last_mut().expect("a field is in something").0 = std::mem::take(&mut word);
            }
            ',' | '}' | ']' | ')' => {
                if let Some(place) = word.strip_prefix('#') {
                    let place = place.parse().expect("a place on the tape is a number");
                    let names: Vec<String> = path
                        .iter()
                        .map(|(name, i)| if name.is_empty() { i.to_string() } else { name.clone() })
                        .collect();
                    found.push((names, Recorded::at(tape, place)));
                }
                word.clear();
                if c == ',' {
                    path.last_mut().expect("a comma is in something").1 += 1;
                } else {
                    path.pop();
                }
            }
            ' ' => {}
            c => word.push(c),
        }
    }
    // The last part of the path, and more where that says too little.
    let short = |names: &[String], parts: usize| {
        let mut from = names.len().saturating_sub(parts);
        let says_little = |name: &str| name.len() == 1;
        while from > 0 && says_little(&names[from]) {
            from -= 1;
        }
        names[from..].join("_")
    };
    let paths: Vec<Vec<String>> = found.iter().map(|(names, _)| names.clone()).collect();
    let name = |names: &Vec<String>| {
        let parts = (1..=names.len()).find(|&parts| {
            let own = short(names, parts);
            paths.iter().filter(|other| short(other, parts) == own).count() == 1
        });
        short(names, parts.unwrap_or(names.len()))
    };
    // The polynomial that docs/mathematics.md calls B.
    let brief = |name: String| name.replace("coefficients_", "b_");
    found.iter().map(|(names, number)| (brief(name(names)), *number)).collect()
}

/// What a function gives.
struct Function {
    graph: Graph,
    outputs: Vec<Value>,
    /// The sampler's numbers and their values here.
    fields: Vec<(String, Value)>,
}

/// Records a function of a sampler, which takes the sampler's numbers for given.
fn of_sampler<'a>(
    form: Form,
    run: impl for<'t> FnOnce(&Session<'t>, &Sampler<Recorded<'t>>) -> Vec<Recorded<'t>>,
) -> Function {
    let (tape, builder) = (Tape::default(), Builder::new(form));
    let session = Session::new(&tape, &builder, form);
    let (sampler, _) = session.prepare();
    let fields = fields(&tape, &sampler);
    let outputs = run(&session, &sampler);
    let mut wanted: Vec<Wanted> = fields.iter().map(|(_, number)| tape.want_number(*number)).collect();
    wanted.extend(outputs.iter().map(|number| tape.want_number(*number)));
    let values = session.play(wanted);
    let (field_values, outputs) = values.split_at(fields.len());
    let fields: Vec<(String, Value)> =
        fields.into_iter().map(|(name, _)| name).zip(field_values.iter().copied()).collect();
    let mut graph = builder.finish();
    let mut parameters = HashMap::new();
    for (i, (_, value)) in fields.iter().enumerate() {
        if !matches!(graph.values[*value].kind, Kind::Number(_)) {
            parameters.entry(*value).or_insert(FIELDS + i);
        }
    }
    graph.cut(&parameters);
    graph.tidy(outputs);
    Function { graph, outputs: outputs.to_vec(), fields }
}

impl Function {
    /// The places of the fields that it reads.
    fn reads(&self) -> BTreeSet<usize> {
        let mut places = BTreeSet::new();
        self.graph.each_read(&self.graph.items, &mut |value| {
            if let Kind::Input(place) = self.graph.values[value].kind {
                places.insert(place);
            }
        });
        for &output in &self.outputs {
            if let Kind::Input(place) = self.graph.values[output].kind {
                places.insert(place);
            }
        }
        let fields = places.iter().filter_map(|place| place.checked_sub(FIELDS)).collect();
        assert!(
            places.iter().all(|&place| place >= U),
            "a function of a sampler reads its numbers alone: {places:?}"
        );
        fields
    }
}

/// The functions of one form.
struct Functions {
    sample: Function,
    pdf_direction: Function,
    pdf_on_sphere: Function,
    prepare: Function,
    importance: Function,
    /// Names of the sampler's numbers that are read, in the order of the outputs of `prepare`.
    fields: Vec<(usize, String)>,
}

impl Functions {
    fn new(form: Form) -> Self {
        let sample = of_sampler(form, |session, sampler| {
            let Sample { offset, direction, distance, normal, density } =
                sampler.sample(session.input(U), session.input(U + 1));
            for (number, name) in
                [(offset.zenith, "zenith"), (offset.side, "side"), (offset.cosine, "cosine")]
            {
                number.named(name);
            }
            vec![
                direction.x,
                direction.y,
                direction.z,
                distance,
                normal.x,
                normal.y,
                normal.z,
                offset.cosine,
                density.solid_angle,
                density.projected_solid_angle,
            ]
        });
        let pdf_direction =
            of_sampler(form, |session, sampler| vec![sampler.pdf_direction(session.direction()).solid_angle]);
        let pdf_on_sphere = of_sampler(form, |session, sampler| {
            let direction = session.direction();
            let density = sampler.pdf_in_cap(sampler.offset(direction));
            vec![density.where_true(is_unit(direction)).solid_angle]
        });
        let read: BTreeSet<usize> =
            [&sample, &pdf_direction, &pdf_on_sphere].iter().flat_map(|function| function.reads()).collect();
        // The measures are fields anyway: where something is sampled, of these values.
        let fields: Vec<(usize, String)> = read
            .into_iter()
            .map(|place| (place, sample.fields[place].0.clone()))
            .filter(|(_, name)| !MEASURES.contains(&name.as_str()))
            .collect();
        let prepare = Self::prepare(form, &fields);
        let importance = Self::importance(form);
        Self { sample, pdf_direction, pdf_on_sphere, prepare, importance, fields }
    }

    /// Whether something is sampled, the two measures, and the other fields.
    fn prepare(form: Form, read: &[(usize, String)]) -> Function {
        let (tape, builder) = (Tape::default(), Builder::new(form));
        let session = Session::new(&tape, &builder, form);
        let (sampler, mask) = session.prepare();
        let all = fields(&tape, &sampler);
        let zero = Recorded::Lit(0.0);
        let cap = sampler.cap();
        let measures = [cap.solid_angle(), cap.projected_solid_angle()]
            .map(|measure| tape.want_number(Recorded::select(mask, measure, zero)));
        let mut wanted = vec![tape.want_mask(mask)];
        wanted.extend(measures);
        let first = wanted.len();
        // All, as they give the names to what is not stored.
        wanted.extend(all.iter().map(|(_, number)| tape.want_number(*number)));
        let values = session.play(wanted);
        let (outputs, all_values) = values.split_at(first);
        let mut outputs = outputs.to_vec();
        outputs.extend(read.iter().map(|(place, _)| all_values[*place]));
        let names: Vec<String> = all.into_iter().map(|(name, _)| name).collect();
        let mut graph = builder.finish();
        graph.names.extend(all_values.iter().copied().zip(names).rev());
        graph.tidy(&outputs);
        Function { graph, outputs, fields: vec![] }
    }

    fn importance(form: Form) -> Function {
        let (tape, builder) = (Tape::default(), Builder::new(form));
        let session = Session::new(&tape, &builder, form);
        let strength = session.input(STRENGTH);
        let Input { receiver, centre, radius } = session.sphere;
        let importance = receiver.importance(centre, radius, strength);
        let outputs = session.play(vec![tape.want_number(importance)]);
        let mut graph = builder.finish();
        graph.tidy(&outputs);
        Function { graph, outputs, fields: vec![] }
    }
}

/// Fields of a sampler that are for the caller.
const MEASURES: [&str; 2] = ["solid_angle", "projected_solid_angle"];

/// Fields of a sample.
const SAMPLE: [(&str, Type, &str); 6] = [
    ("direction", Type::Vector, "Unit direction from the shading point."),
    ("distance", Type::Number, "Distance to the sphere along it, in the unit of the centre."),
    ("normal", Type::Vector, "Unit outward normal of the sphere there."),
    (
        "cosine",
        Type::Number,
        "Cosine of the direction with the surface's normal: more precise than their product.",
    ),
    ("pdf", Type::Number, "Density of the direction, per steradian; 0 if nothing is sampled."),
    ("projected_pdf", Type::Number, "The same over |cosine|, but never infinite."),
];

impl Language {
    /// The whole file.
    fn text(&self, forms: &[(Form, &str, &str, Functions)]) -> String {
        let about = ABOUT.replace("{version}", env!("CARGO_PKG_VERSION")).replace("{prefix}", self.prefix);
        let mut text = self.head.replace("// {about}", &comment(&about));
        text.push('\n');
        let fields: Vec<(String, Type)> =
            SAMPLE.iter().map(|(name, of, _)| ((*name).to_owned(), *of)).collect();
        let comments: Vec<String> =
            SAMPLE.iter().map(|(name, _, about)| format!("{name}: {about}")).collect();
        text += &comment(&format!("A sample.\n{}", comments.join("\n")));
        text.push('\n');
        text += &self.structure("sample", &fields);
        text.push('\n');
        text += &self.no_sample();
        for (form, name, about, functions) in forms {
            text.push('\n');
            text += &comment(about);
            text.push('\n');
            text += &self.form(*form, name, functions);
        }
        text += self.tail;
        text
    }

    fn no_sample(&self) -> String {
        let zero = self.number(0);
        let values = SAMPLE.map(|(_, of, _)| match of {
            Type::Vector => self.vector([0; 3].map(|_| zero.clone())),
            _ => zero.clone(),
        });
        let lines: String =
            self.returned("sample", values.into()).iter().map(|line| format!("    {line}\n")).collect();
        format!("{}\n{lines}}}\n", self.signature("no_sample", &[], Type::Struct("sample")))
    }

    /// The parameters' texts, by place.
    fn inputs(&self, fields: &[(String, Value)]) -> Vec<String> {
        let vector = |name: &str| [0, 1, 2].map(|i| self.component(name, i));
        let mut inputs = Vec::new();
        inputs.extend(vector("normal"));
        inputs.extend(vector("centre"));
        inputs.extend(["radius", "defensive", "u0", "u1"].map(String::from));
        inputs.extend(vector("direction"));
        inputs.push("strength".to_owned());
        inputs.extend(fields.iter().map(|(name, _)| match vector_of(name) {
            Some((vector, i)) => self.component(&self.field("light", vector), i),
            None => self.field("light", name),
        }));
        inputs
    }

    fn form(&self, form: Form, name: &str, functions: &Functions) -> String {
        let sampler: &'static str = match form {
            Form::Surface => "surface_light",
            Form::Front => "front_light",
            Form::Both => "both_light",
        };
        let mut seen = vec![("normal", Type::Vector), ("centre", Type::Vector), ("radius", Type::Number)];
        if form.is_mixed() {
            seen.push(("defensive", Type::Number));
        }
        let prepared = [("light", Type::Struct(sampler))];
        let random = [("u0", Type::Number), ("u1", Type::Number)];
        let not_sampled = format!("if (!{}) {{", self.field("light", "is_sampled"));
        let mut text = String::new();

        // The sampler.
        let mut fields = vec![("is_sampled".to_owned(), Type::Truth)];
        fields.extend(MEASURES.map(|name| (name.to_owned(), Type::Number)));
        for (_, name) in &functions.fields {
            match vector_of(name) {
                None => fields.push((name.clone(), Type::Number)),
                Some((vector, 0)) => fields.push((vector.to_owned(), Type::Vector)),
                Some((vector, _)) => {
                    let is_same =
                        fields.last().is_some_and(|(name, of)| name == vector && *of == Type::Vector);
                    assert!(is_same, "a sampler's vectors are read whole: {name}");
                }
            }
        }
        text += &self.structure(sampler, &fields);
        text.push('\n');
        let Function { graph, outputs, .. } = &functions.prepare;
        let inputs = self.inputs(&[]);
        let mut printer = Printer::new(self, graph, &inputs, outputs);
        if self.guard == Guard::UnknownZero {
            printer.line(self.unknown_zero());
        }
        let types: Vec<Type> = fields.iter().map(|(_, of)| *of).collect();
        self.body(&mut printer, sampler, &types, outputs);
        text += &self.definition(&format!("{name}_prepare"), &seen, Type::Struct(sampler), &printer.lines);

        // A sample of it.
        let sample = &functions.sample;
        let inputs = self.inputs(&sample.fields);
        let mut printer = Printer::new(self, &sample.graph, &inputs, &sample.outputs);
        printer.line(&not_sampled);
        printer.line(&format!("    return {}no_sample();", self.prefix));
        printer.line("}");
        self.body(&mut printer, "sample", &SAMPLE.map(|(_, of, _)| of), &sample.outputs);
        let parameters = [&prepared[..], &random].concat();
        text +=
            &self.definition(&format!("{name}_sample"), &parameters, Type::Struct("sample"), &printer.lines);

        // Both at once.
        let arguments: Vec<&str> = seen.iter().map(|(name, _)| *name).collect();
        let call = format!("{}{name}_prepare({})", self.prefix, arguments.join(", "));
        let body = if self.is_wgsl {
            format!("    return {}{name}_sample({call}, u0, u1);\n", self.prefix)
        } else {
            let address = if self.is_c { "&" } else { "" };
            format!(
                "    {constant}{prefix}{sampler} light = {call};\n    return {prefix}{name}_sample({address}light, u0, u1);\n",
                prefix = self.prefix,
                constant = if self.has_late_constants { "const " } else { "" }
            )
        };
        let parameters = [&seen[..], &random].concat();
        text += &self.definition(&format!("{name}_sample_once"), &parameters, Type::Struct("sample"), &body);

        // Densities.
        for (end, function) in
            [("pdf_direction", &functions.pdf_direction), ("pdf_on_sphere", &functions.pdf_on_sphere)]
        {
            let inputs = self.inputs(&function.fields);
            let mut printer = Printer::new(self, &function.graph, &inputs, &function.outputs);
            printer.line(&not_sampled);
            printer.line(&format!("    return {};", self.number(0)));
            printer.line("}");
            printer.run();
            let value = printer.whole(function.outputs[0]);
            printer.line(&format!("return {value};"));
            let parameters = [&prepared[..], &[("direction", Type::Vector)]].concat();
            text += &self.definition(&format!("{name}_{end}"), &parameters, Type::Number, &printer.lines);
        }

        // The importance.
        let importance = &functions.importance;
        let inputs = self.inputs(&[]);
        let mut printer = Printer::new(self, &importance.graph, &inputs, &importance.outputs);
        printer.run();
        let value = printer.whole(importance.outputs[0]);
        printer.line(&format!("return {value};"));
        let parameters = [&seen[..], &[("strength", Type::Number)]].concat();
        text += &self.definition(&format!("{name}_importance"), &parameters, Type::Number, &printer.lines);
        text
    }

    /// The statements of a function that gives a struct.
    fn body(&self, printer: &mut Printer, of: &'static str, types: &[Type], mut outputs: &[Value]) {
        let mut fields = Vec::new();
        for of in types {
            let (field, rest) = outputs.split_at(if *of == Type::Vector { 3 } else { 1 });
            fields.push(field);
            outputs = rest;
        }
        assert!(outputs.is_empty(), "a struct's vectors are given whole");
        for field in &fields {
            if let &[x, y, z] = *field {
                printer.absorb([x, y, z]);
            }
        }
        printer.run();
        let value = |field: &&[Value]| match **field {
            [x, y, z] => printer.vector([x, y, z]),
            _ => printer.whole(field[0]),
        };
        let values = fields.iter().map(value).collect();
        self.returned(of, values).iter().for_each(|line| printer.line(line));
    }

    fn definition(&self, name: &str, parameters: &[(&str, Type)], result: Type, body: &str) -> String {
        format!("{}\n{body}}}\n\n", self.signature(name, parameters, result))
    }
}

/// The vector that a number of this name is part of, and which component it is.
fn vector_of(name: &str) -> Option<(&str, usize)> {
    ["_x", "_y", "_z"].iter().enumerate().find_map(|(i, end)| {
        let vector = name.strip_suffix(end)?;
        // `t_x` and `t_y` are numbers.
        (vector.len() > 1).then_some((vector, i))
    })
}

/// A text as comment lines.
fn comment(text: &str) -> String {
    let lines: Vec<String> = text.lines().map(|line| format!("// {line}").trim_end().to_owned()).collect();
    lines.join("\n")
}

#[test]
fn the_files_are_not_stale() {
    let forms = FORMS.map(|(form, name, about)| (form, name, about, Functions::new(form)));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    for language in LANGUAGES {
        let made = language.text(&forms);
        let path = folder.join(language.file);
        if env::var_os("SPHERECAP_WRITE_SHADERS").is_some() {
            fs::create_dir_all(&folder).expect("the folder is writable");
            fs::write(&path, &made).expect("the file is writable");
        }
        let found = fs::read_to_string(&path).unwrap_or_default();
        assert!(
            found == made,
            "shaders/{} is not what the kernels give: run `make shaders` and look at the diff",
            language.file
        );
    }
}
