"""Drapes the panels of peer_drape on the torso with Blender's cloth modifier, sewing springs and all.

usage: blender -b --factory-startup -P blender_cloth.py -- PANELS.json TORSO.obj OUT.json
           [--seconds 2] [--fps 24] [--quality 5] [--mesh OUT.obj]

Writes wall seconds of the frames and how much the cloth still moves at the end: speed over the last
frame and edge strain against the flat panels. Written for Blender 3.4.
"""
import argparse
import json
import math
import sys
import time

import bpy

# As peer_drape.cpp: kg/m2, E t in N/m, N m, Coulomb.
AREAL_DENSITY, STIFFNESS, BENDING, FRICTION = 0.15, 261.0, 2.3e-6, 0.3
GAP = 0.002  # m, of Blender's contacts


def add_mesh(name, vertices, edges, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, edges, faces)
    mesh.update()
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def read_obj(path):
    vertices, faces = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                vertices.append(tuple(float(w) for w in words[1:4]))
            elif words and words[0] == "f":
                faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return vertices, faces


def distance(a, b):
    return math.sqrt(sum((p - q) ** 2 for p, q in zip(a, b)))


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))]


def positions(thing):
    graph = bpy.context.evaluated_depsgraph_get()
    return [tuple(v.co) for v in thing.evaluated_get(graph).data.vertices]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("panels")
    parser.add_argument("torso")
    parser.add_argument("out")
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--fps", type=int, default=24)
    parser.add_argument("--quality", type=int, default=5)
    parser.add_argument("--mesh")
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])

    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    with open(options.panels) as file:
        panels = json.load(file)
    torso = add_mesh("torso", *(lambda v, f: (v, [], f))(*read_obj(options.torso)))
    torso.modifiers.new("Collision", "COLLISION")
    torso.collision.thickness_outer = GAP
    torso.collision.cloth_friction = 80 * FRICTION  # the scale of Blender ends at 80
    shirt = add_mesh("shirt", panels["vertices"], panels["sewing"], panels["triangles"])

    vertices, triangles = panels["vertices"], panels["triangles"]
    edges = sorted({tuple(sorted((t[i], t[(i + 1) % 3]))) for t in triangles for i in range(3)})
    flat = [distance(vertices[a], vertices[b]) for a, b in edges]
    mean_edge = sum(flat) / len(flat)
    area = sum(0.5 * abs((vertices[b][0] - vertices[a][0]) * (vertices[c][2] - vertices[a][2])
                         - (vertices[c][0] - vertices[a][0]) * (vertices[b][2] - vertices[a][2]))
               for a, b, c in triangles)  # panels stand square to y

    modifier = shirt.modifiers.new("Cloth", "CLOTH")
    cloth = modifier.settings
    cloth.quality = options.quality
    cloth.mass = AREAL_DENSITY * area / len(vertices)
    # A spring of Blender has the stiffness value / mean edge [N/m]; a net of equilateral triangles
    # of springs k is a sheet of E t = 2 k / sqrt 3.
    stiffness = STIFFNESS * math.sqrt(3) / 2 * mean_edge
    cloth.tension_stiffness = cloth.compression_stiffness = stiffness
    cloth.shear_stiffness = stiffness
    # A hinge of Blender bears 0.1 value edge angle as a force, spread over a triangle's corners: a
    # moment of 0.029 value edge2 angle; the plate's is 1.73 D angle.
    cloth.bending_model = "ANGULAR"
    cloth.bending_stiffness = 1.73 * BENDING / (0.029 * mean_edge ** 2)
    cloth.use_sewing_springs = True
    cloth.sewing_force_max = 0  # no limit
    modifier.collision_settings.use_collision = True
    modifier.collision_settings.distance_min = GAP
    modifier.collision_settings.use_self_collision = True
    modifier.collision_settings.self_distance_min = GAP
    modifier.collision_settings.self_friction = 5

    scene = bpy.context.scene
    scene.render.fps = options.fps
    frames = 1 + round(options.seconds * options.fps)
    scene.frame_start, scene.frame_end = 1, frames
    modifier.point_cache.frame_start, modifier.point_cache.frame_end = 1, frames
    start = time.monotonic()
    before = now = None
    rms_speed = []
    for frame in range(1, frames + 1):
        scene.frame_set(frame)
        before, now = now, positions(shirt)
        if before:
            moved = [distance(p, q) * options.fps for p, q in zip(before, now)]
            rms_speed.append(math.sqrt(sum(m * m for m in moved) / len(moved)))
    wall = time.monotonic() - start

    strain = [distance(now[a], now[b]) / length - 1 for (a, b), length in zip(edges, flat)]
    open_seams = [distance(now[a], now[b]) for a, b in panels["sewing"]]
    figures = {
        "program": "Blender " + bpy.app.version_string, "vertices": len(vertices),
        "triangles": len(triangles), "simulated_seconds": options.seconds,
        "frames": frames, "quality": options.quality, "wall_seconds": wall,
        "settings": {"vertex_mass_kg": cloth.mass, "tension": cloth.tension_stiffness,
                     "bending": cloth.bending_stiffness, "gap_m": GAP},
        "last_speed_m_s": {"rms": rms_speed[-1], "median": quantile(moved, 0.5),
                           "p95": quantile(moved, 0.95), "max": max(moved)},
        "rms_speed_m_s": [round(s, 5) for s in rms_speed],
        "edge_strain": {"min": min(strain), "p1": quantile(strain, 0.01),
                        "median": quantile(strain, 0.5), "p99": quantile(strain, 0.99),
                        "max": max(strain)},
        "open_seam_mm": {"median": 1000 * quantile(open_seams, 0.5), "max": 1000 * max(open_seams)},
        "lowest_z_m": min(p[2] for p in now), "highest_z_m": max(p[2] for p in now)}
    with open(options.out, "w") as file:
        json.dump(figures, file, indent=1)
        file.write("\n")
    if options.mesh:
        with open(options.mesh, "w") as file:
            file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in now)
            file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)
    print(json.dumps({key: figures[key] for key in figures if key != "rms_speed_m_s"}, indent=1))


main()
