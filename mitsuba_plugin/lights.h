/* The spherecap lights of a scene, which choose among themselves at each point by what each gives to it.

   Mitsuba chooses emitter i with a probability p_i that is the same everywhere, asks it for a sample, and
   multiplies the density by p_i and the weight by 1 / p_i. So a light may answer for a group of them: with a
   sample of light j, chosen with probability q_j at this point, and the density P / p_i q_j pdf_j, where P is
   the sum of p over the group. Whichever light was asked, the density is P q_j pdf_j in total. Asked for the
   density of one of its own directions, light j answers P / p_j q_j pdf_j, which gives the same.

   Where kernels are compiled, nothing here may depend on how many lights there are or on which is asked: then
   they share one compiled function. So what is known of them is in tables. */

#pragma once

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include <drjit/while_loop.h>
#include <mitsuba/core/object.h>
#include <mitsuba/render/emitter.h>

#include "recorder.h"
#include "sphere.h"
#include "strategy.h"

NAMESPACE_BEGIN(mitsuba)

/// An answer that all lights of a group give alike. In a virtual call Dr.Jit records the program of each in
/// turn, and all with the same inputs: what the first has recorded is the others' as well.
class Recorded {
public:
    template <typename Answer, typename Body, typename... Inputs>
    Answer get(bool is_last, const Body &body, const Inputs &...inputs) {
        const std::lock_guard<std::mutex> guard(m_mutex);
        Variables asked;
        (dr::detail::collect_indices<true>(inputs, asked), ...);
        Answer answer;
        if (is_known(asked)) {
            dr::detail::update_indices(answer, m_answer);
        } else {
            answer = body();
            m_inputs.release();
            m_answer.release();
            m_inputs = std::move(asked);
            dr::detail::collect_indices<true>(answer, m_answer);
        }
        if (is_last) { // Nothing of a recording outlives it.
            m_inputs.release();
            m_answer.release();
        }
        return answer;
    }

private:
    /// They are kept, so none is freed and its number used anew.
    using Variables = dr::detail::index64_vector;

    bool is_known(const Variables &asked) const { return asked == m_inputs; }

    std::mutex m_mutex;
    Variables m_inputs, m_answer;
};

/// The places of lights by the numbers that Dr.Jit has given them, of which the last is the largest.
inline std::vector<uint32_t> places_of(const void *const *lights, size_t count) {
    std::vector<uint32_t> places;
    for (size_t place = 0; place < count; ++place) {
        const size_t id = jit_registry_id(lights[place]);
        if (places.size() <= id)
            places.resize(id + 1);
        places[id] = uint32_t(place);
    }
    return places;
}

/// Four numbers for each light: `Lights::Part`, and a zero.
inline std::vector<float> parts_of(const std::vector<float> &weights) {
    float sum = 0.f, before = 0.f;
    for (const float weight : weights)
        sum += weight;
    std::vector<float> parts(4 * weights.size());
    for (size_t i = 0; i < weights.size(); ++i) {
        // One without a weight is never asked for a sample, and no other light answers with one of its own.
        if (weights[i] > 0.f) {
            parts[4 * i] = weights[i] / sum;
            parts[4 * i + 1] = sum / weights[i];
            parts[4 * i + 2] = before / sum;
        }
        before += weights[i];
    }
    return parts;
}

template <typename Float, typename Spectrum>
class Lights final : public Object {
public:
    MI_IMPORT_TYPES(Emitter, EmitterPtr)
    using Sphere = mitsuba::Sphere<Float>;

    /// One of them: which, with what probability (0: none gives anything), and what is left of the random
    /// number.
    struct Choice {
        UInt32 index;
        Float probability, rest;
    };

    /// Mitsuba's random number, shared out among all lights by the weights that it chooses them with: the
    /// part of it for which it asks a light, its reciprocal (0 without a weight), and where it begins.
    struct Part {
        Float share, inv_share, before;
    };

    [[gnu::cold]] explicit Lights(const std::vector<const Emitter *> &members) : m_count(members.size()) {
        if constexpr (dr::is_jit_v<Float>) {
            m_geometry = dr::zeros<Table>(4 * m_count);
            m_strength = dr::zeros<Table>(m_count);
            m_radiance = dr::zeros<Table>(Channels * m_count);
            m_members = dr::load<DynamicBuffer<EmitterPtr>>(members.data(), m_count);
            m_attached.resize(m_count);
            const std::vector<uint32_t> places = places_of((const void *const *)members.data(), m_count);
            m_last = uint32_t(places.size()) - 1;
            m_places = dr::load<DynamicBuffer<UInt32>>(places.data(), places.size());
            dr::eval(m_geometry, m_strength, m_radiance, m_members, m_places);
        } else {
            m_members = members;
            for (Numbers &numbers : m_numbers)
                numbers.resize(m_count);
        }
    }

    /// May they answer for each other? Not once one of them is gone, or belongs to another scene, too.
    bool is_complete() const { return m_is_complete; }
    void dissolve() { m_is_complete = false; }

    /// Tells what the light in a place is now.
    void update(size_t place, const UInt32 &index, const Sphere &sphere, const UnpolarizedSpectrum &radiance,
                const Float &strength) {
        if constexpr (dr::is_jit_v<Float>) {
            // What is differentiated is attached below, and what was before is let go.
            m_geometry = dr::detach(m_geometry);
            m_radiance = dr::detach(m_radiance);
            store(index, dr::detach(sphere), dr::detach(radiance));
            dr::scatter(m_strength, dr::detach(strength), index);
            m_attached[place] = {index, sphere, radiance};
            for (const Attached &light : m_attached)
                if (dr::grad_enabled(light.sphere, light.radiance))
                    store(light.index, light.sphere, light.radiance);
        } else {
            const float numbers[5] = {sphere.center.x(), sphere.center.y(), sphere.center.z(), sphere.radius,
                                      strength};
            for (size_t i = 0; i < 5; ++i)
                m_numbers[i][place] = numbers[i];
        }
    }

    /// Tells the weights that Mitsuba chooses the lights with.
    [[gnu::cold]] void weigh(const std::vector<float> &weights) {
        const std::vector<float> parts = parts_of(weights);
        if constexpr (dr::is_jit_v<Float>) {
            m_parts = dr::load<Table>(parts.data(), parts.size());
            dr::eval(m_parts);
        } else {
            m_parts = parts;
        }
    }

    Part part(const UInt32 &index, const Mask &active) const {
        if constexpr (dr::is_jit_v<Float>) {
            const auto row = dr::gather<dr::Array<Float, 4>>(m_parts, index, active);
            return {row[0], row[1], row[2]};
        } else {
            const float *row = &m_parts[4 * index];
            return {row[0], row[1], row[2]};
        }
    }

    Sphere sphere(const UInt32 &index, const Mask &active) const {
        if constexpr (dr::is_jit_v<Float>) {
            const auto row = dr::gather<dr::Array<Float, 4>>(m_geometry, index, active);
            return {Point3f(row[0], row[1], row[2]), row[3]};
        } else {
            return {Point3f(m_numbers[0][index], m_numbers[1][index], m_numbers[2][index]),
                    m_numbers[3][index]};
        }
    }

    EmitterPtr emitter(const UInt32 &index, const Mask &active) const {
        if constexpr (dr::is_jit_v<Float>)
            return dr::gather<EmitterPtr>(m_members, index, active);
        else
            return active ? m_members[index] : nullptr;
    }

    /// Is the radiance in a table? A spectral one depends on wavelengths, and has to be asked for.
    static constexpr bool HasRadiance = dr::is_jit_v<Float> && !is_spectral_v<Spectrum>;

    UnpolarizedSpectrum radiance(const UInt32 &index, const Mask &active) const {
        UnpolarizedSpectrum result(0.f);
        if constexpr (HasRadiance)
            for (uint32_t i = 0; i < Channels; ++i)
                result[i] = dr::gather<Float>(m_radiance, Channels * index + i, active);
        return result;
    }

    /// Chooses a light for a point with a random number in [0, 1].
    Choice choose(const Strategy &strategy, const Point3f &p, const Normal3f &n, const Float &u,
                  const Mask &active) const {
        if constexpr (dr::is_jit_v<Float>) {
            const SymbolicLoops guard;
            const Total total = this->total(strategy, p, n, active);
            // The last light that gives something takes what rounding leaves.
            UInt32 index = 0, next = 0;
            Float below = 0.f, share = 0.f, rest = 0.f;
            Mask searching = active && total.sum > 0.f;
            dr::tie(index, next, below, share, rest, searching) = dr::while_loop(
                dr::make_tuple(index, next, below, share, rest, searching),
                [](const UInt32 &, const UInt32 &, const Float &, const Float &, const Float &,
                   const Mask &searching) { return searching; },
                [&](UInt32 &index, UInt32 &next, Float &below, Float &share, Float &rest, Mask &searching) {
                    const Float own = total.share(importance(strategy, p, n, next, searching));
                    const Mask is_lit = searching && own > 0.f;
                    dr::masked(index, is_lit) = next;
                    dr::masked(share, is_lit) = own;
                    dr::masked(rest, is_lit) = (u - below) / own;
                    dr::masked(below, is_lit) = below + own;
                    next += 1;
                    searching &= !(is_lit && u < below) && next < uint32_t(m_count);
                },
                "spherecap choice");
            return {index, share, dr::clip(rest, 0.f, 1.f)};
        } else {
            spherecap_choice_t choice{};
            if (active) {
                const Known known(*this, strategy, p, n);
                spherecap_choose(known.importances, m_count, &known.total, Even, u, &choice);
            }
            return {uint32_t(choice.index), choice.probability, choice.rest};
        }
    }

    /// The probability with which `choose` gives this light.
    Float probability(const Strategy &strategy, const Point3f &p, const Normal3f &n, const UInt32 &index,
                      const Mask &active) const {
        if constexpr (dr::is_jit_v<Float>) {
            const SymbolicLoops guard;
            const Total total = this->total(strategy, p, n, active);
            return total.share(importance(strategy, p, n, index, active));
        } else {
            float probability = 0.f;
            if (active) {
                const Known known(*this, strategy, p, n);
                spherecap_choice_probability(known.importances[index], &known.total, Even, &probability);
            }
            return probability;
        }
    }

    /// Is a virtual call recorded that has reached this light, and whose answers all lights may share? Not
    /// what is differentiated, and no spectral radiance, which each has of its own.
    template <typename... Inputs>
    bool may_share(const Emitter *light, const Inputs &...inputs) const {
        if constexpr (HasRadiance) {
            const auto [id, self] = asked();
            return jit_flag(JitFlag::SymbolicScope) && id != 0 && id == jit_registry_id(light) &&
                   !dr::grad_enabled(m_geometry, m_radiance, inputs...);
        } else {
            return false;
        }
    }

    /// The answer that they share, of a function of the place of the light that is asked.
    template <typename Answer, typename Body, typename... Inputs>
    Answer shared(Recorded &recorded, const Body &body, const Inputs &...inputs) const {
        const auto [id, self] = asked();
        const UInt32 light = UInt32::borrow(self);
        return recorded.get<Answer>(
            id == m_last, [&] { return body(dr::gather<UInt32>(m_places, light)); }, inputs...);
    }

    mutable Recorded samples, densities;

    MI_DECLARE_CLASS(Lights)

private:
    /// The light that is asked for, where virtual calls are recorded: which it is, and the variable that says
    /// so for all of them.
    static std::pair<uint32_t, uint32_t> asked() {
        std::pair<uint32_t, uint32_t> result;
        jit_var_self(dr::backend_v<Float>, &result.first, &result.second);
        return result;
    }

    using Table = DynamicBuffer<Float>;
    static constexpr uint32_t Channels = dr::size_v<UnpolarizedSpectrum>;

    /// The part of the probability that all lights share that give anything, however little: it bounds the
    /// noise where the brightest of them is hidden. Variance of `area` over ours in scenes of `make lights`:
    /// with 0.02, 12.3 for 2 lights, 78.7 for 10, and 0.18 with the bright ones behind a wall; with
    /// 0.05, 10.9, 68.3 and 0.23.
    static constexpr float Even = 0.05f;

    /// Within a virtual call, say, loops can only be symbolic, and Dr.Jit warns where Mitsuba has asked for
    /// the other kind. It does so for loops that are differentiated, as these are not.
    struct SymbolicLoops {
        dr::scoped_set_flag guard{JitFlag::SymbolicLoops,
                                  jit_flag(JitFlag::SymbolicLoops) || jit_flag(JitFlag::SymbolicScope)};
    };

    /// What all lights give to a point, and how many do.
    struct Total {
        Float sum, lit;

        spherecap_recorded_total_t recorded() const {
            return {Recorder<Float>::term(sum), Recorder<Float>::term(lit)};
        }

        void add(const Float &importance) {
            const spherecap_term_t term = Recorder<Float>::term(importance);
            const spherecap_recorded_total_t total = recorded();
            const auto with = Recorder<Float>().template record<spherecap_total_nodes_t>(
                spherecap_record_total, &term, &total);
            sum = Recorder<Float>::number(with.sum);
            lit = Recorder<Float>::number(with.lit);
        }

        Float share(const Float &importance) const {
            const spherecap_term_t term = Recorder<Float>::term(importance),
                                   even = Recorder<Float>::term(Even);
            const spherecap_recorded_total_t total = recorded();
            return Recorder<Float>::number(Recorder<Float>().template record<uint64_t>(
                spherecap_record_choice_probability, &term, &total, &even));
        }
    };

    Total total(const Strategy &strategy, const Point3f &p, const Normal3f &n, const Mask &active) const {
        UInt32 index = 0;
        Float sum = 0.f, lit = 0.f;
        dr::tie(index, sum, lit) = dr::while_loop(
            dr::make_tuple(index, sum, lit),
            [&](const UInt32 &index, const Float &, const Float &) {
                return active && index < uint32_t(m_count);
            },
            [&](UInt32 &index, Float &sum, Float &lit) {
                Total total{sum, lit};
                total.add(importance(strategy, p, n, index, active));
                sum = total.sum;
                lit = total.lit;
                index += 1;
            },
            "spherecap lights");
        return {sum, lit};
    }

    Float importance(const Strategy &strategy, const Point3f &p, const Normal3f &n, const UInt32 &index,
                     const Mask &active) const {
        const Sphere light = dr::detach(sphere(index, active));
        const Vector3f centre = light.center - p;
        const Float strength = dr::gather<Float>(m_strength, index, active);
        const spherecap_term_t term = Recorder<Float>::term(strength);
        const spherecap_recorded_input_t input = strategy.recorded(n, centre, light.radius);
        return Recorder<Float>::number(
            Recorder<Float>().template record<uint64_t>(spherecap_record_importance, &input, &term));
    }

    void store(const UInt32 &index, const Sphere &sphere, const UnpolarizedSpectrum &radiance) {
        for (uint32_t i = 0; i < 3; ++i)
            dr::scatter(m_geometry, sphere.center[i], 4 * index + i);
        dr::scatter(m_geometry, sphere.radius, 4 * index + 3);
        if constexpr (HasRadiance)
            for (uint32_t i = 0; i < Channels; ++i)
                dr::scatter(m_radiance, radiance[i], Channels * index + i);
    }

    // Where points are shaded one by one, arrays; else tables, and the numbers of lights that are
    // differentiated.
    using Numbers = std::vector<float>;

    /// What a point knows of its lights, in memory that is used again for the next.
    struct Known {
        Known(const Lights &lights, const Strategy &strategy, const Point3f &p, const Normal3f &n) {
            static thread_local Numbers memory;
            memory.resize(std::max(memory.size(), lights.m_count));
            importances = memory.data();
            const auto &[x, y, z, radius, strength] = lights.m_numbers;
            const spherecap_lights_t arrays{
                lights.m_count, {x.data(), y.data(), z.data()}, radius.data(), strength.data()};
            const spherecap_receiver_t receiver = strategy.receiver(n);
            const float point[3] = {p.x(), p.y(), p.z()};
            spherecap_importances(&receiver, point, &arrays, importances, &total);
        }

        float *importances;
        spherecap_total_t total;
    };

    struct Attached {
        UInt32 index;
        Sphere sphere;
        UnpolarizedSpectrum radiance;
    };

    const size_t m_count;
    bool m_is_complete = true;
    Numbers m_numbers[5];
    Table m_geometry, m_strength, m_radiance;
    std::conditional_t<dr::is_jit_v<Float>, Table, std::vector<float>> m_parts;
    std::vector<Attached> m_attached;
    /// The places of lights by their numbers in Dr.Jit, and the last of those.
    DynamicBuffer<UInt32> m_places;
    uint32_t m_last = 0;
    std::conditional_t<dr::is_jit_v<Float>, DynamicBuffer<EmitterPtr>, std::vector<const Emitter *>>
        m_members;

    MI_TRAVERSE_CB(Object, m_geometry, m_strength, m_radiance, m_parts, m_places, m_members)
};

NAMESPACE_END(mitsuba)
