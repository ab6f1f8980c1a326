// What docs/porting.md leaves to the host, and whether the page's functions, which are included, do what it
// says. The host's surfaces reflect and transmit diffusely, and its BSDF samples are stratified. The test
// also makes a program in double precision of it.

#include "porting.h"

#include <stdio.h>

static const float PI = 3.14159265f;
enum { SIDE = 400 };

static int failures = 0;

static void expect(const char *what, double got, double expected, double tolerance) {
    if (!(fabs(got - expected) <= tolerance * fabs(expected))) {
        printf("%s: %g instead of %g\n", what, got, expected);
        ++failures;
    }
}

// Is the light on the side of the surface from where it gets to `outgoing`? Geometric normals decide.
static int passes(const vertex_t *vertex, const float *direction) {
    return vertex->transmits || dot(vertex->normal, vertex->outgoing) * dot(vertex->normal, direction) > 0;
}

float bsdf_cos(const vertex_t *vertex, const float *direction) {
    const float sides = vertex->transmits ? 2.0f : 1.0f;
    return passes(vertex, direction) ? fabsf(dot(vertex->shading_normal, direction)) / PI / sides : 0;
}

// The host samples the whole sphere, so that it finds all that the light does.
float bsdf_pdf(const vertex_t *vertex, const float *direction) {
    (void)vertex;
    (void)direction;
    return 0.25f / PI;
}

int is_visible(const vertex_t *vertex, const float *direction, float distance) {
    (void)vertex;
    return fabsf(dot(direction, direction) - 1) < 1e-6f && distance > 0;
}

static int hits(const vertex_t *vertex, const light_t *light, const float *direction) {
    float centre[3];
    for (int i = 0; i < 3; ++i) {
        centre[i] = light->centre[i] - vertex->point[i];
    }
    const float along = dot(centre, direction);
    const float miss2 = dot(centre, centre) - along * along, radius2 = light->radius * light->radius;
    return miss2 < radius2 && (along > 0 || dot(centre, centre) < radius2);
}

// Light and BSDF sampling together give what BSDF sampling alone does.
static void check(const char *what, const vertex_t *vertex, const light_t *light, int is_sampled) {
    spherecap_sampler_t sampler;
    const uint32_t status = prepare(vertex, light, &sampler);
    double by_light = 0, by_bsdf = 0, alone = 0;
    for (int k = 0; k < SIDE * SIDE; ++k) {
        const float u0 = ((float)(k % SIDE) + 0.5f) / SIDE, u1 = ((float)(k / SIDE) + 0.5f) / SIDE;
        // One sample of two lights alike, chosen with the probability 1/2.
        by_light += light->chosen * sample_light(vertex, light, &sampler, u0, u1);
        const float z = 2 * u0 - 1, r = sqrtf(1 - z * z);
        const float direction[3] = {r * cosf(2 * PI * u1), r * sinf(2 * PI * u1), z};
        if (hits(vertex, light, direction)) {
            by_bsdf += hit_light(vertex, light, &sampler, direction);
            alone += bsdf_cos(vertex, direction) * light->radiance / bsdf_pdf(vertex, direction);
        }
    }
    printf("%s: %s; %.4f + %.4f, and %.4f\n", what, spherecap_status_message(status), by_light / SIDE / SIDE,
           by_bsdf / SIDE / SIDE, alone / SIDE / SIDE);
    // A hundredth: the strata that the light's edge cuts.
    expect(what, by_light + by_bsdf, alone, 0.01);
    if ((by_light > 0) != is_sampled || !(alone > 0)) {
        printf("%s: is not what it says\n", what);
        ++failures;
    }
}

// No direction towards the light is rarer than the fraction of what it would be by solid angle.
static void check_defensive(const vertex_t *vertex, const light_t *light) {
    spherecap_sampler_t sampler;
    float solid_angle = 0, least = INFINITY;
    prepare(vertex, light, &sampler);
    spherecap_solid_angle(&sampler, &solid_angle);
    for (int k = 0; k < SIDE; ++k) {
        spherecap_sample_t sample;
        spherecap_sample(&sampler, ((float)k + 0.5f) / SIDE, 0.5f, &sample);
        least = fminf(least, sample.density.solid_angle);
    }
    expect("defensive fraction", least * solid_angle, 0.125, 1e-5);
}

static void check_area(void) {
    // The mean of the light's cosine over the density by area is the integral of that cosine over what is
    // seen of the sphere: at the angle a around the axis it is (d cos a - r) over the distance.
    const spherecap_receiver_t receiver = {
        {0, 0, 0}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0};
    const float centre[3] = {1, 2, 2};
    const double r = 1.5, d = 3;
    spherecap_sampler_t sampler;
    spherecap_prepare(&receiver, centre, (float)r, &sampler);
    double mean = 0, integral = 0;
    for (int k = 0; k < SIDE * SIDE; ++k) {
        spherecap_sample_t sample;
        spherecap_sample(&sampler, ((float)(k % SIDE) + 0.5f) / SIDE, ((float)(k / SIDE) + 0.5f) / SIDE,
                         &sample);
        mean -= dot(sample.direction, sample.normal) / pdf_by_area(&sample) / SIDE / SIDE;
        const double cosine = r / d + (1 - r / d) * (k + 0.5) / SIDE / SIDE;
        const double distance = sqrt(d * d + r * r - 2 * d * r * cosine);
        integral += 2 * PI * r * r * (1 - r / d) * (d * cosine - r) / distance / SIDE / SIDE;
    }
    // Midpoints err at the limb, in one of the strata along a side.
    expect("area", mean, integral, 1.0 / SIDE);
}

static void check_solid_angles(void) {
    const spherecap_receiver_t receiver = {
        {0, 0, 0}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0};
    const float centre[3] = {0, 0, 1}, sizes[] = {0.9f, 1e-3f, 1.7e-4f, 1e-6f};
    for (int i = 0; i < 4; ++i) {
        const float s = sizes[i];
        spherecap_sampler_t sampler;
        float solid_angle = 0;
        spherecap_prepare(&receiver, centre, s, &sampler);
        spherecap_solid_angle(&sampler, &solid_angle);
        expect("solid angle", solid_angle_of(s), solid_angle, 1e-6);
        const float cosine = sqrtf(1 - s * s);
        const float error = fabsf(2 * PI * (1 - cosine) / solid_angle - 1);
        // In double precision the digits last longer.
        const int is_single = sizeof solid_angle == 4;
        if (is_single && ((i == 1 && !(error > 0.01f)) || (i > 1 && error != 1))) {
            printf("1 - cos is off by %g at s = %g\n", error, s);
            ++failures;
        }
    }
}

int main(void) {
    const light_t light = {{1.5f, 0, 0.3f}, 1, 3, 0.5f}, low = {{1.5f, 0, -0.3f}, 1, 3, 0.5f};
    const light_t behind = {{0.5f, 0, -2.5f}, 1, 3, 0.5f}, around = {{0.1f, 0, 0.3f}, 1, 3, 0.5f};
    // Not of unit length, and turned away from where the path came from.
    const vertex_t stretched = {{0.25f, 0.5f, -0.125f}, {0, 0, -3}, {0, 0, -3}, {0.6f, 0, 0.8f}, 0};
    vertex_t vertex = stretched;
    vertex.shading_normal[2] = -1;
    vertex.normal[2] = -1;
    check("smooth", &vertex, &light, 1);
    check("smooth, centre below", &vertex, &low, 1);
    check("inside", &vertex, &around, 0);
    vertex.shading_normal[0] = -0.6f;
    vertex.shading_normal[2] = -0.8f;
    check("shading normal", &vertex, &light, 1);
    check("shading normal, centre below", &vertex, &low, 1);
    check_defensive(&vertex, &light);
    vertex.transmits = 1;
    check("transmitting", &vertex, &light, 1);
    vertex.shading_normal[0] = 0;
    vertex.shading_normal[2] = -1;
    check("light behind", &vertex, &behind, 1);
    check_area();
    check_solid_angles();

    spherecap_sampler_t of_any_length, of_unit_length;
    spherecap_sample_t samples[2];
    vertex.transmits = 0;
    prepare(&stretched, &light, &of_any_length);
    prepare(&vertex, &light, &of_unit_length);
    // Beyond 1 is 1.
    spherecap_sample(&of_any_length, 0.25f, 1.00001f, &samples[0]);
    spherecap_sample(&of_unit_length, 0.25f, 1, &samples[1]);
    expect("normals of any length", samples[0].density.solid_angle, samples[1].density.solid_angle, 1e-6);
    // A ray that ends just in front of the light.
    expect("shadow ray", shadow_ray_end(samples[0].distance), samples[0].distance, 1e-3);
    if (!(shadow_ray_end(samples[0].distance) < samples[0].distance)) {
        ++failures;
    }
    return failures != 0;
}
