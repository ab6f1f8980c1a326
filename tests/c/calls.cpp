// Calls every function from C++17, and from two threads at once: a sampler may be shared, and nothing else
// is.

#include "spherecap_record.h" // first, so that it must be self-contained

#include "check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <thread>
#include <type_traits>
#include <vector>

// Plain data, as the header says: on the stack, in arrays, copied as bytes.
static_assert(std::is_trivial_v<spherecap_sampler_t> && std::is_standard_layout_v<spherecap_sampler_t>);
static_assert(std::is_trivial_v<spherecap_receiver_t> && std::is_standard_layout_v<spherecap_receiver_t>);
static_assert(std::is_trivial_v<spherecap_sample_t> && std::is_standard_layout_v<spherecap_sample_t>);
static_assert(std::is_trivial_v<spherecap_offset_t> && std::is_standard_layout_v<spherecap_offset_t>);
static_assert(std::is_trivial_v<spherecap_density_t> && std::is_standard_layout_v<spherecap_density_t>);

namespace {

constexpr std::array<float, 3> ahead{3.0f, 0.0f, 0.5f};

spherecap_sampler_t prepare(uint32_t technique, float radius) {
    const spherecap_receiver_t receiver{{0.0f, 0.0f, 1.0f}, technique, SPHERECAP_HEMISPHERES_BOTH, 0.125f};
    spherecap_sampler_t sampler;
    CHECK(spherecap_prepare(&receiver, ahead.data(), radius, &sampler) == SPHERECAP_STATUS_OK);
    return sampler;
}

void call_everything() {
    CHECK(spherecap_abi_version() == SPHERECAP_ABI);
    CHECK(std::string_view(spherecap_version()).find('.') != std::string_view::npos);
    CHECK(std::string_view(spherecap_status_message(SPHERECAP_STATUS_OK)) == "success");

    const spherecap_sampler_t sampler = prepare(SPHERECAP_TECHNIQUE_PROJECTED, 1.0f);
    spherecap_sample_t sample;
    CHECK(spherecap_sample(&sampler, 0.25f, 0.75f, &sample) == SPHERECAP_STATUS_OK);
    spherecap_density_t density;
    CHECK(spherecap_pdf(&sampler, &sample.offset, &density) == SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&density, &sample.density, sizeof density) == 0);
    CHECK(spherecap_pdf_direction(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_pdf_on_sphere(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    spherecap_sample_t once;
    spherecap_density_t density_once;
    const spherecap_receiver_t leaf{
        {0.0f, 0.0f, 1.0f}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_BOTH, 0.125f};
    CHECK(spherecap_sample_once(&leaf, ahead.data(), 1.0f, 0.25f, 0.75f, &once) == SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&once, &sample, sizeof once) == 0);
    CHECK(spherecap_pdf_once(&leaf, ahead.data(), 1.0f, sample.direction, &density_once) ==
          SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&density_once, &density, sizeof density) == 0);
    CHECK(density.solid_angle > 0.0f);
    std::array<float, 2> u;
    CHECK(spherecap_invert(&sampler, &sample.offset, u.data()) == SPHERECAP_STATUS_OK);
    float solid_angle, projected_solid_angle, bound;
    CHECK(spherecap_solid_angle(&sampler, &solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_projected_solid_angle(&sampler, &projected_solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_density_bound(&sampler, &bound) == SPHERECAP_STATUS_OK);
    CHECK(projected_solid_angle < solid_angle && bound >= 1.0f);

    const spherecap_receiver_t receiver{{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    const std::array<float, 2> x{3.0f, -2.0f}, y{0.0f, 1.0f}, z{0.5f, 2.0f}, radius{1.0f, 0.5f},
        strength{1.0f, 4.0f};
    const spherecap_lights_t lights{x.size(), {x.data(), y.data(), z.data()}, radius.data(), strength.data()};
    std::array<float, 2> importances;
    spherecap_total_t total;
    spherecap_choice_t choice;
    float probability;
    CHECK(spherecap_importances(&receiver, std::array<float, 3>{}.data(), &lights, importances.data(),
                                &total) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_total(importances.data(), importances.size(), &total) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_choose(importances.data(), importances.size(), &total, 0.02f, 0.9f, &choice) ==
          SPHERECAP_STATUS_OK);
    CHECK(spherecap_choice_probability(importances[choice.index], &total, 0.02f, &probability) ==
          SPHERECAP_STATUS_OK);
    CHECK(choice.probability == probability && probability > 0.0f);

    CHECK(spherecap_sample(nullptr, 0.5f, 0.5f, &sample) == SPHERECAP_STATUS_NULL_POINTER);
}

// Samples of a shared sampler and of caps of its own.
std::vector<spherecap_sample_t> samples(const spherecap_sampler_t &shared) {
    constexpr int count = 20000;
    std::vector<spherecap_sample_t> all(2 * count);
    for (int i = 0; i < count; ++i) {
        const float u = static_cast<float>(i) / count;
        const spherecap_sampler_t own = prepare(static_cast<uint32_t>(i % 3), 0.5f + u);
        CHECK(spherecap_sample(&shared, u, 1.0f - u, &all[2 * i]) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_sample(&own, u, 1.0f - u, &all[2 * i + 1]) == SPHERECAP_STATUS_OK);
    }
    return all;
}

void call_from_two_threads() {
    const spherecap_sampler_t shared = prepare(SPHERECAP_TECHNIQUE_PROJECTED, 1.0f);
    std::vector<spherecap_sample_t> first, second;
    std::thread a([&] { first = samples(shared); });
    std::thread b([&] { second = samples(shared); });
    a.join();
    b.join();
    const std::vector<spherecap_sample_t> alone = samples(shared);
    const std::size_t size = alone.size() * sizeof alone[0];
    CHECK(std::memcmp(first.data(), alone.data(), size) == 0);
    CHECK(std::memcmp(second.data(), alone.data(), size) == 0);
}

// Vectors as arrays, which need no alignment of their own; what is not wanted is null.
void call_the_batches() {
    constexpr std::size_t count = 100;
    const std::vector<float> zeros(count, 0.0f), ones(count, 1.0f), threes(count, 3.0f), halves(count, 0.5f);
    const spherecap_batch_t batch{SPHERECAP_TECHNIQUE_PROJECTED,
                                  SPHERECAP_HEMISPHERES_BOTH,
                                  0.125f,
                                  count,
                                  {zeros.data(), zeros.data(), ones.data()},
                                  {threes.data(), zeros.data(), zeros.data()},
                                  ones.data()};
    std::vector<float> x(count), y(count), z(count), pdf(count);
    spherecap_batch_samples_t samples{};
    samples.direction[0] = x.data();
    samples.direction[1] = y.data();
    samples.direction[2] = z.data();
    samples.density.solid_angle = pdf.data();
    const spherecap_batch_random_t random{halves.data(), halves.data()};
    std::size_t refused = 1;
    CHECK(spherecap_batch_sample(&batch, &random, &samples, &refused) == SPHERECAP_STATUS_OK);
    CHECK(refused == 0 && *std::min_element(pdf.begin(), pdf.end()) > 0.0f);

    const spherecap_receiver_t receiver{{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    const float centre[3] = {3.0f, 0.0f, 0.0f};
    spherecap_sampler_t sampler;
    CHECK(spherecap_prepare(&receiver, centre, 1.0f, &sampler) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_sample_many(&sampler, count, &random, &samples) == SPHERECAP_STATUS_OK);
    CHECK(*std::min_element(pdf.begin(), pdf.end()) > 0.0f);

    const spherecap_batch_directions_t directions{x.data(), y.data(), z.data()};
    const spherecap_batch_offsets_t offsets{zeros.data(), zeros.data(), halves.data()};
    const spherecap_batch_densities_t densities{pdf.data(), nullptr};
    CHECK(spherecap_batch_pdf(&batch, &offsets, &densities, nullptr) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_direction(&batch, &directions, &densities, nullptr) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, &directions, &densities, nullptr) == SPHERECAP_STATUS_OK);
    CHECK(*std::min_element(pdf.begin(), pdf.end()) > 0.0f);
    const spherecap_batch_measures_t measures{nullptr, pdf.data()};
    CHECK(spherecap_batch_measures(&batch, &measures, nullptr) == SPHERECAP_STATUS_OK);
    CHECK(*std::min_element(pdf.begin(), pdf.end()) > 0.0f);
    CHECK(spherecap_batch_importances(&batch, batch.radius, pdf.data(), nullptr) == SPHERECAP_STATUS_OK);
    CHECK(*std::min_element(pdf.begin(), pdf.end()) > 0.0f);
    CHECK(!std::string_view(spherecap_batch_instructions()).empty());
}

// The functions in double precision.
void call_in_double_precision() {
    const spherecap_receiver_f64_t receiver{
        {0.0, 0.0, 1.0}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_BOTH, 0.125};
    const std::array<double, 3> centre{3.0, 0.0, 0.5};
    spherecap_sampler_f64_t sampler;
    CHECK(spherecap_prepare_f64(&receiver, centre.data(), 1.0, &sampler) == SPHERECAP_STATUS_OK);
    spherecap_sample_f64_t sample;
    CHECK(spherecap_sample_f64(&sampler, 0.25, 0.75, &sample) == SPHERECAP_STATUS_OK);
    spherecap_density_f64_t density;
    CHECK(spherecap_pdf_f64(&sampler, &sample.offset, &density) == SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&density, &sample.density, sizeof density) == 0);
    CHECK(spherecap_pdf_direction_f64(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_pdf_on_sphere_f64(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    spherecap_sample_f64_t once;
    spherecap_density_f64_t density_once;
    CHECK(spherecap_sample_once_f64(&receiver, centre.data(), 1.0, 0.25, 0.75, &once) == SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&once, &sample, sizeof once) == 0);
    CHECK(spherecap_pdf_once_f64(&receiver, centre.data(), 1.0, sample.direction, &density_once) ==
          SPHERECAP_STATUS_OK);
    CHECK(std::memcmp(&density_once, &density, sizeof density) == 0);
    std::array<double, 2> u;
    CHECK(spherecap_invert_f64(&sampler, &sample.offset, u.data()) == SPHERECAP_STATUS_OK);
    double solid_angle, projected_solid_angle, bound;
    CHECK(spherecap_solid_angle_f64(&sampler, &solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_projected_solid_angle_f64(&sampler, &projected_solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_density_bound_f64(&sampler, &bound) == SPHERECAP_STATUS_OK);
    CHECK(projected_solid_angle < solid_angle && bound >= 1.0);
}

// A graph without edges: every node is new.
void call_the_recorder() {
    std::vector<bool> alive(1, false);
    const auto add = [](void *user) -> uint64_t {
        auto &nodes = *static_cast<std::vector<bool> *>(user);
        nodes.push_back(true);
        return nodes.size() - 1;
    };
    static const auto make = +add;
    const spherecap_recorder_t recorder{
        &alive,
        [](void *user, float) { return make(user); },
        [](void *user, spherecap_op_t, const uint64_t *, uint32_t) { return make(user); },
        [](void *user, uint64_t node) {
            auto &nodes = *static_cast<std::vector<bool> *>(user);
            CHECK(nodes[node]);
            nodes[node] = false;
        },
        nullptr,
        nullptr};
    // Three inputs, and for the rest constants.
    const spherecap_term_t input{add(&alive), 0.0f}, zero{0, 0.0f}, one{0, 1.0f};
    const spherecap_recorded_input_t inputs{SPHERECAP_TECHNIQUE_PROJECTED,
                                            SPHERECAP_HEMISPHERES_FRONT,
                                            zero,
                                            {zero, zero, one},
                                            {input, input, input},
                                            one};
    const std::array<spherecap_term_t, 3> terms{one, zero, zero};
    spherecap_recorded_sample_t sample;
    CHECK(spherecap_record_sample(&recorder, &inputs, terms.data(), &sample) == SPHERECAP_STATUS_OK);
    spherecap_recorded_density_t density;
    CHECK(spherecap_record_pdf_on_sphere(&recorder, &inputs, terms.data(), &density) == SPHERECAP_STATUS_OK);
    uint64_t importance;
    CHECK(spherecap_record_importance(&recorder, &inputs, terms.data(), &importance) == SPHERECAP_STATUS_OK);
    const spherecap_recorded_total_t total{input, one};
    spherecap_total_nodes_t with;
    CHECK(spherecap_record_total(&recorder, terms.data(), &total, &with) == SPHERECAP_STATUS_OK);
    uint64_t probability;
    CHECK(spherecap_record_choice_probability(&recorder, terms.data(), &total, &zero, &probability) ==
          SPHERECAP_STATUS_OK);
    CHECK(std::count(alive.begin(), alive.end(), true) == 1 + 11 + 2 + 1 + 2 + 1);
}

} // namespace

int main() {
    call_everything();
    call_the_batches();
    call_in_double_precision();
    call_the_recorder();
    call_from_two_threads();
}
