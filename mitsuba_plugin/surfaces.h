/* What the surfaces of a scene demand of a light's sampler.

   A light is told the geometric normal of the point that it illuminates, but neither which side of the
   surface is being shaded nor the shading normal. Both are properties of the scene, so the light looks once,
   when it is attached to its scene. Later changes of a BSDF or a mesh reach no emitter.

   What cannot be known is demanded: too much costs some noise, too little loses light. */

#pragma once

#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/scene.h>
#include <mitsuba/render/shape.h>

#include "compat.h"

NAMESPACE_BEGIN(mitsuba)

template <typename Float, typename Spectrum>
class SurfaceDemands final : private TraversalCallback {
public:
    MI_IMPORT_TYPES(Scene, Shape, BSDF)

    /// Some surface scatters light that arrives below its geometric normal.
    bool both_sides() const { return m_both_sides; }

    /// Some surface is shaded with another normal than its geometric one.
    bool shading_normals() const { return m_shading_normals; }

    /// Demands one or the other whatever the surfaces are, which are then not asked about it.
    void demand(bool both_sides, bool shading_normals) {
        m_both_sides |= both_sides;
        m_shading_normals |= shading_normals;
    }

    [[gnu::cold]] void look_at(const Scene *scene) {
        for (ref<Shape> shape : scene->shapes())
            look_at(shape.get());
        // An instance has a BSDF that is never used; the shapes that it repeats are in the groups.
        for (Object *shape : GroupedShapes::in(const_cast<Scene *>(scene)))
            look_at(static_cast<Shape *>(shape));
    }

private:
    using MeshFloats = DynamicBuffer<dr::replace_scalar_t<Float, float>>;
    using MeshIndices = DynamicBuffer<dr::uint32_array_t<Float>>;
    using InputVector3f = Vector<float, 3>;

    void look_at(Shape *shape) {
        if (m_both_sides && m_shading_normals)
            return;

        // `sdfgrid` does not tell whether it interpolates its normals: assume that it does.
        m_shading_normals |= shape->shape_type() == +ShapeType::SDFGrid;

        // The parameters of a shape are its BSDF and, if it is a mesh, its normals. (The wheel's
        // `render/mesh.h`, where a mesh would answer directly, includes a file that the wheel lacks.)
        m_faces = nullptr;
        m_positions = m_normals = nullptr;
        shape->traverse(this);
        if (m_faces && m_positions && m_normals)
            compare_normals();
    }

    void look_at(BSDF *bsdf) {
        // One that is written in Python has no class name of its own. What it says of itself may be
        // incomplete or wrong without Mitsuba noticing, and its `traverse` may want another kind of callback.
        if (bsdf->class_name() == BSDF::ClassName) {
            demand(true, true);
            return;
        }

        uint32_t listed = 0;
        for (size_t i = 0; i < bsdf->component_count(); ++i) {
            listed |= bsdf->flags(i);
            m_both_sides |= is_lit_from_behind(bsdf->flags(i));
        }
        // Mitsuba itself reads the flags of the whole.
        constexpr uint32_t Lobes = BSDFFlags::All | BSDFFlags::FrontSide | BSDFFlags::BackSide;
        if ((bsdf->flags() & ~listed & Lobes) != 0)
            m_both_sides |= is_lit_from_behind(bsdf->flags());

        // No flag tells these two from the BSDF that they wrap.
        m_shading_normals |= bsdf->class_name() == "BumpMap" || bsdf->class_name() == "NormalMap";

        // The BSDFs that it is made of
        bsdf->traverse(this);
    }

    /// Only smooth lobes are lit by emitter sampling. `Null`, a part of `Transmission`, is not among them, so
    /// media boundaries, masks and clear glass demand nothing.
    static bool is_lit_from_behind(uint32_t flags) {
        constexpr uint32_t Transmission = BSDFFlags::DiffuseTransmission | BSDFFlags::GlossyTransmission;
        return has_flag(flags, BSDFFlags::Smooth) &&
               (has_flag(flags, BSDFFlags::BackSide) || (flags & Transmission) != 0);
    }

    void put_value(std::string_view name, void *value, uint32_t, const std::type_info &type) override {
        if (name == "faces" && type == typeid(MeshIndices))
            m_faces = static_cast<const MeshIndices *>(value);
        else if (name == "vertex_positions" && type == typeid(MeshFloats))
            m_positions = static_cast<const MeshFloats *>(value);
        else if (name == "vertex_normals" && type == typeid(MeshFloats))
            m_normals = static_cast<const MeshFloats *>(value);
    }

    void put_object(std::string_view, Object *object, uint32_t) override {
        if (object && object->type() == ObjectType::BSDF)
            look_at(static_cast<BSDF *>(object));
    }

    /// Looks for a vertex normal of a mesh that is not the normal of its triangle: boxes, and most files of
    /// flat meshes, have vertex normals that change nothing.
    [[gnu::cold]] void compare_normals() {
        // 0.6 degrees, more than the rounding of normals in text files. A smaller angle changes the weight of
        // a sample by less than 0.01/cos, which is large only where the surface is dark.
        constexpr float SameNormal = 1.f - 0.5f * 0.01f * 0.01f;

        // Where the variant compiles kernels, the buffers may be on a device.
        auto &&faces = dr::migrate(*m_faces, HostMemory);
        auto &&positions = dr::migrate(*m_positions, HostMemory);
        auto &&normals = dr::migrate(*m_normals, HostMemory);
        if constexpr (dr::is_jit_v<Float>)
            dr::sync_thread();
        if (dr::width(normals) != dr::width(positions))
            return; // no vertex normals: an empty buffer

        for (size_t i = 0; i + 2 < dr::width(faces); i += 3) {
            const uint32_t *corner = faces.data() + i;
            const InputVector3f p = vector(positions.data() + 3 * corner[0]);
            const InputVector3f normal = dr::normalize(dr::cross(
                vector(positions.data() + 3 * corner[1]) - p, vector(positions.data() + 3 * corner[2]) - p));
            for (size_t j = 0; j < 3; ++j) {
                const InputVector3f shaded = dr::normalize(vector(normals.data() + 3 * corner[j]));
                const float cosine = dr::dot(normal, shaded);
                // Comparisons are false for degenerate triangles, whose normal is NaN.
                m_shading_normals |= cosine < SameNormal;
                // Normals against the winding (mirrored meshes): what is lit lies below the geometric normal.
                m_both_sides |= cosine < 0.f;
            }
            if (m_both_sides && m_shading_normals)
                return;
        }
    }

    /// Three floats. (`dr::load` would read a fourth.)
    static InputVector3f vector(const float *v) { return {v[0], v[1], v[2]}; }

    bool m_both_sides = false;
    bool m_shading_normals = false;

    // Of the mesh that is being looked at
    const MeshIndices *m_faces = nullptr;
    const MeshFloats *m_positions = nullptr;
    const MeshFloats *m_normals = nullptr;
};

NAMESPACE_END(mitsuba)
