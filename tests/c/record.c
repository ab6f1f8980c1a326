// Records the kernels into a recorder that evaluates at once, in plain C floats, and checks that it gives the
// bits of the library's own functions, zeros where they refuse, and every node back. With conditionals, too:
// what they give where their mask is false is rubbish here, and nothing else of theirs may be read after
// their end. A sum whose own rounding counts has no product that may be fused into it.
//
// Input: as of `bits.c`. Output: how many lines there were, how many of them had something to sample, and the
// most operations of a sample, of a density and of an importance, and the most conditionals of each.

#include "spherecap_record.h"

#include "check.h"

#include <math.h>

enum { WORDS_IN = 12, NODES = 4096, DEPTH = 8 };

// A node is an index into these arrays. Values are all that it has.
typedef struct graph_t {
    float value[NODES];
    int references[NODES];
    // Of each node the conditional that it is in, or 0.
    unsigned in[NODES];
    // Is it a product, negated or not, whose own rounding does not count?
    int is_loose[NODES];
    unsigned count, alive, operations, fails_at;
    // Conditionals by the order of their beginnings, from 1, and those that have not ended.
    unsigned conditionals, depth, open[DEPTH];
    // How many sums, differences and products have a rounding that counts.
    unsigned rounded[SPHERECAP_OP_FMA + 1];
    float mask[DEPTH];
} graph_t;

static float as_float(uint32_t bits) {
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static uint32_t as_bits(float number) {
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

static uint64_t new_node(graph_t *graph, float value) {
    CHECK(graph->count + 1 < NODES);
    if (graph->count == graph->fails_at) {
        return 0;
    }
    graph->value[++graph->count] = value;
    graph->references[graph->count] = 1;
    graph->in[graph->count] = graph->depth == 0 ? 0 : graph->open[graph->depth - 1];
    ++graph->alive;
    return graph->count;
}

static float value_of(const graph_t *graph, uint64_t node) {
    CHECK(1 <= node && node <= graph->count && graph->references[node] == 1);
    int has_ended = graph->in[node] != 0;
    for (unsigned i = 0; i < graph->depth; ++i) {
        has_ended = has_ended && graph->open[i] != graph->in[node];
    }
    CHECK(!has_ended);
    return graph->value[node];
}

static uint64_t literal(void *user, float value) { return new_node((graph_t *)user, value); }

static void release(void *user, uint64_t node) {
    graph_t *graph = (graph_t *)user;
    CHECK(1 <= node && node <= graph->count && graph->references[node] == 1);
    --graph->references[node];
    --graph->alive;
}

static uint64_t operation(void *user, spherecap_op_t op, const uint64_t *operands, uint32_t is_rounded) {
    graph_t *graph = (graph_t *)user;
    const int arity = op == SPHERECAP_OP_FMA || op == SPHERECAP_OP_SELECT ? 3
                      : (op >= SPHERECAP_OP_NEG && op <= SPHERECAP_OP_SQRT) || op == SPHERECAP_OP_NOT ||
                              op >= SPHERECAP_OP_POWER_OF_TWO
                          ? 1
                          : 2;
    float x[3] = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i < arity; ++i) {
        x[i] = value_of(graph, operands[i]);
    }
    const float a = x[0], b = x[1], c = x[2];
    float result = 0.0f;
    switch (op) {
    case SPHERECAP_OP_ADD:
        result = a + b;
        break;
    case SPHERECAP_OP_SUB:
        result = a - b;
        break;
    case SPHERECAP_OP_MUL:
        result = a * b;
        break;
    case SPHERECAP_OP_DIV:
        result =
            b == 0.0f ? (a != a || a == 0.0f ? NAN : copysignf(INFINITY, a) * copysignf(1.0f, b)) : a / b;
        break;
    case SPHERECAP_OP_FMA:
        result = fmaf(a, b, c);
        break;
    case SPHERECAP_OP_NEG:
        result = -a;
        break;
    case SPHERECAP_OP_ABS:
        result = fabsf(a);
        break;
    case SPHERECAP_OP_SQRT:
        result = sqrtf(a);
        break;
    case SPHERECAP_OP_LT:
        result = a < b;
        break;
    case SPHERECAP_OP_LE:
        result = a <= b;
        break;
    case SPHERECAP_OP_AND:
        result = a != 0.0f && b != 0.0f;
        break;
    case SPHERECAP_OP_OR:
        result = a != 0.0f || b != 0.0f;
        break;
    case SPHERECAP_OP_NOT:
        result = a == 0.0f;
        break;
    case SPHERECAP_OP_SELECT:
        result = a != 0.0f ? b : c;
        break;
    case SPHERECAP_OP_POWER_OF_TWO:
        result = as_float(as_bits(a) & 0x7f800000);
        break;
    case SPHERECAP_OP_BITS:
        result = (float)(int32_t)as_bits(a);
        break;
    case SPHERECAP_OP_FLOAT_OF_BITS:
        result = 0.0f <= a && a < 2147483648.0f ? as_float((uint32_t)a) : 0.0f;
        break;
    }
    if (is_rounded != 0) {
        CHECK(op <= SPHERECAP_OP_FMA && op != SPHERECAP_OP_DIV);
        CHECK(op > SPHERECAP_OP_SUB || (!graph->is_loose[operands[0]] && !graph->is_loose[operands[1]]));
        ++graph->rounded[op];
    }
    ++graph->operations;
    const uint64_t node = new_node(graph, result);
    graph->is_loose[node] = (op == SPHERECAP_OP_MUL && is_rounded == 0) ||
                            (op == SPHERECAP_OP_NEG && graph->is_loose[operands[0]]);
    return node;
}

static uint64_t begin_if(void *user, uint64_t mask) {
    graph_t *graph = (graph_t *)user;
    const float value = value_of(graph, mask);
    ++graph->conditionals;
    if (graph->conditionals % 5 == 0) {
        return 0; // A recorder may have none here.
    }
    CHECK(graph->depth < DEPTH);
    graph->mask[graph->depth] = value;
    graph->open[graph->depth] = graph->conditionals;
    return graph->open[graph->depth++];
}

static uint32_t end_if(void *user, uint64_t conditional, uint64_t *nodes, size_t count) {
    graph_t *graph = (graph_t *)user;
    CHECK(graph->depth > 0 && conditional == graph->open[graph->depth - 1] && count > 0);
    const float mask = graph->mask[graph->depth - 1];
    uint64_t merged[NODES];
    float values[NODES];
    for (size_t i = 0; i < count; ++i) {
        values[i] = mask != 0.0f ? value_of(graph, nodes[i]) : NAN;
    }
    --graph->depth;
    for (size_t i = 0; i < count; ++i) {
        merged[i] = new_node(graph, values[i]);
        if (merged[i] == 0) {
            while (i-- > 0) {
                release(graph, merged[i]);
            }
            return 0;
        }
    }
    memcpy(nodes, merged, count * sizeof *nodes);
    return 1;
}

static int read_words(uint32_t words[WORDS_IN]) {
    for (int i = 0; i < WORDS_IN; ++i) {
        unsigned word;
        if (scanf("%x", &word) != 1) {
            CHECK(i == 0 && feof(stdin));
            return 0;
        }
        words[i] = word;
    }
    return 1;
}

// An input of the graph, or a constant.
static spherecap_term_t term(graph_t *graph, float value) {
    spherecap_term_t term = {0, value};
    if (graph != NULL) {
        term.node = new_node(graph, value);
        term.constant = NAN; // not to be looked at
    }
    return term;
}

static spherecap_recorded_input_t recorded_input(graph_t *graph, const uint32_t *words, const float *in) {
    spherecap_recorded_input_t input;
    input.technique = words[0];
    input.hemispheres = words[1];
    input.defensive = term(NULL, in[2]); // a constant, as renderers have it
    for (int i = 0; i < 3; ++i) {
        input.normal[i] = term(graph, in[3 + i]);
        input.centre[i] = term(graph, in[6 + i]);
    }
    input.radius = term(graph, in[9]);
    return input;
}

static void expect_bits(const graph_t *graph, uint64_t node, float expected) {
    const float found = value_of(graph, node);
    CHECK(as_bits(found) == as_bits(expected));
}

static graph_t graph;
static const spherecap_recorder_t recorders[2] = {{&graph, literal, operation, release, NULL, NULL},
                                                  {&graph, literal, operation, release, begin_if, end_if}};

static void start(void) {
    memset(&graph, 0, sizeof graph);
    graph.fails_at = NODES;
}

// The most that any recording had.
typedef struct most_t {
    unsigned operations, conditionals;
} most_t;

static void add_to(most_t *most) {
    CHECK(graph.depth == 0);
    most->operations = graph.operations > most->operations ? graph.operations : most->operations;
    most->conditionals = graph.conditionals > most->conditionals ? graph.conditionals : most->conditionals;
}

static void check_sample(most_t *most, const spherecap_recorder_t *recorder, const uint32_t *words,
                         const float *in, int with_nodes, const spherecap_sample_t *expected,
                         int is_sampled) {
    start();
    graph_t *inputs = with_nodes ? &graph : NULL;
    const spherecap_recorded_input_t input = recorded_input(inputs, words, in);
    const spherecap_term_t u[2] = {term(inputs, in[10]), term(inputs, in[11])};
    const unsigned before = graph.alive;
    spherecap_recorded_sample_t sample;
    CHECK(spherecap_record_sample(recorder, &input, u, &sample) == SPHERECAP_STATUS_OK);
    CHECK(graph.alive == before + 11); // what the sample holds
    for (int i = 0; i < 3; ++i) {
        expect_bits(&graph, sample.direction[i], expected->direction[i]);
        expect_bits(&graph, sample.normal[i], expected->normal[i]);
        release(&graph, sample.direction[i]);
        release(&graph, sample.normal[i]);
    }
    expect_bits(&graph, sample.distance, expected->distance);
    expect_bits(&graph, sample.cosine, expected->offset.cosine);
    expect_bits(&graph, sample.density.solid_angle, expected->density.solid_angle);
    expect_bits(&graph, sample.density.projected_solid_angle, expected->density.projected_solid_angle);
    expect_bits(&graph, sample.is_sampled, (float)is_sampled);
    const uint64_t rest[5] = {sample.distance, sample.cosine, sample.density.solid_angle,
                              sample.density.projected_solid_angle, sample.is_sampled};
    for (int i = 0; i < 5; ++i) {
        release(&graph, rest[i]); // each is another node, or this would be its second time
    }
    CHECK(graph.alive == before && (with_nodes || graph.operations <= 1));
    for (int op = SPHERECAP_OP_ADD; op <= SPHERECAP_OP_MUL; ++op) {
        CHECK((graph.rounded[op] > 0) == with_nodes);
    }
    add_to(most);
}

static void check_density(most_t *most, const spherecap_recorder_t *recorder, const uint32_t *words,
                          const float *in, int with_nodes, const float *direction,
                          const spherecap_density_t *expected) {
    start();
    graph_t *inputs = with_nodes ? &graph : NULL;
    const spherecap_recorded_input_t input = recorded_input(inputs, words, in);
    const spherecap_term_t d[3] = {term(inputs, direction[0]), term(inputs, direction[1]),
                                   term(inputs, direction[2])};
    const unsigned before = graph.alive;
    spherecap_recorded_density_t density;
    CHECK(spherecap_record_pdf_on_sphere(recorder, &input, d, &density) == SPHERECAP_STATUS_OK);
    CHECK(graph.alive == before + 2);
    expect_bits(&graph, density.solid_angle, expected->solid_angle);
    expect_bits(&graph, density.projected_solid_angle, expected->projected_solid_angle);
    release(&graph, density.solid_angle);
    release(&graph, density.projected_solid_angle);
    CHECK(graph.alive == before);
    add_to(most);
}

// Of a light as strong as the first random number.
static void check_importance(most_t *most, const spherecap_recorder_t *recorder, const uint32_t *words,
                             const float *in, int with_nodes) {
    const spherecap_receiver_t receiver = {{in[3], in[4], in[5]}, words[0], words[1], in[2]};
    const spherecap_lights_t light = {1, {&in[6], &in[7], &in[8]}, &in[9], &in[10]};
    const float origin[3] = {0.0f, 0.0f, 0.0f};
    float expected = 0.0f; // where the receiver is refused
    spherecap_total_t total;
    (void)spherecap_importances(&receiver, origin, &light, &expected, &total);
    start();
    graph_t *inputs = with_nodes ? &graph : NULL;
    const spherecap_recorded_input_t input = recorded_input(inputs, words, in);
    const spherecap_term_t strength = term(inputs, in[10]);
    const unsigned before = graph.alive;
    uint64_t importance;
    CHECK(spherecap_record_importance(recorder, &input, &strength, &importance) == SPHERECAP_STATUS_OK);
    CHECK(graph.alive == before + 1);
    expect_bits(&graph, importance, expected);
    release(&graph, importance);
    CHECK(graph.alive == before && (with_nodes || graph.operations == 0));
    add_to(most);
}

static void expect_close(uint64_t node, float expected) {
    const float found = value_of(&graph, node);
    // Five roundings, and what underflows.
    CHECK(fabsf(found - expected) <= 4e-7f * expected + 1e-36f);
    release(&graph, node);
}

// The importances of two lights: any numbers, but none too small for single precision.
static void check_choice(const float *in, graph_t *inputs) {
    float importances[2];
    for (int i = 0; i < 2; ++i) {
        const float any = in[i == 0 ? 6 : 10];
        importances[i] = any > 0.0f && any < 0x1p-126f ? 0.0f : any;
    }
    const float even = in[2] > 1.0f ? 1.0f : in[2] > 0.0f ? in[2] : 0.0f;
    spherecap_total_t expected;
    CHECK(spherecap_total(importances, 2, &expected) == SPHERECAP_STATUS_OK);
    start();
    const spherecap_recorder_t *recorder = &recorders[0];
    const spherecap_term_t terms[2] = {term(inputs, importances[0]), term(inputs, importances[1])};
    const unsigned before = graph.alive;
    spherecap_recorded_total_t total = {{0, 0.0f}, {0, 0.0f}};
    spherecap_total_nodes_t nodes[2];
    for (int i = 0; i < 2; ++i) {
        CHECK(spherecap_record_total(recorder, &terms[i], &total, &nodes[i]) == SPHERECAP_STATUS_OK);
        total.sum.node = nodes[i].sum;
        total.lit.node = nodes[i].lit;
    }
    CHECK(value_of(&graph, total.lit.node) == (float)expected.lit);
    // A constant, as renderers have it; one that is out of range is taken for the nearer end.
    const spherecap_term_t any = {0, in[2]};
    for (int i = 0; i < 2; ++i) {
        float probability;
        CHECK(spherecap_choice_probability(importances[i], &expected, even, &probability) ==
              SPHERECAP_STATUS_OK);
        uint64_t node;
        CHECK(spherecap_record_choice_probability(recorder, &terms[i], &total, &any, &node) ==
              SPHERECAP_STATUS_OK);
        expect_close(node, probability);
    }
    expect_close(nodes[1].sum, expected.sum);
    release(&graph, nodes[1].lit);
    release(&graph, nodes[0].sum);
    release(&graph, nodes[0].lit);
    CHECK(graph.alive == before);
}

// A recorder that fails at its n-th node: everything comes back, whatever n.
static void check_failures(const spherecap_recorder_t *recorder, const uint32_t *words, const float *in) {
    for (unsigned n = 9;; n += 7) {
        start();
        const spherecap_recorded_input_t input = recorded_input(&graph, words, in);
        const spherecap_term_t u[2] = {term(&graph, in[10]), term(&graph, in[11])};
        const unsigned before = graph.alive;
        graph.fails_at = n;
        spherecap_recorded_sample_t sample;
        spherecap_recorded_density_t density;
        fill_with_rubbish(&sample, sizeof sample);
        if (spherecap_record_sample(recorder, &input, u, &sample) == SPHERECAP_STATUS_OK) {
            CHECK(n > 100);
            return;
        }
        CHECK(is_all_zero(&sample, sizeof sample) && graph.alive == before);
        graph.depth = 0;
        CHECK(spherecap_record_pdf_on_sphere(recorder, &input, input.normal, &density) ==
              SPHERECAP_STATUS_RECORDER);
        CHECK(is_all_zero(&density, sizeof density) && graph.alive == before);
    }
}

int main(void) {
    uint32_t words[WORDS_IN];
    unsigned lines = 0, sampled = 0;
    most_t of_samples = {0, 0}, of_densities = {0, 0}, of_importances = {0, 0};
    while (read_words(words)) {
        float in[WORDS_IN];
        for (int i = 0; i < WORDS_IN; ++i) {
            in[i] = as_float(words[i]);
        }
        spherecap_sampler_t sampler;
        spherecap_sample_t sample;
        spherecap_density_t density;
        const uint32_t status = prepare_for(words[0], words[1], in[2], in + 3, in + 6, in[9], &sampler);
        CHECK(spherecap_sample(&sampler, in[10], in[11], &sample) == status);
        const int is_sampled = status == SPHERECAP_STATUS_OK;
        const float other[3] = {0.6f, 0.0f, 0.8f}, too_long[3] = {1.0f, 0.0f, 0.1f};
        const float *directions[3] = {is_sampled ? sample.direction : other, other, too_long};
        check_choice(in, NULL);
        check_choice(in, &graph);
        for (int i = 0; i < 2; ++i) {
            const spherecap_recorder_t *recorder = &recorders[i];
            // With nodes for all numbers, and with constants for all: then nothing is recorded but the
            // results.
            for (int with_nodes = 0; with_nodes < 2; ++with_nodes) {
                check_sample(&of_samples, recorder, words, in, with_nodes, &sample, is_sampled);
                check_importance(&of_importances, recorder, words, in, with_nodes);
                for (int j = 0; j < 3; ++j) {
                    const uint32_t expected = spherecap_pdf_on_sphere(&sampler, directions[j], &density);
                    CHECK(status != SPHERECAP_STATUS_OK || (expected == SPHERECAP_STATUS_OK) == (j < 2));
                    check_density(&of_densities, recorder, words, in, with_nodes, directions[j], &density);
                }
            }
            if (lines % 500 == 0) {
                check_failures(recorder, words, in);
            }
        }
        ++lines;
        sampled += (unsigned)is_sampled;
    }
    printf("%u %u %u %u %u %u %u %u\n", lines, sampled, of_samples.operations, of_densities.operations,
           of_importances.operations, of_samples.conditionals, of_densities.conditionals,
           of_importances.conditionals);
    return 0;
}
