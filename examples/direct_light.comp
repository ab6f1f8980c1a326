// A path tracer's direct light in a compute shader: a lamp that dips below the floor, and two balls in front of it. Every pixel
// takes four paths; where nothing hides the lamp there is no noise.
//
//     glslangValidator -V -Ishaders examples/direct_light.comp -o direct_light.spv
//
// Each thread stores the colour of one pixel of a picture of 480 by 270, row by row from the top.

#version 450
#extension GL_GOOGLE_include_directive : require

// Desktop GPUs round fma() once, and may define this. Software that runs shaders on the CPU may not.
// #define SPHERECAP_FUSED_FMA
#include "spherecap.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Picture { float picture[]; };

const uvec2 SIZE = uvec2(480, 270);
const uint PATHS = 4;
const vec4 LAMP = vec4(-1.9, 1.3, 0.3, 0.7); // centre and radius
const vec3 RADIANCE = vec3(9.0, 7.5, 5.5);
const vec4 BALLS[2] = vec4[](vec4(0.1, 2.0, 0.6, 0.6), vec4(1.3, 0.4, 0.35, 0.35));
const vec3 COLOURS[2] = vec3[](vec3(0.8, 0.3, 0.2), vec3(0.2, 0.5, 0.8));
const float FAR = 1e9;

// A random number from the bits of a state (PCG), which it changes.
float random(inout uint state) {
    state = state * 747796405u + 2891336453u;
    const uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

// Distance to a ball, or FAR.
float meet(vec4 ball, vec3 origin, vec3 direction) {
    const vec3 centre = ball.xyz - origin;
    const float along = dot(centre, direction);
    const vec3 across = centre - along * direction;
    const float rest = ball.w * ball.w - dot(across, across);
    if (rest < 0.0) {
        return FAR;
    }
    const float near = along - sqrt(rest);
    return near > 1e-4 ? near : FAR;
}

bool is_hidden(vec3 origin, vec3 direction, float distance) {
    // The floor hides what is below it, and no direction above the horizon goes there.
    for (int i = 0; i < 2; ++i) {
        if (meet(BALLS[i], origin, direction) < distance) {
            return true;
        }
    }
    return false;
}

// What a diffuse surface reflects of the lamp.
vec3 reflected(vec3 point, vec3 normal, vec3 colour, inout uint state) {
    const spherecap_sample light =
        spherecap_surface_sample_once(normal, LAMP.xyz - point, LAMP.w, random(state), random(state));
    if (light.pdf == 0.0 || is_hidden(point, light.direction, light.distance)) {
        return vec3(0.0);
    }
    return colour / 3.14159265 * RADIANCE * light.cosine / light.pdf;
}

vec3 radiance(vec3 origin, vec3 direction, inout uint state) {
    float nearest = direction.z < 0.0 ? -origin.z / direction.z : FAR;
    int hit = -1;
    for (int i = 0; i < 2; ++i) {
        const float distance = meet(BALLS[i], origin, direction);
        if (distance < nearest) {
            nearest = distance;
            hit = i;
        }
    }
    if (meet(LAMP, origin, direction) < nearest) {
        return RADIANCE;
    }
    if (nearest == FAR) {
        return vec3(0.0);
    }
    const vec3 point = origin + nearest * direction;
    if (hit < 0) {
        return reflected(vec3(point.xy, 0.0), vec3(0.0, 0.0, 1.0), vec3(0.6), state);
    }
    const vec3 normal = normalize(point - BALLS[hit].xyz);
    return reflected(point + 1e-4 * normal, normal, COLOURS[hit], state);
}

void main() {
    const uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= SIZE.x * SIZE.y) {
        return;
    }
    const uvec2 place = uvec2(pixel % SIZE.x, pixel / SIZE.x);
    uint state = pixel * 9781u + 1u;
    vec3 sum = vec3(0.0);
    for (uint i = 0; i < PATHS; ++i) {
        const vec2 at = vec2(place) + vec2(random(state), random(state));
        const vec2 screen = (2.0 * at - vec2(SIZE)) / float(SIZE.y);
        const vec3 direction = normalize(vec3(0.55 * screen.x, 1.0, -0.32 - 0.55 * screen.y));
        sum += radiance(vec3(0.0, -3.5, 1.9), direction, state);
    }
    for (int i = 0; i < 3; ++i) {
        picture[3u * pixel + i] = sum[i] / float(PATHS);
    }
}
