// A small renderer that lights its scenes with spherecap: rectangles, balls and boxes, Lambertian, direct
// light only.
//
//     cargo build --release
//     cc -std=c99 -O2 -Iinclude tests/c/renderer.c target/release/libspherecap.a -lpthread -ldl -lm -o
//     renderer
//     ./renderer projected independent 16 1 < scene.txt > image.pfm
//
// or without the library, by the inline header alone:
//
//     cc -std=c99 -O2 -mfma -fno-math-errno -DSPHERECAP_INLINE -Ishaders tests/c/renderer.c -lm
//
// What a renderer has to do with either is in `choose_light` and `sample_light`; the rest is what every
// renderer has. The scene is text, one thing per line: a word and its numbers (see `WORDS`), or a comment
// that starts with #. The image is in the PFM format: a line each with "Pf", width and height, and -1 for
// little-endian; then floats, rows from the bottom up.

#ifdef SPHERECAP_INLINE
#include "spherecap_inline.h"
#else
#include "spherecap.h"
#endif

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;
// Geometry is in double precision: where a ray meets a surface is known to about 1e-13 of the scene's size.
// Directions come in single precision, so at grazing angles a shadow ray may cross its own surface within a
// millionth.
static const double RAY_START = 1e-6;
// The part of the choice among lights that all share alike, for where the brightest are hidden: as in the
// Mitsuba plugin (lights.h), where its cost and its gain were measured.
static const float EVEN = 0.05f;

typedef struct {
    double x[3];
} vec_t;

static vec_t vec(const double *x) { return (vec_t){{x[0], x[1], x[2]}}; }
// a + s b
static vec_t add(vec_t a, double s, vec_t b) {
    return (vec_t){{a.x[0] + s * b.x[0], a.x[1] + s * b.x[1], a.x[2] + s * b.x[2]}};
}
static double dot(vec_t a, vec_t b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
static vec_t cross(vec_t a, vec_t b) {
    return (vec_t){{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
                    a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
static vec_t unit(vec_t a) { return add((vec_t){{0, 0, 0}}, 1 / sqrt(dot(a, a)), a); }

typedef enum { RECTANGLE, BALL, BOX } kind_t;

// A rectangle is all a + u b + v c with u, v in [-1, 1]; a ball has the centre a and a radius; a box the
// corners a and b.
typedef struct {
    kind_t kind;
    vec_t a, b, c;
    double radius, albedo;
} shape_t;

typedef struct {
    vec_t centre;
    double radius, radiance;
} light_t;

enum { MOST = 64 };

typedef struct {
    shape_t shapes[MOST];
    light_t lights[MOST];
    int shape_count, light_count, width, height;
    vec_t eye, target;
    double fov; // horizontal, in degrees
} scene_t;

static void fail(const char *what, const char *which) {
    fprintf(stderr, "renderer: %s%s\n", what, which);
    exit(1);
}

// ---- Rays ----

// Where a ray (unit direction) meets a ball, between the distances near and far; far if it does not.
static double hit_ball(vec_t centre, double radius, vec_t origin, vec_t direction, double near, double far) {
    const vec_t to_centre = add(centre, -1, origin);
    const double along = dot(to_centre, direction);
    const vec_t miss = add(to_centre, -along, direction);
    const double square = radius * radius - dot(miss, miss);
    if (square < 0) {
        return far;
    }
    const double first = along - sqrt(square), second = along + sqrt(square);
    const double t = first > near ? first : second;
    return t > near && t < far ? t : far;
}

// Where a ray meets a shape, likewise; then the normal there is stored, not of unit length, on either side.
static double hit_shape(const shape_t *shape, vec_t origin, vec_t direction, double near, double far,
                        vec_t *normal) {
    if (shape->kind == BALL) {
        const double t = hit_ball(shape->a, shape->radius, origin, direction, near, far);
        *normal = add(add(origin, t, direction), -1, shape->a);
        return t;
    }
    if (shape->kind == RECTANGLE) {
        const vec_t across = cross(shape->b, shape->c), to_centre = add(shape->a, -1, origin);
        const double t = dot(to_centre, across) / dot(direction, across);
        const vec_t offset = add(add(origin, t, direction), -1, shape->a);
        // Coordinates along b and c, which need not be at right angles.
        const double u = dot(cross(offset, shape->c), across), v = dot(cross(shape->b, offset), across);
        const double area = dot(across, across);
        *normal = across;
        return t > near && t < far && fabs(u) <= area && fabs(v) <= area ? t : far;
    }
    // A box is where three slabs overlap.
    double enter = -INFINITY, leave = INFINITY;
    int enter_axis = 0, leave_axis = 0;
    for (int i = 0; i < 3; ++i) {
        const double t0 = (shape->a.x[i] - origin.x[i]) / direction.x[i];
        const double t1 = (shape->b.x[i] - origin.x[i]) / direction.x[i];
        if (fmin(t0, t1) > enter) {
            enter = fmin(t0, t1);
            enter_axis = i;
        }
        if (fmax(t0, t1) < leave) {
            leave = fmax(t0, t1);
            leave_axis = i;
        }
    }
    const double t = enter > near ? enter : leave;
    *normal = (vec_t){{0, 0, 0}};
    normal->x[enter > near ? enter_axis : leave_axis] = 1;
    return enter <= leave && t > near && t < far ? t : far;
}

// Whether something is between a point and a sampled point on a light. The light itself is not in its own
// way.
static int is_occluded(const scene_t *scene, const light_t *light, vec_t point, vec_t direction,
                       double distance) {
    vec_t normal;
    for (int i = 0; i < scene->shape_count; ++i) {
        if (hit_shape(&scene->shapes[i], point, direction, RAY_START, distance, &normal) < distance) {
            return 1;
        }
    }
    for (int i = 0; i < scene->light_count; ++i) {
        const light_t *other = &scene->lights[i];
        if (other != light &&
            hit_ball(other->centre, other->radius, point, direction, 0, distance) < distance) {
            return 1;
        }
    }
    return 0;
}

// ---- Light ----

// A surface at the point: its normal, of unit length, on the side that is looked at.
typedef struct {
    float normal[3];
    uint32_t technique;
} surface_t;

typedef struct {
    size_t index;
    float probability, rest; // the latter is what is left of the random number, which is random again
} choice_t;

// What one random direction to a light is like; a density of 0 says that the light gives nothing here.
typedef struct {
    float direction[3], distance, cosine, density;
} direction_t;

// A light's centre as seen from a point: subtracted in double precision.
static void see(const light_t *light, vec_t point, float centre[3]) {
    for (int k = 0; k < 3; ++k) {
        centre[k] = (float)(light->centre.x[k] - point.x[k]);
    }
}

#ifdef SPHERECAP_INLINE

// Chooses the light to sample at a point, by what each gives to it if nothing is in the way: as
// `spherecap_choose` does.
static choice_t choose_light(const scene_t *scene, const surface_t *surface, vec_t point, float u) {
    float importances[MOST];
    double sum = 0;
    int lit = 0;
    for (int i = 0; i < scene->light_count; ++i) {
        const light_t *light = &scene->lights[i];
        float centre[3];
        see(light, point, centre);
        importances[i] = spherecap_inline_surface_importance(surface->normal, centre, (float)light->radius,
                                                             (float)light->radiance);
        sum += importances[i];
        lit += importances[i] > 0;
    }
    choice_t choice = {0, 0, 0};
    double start = 0, end = 0, share = 0;
    for (int i = 0; i < scene->light_count && end <= u; ++i) {
        if (importances[i] > 0) {
            share = importances[i] * ((1 - (double)EVEN) / (float)sum) + (double)EVEN / lit;
            start = end;
            end += share;
            choice.index = (size_t)i;
        }
    }
    if (lit > 0) {
        // The last one takes what rounding leaves.
        choice.probability = (float)share;
        choice.rest = (float)fmin((u - start) / share, 1);
    }
    return choice;
}

static direction_t sample_light(const surface_t *surface, const float centre[3], float radius, float u0,
                                float u1) {
    const spherecap_inline_sample sample =
        spherecap_inline_surface_sample_once(surface->normal, centre, radius, u0, u1);
    const float *direction = sample.direction;
    return (direction_t){
        {direction[0], direction[1], direction[2]}, sample.distance, sample.cosine, sample.pdf};
}

static void check_technique(uint32_t technique) {
    if (technique != 0) {
        fail("the inline header samples by projected solid angle alone: say `projected`", "");
    }
}

#else

static spherecap_receiver_t receiver_of(const surface_t *surface) {
    const float *normal = surface->normal;
    return (spherecap_receiver_t){
        {normal[0], normal[1], normal[2]}, surface->technique, SPHERECAP_HEMISPHERES_FRONT, 0};
}

// Chooses the light to sample at a point, by what each gives to it if nothing is in the way.
static choice_t choose_light(const scene_t *scene, const surface_t *surface, vec_t point, float u) {
    float centre[3][MOST], radius[MOST], strength[MOST], importances[MOST];
    for (int i = 0; i < scene->light_count; ++i) {
        const light_t *light = &scene->lights[i];
        float own[3];
        see(light, point, own);
        for (int k = 0; k < 3; ++k) {
            centre[k][i] = own[k];
        }
        radius[i] = (float)light->radius;
        strength[i] = (float)light->radiance;
    }
    const size_t count = (size_t)scene->light_count;
    const spherecap_lights_t lights = {count, {centre[0], centre[1], centre[2]}, radius, strength};
    const spherecap_receiver_t receiver = receiver_of(surface);
    static const float here[3] = {0, 0, 0};
    spherecap_total_t total;
    spherecap_choice_t choice;
    uint32_t status = spherecap_importances(&receiver, here, &lights, importances, &total);
    if (status == SPHERECAP_STATUS_OK) {
        status = spherecap_choose(importances, count, &total, EVEN, u, &choice);
    }
    if (status != SPHERECAP_STATUS_OK) {
        fail("no light can be chosen: ", spherecap_status_message(status));
    }
    return (choice_t){choice.index, choice.probability, choice.rest};
}

static direction_t sample_light(const surface_t *surface, const float centre[3], float radius, float u0,
                                float u1) {
    const spherecap_receiver_t receiver = receiver_of(surface);
    spherecap_sample_t sample;
    const uint32_t status = spherecap_sample_once(&receiver, centre, radius, u0, u1, &sample);
    if (status == SPHERECAP_STATUS_INVISIBLE || status == SPHERECAP_STATUS_INSIDE) {
        return (direction_t){{0, 0, 0}, 0, 0, 0}; // below the horizon, or around the point
    }
    if (status != SPHERECAP_STATUS_OK) {
        fail("a light cannot be sampled: ", spherecap_status_message(status));
    }
    const float *direction = sample.direction;
    return (direction_t){{direction[0], direction[1], direction[2]},
                         sample.distance,
                         sample.offset.cosine,
                         sample.density.solid_angle};
}

static void check_technique(uint32_t technique) {
    (void)technique; // all of them are there
    if (spherecap_abi_version() != SPHERECAP_ABI) {
        fail("the header and the library are of different versions: ", spherecap_version());
    }
}

#endif

// Estimates with one shadow ray what a light adds to the radiance that a Lambertian surface reflects; u0 and
// u1 are random numbers in [0, 1].
static double light_of(const scene_t *scene, const light_t *light, const surface_t *surface, vec_t point,
                       double albedo, float u0, float u1) {
    float centre[3];
    see(light, point, centre);
    const direction_t sample = sample_light(surface, centre, (float)light->radius, u0, u1);
    if (!(sample.density > 0 && sample.cosine > 0)) {
        return 0; // nothing to sample; or sampled by solid angle, and below the horizon
    }
    const vec_t direction = {{sample.direction[0], sample.direction[1], sample.direction[2]}};
    if (is_occluded(scene, light, point, direction, sample.distance)) {
        return 0;
    }
    return albedo / PI * light->radiance * sample.cosine / sample.density;
}

// Radiance that comes back along a ray of the camera. Lights are looked through, and nothing is black.
static double radiance(const scene_t *scene, uint32_t technique, vec_t origin, vec_t direction, float u0,
                       float u1) {
    double nearest = INFINITY;
    vec_t normal = {{0, 0, 0}};
    const shape_t *shape = NULL;
    for (int i = 0; i < scene->shape_count; ++i) {
        vec_t candidate;
        const double t = hit_shape(&scene->shapes[i], origin, direction, 0, nearest, &candidate);
        if (t < nearest) {
            nearest = t;
            normal = unit(candidate);
            shape = &scene->shapes[i];
        }
    }
    if (shape == NULL || shape->albedo == 0) {
        return 0;
    }
    if (dot(normal, direction) > 0) {
        normal = add((vec_t){{0, 0, 0}}, -1, normal);
    }
    const vec_t point = add(origin, nearest, direction);
    const surface_t surface = {{(float)normal.x[0], (float)normal.x[1], (float)normal.x[2]}, technique};
    const choice_t choice = choose_light(scene, &surface, point, u0);
    if (choice.probability == 0) {
        return 0; // no light gives anything here
    }
    const light_t *light = &scene->lights[choice.index];
    return light_of(scene, light, &surface, point, shape->albedo, choice.rest, u1) / choice.probability;
}

// ---- Random numbers ----

// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
static uint32_t random_bits(uint64_t *state) {
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)((z ^ (z >> 31)) >> 32);
}

// The largest multiples of 2^-24 below the fraction: in [0, 1), exact in single precision.
static float fraction(uint32_t bits) { return (float)(bits >> 8) * 0x1p-24f; }

// Four numbers for the i-th sample of a pixel: independent, or a lattice that is shifted at random as a
// whole. Its steps are 2^32 times the powers -1 to -4 of the root of x^5 = x + 1 (M. Roberts, "The
// Unreasonable Effectiveness of Quasirandom Sequences", 2018).
static void random_numbers(int is_lattice, uint32_t i, const uint32_t *shift, uint64_t *state, float *u) {
    static const uint32_t steps[4] = {3679390609u, 3152041523u, 2700274806u, 2313257605u};
    for (int k = 0; k < 4; ++k) {
        u[k] = fraction(is_lattice ? shift[k] + i * steps[k] : random_bits(state));
    }
}

static void render(const scene_t *scene, uint32_t technique, int is_lattice, uint32_t spp, uint64_t seed,
                   float *image) {
    const vec_t forward = unit(add(scene->target, -1, scene->eye));
    const vec_t right = unit(cross(forward, (vec_t){{0, 0, 1}})), up = cross(right, forward);
    const double half_width = tan(scene->fov / 2 * PI / 180), width = scene->width, height = scene->height;
    uint64_t state = seed;
    for (int y = 0; y < scene->height; ++y) {
        for (int x = 0; x < scene->width; ++x) {
            uint32_t shift[4];
            for (int k = 0; k < 4; ++k) {
                shift[k] = random_bits(&state);
            }
            double sum = 0;
            for (uint32_t i = 0; i < spp; ++i) {
                float u[4];
                random_numbers(is_lattice, i, shift, &state, u);
                const double film_x = (2 * (x + u[0]) - width) / width * half_width;
                const double film_y = (2 * (y + u[1]) - height) / width * half_width; // upwards
                const vec_t direction = unit(add(add(forward, film_x, right), film_y, up));
                sum += radiance(scene, technique, scene->eye, direction, u[2], u[3]);
            }
            image[y * scene->width + x] = (float)(sum / spp);
        }
    }
}

// ---- Input and output ----

static const struct {
    const char *word, *numbers;
    int count;
} WORDS[] = {
    {"image", "width and height in pixels", 2},
    {"bounces", "0: there is no indirect light here", 1},
    {"camera", "eye, target, horizontal field of view in degrees", 7},
    {"light", "centre, radius, radiance", 5},
    {"rectangle", "centre, half an edge, half another edge, albedo", 10},
    {"ball", "centre, radius, albedo", 5},
    {"box", "low corner, high corner, albedo", 7},
};
enum { IMAGE, BOUNCES, CAMERA, LIGHT, FIRST_SHAPE, WORD_COUNT = sizeof WORDS / sizeof *WORDS };

// Says which line is wrong and what it should be.
static void fail_in(int line, int word, const char *what) {
    fprintf(stderr, "renderer: line %d of the scene: %s. After '%s' come: %s.\n", line, what,
            WORDS[word].word, WORDS[word].numbers);
    exit(1);
}

static void read_shape(scene_t *scene, int line, int word, const double *n) {
    shape_t shape = {(kind_t)(word - FIRST_SHAPE), vec(n), {{0, 0, 0}}, {{0, 0, 0}}, 0,
                     n[WORDS[word].count - 1]};
    if (shape.kind == BALL) {
        shape.radius = n[3];
    } else {
        shape.b = vec(n + 3);
    }
    if (shape.kind == RECTANGLE) {
        shape.c = vec(n + 6);
    }
    const vec_t across = cross(shape.b, shape.c), size = add(shape.b, -1, shape.a);
    if ((shape.kind == RECTANGLE && !(dot(across, across) > 0)) ||
        (shape.kind == BALL && !(shape.radius > 0)) ||
        (shape.kind == BOX && !(size.x[0] > 0 && size.x[1] > 0 && size.x[2] > 0))) {
        fail_in(line, word, "it has no extent");
    }
    if (!(shape.albedo >= 0 && shape.albedo <= 1)) {
        fail_in(line, word, "the albedo is not in [0, 1]");
    }
    if (scene->shape_count == MOST) {
        fail_in(line, word, "there are too many shapes (64 is the most)");
    }
    scene->shapes[scene->shape_count++] = shape;
}

static void read_line(scene_t *scene, int line, int word, const double *n) {
    if (word == IMAGE) {
        // Of a size that an int can count.
        if (!(n[0] >= 1 && n[0] <= 32768 && n[1] >= 1 && n[1] <= 32768)) {
            fail_in(line, word, "the size is not between 1 and 32768");
        }
        scene->width = (int)n[0];
        scene->height = (int)n[1];
    } else if (word == BOUNCES) {
        if (n[0] != 0) {
            fail_in(line, word, "this renderer cannot do that");
        }
    } else if (word == CAMERA) {
        scene->eye = vec(n);
        scene->target = vec(n + 3);
        scene->fov = n[6];
        const vec_t forward = add(scene->target, -1, scene->eye);
        if (!(scene->fov > 0 && scene->fov < 180) || (forward.x[0] == 0 && forward.x[1] == 0)) {
            fail_in(line, word, "the field of view is not in (0, 180), or the view is vertical");
        }
    } else if (word == LIGHT) {
        if (scene->light_count == MOST) {
            fail_in(line, word, "there are too many lights (64 is the most)");
        }
        if (!(n[3] > 0) || n[4] < 0) {
            fail_in(line, word, "the radius is not positive, or the radiance negative");
        }
        scene->lights[scene->light_count++] = (light_t){vec(n), n[3], n[4]};
    } else {
        read_shape(scene, line, word, n);
    }
}

static void read_scene(FILE *file, scene_t *scene) {
    char text[512];
    for (int line = 1; fgets(text, sizeof text, file) != NULL; ++line) {
        const char *first = strtok(text, " \t\r\n");
        if (first == NULL || first[0] == '#') {
            continue;
        }
        int word = 0, count = 0;
        while (word < WORD_COUNT && strcmp(first, WORDS[word].word) != 0) {
            ++word;
        }
        if (word == WORD_COUNT) {
            fprintf(stderr, "renderer: line %d of the scene: there is nothing called '%s'\n", line, first);
            exit(1);
        }
        double numbers[10] = {0};
        for (const char *token; (token = strtok(NULL, " \t\r\n")) != NULL; ++count) {
            char *end;
            const double number = strtod(token, &end);
            if (count == WORDS[word].count || *end != '\0' || !isfinite(number)) {
                fail_in(line, word, "there is something else than the numbers it takes");
            }
            numbers[count] = number;
        }
        if (count != WORDS[word].count) {
            fail_in(line, word, "a number is missing");
        }
        read_line(scene, line, word, numbers);
    }
    if (scene->width == 0 || scene->fov == 0) {
        fail("the scene has no line 'image' or none 'camera'", "");
    }
}

static void write_image(FILE *file, const scene_t *scene, const float *image) {
    const uint16_t one = 1;
    const int is_little_endian = *(const unsigned char *)&one;
    fprintf(file, "Pf\n%d %d\n%d\n", scene->width, scene->height, is_little_endian ? -1 : 1);
    const size_t count = (size_t)scene->width * (size_t)scene->height;
    if (fwrite(image, sizeof *image, count, file) != count || fflush(file) != 0) {
        fail("the image cannot be written", "");
    }
}

// ---- Command line ----

static int choice(const char *text, const char *const *names, int count) {
    for (int i = 0; i < count; ++i) {
        if (strcmp(text, names[i]) == 0) {
            return i;
        }
    }
    fail("there is no such choice: ", text);
    return 0;
}

static unsigned long long whole_number(const char *text, unsigned long long low, unsigned long long high) {
    char *end;
    const unsigned long long number = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || number < low || number > high) {
        fail("not a whole number, or out of range: ", text);
    }
    return number;
}

int main(int argc, char **argv) {
    static const char *const techniques[] = {"projected", "projected_bounded", "solid_angle"}; // in C's order
    static const char *const samplers[] = {"independent", "lattice"};
    if (argc != 5) {
        fail("usage: renderer solid_angle|projected_bounded|projected independent|lattice SPP SEED",
             " < scene.txt > image.pfm");
    }
    const uint32_t technique = (uint32_t)choice(argv[1], techniques, 3);
    check_technique(technique);
    const int is_lattice = choice(argv[2], samplers, 2);
    const uint32_t spp = (uint32_t)whole_number(argv[3], 1, 1000000);
    // The states of neighbouring seeds must not be those of neighbouring samples: mix.
    uint64_t seed = whole_number(argv[4], 0, 0xffffffffu);
    const uint64_t high = random_bits(&seed), low = random_bits(&seed);
    seed = high << 32 | low;

    static scene_t scene;
    read_scene(stdin, &scene);
    float *image = malloc((size_t)scene.width * (size_t)scene.height * sizeof *image);
    if (image == NULL) {
        fail("there is not enough memory for the image", "");
    }
    render(&scene, technique, is_lattice, spp, seed, image);
    write_image(stdout, &scene, image);
    free(image);
    return 0;
}
