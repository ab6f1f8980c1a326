"""Blender's Cycles, in an environment of its own. Its sampler is TABULATED_SOBOL, its light sampling `cone`.

Its point lights with a radius sample the cone of directions uniformly, as Mitsuba's `area` does.
"""

import math
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from cross import worker
from cross.mesh import lamp_bodies, mesh
from cross.scene import Scene


def add(name: str, data: object) -> "bpy.types.Object":
    """Put a mesh, a lamp or a camera into the scene."""
    result = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(result)
    return result


def load(scene: Scene) -> None:
    """Build the scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    blender = bpy.context.scene
    blender.world = bpy.data.worlds.new("black")
    blender.world.use_nodes = True
    blender.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.0

    for i, light in enumerate(scene.lights):
        lamp = bpy.data.lights.new(f"light{i}", "POINT")
        lamp.shadow_soft_size = light.radius
        lamp.use_soft_falloff = False  # By default lights are dimmed where surfaces are near or inside.
        lamp.energy = 4 * math.pi**2 * light.radius**2 * light.radiance  # watts
        placed = add(f"light{i}", lamp)
        placed.location = light.centre
        placed.visible_camera = False
    for i, one in enumerate([*scene.shapes, *lamp_bodies(scene)]):
        vertices, triangles = mesh(one)
        data = bpy.data.meshes.new(f"mesh{i}")
        data.from_pydata(vertices, [], triangles)
        material = bpy.data.materials.new(f"material{i}")
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        nodes.clear()
        diffuse, output = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeOutputMaterial")
        diffuse.inputs["Color"].default_value = (one.albedo, one.albedo, one.albedo, 1.0)
        diffuse.inputs["Roughness"].default_value = 0.0
        links.new(diffuse.outputs["BSDF"], output.inputs["Surface"])
        data.materials.append(material)
        add(f"mesh{i}", data).visible_camera = i < len(scene.shapes)

    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "HORIZONTAL"
    camera.angle = math.radians(scene.camera.fov)
    camera.clip_start, camera.clip_end = 1e-3, 1e4
    placed = add("camera", camera)
    forward, right, up = scene.camera.axes()
    eye = scene.camera.eye
    placed.matrix_world = [[right[i], up[i], -forward[i], eye[i]] for i in range(3)] + [[0, 0, 0, 1]]
    # Blender's matrices are given by rows to the constructor, and by columns to the property.
    placed.matrix_world.transpose()
    blender.camera = placed


def configure(scene: Scene, job: worker.Job, seed: int) -> None:
    """Set how to render: light sampling alone, nothing clamped, skipped or denoised, raw values."""
    blender = bpy.context.scene
    blender.render.engine = "CYCLES"
    blender.render.resolution_x, blender.render.resolution_y = job.width, job.height
    blender.render.resolution_percentage = 100
    blender.render.threads_mode, blender.render.threads = "FIXED", 1
    blender.render.use_compositing = blender.render.use_sequencer = False
    blender.render.dither_intensity = 0.0
    blender.view_settings.view_transform = "Raw"
    blender.view_settings.exposure = 0.0
    blender.render.image_settings.file_format = "OPEN_EXR"
    blender.render.image_settings.color_depth = "32"
    blender.render.image_settings.exr_codec = "NONE"
    cycles = blender.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = job.spp, seed
    cycles.sampling_pattern = job.sampler
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_light_tree = False
    cycles.use_auto_tile = False
    cycles.light_sampling_threshold = 0.0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = scene.bounces
    for lamp in bpy.data.lights:
        lamp.cycles.use_multiple_importance_sampling = False


def render(scene: Scene, job: worker.Job, seed: int) -> tuple[np.ndarray, float]:
    """Render once."""
    load(scene)
    configure(scene, job, seed)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "image.exr"
        bpy.context.scene.render.filepath = str(path)
        bpy.ops.render.render(write_still=True)
        saved = bpy.data.images.load(str(path))
        saved.colorspace_settings.name = "Non-Color"  # The values as they are.
        pixels = np.empty(4 * job.width * job.height, dtype=np.float32)
        saved.pixels.foreach_get(pixels)  # It reads the file only now.
    return pixels.reshape(job.height, job.width, 4)[::-1, :, 0], float(job.spp)  # Rows are bottom-up.


if __name__ == "__main__":
    worker.run(render)
