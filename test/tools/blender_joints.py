"""Run by Blender: imports a .bvh or .glb file and writes the places of all joints at the times of a
list as CSV: time, joint, x, y, z in Blender's axes and unit, and the rotation's quaternion
w x y z."""
import sys

import bpy
import io_anim_bvh.import_bvh
import numpy

# Debian 12 ships Blender 3.4, whose importers use what its Python 3.11 and NumPy have dropped.
io_anim_bvh.import_bvh.open = lambda path, mode: open(path, 'r')
for name, kind in (('bool', bool), ('int', int), ('float', float)):
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)

motion, table, step, frames = sys.argv[sys.argv.index('--') + 1:]
step, frames = float(step), int(frames)
bpy.ops.wm.read_factory_settings(use_empty=True)
if motion.endswith('.bvh'):
    bpy.ops.import_anim.bvh(filepath=motion, use_fps_scale=False)

    def frame_of(index):
        return float(index + 1)
else:
    bpy.ops.import_scene.gltf(filepath=motion)
    rate = bpy.context.scene.render.fps / bpy.context.scene.render.fps_base

    def frame_of(index):
        return index * step * rate

body = next(o for o in bpy.data.objects if o.type == 'ARMATURE')
with open(table, 'w') as out:
    for index in range(frames):
        frame = frame_of(index)
        bpy.context.scene.frame_set(int(frame), subframe=frame - int(frame))
        for bone in body.pose.bones:
            place = body.matrix_world @ bone.head
            # From the rest pose, so that the axes Blender gives its bones do not matter.
            turn = (body.matrix_world @ bone.matrix @ bone.bone.matrix_local.inverted()
                    @ body.matrix_world.inverted()).to_quaternion()
            print(index, bone.name, *place, *turn, sep=',', file=out)
