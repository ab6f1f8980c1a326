/* What becomes of a sampled direction when the point or the sphere moves.

   The library chooses directions, and what it computes has no gradients. Integrators that differentiate what
   they have sampled need them: a sample then keeps its place in the cap while the cap moves and grows
   (docs/mathematics.md, 11). Only gradients of what is computed here are used: values stay the library's. */

#pragma once

#include <mitsuba/core/vector.h>

#include "sphere.h"

NAMESPACE_BEGIN(mitsuba)

/// A direction from a point towards a sphere, which follows the sphere.
template <typename Float>
struct Following {
    using Mask = dr::mask_t<Float>;
    using Point3f = Point<Float, 3>;
    using Vector3f = Vector<Float, 3>;
    using Normal3f = Normal<Float, 3>;

    /// The direction, and the distance to the sphere along it
    Vector3f direction;
    Float distance;
    /// The solid angle of the whole cap over 2 pi
    Float coverage;

    /// Follows `chosen`. Where that is not valid, nothing is followed.
    Following(const Mask &valid, const Sphere<Float> &sphere, const Point3f &p, const Vector3f &chosen) {
        const Vector3f centre = dr::select(valid, sphere.center - p, Vector3f(0.f, 0.f, 2.f * sphere.radius));
        const Float far = dr::norm(centre), s = sphere.radius / far;
        const Vector3f axis = centre / far;
        coverage = s * s / (1.f + dr::safe_sqrt((1.f - s) * (1.f + s)));

        // The place: the fraction of the cap that is nearer to its centre, and a vector to the side.
        const Vector3f w = dr::detach(chosen), axis_now = dr::detach(axis);
        const Vector3f side = w - dr::dot(w, axis_now) * axis_now;
        const Float sine2_now = dr::minimum(dr::squared_norm(side), dr::detach(s * s)),
                    fraction = sine2_now / (1.f + dr::safe_sqrt(1.f - sine2_now)) / dr::detach(coverage);

        // The angle from the axis has the cosine 1 - height. The vector to the side stays perpendicular to
        // the axis, and as long as the sine.
        const Float height = coverage * fraction, sine2 = height * (2.f - height),
                    stretch = dr::sqrt(coverage * (2.f - height));
        direction =
            (1.f - height) * axis + stretch / dr::detach(stretch) * (side - dr::dot(side, axis) * axis);
        distance = far * ((1.f - height) - s * dr::safe_sqrt(1.f - sine2 / (s * s)));
    }

    /// Attaches a sample: its direction, its distance, the sphere's point and normal there, and its density
    /// with respect to solid angle (0 where there is none).
    static void attach(const Sphere<Float> &sphere, const Point3f &p, Vector3f &direction, Float &distance,
                       Point3f &point, Normal3f &normal, Float &pdf) {
        const Following following(pdf != 0.f, sphere, p, direction);
        const Vector3f way = following.direction * following.distance;
        direction = dr::replace_grad(direction, following.direction);
        distance = dr::replace_grad(distance, following.distance);
        point = dr::replace_grad(point, Point3f(p + way));
        normal = dr::replace_grad(normal, Normal3f((p + way - sphere.center) / sphere.radius));
        pdf = dr::replace_grad(pdf, following.scaled(pdf));
    }

    /// The density of a direction that moves in a way of its own, attached. Integrators may differentiate the
    /// weights of multiple importance sampling: they need one function of the direction for their own
    /// directions and for samples. A part of it, `uniform` times the density of the whole cap, is the same
    /// for all directions, and the rest proportional to the cosine with the normal.
    static Float attached_pdf(const Sphere<Float> &sphere, const Point3f &p, const Normal3f &n,
                              const Vector3f &direction, const Float &pdf, dr::scalar_t<Float> uniform) {
        const Following following(pdf != 0.f, sphere, p, direction);
        const Vector3f normal = dr::detach(n);
        const Float cosine = dr::detach(dr::dot(normal, direction)),
                    rest = pdf - uniform * dr::InvTwoPi<Float> / dr::detach(following.coverage),
                    slope = dr::select(rest > 0.f && cosine != 0.f, rest / cosine, 0.f);
        return dr::replace_grad(pdf, following.scaled(pdf) +
                                         slope * dr::dot(normal, direction - following.direction));
    }

private:
    /// A density that moves with the direction.
    Float scaled(const Float &pdf) const { return pdf * (dr::detach(coverage) / coverage); }
};

NAMESPACE_END(mitsuba)
