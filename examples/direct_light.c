// The picture of direct_light.comp from C, by the inline header alone: a lamp that dips below the floor, and
// two balls.
//
//     cc -std=c99 -O2 -mfma -fno-math-errno -Ishaders examples/direct_light.c -lm -o direct_light
//     ./direct_light > direct_light.ppm

#include "spherecap_inline.h"

#include <stdio.h>

enum { WIDTH = 480, HEIGHT = 270, PATHS = 4, BALLS = 2 };

typedef struct {
    float centre[3], radius, colour[3];
} ball_t;

static const ball_t LAMP = {{-1.9f, 1.3f, 0.3f}, 0.7f, {9.0f, 7.5f, 5.5f}};
static const ball_t BALL[BALLS] = {
    {{0.1f, 2.0f, 0.6f}, 0.6f, {0.8f, 0.3f, 0.2f}},
    {{1.3f, 0.4f, 0.35f}, 0.35f, {0.2f, 0.5f, 0.8f}},
};
static const float FLOOR[3] = {0.6f, 0.6f, 0.6f};
static const float FARTHEST = 1e9f;

// A random number from the bits of a state (PCG), which it changes.
static float random_number(uint32_t *state) {
    *state = *state * 747796405u + 2891336453u;
    const uint32_t word = ((*state >> ((*state >> 28) + 4)) ^ *state) * 277803737u;
    return (float)(((word >> 22) ^ word) >> 8) / 16777216.0f;
}

static float dot(const float a[3], const float b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Distance to a ball, or FARTHEST.
static float meet(const ball_t *ball, const float origin[3], const float direction[3]) {
    float centre[3], across[3];
    for (int i = 0; i < 3; ++i) {
        centre[i] = ball->centre[i] - origin[i];
    }
    const float along = dot(centre, direction);
    for (int i = 0; i < 3; ++i) {
        across[i] = centre[i] - along * direction[i];
    }
    const float rest = ball->radius * ball->radius - dot(across, across);
    if (rest < 0) {
        return FARTHEST;
    }
    const float near = along - sqrtf(rest);
    return near > 1e-4f ? near : FARTHEST;
}

// The nearest of the balls, or -1; `*nearest` is the distance to what is in front of it.
static int nearest_ball(const float origin[3], const float direction[3], float *nearest) {
    int hit = -1;
    for (int i = 0; i < BALLS; ++i) {
        const float distance = meet(&BALL[i], origin, direction);
        if (distance < *nearest) {
            *nearest = distance;
            hit = i;
        }
    }
    return hit;
}

// Adds what a diffuse surface reflects of the lamp.
static void add_reflected(const float point[3], const float normal[3], const float colour[3], uint32_t *state,
                          float sum[3]) {
    const float centre[3] = {LAMP.centre[0] - point[0], LAMP.centre[1] - point[1], LAMP.centre[2] - point[2]};
    const float u0 = random_number(state), u1 = random_number(state);
    const spherecap_inline_sample light =
        spherecap_inline_surface_sample_once(normal, centre, LAMP.radius, u0, u1);
    float distance = light.distance;
    if (light.pdf > 0 && nearest_ball(point, light.direction, &distance) < 0) {
        for (int i = 0; i < 3; ++i) {
            sum[i] += colour[i] / 3.14159265f * LAMP.colour[i] * light.cosine / light.pdf;
        }
    }
}

static void add_radiance(const float origin[3], const float direction[3], uint32_t *state, float sum[3]) {
    float nearest = direction[2] < 0 ? -origin[2] / direction[2] : FARTHEST;
    const int hit = nearest_ball(origin, direction, &nearest);
    if (meet(&LAMP, origin, direction) < nearest) {
        for (int i = 0; i < 3; ++i) {
            sum[i] += LAMP.colour[i];
        }
        return;
    }
    if (nearest == FARTHEST) {
        return;
    }
    float point[3], normal[3] = {0, 0, 1};
    for (int i = 0; i < 3; ++i) {
        point[i] = origin[i] + nearest * direction[i];
    }
    if (hit < 0) {
        point[2] = 0;
        add_reflected(point, normal, FLOOR, state, sum);
        return;
    }
    for (int i = 0; i < 3; ++i) {
        normal[i] = point[i] - BALL[hit].centre[i];
    }
    const float length = sqrtf(dot(normal, normal));
    for (int i = 0; i < 3; ++i) {
        normal[i] /= length;
        point[i] += 1e-4f * normal[i];
    }
    add_reflected(point, normal, BALL[hit].colour, state, sum);
}

static unsigned char srgb(float linear) {
    const float x = linear < 1 ? linear : 1;
    return (unsigned char)(255 * (x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f) + 0.5f);
}

int main(void) {
    printf("P6\n%d %d\n255\n", WIDTH, HEIGHT);
    const float eye[3] = {0, -3.5f, 1.9f};
    for (int y = 0; y < HEIGHT; ++y) {
        for (int x = 0; x < WIDTH; ++x) {
            uint32_t state = (uint32_t)(y * WIDTH + x) * 9781u + 1u;
            float sum[3] = {0, 0, 0};
            for (int i = 0; i < PATHS; ++i) {
                const float across = (2 * ((float)x + random_number(&state)) - WIDTH) / HEIGHT;
                const float down = (2 * ((float)y + random_number(&state)) - HEIGHT) / HEIGHT;
                float direction[3] = {0.55f * across, 1, -0.32f - 0.55f * down};
                const float length = sqrtf(dot(direction, direction));
                for (int k = 0; k < 3; ++k) {
                    direction[k] /= length;
                }
                add_radiance(eye, direction, &state, sum);
            }
            for (int i = 0; i < 3; ++i) {
                putchar(srgb(sum[i] / PATHS));
            }
        }
    }
    return 0;
}
