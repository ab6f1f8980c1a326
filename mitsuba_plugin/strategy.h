/* How an emitter samples: what the library is told of it. */

#pragma once

#include <spherecap.h>
#include <spherecap_record.h>

#include "recorder.h"

NAMESPACE_BEGIN(mitsuba)

struct Strategy {
    uint32_t technique, hemispheres;
    float defensive;

    /// A point with a normal that receives the light.
    template <typename Normal3f>
    spherecap_receiver_t receiver(const Normal3f &n) const {
        return {{n.x(), n.y(), n.z()}, technique, hemispheres, defensive};
    }

    /// The same for a recorded kernel, and a sphere that is seen from the point.
    template <typename Float>
    spherecap_recorded_input_t recorded(const Normal<Float, 3> &n, const Vector<Float, 3> &centre,
                                        const Float &radius) const {
        using Recorder = mitsuba::Recorder<Float>;
        spherecap_recorded_input_t input;
        input.technique = technique;
        input.hemispheres = hemispheres;
        input.defensive = Recorder::term(defensive);
        Recorder::terms(n, input.normal);
        Recorder::terms(centre, input.centre);
        input.radius = Recorder::term(radius);
        return input;
    }
};

NAMESPACE_END(mitsuba)
