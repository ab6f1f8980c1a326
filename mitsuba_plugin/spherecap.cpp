#include <cstring>

#include <mitsuba/core/properties.h>
#include <mitsuba/core/spectrum.h>
#include <mitsuba/core/string.h>
#include <mitsuba/core/warp.h>
#include <mitsuba/render/emitter.h>
#include <mitsuba/render/medium.h>
#include <mitsuba/render/scene.h>
#include <mitsuba/render/shape.h>
#include <mitsuba/render/texture.h>

#include <spherecap.h>

#include "gradients.h"
#include "lights.h"
#include "recorder.h"
#include "sphere.h"
#include "strategy.h"
#include "surfaces.h"

// Mitsuba passes Dr.Jit arrays to plugins by value, and the compiler's flags decide their layout: with wrong
// ones everything links, loads and renders garbage. The flags come from FindMitsubaWheel.cmake.
#if !defined(__SSE4_2__)
#error "The Mitsuba wheel is built with -march=haswell: without it this plugin would render garbage."
#endif
static_assert(sizeof(mitsuba::Vector<float, 3>) == 16 && alignof(mitsuba::Vector<float, 3>) == 16,
              "The Mitsuba wheel pads 3-vectors to 16 bytes: use its flags.");

NAMESPACE_BEGIN(mitsuba)

// clang-format off
/**!

.. _emitter-spherecap:

Sphere light sampled by projected solid angle (:monosp:`spherecap`)
-------------------------------------------------------------------

.. pluginparameters::

 * - radiance
   - |spectrum|
   - Specifies the emitted radiance in units of power per unit area per unit steradian. It must not vary over
     the sphere. (Default: 1)
   - |exposed|, |differentiable|

 * - technique
   - |string|
   - How directions towards the light are chosen. (Default: :monosp:`projected`)

     - :monosp:`projected`: uniformly over the projected solid angle of the visible part of the sphere that
       lies above the surface. Without occlusion a diffuse surface then has no noise.
     - :monosp:`projected_bounded`: the same where the centre of the sphere is above the surface; where it is
       below, a close approximation of it (a warp, with its exact density).
     - :monosp:`solid_angle`: uniformly over the solid angle of the whole visible part, as the
       :ref:`area <emitter-area>` emitter does.

 * - hemispheres
   - |string|
   - Which sides of an illuminated surface receive light from this emitter's samples.
     (Default: :monosp:`auto`)

     - :monosp:`auto`: :monosp:`front`, unless a BSDF of the scene reflects on its back side or transmits
       diffusely or glossily. Until the emitter is part of a scene: :monosp:`both`.
     - :monosp:`front`: only the side of the geometric normal.
     - :monosp:`both`: both sides, each uniformly over its projected solid angle.

 * - defensive
   - |float|
   - Probability, in :math:`[0, 1]`, of sampling the whole visible part by solid angle instead. It bounds the
     noise where the shading normal differs from the geometric one, which an emitter is not told. (Default:
     0 if no mesh of the scene has interpolated normals and no BSDF perturbs them, else 1/8. Until the
     emitter is part of a scene: 1/8)

 * - lights
   - |string|
   - How a light is chosen where a scene has several. (Default: :monosp:`all`)

     - :monosp:`all`: all :monosp:`spherecap` emitters of the scene with the same technique, hemispheres and
       defensive fraction choose among themselves at each point, by what each gives to it without occlusion,
       times its :monosp:`sampling_weight`.
     - :monosp:`one`: by the :monosp:`sampling_weight` alone, as Mitsuba does.

This plugin is a drop-in replacement for the :ref:`area <emitter-area>` emitter on a :ref:`sphere
<shape-sphere>`. It emits the same light, and renders converge to the same image; only the samples are chosen
better, most visibly on diffuse surfaces and near large lights. Like :monosp:`area` it emits diffusely,
outwards only.

.. tabs::
    .. code-tab:: xml
        :name: spherecap-light

        <shape type="sphere">
            <emitter type="spherecap">
                <rgb name="radiance" value="1.0"/>
            </emitter>
        </shape>

    .. code-tab:: python

        'type': 'sphere',
        'emitter': {
            'type': 'spherecap',
            'radiance': {
                'type': 'rgb',
                'value': 1.0,
            }
        }

.. note::
    - The sphere must be scaled uniformly, and its normals must point outwards. It may be moved and scaled
      later through :monosp:`mi.traverse`.
    - Vertices in participating media have no surface, and use :monosp:`solid_angle`.
    - The automatic choices look at the BSDFs and shapes that the scene has when it is created: replacing them
      later calls for explicit parameters. A BSDF that is written in Python is taken for one that may do
      everything: :monosp:`both` and 1/8.
    - Runs in all variants. Where kernels are compiled, moving the light does not compile them again.
    - Derivatives are those of :monosp:`area`, also for integrators that differentiate what they have sampled:
      a sample keeps its place in the cap that the light is seen as, and follows it.

 */
// clang-format on

/// Throws unless the linked library is the one that this file was compiled for. (guard.cpp looks at Mitsuba.)
static const Properties &supported(const Properties &props) {
    if (spherecap_abi_version() != SPHERECAP_ABI)
        throw std::runtime_error("The spherecap plugin was compiled with a header of ABI " +
                                 std::to_string(SPHERECAP_ABI) + " and linked with a library of ABI " +
                                 std::to_string(spherecap_abi_version()) + ": build both again.");
    return props;
}

/// A C enumeration under the names that a scene uses for it.
struct NamedValue {
    const char *name;
    uint32_t value;
};

template <size_t N>
static const NamedValue &choose(const Properties &props, const char *parameter,
                                const NamedValue (&choices)[N]) {
    const std::string name = props.get<std::string>(parameter, choices[0].name);
    std::string list;
    for (const NamedValue &choice : choices) {
        if (name == choice.name)
            return choice;
        list += std::string(list.empty() ? "\"" : ", \"") + choice.name + "\"";
    }
    Throw("The %s \"%s\" of a spherecap emitter is unknown: use one of %s.", parameter, name, list);
}

// The first of each list is the default.
static constexpr NamedValue Techniques[] = {
    {"projected", SPHERECAP_TECHNIQUE_PROJECTED},
    {"projected_bounded", SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED},
    {"solid_angle", SPHERECAP_TECHNIQUE_SOLID_ANGLE},
};
static constexpr uint32_t HemispheresAuto = uint32_t(-1);
static constexpr NamedValue Hemispheres[] = {
    {"auto", HemispheresAuto},
    {"front", SPHERECAP_HEMISPHERES_FRONT},
    {"both", SPHERECAP_HEMISPHERES_BOTH},
};
static constexpr uint32_t LightsAll = 1;
static constexpr NamedValue LightsChoices[] = {{"all", LightsAll}, {"one", 0}};
/// The defensive fraction of scenes with shading normals. Relative RMSE of scenes/smooth_mesh.xml, 64 x 48
/// pixels, 16 samples, light sampling alone: 0.066 at 0, 0.062 at 1/8, 0.060 at 1/4, 0.066 at 1/2 (`area`:
/// 0.093); in the worst pixel 0.76, 0.41, 0.39, 0.36 (`area`: 0.42). The smallest that is nowhere worse than
/// `area`.
static constexpr float DefensiveFraction = 0.125f;

template <typename Float, typename Spectrum>
class SphereCap final : public Emitter<Float, Spectrum> {
public:
    MI_IMPORT_BASE(Emitter, m_flags, m_shape, m_medium, m_sampling_weight)
    MI_IMPORT_TYPES(Scene, Shape, Texture)
    using Sphere = mitsuba::Sphere<Float>;
    using Lights = mitsuba::Lights<Float, Spectrum>;

    // Cold is what a scene runs once, or where it changes: it is compiled for size, once for each variant.
    [[gnu::cold]] SphereCap(const Properties &props) : Base(supported(props)) {
        if (props.has_property("to_world"))
            Throw(
                "A spherecap emitter takes no \"to_world\": it follows its sphere, so transform the sphere.");

        m_radiance = props.get_emissive_texture<Texture>("radiance", 1.f);
        if (m_radiance->is_spatially_varying())
            Throw(
                "The radiance of a spherecap emitter must not vary over the sphere: use the \"area\" emitter "
                "for textured lights.");

        m_technique = choose(props, "technique", Techniques);
        m_hemispheres = choose(props, "hemispheres", Hemispheres);
        m_joins = choose(props, "lights", LightsChoices).value == LightsAll;
        m_defensive_auto = !props.has_property("defensive");
        m_defensive = props.get<ScalarFloat>("defensive", DefensiveFraction);
        if (!(m_defensive >= 0.f && m_defensive <= 1.f))
            Throw("The \"defensive\" fraction of a spherecap emitter is a probability in [0, 1], not %s.",
                  m_defensive);
        // What is given is not asked of the surfaces.
        m_demands.demand(m_hemispheres.value != HemispheresAuto, !m_defensive_auto);

        m_flags = +EmitterFlags::Surface;
    }

    ~SphereCap() override { leave(); }

    void traverse(TraversalCallback *callback) override {
        Base::traverse(callback);
        callback->put("radiance", m_radiance, ParamFlags::Differentiable);
    }

    [[gnu::cold]] void parameters_changed(const std::vector<std::string> &keys) override {
        // A sphere that was moved tells its emitter: "parent".
        if (m_shape && (keys.empty() || string::contains(keys, "parent")))
            m_sphere = Sphere::of(m_shape);
        Base::parameters_changed(keys);
        if (is_grouped()) {
            tell();
            if (keys.empty() || string::contains(keys, "sampling_weight"))
                weigh();
        }
    }

    [[gnu::cold]] void set_shape(Shape *shape) override {
        m_sphere = Sphere::of(shape);
        Base::set_shape(shape);
    }

    [[gnu::cold]] void set_scene(const Scene *scene) override {
        // An emitter that is part of several scenes must satisfy all of them.
        m_demands.look_at(scene);
        m_in_scene = true;
        if (m_joins)
            join(scene);
    }

    Spectrum eval(const SurfaceInteraction3f &si, Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointEvaluate, active);
        return depolarizer<Spectrum>(m_radiance->eval(si, active)) & (Frame3f::cos_theta(si.wi) > 0.f);
    }

    std::pair<Ray3f, Spectrum> sample_ray(Float time, Float wavelength_sample, const Point2f &position_sample,
                                          const Point2f &direction_sample, Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointSampleRay, active);

        auto [ps, area] = sample_position(time, position_sample, active);
        SurfaceInteraction3f si(ps, dr::zeros<Wavelength>());
        auto [wavelengths, radiance] = sample_wavelengths(si, wavelength_sample, active);
        si.time = time;
        si.wavelengths = wavelengths;

        // Cosine-weighted directions: their density and the cosine leave a factor of pi.
        Vector3f local = warp::square_to_cosine_hemisphere(direction_sample);
        Spectrum weight = area * radiance * dr::Pi<ScalarFloat>;
        return {si.spawn_ray(si.to_world(local)), depolarizer<Spectrum>(weight)};
    }

    std::pair<DirectionSample3f, Spectrum> sample_direction(const Interaction3f &it, const Point2f &sample,
                                                            Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointSampleDirection, active);
        if (!attached())
            return {dr::zeros<DirectionSample3f>(), 0.f};

        if (!is_grouped())
            return sample_itself(it, sample, active);
        if constexpr (Lights::HasRadiance)
            if (m_lights->may_share(this, it, sample))
                return m_lights->template shared<std::pair<DirectionSample3f, Spectrum>>(
                    m_lights->samples,
                    [&](const UInt32 &asked) { return sample_group(asked, it, sample, active); }, it, sample,
                    active);
        return sample_group(m_index, it, sample, active);
    }

    Float pdf_direction(const Interaction3f &it, const DirectionSample3f &ds, Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointEvaluate, active);
        if (!attached())
            return 0.f;
        if (!is_grouped())
            return pdf_of(m_sphere, it, ds.d, active);
        if constexpr (Lights::HasRadiance)
            if (m_lights->may_share(this, it, ds.d))
                return m_lights->template shared<Float>(
                    m_lights->densities,
                    [&](const UInt32 &asked) {
                        return pdf_in_group(asked, m_lights->sphere(asked, active), it, ds.d, active);
                    },
                    it.p, it.n, it.t, ds.d, active);
        return pdf_in_group(m_index, m_sphere, it, ds.d, active);
    }

    Spectrum eval_direction(const Interaction3f &it, const DirectionSample3f &ds,
                            Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointEvaluate, active);
        // Samples at the edge are perpendicular to it, up to 2e-6 with the arithmetic of GPUs.
        active &= dr::dot(ds.d, ds.n) < 1e-5f;
        return dr::select(active, depolarizer<Spectrum>(radiance(it, ds, active)), 0.f);
    }

    std::pair<PositionSample3f, Float> sample_position(Float time, const Point2f &sample,
                                                       Mask active) const override {
        MI_MASKED_FUNCTION(ProfilerPhase::EndpointSamplePosition, active);
        if (!attached())
            return {dr::zeros<PositionSample3f>(), 0.f};
        PositionSample3f ps = m_shape->sample_position(time, sample, active);
        return {ps, dr::select(active && ps.pdf > 0.f, dr::rcp(ps.pdf), Float(0.f))};
    }

    std::pair<Wavelength, Spectrum> sample_wavelengths(const SurfaceInteraction3f &si, Float sample,
                                                       Mask active) const override {
        return m_radiance->sample_spectrum(si, math::sample_shifted<Wavelength>(sample), active);
    }

    ScalarBoundingBox3f bbox() const override { return m_shape->bbox(); }

    [[gnu::cold]] std::string to_string() const override {
        std::ostringstream out;
        out << "SphereCap[" << std::endl
            << "  radiance = " << string::indent(m_radiance) << "," << std::endl
            << "  technique = " << m_technique.name << "," << std::endl
            << "  hemispheres = " << (hemispheres() == SPHERECAP_HEMISPHERES_BOTH ? "both" : "front")
            << (m_hemispheres.value == HemispheresAuto ? " (auto)" : "") << "," << std::endl
            << "  defensive = " << defensive() << (m_defensive_auto ? " (auto)" : "") << "," << std::endl
            << "  lights = " << (m_joins ? "all" : "one") << "," << std::endl
            << "  sphere = ";
        if (m_shape) // which may be gone by now: print what was taken over from it
            out << "[center = " << m_sphere.center << ", radius = " << m_sphere.radius << "]";
        else
            out << "<no shape attached!>";
        out << "," << std::endl << "  medium = ";
        if (m_medium)
            out << string::indent(m_medium);
        else
            out << "<no medium attached!>";
        out << std::endl << "]";
        return out.str();
    }

    MI_DECLARE_CLASS(SphereCap)

private:
    /// Is there a sphere to sample? Virtual calls of JIT variants may reach an emitter that has none.
    bool attached() const {
        if constexpr (!dr::is_jit_v<Float>)
            Assert(m_shape, "A spherecap emitter can only be sampled once it belongs to a sphere.");
        return m_shape != nullptr;
    }

    uint32_t hemispheres() const {
        if (m_hemispheres.value != HemispheresAuto)
            return m_hemispheres.value;
        return m_in_scene && !m_demands.both_sides() ? SPHERECAP_HEMISPHERES_FRONT
                                                     : SPHERECAP_HEMISPHERES_BOTH;
    }

    ScalarFloat defensive() const {
        return m_defensive_auto && m_in_scene && !m_demands.shading_normals() ? 0.f : m_defensive;
    }

    Strategy strategy() const { return {m_technique.value, hemispheres(), defensive()}; }

    /// Is this a point of a light's own surface that might be lit from below?
    Mask is_own(const Sphere &sphere, const Interaction3f &it) const {
        if (hemispheres() == SPHERECAP_HEMISPHERES_FRONT && uniform() == 0.f)
            return false;
        return sphere.has(it.p, it.n, it.t);
    }

    /// The probability of a direction that is uniform in solid angle.
    ScalarFloat uniform() const {
        return m_technique.value == SPHERECAP_TECHNIQUE_SOLID_ANGLE ? 1.f : defensive();
    }

    /// The radiance that this light sends back along a direction.
    DRJIT_NOINLINE UnpolarizedSpectrum radiance(const Interaction3f &it, const DirectionSample3f &ds,
                                                const Mask &active) const {
        return m_radiance->eval(SurfaceInteraction3f(ds, it.wavelengths), active);
    }

    /// A sample of this light, which was chosen by whoever asks.
    std::pair<DirectionSample3f, Spectrum> sample_itself(const Interaction3f &it, const Point2f &sample,
                                                         Mask active) const {
        DirectionSample3f ds = sample_of(m_sphere, it, sample, active);
        ds.emitter = this;
        active &= ds.pdf != 0.f;
        return {ds, depolarizer<Spectrum>(radiance(it, ds, active) / ds.pdf) & active};
    }

    /// A sample of one light of the group, the one in this place having been asked.
    DRJIT_NOINLINE std::pair<DirectionSample3f, Spectrum>
    sample_group(const UInt32 &asked, const Interaction3f &it, const Point2f &sample, Mask active) const {
        // Mitsuba has stretched the number to choose the light that it asks: what it was before is one for
        // all.
        const typename Lights::Part part = m_lights->part(asked, active);
        const typename Lights::Choice choice =
            m_lights->choose(strategy(), dr::detach(it.p), dr::detach(it.n),
                             dr::fmadd(part.share, dr::detach(sample.x()), part.before), active);
        active &= choice.probability > 0.f;
        const Sphere sphere = m_lights->sphere(choice.index, active);
        DirectionSample3f ds = sample_of(sphere, it, Point2f(choice.rest, sample.y()), active);
        ds.pdf *= choice.probability * part.inv_share;
        ds.emitter = m_lights->emitter(choice.index, active);
        active &= ds.pdf != 0.f;
        if constexpr (Lights::HasRadiance)
            return {ds, depolarizer<Spectrum>(m_lights->radiance(choice.index, active) / ds.pdf) & active};
        else if (dr::none_or<false>(active))
            return {dr::zeros<DirectionSample3f>(), 0.f};
        else
            return {ds, (ds.emitter->eval_direction(it, ds, active) / ds.pdf) & active};
    }

    /// A direction towards a sphere, attached where it is differentiated; a pdf of zero where there is none.
    DirectionSample3f sample_of(const Sphere &sphere, const Interaction3f &it, const Point2f &sample,
                                const Mask &active) const {
        DirectionSample3f ds = sample_cap(sphere, it, sample, active && !is_own(sphere, it));
        if constexpr (dr::is_diff_v<Float>) {
            if (dr::grad_enabled(it.p, sphere))
                Following<Float>::attach(sphere, it.p, ds.d, ds.dist, ds.p, ds.n, ds.pdf);
        }
        ds.time = it.time;
        return ds;
    }

    /// The density of a direction towards a sphere, likewise.
    Float pdf_of(const Sphere &sphere, const Interaction3f &it, const Vector3f &direction,
                 Mask active) const {
        // Whatever the normal: at the light's edge, where it is perpendicular, it may face away by rounding.
        active &= !is_own(sphere, it);
        Float pdf = dr::select(active, pdf_cap(sphere, it, direction, active), 0.f);
        if constexpr (dr::is_diff_v<Float>) {
            if (dr::grad_enabled(it.p, direction, sphere))
                pdf = Following<Float>::attached_pdf(sphere, it.p, it.n, direction, pdf, uniform());
        }
        return pdf;
    }

    /// The same where the group chooses its light, the one in this place.
    DRJIT_NOINLINE Float pdf_in_group(const UInt32 &asked, const Sphere &sphere, const Interaction3f &it,
                                      const Vector3f &direction, Mask active) const {
        const Float pdf = pdf_of(sphere, it, direction, active);
        active &= pdf != 0.f;
        return pdf * m_lights->probability(strategy(), dr::detach(it.p), dr::detach(it.n), asked, active) *
               m_lights->part(asked, active).inv_share;
    }

    // The functions below are all that differs between the executions of the library's kernel.

    /// A direction towards the light, with the point that it meets first; a pdf of zero where there is none.
    DirectionSample3f sample_cap(const Sphere &sphere, const Interaction3f &it, const Point2f &sample,
                                 Mask active) const {
        DirectionSample3f ds = dr::zeros<DirectionSample3f>();
        if constexpr (dr::is_jit_v<Float>) {
            const Strategy strategy = this->strategy();
            // Several paths are traced at once: where none of them needs a sample any more, the kernel is
            // skipped.
            using Drawn = dr::tuple<Normal3f, Vector3f, Float, Float>;
            const auto inputs = dr::make_tuple(dr::detach(it.n), dr::detach(sphere.center - it.p),
                                               dr::detach(sphere.radius), dr::detach(sample));
            const Drawn drawn = dr::if_stmt(
                inputs, Recorder<Float>::condition(active, dr::width(inputs)),
                [strategy](const Normal3f &normal, const Vector3f &centre, const Float &radius,
                           const Point2f &sample) {
                    using Recorder = mitsuba::Recorder<Float>;
                    const spherecap_term_t u[2] = {Recorder::term(sample.x()), Recorder::term(sample.y())};
                    const spherecap_recorded_input_t input = strategy.recorded(normal, centre, radius);
                    const auto drawn = Recorder().template record<spherecap_recorded_sample_t>(
                        spherecap_record_sample, &input, u);
                    Recorder::mask(drawn.is_sampled); // Else the density is zero.
                    for (uint64_t unused : {drawn.cosine, drawn.density.projected_solid_angle})
                        Recorder::number(unused);
                    return Drawn(Recorder::vector(drawn.normal), Recorder::vector(drawn.direction),
                                 Recorder::number(drawn.distance),
                                 Recorder::number(drawn.density.solid_angle));
                },
                [](const Normal3f &, const Vector3f &, const Float &, const Point2f &) {
                    return Drawn(0.f, 0.f, 0.f, 0.f);
                },
                "spherecap sample");
            ds.n = dr::get<0>(drawn);
            ds.d = dr::get<1>(drawn);
            ds.dist = dr::get<2>(drawn);
            ds.pdf = dr::get<3>(drawn);
        } else {
            spherecap_sample_t drawn;
            const spherecap_receiver_t receiver = strategy().receiver(it.n);
            const Vector3f c = sphere.center - it.p;
            const float center[3] = {c.x(), c.y(), c.z()};
            if (!active || spherecap_sample_once(&receiver, center, sphere.radius, sample.x(), sample.y(),
                                                 &drawn) != SPHERECAP_STATUS_OK)
                return ds;
            ds.n = Normal3f(drawn.normal[0], drawn.normal[1], drawn.normal[2]);
            ds.d = Vector3f(drawn.direction[0], drawn.direction[1], drawn.direction[2]);
            ds.dist = drawn.distance;
            ds.pdf = drawn.density.solid_angle;
        }
        ds.p = sphere.point(ds.n);
        return ds;
    }

    /// The density with which `sample_cap` chooses a direction that is known to meet the sphere.
    Float pdf_cap(const Sphere &sphere, const Interaction3f &it, const Vector3f &direction,
                  Mask active) const {
        if constexpr (dr::is_jit_v<Float>) {
            const Strategy strategy = this->strategy();
            // Likewise: few rays meet the light by chance.
            const auto inputs = dr::make_tuple(dr::detach(it.n), dr::detach(sphere.center - it.p),
                                               dr::detach(sphere.radius), dr::detach(direction));
            return dr::if_stmt(
                inputs, Recorder<Float>::condition(active, dr::width(inputs)),
                [strategy](const Normal3f &normal, const Vector3f &centre, const Float &radius,
                           const Vector3f &direction) {
                    using Recorder = mitsuba::Recorder<Float>;
                    spherecap_term_t d[3];
                    Recorder::terms(direction, d);
                    const spherecap_recorded_input_t input = strategy.recorded(normal, centre, radius);
                    const auto density = Recorder().template record<spherecap_recorded_density_t>(
                        spherecap_record_pdf_on_sphere, &input, d);
                    Recorder::number(density.projected_solid_angle);
                    return Recorder::number(density.solid_angle);
                },
                [](const Normal3f &, const Vector3f &, const Float &, const Vector3f &) {
                    return Float(0.f);
                },
                "spherecap pdf");
        } else {
            spherecap_density_t density;
            const spherecap_receiver_t receiver = strategy().receiver(it.n);
            const Vector3f c = sphere.center - it.p;
            const float center[3] = {c.x(), c.y(), c.z()};
            const float d[3] = {direction.x(), direction.y(), direction.z()};
            if (!active ||
                spherecap_pdf_once(&receiver, center, sphere.radius, d, &density) != SPHERECAP_STATUS_OK)
                return 0.f;
            return density.solid_angle;
        }
    }

    // The lights that choose among themselves.

    bool is_grouped() const { return m_lights && m_lights->is_complete(); }

    /// The first light of a scene makes the group of those that sample as it does.
    [[gnu::cold]] void join(const Scene *scene) {
        if (m_scene && m_scene != scene) {
            // It cannot know which of its scenes asks.
            leave();
            m_joins = false;
            return;
        }
        m_scene = scene;
        std::vector<SphereCap *> members;
        for (const auto &emitter : scene->emitters())
            if (auto *other = dynamic_cast<SphereCap *>(const_cast<Base *>(emitter.get())))
                if (other->samples_as(*this) && (!other->m_scene || other->m_scene == scene))
                    members.push_back(other);
        if (members.size() < 2 || members.front() != this)
            return;
        const ref<Lights> lights = new Lights({members.begin(), members.end()});
        for (size_t i = 0; i < members.size(); ++i) {
            members[i]->leave();
            members[i]->m_lights = lights;
            members[i]->m_place = i;
            members[i]->m_index = dr::opaque<UInt32>(uint32_t(i));
            members[i]->m_colleagues = members;
            members[i]->tell();
        }
        weigh();
    }

    bool samples_as(const SphereCap &other) const {
        return m_joins && other.m_joins && m_technique.value == other.m_technique.value &&
               m_hemispheres.value == other.m_hemispheres.value && m_defensive == other.m_defensive &&
               m_defensive_auto == other.m_defensive_auto;
    }

    void leave() {
        if (m_lights)
            m_lights->dissolve();
    }

    /// Tells the group what this light is now.
    [[gnu::cold]] void tell() {
        SurfaceInteraction3f si = dr::zeros<SurfaceInteraction3f>();
        const UnpolarizedSpectrum radiance = m_radiance->eval(si, true);
        Float strength = 0.f;
        bool may_be_black = true;
        if constexpr (is_spectral_v<Spectrum>) {
            // Here and there, 15 nanometres apart. In between there may be a line.
            constexpr size_t Lines = 32, Width = dr::size_v<Wavelength>;
            for (size_t i = 0; i < Lines; i += Width) {
                for (size_t j = 0; j < Width; ++j)
                    si.wavelengths[j] = 360.f + 15.f * ScalarFloat(i + j);
                strength += dr::mean(dr::abs(dr::detach(m_radiance->eval(si, true))));
            }
            may_be_black = false;
        } else if constexpr (is_rgb_v<Spectrum>) {
            strength = luminance(UnpolarizedSpectrum(dr::abs(dr::detach(radiance))));
        } else {
            strength = dr::mean(dr::abs(dr::detach(radiance)));
        }
        if constexpr (dr::is_diff_v<Float>)
            may_be_black &= !dr::grad_enabled(radiance); // else it is sampled to find out what it should be
        // However little: it then has a part in what is shared evenly.
        if (!may_be_black)
            strength = dr::maximum(strength, 1e-20f);
        m_lights->update(m_place, m_index, m_sphere, radiance, strength * m_sampling_weight);
    }

    /// Tells it how often Mitsuba asks for each.
    void weigh() {
        std::vector<float> weights;
        for (const SphereCap *member : m_colleagues)
            weights.push_back(member->m_sampling_weight);
        m_lights->weigh(weights);
    }

    ref<Texture> m_radiance;
    Sphere m_sphere;

    NamedValue m_technique, m_hemispheres;
    ScalarFloat m_defensive;
    bool m_defensive_auto;

    bool m_in_scene = false;
    SurfaceDemands<Float, Spectrum> m_demands;

    bool m_joins;
    const Scene *m_scene = nullptr;
    ref<Lights> m_lights;
    std::vector<SphereCap *> m_colleagues;
    size_t m_place = 0;
    /// The place, where kernels are compiled in memory
    UInt32 m_index = 0;

    MI_TRAVERSE_CB(Base, m_radiance, m_sphere, m_lights, m_index)
};

MI_EXPORT_PLUGIN(SphereCap)
NAMESPACE_END(mitsuba)
