/* The sphere that a light is attached to, and what moves with it.

   A shape has no accessors for its centre and its radius, so the light takes them from its transformation
   whenever that changes. */

#pragma once

#include <mitsuba/core/transform.h>
#include <mitsuba/render/interaction.h>
#include <mitsuba/render/shape.h>

NAMESPACE_BEGIN(mitsuba)

/// Finds the transformation of a shape, which has no accessor, among its parameters.
template <typename Transform>
class FindToWorld final : public TraversalCallback {
public:
    static const Transform *in(Object *shape) {
        FindToWorld visitor;
        shape->traverse(&visitor);
        return visitor.m_to_world;
    }

private:
    void put_value(std::string_view name, void *value, uint32_t, const std::type_info &type) override {
        if (name == "to_world" && type == typeid(Transform))
            m_to_world = static_cast<const Transform *>(value);
    }
    void put_object(std::string_view, Object *, uint32_t) override {}

    const Transform *m_to_world = nullptr;
};

/// A sphere in world space.
template <typename Float>
struct Sphere {
    using Mask = dr::mask_t<Float>;
    using Point3f = Point<Float, 3>;
    using Vector3f = Vector<Float, 3>;
    using Normal3f = Normal<Float, 3>;
    using ScalarFloat = dr::scalar_t<Float>;
    using AffineTransform4f = AffineTransform<Point<Float, 4>>;

    Point3f center = 0.f;
    Float radius = 0.f;

    DRJIT_STRUCT(Sphere, center, radius)

    /// The sphere that a shape is; throws unless it is one that emits outwards.
    template <typename Shape>
    static Sphere of(Shape *shape) {
        if (shape->shape_type() != +ShapeType::Sphere)
            Throw("A spherecap emitter must be attached to a \"sphere\", not to a shape of class %s: use the "
                  "\"area\" emitter for other shapes.",
                  shape->class_name());
        if (shape->has_flipped_normals())
            Throw("The sphere of a spherecap emitter must not have flipped normals (\"flip_normals\", or a "
                  "mirroring \"to_world\"): remove the flip, or use the \"area\" emitter.");
        const AffineTransform4f *to_world = FindToWorld<AffineTransform4f>::in(shape);
        if (!to_world)
            Throw("The \"sphere\" of this Mitsuba has no parameter \"to_world\".");
        return transformed(*to_world);
    }

    /// The point with this unit normal.
    Point3f point(const Normal3f &normal) const {
        // Relative to the sphere, not to whoever sees it, so that the rounding does not grow with the
        // distance.
        return dr::fmadd(Vector3f(normal), radius, center);
    }

    /// Whether a point with a normal, found at a distance t along a ray, is of the sphere's own surface. Such
    /// a point sees nothing of the sphere; but where rounding has moved it outwards, almost half of all
    /// directions would meet the sphere, from below.
    ///
    /// Its normal tells: the centre is exactly below it. What separates it from the points of a floor that
    /// the sphere touches from below is that of those only the touching point, to its rounding, has that.
    Mask has(const Point3f &p, const Normal3f &n, const Float &t) const {
        // A point of the sphere is off to the side by the rounding of coordinates, and off upwards by that of
        // distances: by 3.3 and 1.2 epsilon of these lengths, among 10 million points of spheres of every
        // size, in every place and seen from everywhere.
        const Float length = dr::max(dr::abs(center)) + radius,
                    far = length + dr::select(dr::isfinite(t), t, 0.f);
        const ScalarFloat tolerance = 8.f * dr::Epsilon<ScalarFloat>;
        const Vector3f offset = p - center;
        const Float height = dr::dot(offset, n);
        return dr::max(dr::abs(offset - height * n)) <= tolerance * length &&
               dr::abs(height - radius) <= tolerance * far;
    }

private:
    /// The unit sphere, transformed.
    static Sphere transformed(const AffineTransform4f &to_world) {
        using ScalarPoint3f = Point<ScalarFloat, 3>;
        using ScalarVector3f = Vector<ScalarFloat, 3>;

        // On the host, where the shape itself needs its transformation: no kernel is compiled or waited for.
        const auto host = dr::slice<AffineTransform<Point<ScalarFloat, 4>>>(to_world);
        const ScalarVector3f axes[3] = {host * ScalarVector3f(1.f, 0.f, 0.f),
                                        host * ScalarVector3f(0.f, 1.f, 0.f),
                                        host * ScalarVector3f(0.f, 0.f, 1.f)};
        const ScalarFloat length = dr::norm(axes[0]);

        // Rounding in a product of a few transformations is of order 1e-6; a difference of 1e-4 changes the
        // light by 2e-4, which no image shows.
        const ScalarFloat tolerance = 1e-4f * length;
        bool uniform = length > 0.f && dr::isfinite(length);
        for (size_t i = 0; i < 3; ++i)
            uniform &= dr::abs(dr::norm(axes[i]) - length) <= tolerance &&
                       dr::abs(dr::dot(axes[i], axes[(i + 1) % 3])) <= tolerance * length;
        if (!uniform)
            Throw("The sphere of a spherecap emitter must have a positive radius and a uniformly scaled "
                  "\"to_world\", without shear: use the \"area\" emitter on a mesh for ellipsoids.");

        // Each number in memory of its own, also where two are equal: kernels that are compiled for one place
        // of the light then serve for all.
        const ScalarPoint3f origin = host * ScalarPoint3f(0.f);
        Sphere sphere;
        sphere.radius = dr::opaque<Float>(length);
        for (size_t i = 0; i < 3; ++i)
            sphere.center[i] = dr::opaque<Float>(origin[i]);
        if constexpr (dr::is_diff_v<Float>) {
            if (dr::grad_enabled(to_world)) {
                sphere.radius = dr::replace_grad(sphere.radius, dr::norm(to_world * Vector3f(1.f, 0.f, 0.f)));
                sphere.center = dr::replace_grad(sphere.center, to_world * Point3f(0.f));
            }
        }
        return sphere;
    }
};

NAMESPACE_END(mitsuba)
