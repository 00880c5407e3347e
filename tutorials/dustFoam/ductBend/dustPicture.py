"""Draw where the dust is at the last time: dust.png, the duct from the side and the plate
from upstream.

    xvfb-run -a pvbatch dustPicture.py [CASE [PICTURE]]

The dust is drawn as dots of one size, coloured by diameter. ParaView 5.10 or later.
"""

import os
import sys

from paraview.simple import *

case = sys.argv[1] if len(sys.argv) > 1 else "."
picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(case, "dust.png")

walls = ["floor", "straightIn", "bendOuter", "bendInner", "bendSides", "straightOut"]
upstream = 0.108, 0.114     # m: what is shown of the dust at the plate
black = [0, 0, 0]

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
    sys.exit("dustPicture: no time but 0 in " + os.path.abspath(case))
time = times[-1]


def block(*names):
    part = MergeBlocks(Input=ExtractBlock(Input=reader, Selectors=["//" + n for n in names]))
    part.UpdatePipeline(time)
    return part


microns = Calculator(Input=block("dust"), AttributeType="Point Data")
microns.ResultArrayName, microns.Function = "diameter", "d*1e6"
along = Calculator(Input=microns, AttributeType="Point Data")
along.ResultArrayName, along.Function = "along", "coordsY"
atPlate = Threshold(Input=along, Scalars=["POINTS", "along"])
atPlate.LowerThreshold, atPlate.UpperThreshold = upstream
duct = block(*walls)
plate = block("plate")

colours = GetColorTransferFunction("diameter")
colours.ApplyPreset("Turbo", True)
colours.RescaleTransferFunction(0.5, 50)
colours.MapControlPointsToLogSpace()
colours.UseLogScale = 1


def plain(part, view, opacity):
    shown = Show(part, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [0.75, 0.77, 0.79]
    shown.Opacity = opacity


def dots(part, view, radius):
    glyph = Glyph(Input=part, GlyphType="Sphere")
    glyph.GlyphType.ThetaResolution = glyph.GlyphType.PhiResolution = 8
    glyph.GlyphType.Radius = radius
    glyph.ScaleArray, glyph.ScaleFactor, glyph.GlyphMode = ["POINTS", "No scale array"], 1, "All Points"
    shown = Show(glyph, view)
    ColorBy(shown, ("POINTS", "diameter"))
    shown.Ambient, shown.Diffuse = 0.6, 0.5
    return shown


def label(view, text):
    shown = Show(Text(Text=text), view, "TextSourceRepresentation")
    shown.WindowLocation = "Upper Center"
    shown.FontSize, shown.Color = 16, black


layout = CreateLayout("dust")
left = CreateView("RenderView")
AssignViewToLayout(left, layout, 0)
right = CreateView("RenderView")
AssignViewToLayout(right, layout, layout.SplitHorizontal(0, 0.5) + 1)
layout.SetSize(1600, 900)
views = [
    # view, focus, direction, up, height
    (left, [0, 0.08, 0.02], [0, 0, -1], [0, 1, 0], 0.19),
    (right, [0.04, 0.11, 0.02], [0, 1, 0], [0, 0, 1], 0.052),
]
for view, focus, direction, up, height in views:
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.ViewTime = time
    view.CameraFocalPoint = focus
    view.CameraPosition = [f - 0.5 * d for f, d in zip(focus, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = height / 2

plain(duct, left, 0.12)
plain(plate, left, 0.5)
shown = dots(microns, left, 3.5e-4)
label(left, "all dust at %g s; air from the left, then up" % time)
plain(plate, right, 1)
dots(atPlate, right, 1.5e-4)
label(right, "the perforated plate from upstream")

bar = GetScalarBar(colours, left)
bar.Title, bar.ComponentTitle = "diameter [um]", ""
bar.TitleColor = bar.LabelColor = black
bar.WindowLocation = "Any Location"
bar.Position = [0.05, 0.45]
bar.ScalarBarLength = 0.4
shown.SetScalarBarVisibility(left, True)

SaveScreenshot(picture, layout, ImageResolution=[1600, 900], CompressionLevel="9")
print("%s: time %g s" % (picture, time))
