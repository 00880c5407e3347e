"""Draw how the screen clogs: filmStrip.png, the dust at four times seen from upstream and
from the side.

    xvfb-run -a pvbatch filmStrip.py [CASE [PICTURE]]

Spheres of true diameter on the wires of the screen. ParaView 5.10 or later.
"""

import os
import sys

from paraview.simple import *

case = sys.argv[1] if len(sys.argv) > 1 else "."
picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(case, "filmStrip.png")

height = 0.62e-3        # m, of each view
centre = [0.8e-3, 0, 0]
slab = [0.3e-3, 1.3e-3]  # along the duct: without the dust that flies elsewhere

paraview.simple._DisableFirstRenderCameraReset()

file = os.path.join(os.path.abspath(case), "case.foam")
open(file, "a").close()
reader = OpenFOAMReader(FileName=file)
reader.CaseType = "Reconstructed Case"
reader.SkipZeroTime = 1
reader.MeshRegions = reader.GetProperty("MeshRegions").Available
reader.UpdatePipelineInformation()
times = list(reader.TimestepValues)
if not times:
    sys.exit("filmStrip: no time but 0 in " + os.path.abspath(case))
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
chosen = sorted({times[(len(times) - 1) * i // 3] for i in range(4)})


def block(name, time):
    part = MergeBlocks(Input=ExtractBlock(Input=reader, Selectors=["//" + name]))
    part.UpdatePipeline(time)
    return part


screen = block("screen", chosen[-1])
dust = block("dust", chosen[-1])
along = Calculator(Input=dust, AttributeType="Point Data")
along.ResultArrayName, along.Function = "along", "coordsX"
near = Threshold(Input=along, Scalars=["POINTS", "along"])
near.LowerThreshold, near.UpperThreshold = slab
glyph = Glyph(Input=near, GlyphType="Sphere")
glyph.GlyphType.ThetaResolution = glyph.GlyphType.PhiResolution = 20
glyph.GlyphType.Radius = 0.5
glyph.ScaleArray, glyph.ScaleFactor, glyph.GlyphMode = ["POINTS", "d"], 1, "All Points"

layout = CreateLayout("strip")
size = 360
layout.SetSize(size * len(chosen), 2 * size)
bottom = layout.SplitVertical(0, 0.5) + 1
rows = [bottom - 1, bottom]
cells = []
for row in rows:
    left, line = row, []
    for i in range(len(chosen), 1, -1):
        right = layout.SplitHorizontal(left, 1 / i) + 1
        line.append(right - 1)
        left = right
    cells.append(line + [left])

for row, (direction, up) in enumerate([((1, 0, 0), (0, 0, 1)), ((0, 1, 0), (0, 0, 1))]):
    for column, time in enumerate(chosen):
        view = CreateView("RenderView")
        AssignViewToLayout(view, layout, cells[row][column])
        view.UseColorPaletteForBackground = 0
        view.Background = [1, 1, 1]
        view.OrientationAxesVisibility = 0
        view.CameraParallelProjection = 1
        view.ViewTime = time
        view.CameraFocalPoint = centre
        view.CameraPosition = [c - 0.02 * d for c, d in zip(centre, direction)]
        view.CameraViewUp = up
        view.CameraParallelScale = height / 2
        wires = Show(screen, view)
        wires.ColorArrayName = ["POINTS", ""]
        wires.AmbientColor = wires.DiffuseColor = [0.75, 0.77, 0.79]
        wires.Ambient = 0.2
        if row == 1:
            wires.Opacity = 0.3
        spheres = Show(glyph, view)
        spheres.ColorArrayName = ["POINTS", ""]
        spheres.AmbientColor = spheres.DiffuseColor = [0.55, 0.35, 0.2]
        text = "%.3g ms, from upstream" if row == 0 else "%.3g ms, air flows to the right"
        shown = Show(Text(Text=text % (1e3 * time)), view, "TextSourceRepresentation")
        shown.WindowLocation = "Upper Center"
        shown.FontSize, shown.Color = 14, [0, 0, 0]

SaveScreenshot(picture, layout, ImageResolution=[size * len(chosen), 2 * size], CompressionLevel="9")
print("%s: times %s s" % (picture, ", ".join("%g" % t for t in chosen)))
