"""What is rendered to test the emitter: variants, scenes, resolutions and sample counts, all in one place.

The z-tests use few, large pixels: noise per pixel is what limits them, and a pixel of a coarse image
averages for free. Sample counts were chosen for power: each test must reject a copy that is 1 % too dark
(the tests check it). Stratified samples ("multijitter") make that affordable; renders with other seeds stay
independent, and only the spread between seeds enters the statistics. All comparisons of noise use
independent samples.
"""

from dataclasses import dataclass, field

# Mitsuba variants that every render test runs in.
VARIANTS = ("scalar_rgb", "llvm_ad_rgb")

# Independent renders per emitter in a z-test: enough for a t-test whose tails are close to the normal ones.
SEEDS = 32

# Chance that one z-test fails although all is right. Seeds are fixed, so a build either passes for ever or
# not. With 35 z-tests a new, correct build fails with a chance of 3.5 %; other seeds then settle it.
SIGNIFICANCE = 1e-3


@dataclass(frozen=True)
class Plan:
    """How one scene is tested.

    spp: samples per pixel of one of the `SEEDS` renders of a z-test; a square, as the sampler wants.
    """

    scene: str
    spp: int
    width: int = 16
    height: int = 12
    parameters: dict[str, object] = field(default_factory=dict)
    # The built-in emitter is right here, so that both must agree.
    built_in_is_right: bool = True
    # Diffuse surfaces: projected solid angle must never be noisier than the built-in emitter.
    diffuse: bool = True
    note: str = ""

    @property
    def name(self) -> str:
        """Name for test ids, tables and folders."""
        return self.scene + self.note


PLANS = (
    Plan("open_floor", 64),
    Plan("cut_light", 2500, width=8, height=6),
    Plan("sunken_light", 2500, width=8, height=6),
    Plan("touching_light", 100),
    Plan("tiny_far_light", 16, built_in_is_right=False),
    Plan("soft_shadows", 256),
    Plan("smooth_mesh", 256),
    Plan("two_sided", 256),
    Plan("several_lights", 256),
    Plan("cornell_box", 1600, width=8, height=6, parameters={"max_depth": 3}),
    # A part of the frame near the light: looked at as a whole, fog is too noisy for any power.
    Plan("fog", 400, width=8, height=6, parameters={"max_depth": 3, "fov": 20, "target": "-0.2, -0.5, 0"}),
    Plan("glossy", 256, diffuse=False),
    # The same with multiple importance sampling: here the density of a given direction enters too.
    Plan("cut_light", 1600, width=8, height=6, parameters={"bsdf_samples": 1}, note="-mis"),
    Plan("sunken_light", 2500, width=8, height=6, parameters={"bsdf_samples": 1}, note="-mis"),
    Plan("smooth_mesh", 256, parameters={"bsdf_samples": 1}, note="-mis"),
    Plan("two_sided", 256, parameters={"bsdf_samples": 1}, note="-mis"),
)
