"""Renders on demand, kept until the end: several tests look at the same images."""

import numpy as np
from plan import SEEDS, Plan
from renderlab.estimate import Estimate
from renderlab.floor_reference import FloorScene, read_floor_scene, reference_image, trusted_pixels
from renderlab.scenes import load_scene, render_stack
from spherecap_command.scene import BUILT_IN, use_variant

# Both emitters get seeds of their own, so that their noise is independent even where they sample alike.
FIRST_SEED = {True: 1000, False: 0}


class Gallery:
    """All images of one Mitsuba variant. `candidate` is the emitter under test."""

    def __init__(self, variant: str, candidate: str):
        """Start empty; nothing is rendered before it is asked for."""
        self.variant = variant
        self.candidate = candidate
        self._kept: dict[tuple, object] = {}

    def _once(self, key: tuple, make):
        if key not in self._kept:
            use_variant(self.variant)
            self._kept[key] = make()
        return self._kept[key]

    def stack(
        self, plan: Plan, ours: bool, spp: int, seeds: int, sampler: str, width: int, height: int
    ) -> np.ndarray:
        """Return independent renders, shape (seeds, height, width, 3)."""
        emitter = self.candidate if ours else BUILT_IN

        def make() -> np.ndarray:
            scene = load_scene(
                plan.scene, emitter, sampler=sampler, width=width, height=height, spp=spp, **plan.parameters
            )
            first = FIRST_SEED[not ours]
            return render_stack(scene, spp, range(first, first + seeds))

        return self._once((plan.name, ours, spp, seeds, sampler, width, height), make)

    def precise(self, plan: Plan, ours: bool) -> np.ndarray:
        """Return the stack of a z-test."""
        return self.stack(plan, ours, plan.spp, SEEDS, "multijitter", plan.width, plan.height)

    def floor(self, plan: Plan, width: int, height: int) -> tuple[FloorScene, np.ndarray, np.ndarray]:
        """Return a floor scene with its analytic image and the mask of pixels where that is trusted."""

        def make() -> tuple:
            scene = read_floor_scene(plan.scene, width=width, height=height, **plan.parameters)
            return scene, reference_image(scene), trusted_pixels(scene)

        return self._once((plan.name, "floor", width, height), make)


def image_mean(stack: np.ndarray) -> Estimate:
    """Estimate the mean of the whole image, per channel."""
    return Estimate.from_stack(stack.mean(axis=(1, 2)))
