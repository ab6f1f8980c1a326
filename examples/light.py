"""The light that a floor gets from a sphere of radiance 10, in Mitsuba: one sample is as good as many."""

import spherecap  # noqa: F401, I001 (makes the emitter known; before Mitsuba, as it says where LLVM is)
import mitsuba as mi

mi.set_variant("scalar_rgb")
emitter = {"type": "spherecap", "radiance": {"type": "rgb", "value": 10.0}}
light = {"type": "sphere", "center": [3, 0, 0.5], "radius": 1, "emitter": emitter}  # the horizon cuts it
scene = mi.load_dict({"type": "scene", "floor": {"type": "rectangle"}, "light": light})
si = scene.ray_intersect(mi.Ray3f([0, 0, 1], [0, 0, -1]))
sample, radiance = scene.sample_emitter_direction(si, mi.Point2f(0.25, 0.75))
print(f"irradiance {radiance[0] * mi.Frame3f.cos_theta(si.to_local(sample.d)):.4f}")
