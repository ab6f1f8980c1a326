"""Compute shaders that run the functions of a file of `shaders` on records: what tests/c/inline.c does."""

import pathlib

FOLDER = pathlib.Path(__file__).parents[2] / "shaders"
INPUTS, OUTPUTS = 15, 16

FORM = """
    if (form == {number}.0) {{
        {light} light = spherecap_{form}_prepare(normal, centre, radius{defensive});
        {sample} sampled = spherecap_{form}_sample(light, u0, u1);
        {once} once = spherecap_{form}_sample_once(normal, centre, radius{defensive}, u0, u1);
        results[o] = {one};
        results[o + 1u] = light.solid_angle;
        results[o + 2u] = light.projected_solid_angle;
        results[o + 3u] = sampled.direction.x;
        results[o + 4u] = sampled.direction.y;
        results[o + 5u] = sampled.direction.z;
        results[o + 6u] = sampled.distance;
        results[o + 7u] = sampled.normal.x;
        results[o + 8u] = sampled.normal.y;
        results[o + 9u] = sampled.normal.z;
        results[o + 10u] = sampled.cosine;
        results[o + 11u] = once.pdf;
        results[o + 12u] = once.projected_pdf;
        results[o + 13u] = spherecap_{form}_pdf_direction(light, direction);
        results[o + 14u] = spherecap_{form}_pdf_on_sphere(light, direction);
        results[o + 15u] = spherecap_{form}_importance(normal, centre, radius{defensive}, strength);
    }}
"""
READ = """
    {uint} i = 15u * {id};
    {uint} o = 16u * {id};
    {float} form = records[i];
    {vector} normal = {make}(records[i + 1u], records[i + 2u], records[i + 3u]);
    {vector} centre = {make}(records[i + 4u], records[i + 5u], records[i + 6u]);
    {float} radius = records[i + 7u];
    {float} defensive = records[i + 8u];
    {float} u0 = records[i + 9u];
    {float} u1 = records[i + 10u];
    {vector} direction = {make}(records[i + 11u], records[i + 12u], records[i + 13u]);
    {float} strength = records[i + 14u];
"""
GLSL = """#version 450
{define}
{file}
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Records {{ float records[]; }};
layout(std430, binding = 1) writeonly buffer Results {{ float results[]; }};
void main() {{
{body}
}}
"""
HLSL = """{define}
{file}
[[vk::binding(0, 0)]] RWStructuredBuffer<float> records;
[[vk::binding(1, 0)]] RWStructuredBuffer<float> results;
[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{
{body}
}}
"""
WGSL = """{file}
@group(0) @binding(0) var<storage, read> records: array<f32>;
@group(0) @binding(1) var<storage, read_write> results: array<f32>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {{
{body}
}}
"""


def _body(language):
    is_wgsl = language == "wgsl"
    words = {
        "glsl": {"id": "gl_GlobalInvocationID.x", "vector": "vec3", "make": "vec3"},
        "hlsl": {"id": "id.x", "vector": "float3", "make": "float3"},
        "wgsl": {"id": "id.x", "vector": "let", "make": "vec3f"},
    }[language]
    words |= {"uint": "let", "float": "let"} if is_wgsl else {"uint": "uint", "float": "float"}
    text = READ.format(**words)
    for number, form in enumerate(("surface", "front", "both")):
        text += FORM.format(
            number=number,
            form=form,
            defensive="" if form == "surface" else ", defensive",
            light="let" if is_wgsl else f"spherecap_{form}_light",
            sample="let" if is_wgsl else "spherecap_sample",
            once="let" if is_wgsl else "spherecap_sample",
            one="select(0.0, 1.0, light.is_sampled)" if is_wgsl else "light.is_sampled ? 1.0 : 0.0",
        )
    return text


def main(language, define=""):
    """The whole shader; `define` is a line of the preprocessor."""
    template = {"glsl": GLSL, "hlsl": HLSL, "slang": HLSL, "wgsl": WGSL}[language]
    file = (FOLDER / f"spherecap.{language}").read_text()
    return template.format(file=file, define=define, body=_body("hlsl" if language == "slang" else language))
