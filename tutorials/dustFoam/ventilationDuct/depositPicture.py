"""Draw the dust on the screen: deposit.png, from the last time of this case.

    xvfb-run -a pvbatch depositPicture.py [CASE [PICTURE [WIDTH]]]

Top: the duct with the speed of the air in its middle plane. Below: the screen seen
from upstream, dust as dots, and the densest part of its deposit, dust as spheres of
true diameter. ParaView 5.10 or later.
"""

import math
import os
import sys

from paraview.simple import *
from paraview import servermanager

case = sys.argv[1] if len(sys.argv) > 1 else "."
picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(case, "deposit.png")
width = int(sys.argv[3]) if len(sys.argv) > 3 else 1800    # pixels

windowSize = 0.4e-3     # m, of the close-up
black = [0, 0, 0]

# Small vectors by hand: Debian's ParaView does not bring numpy


def plus(a, b, factor=1):
    return [p + factor * q for p, q in zip(a, b)]


def cross(a, b):
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def unit(a):
    return [p / math.sqrt(sum(q * q for q in a)) for p in a]


paraview.simple._DisableFirstRenderCameraReset()


# Data

file = os.path.join(os.path.abspath(case), "case.foam")
open(file, "a").close()

reader = OpenFOAMReader(FileName=file)
reader.CaseType = "Reconstructed Case"
reader.SkipZeroTime = 0
reader.MeshRegions = reader.GetProperty("MeshRegions").Available
reader.UpdatePipelineInformation()
time = max(reader.TimestepValues, default=0.0)
animation = GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
animation.AnimationTime = time
reader.UpdatePipeline(time)


def block(name):
    """The named part of the case, or None where it is absent or empty."""
    part = MergeBlocks(Input=ExtractBlock(Input=reader, Selectors=["//" + name]))
    part.UpdatePipeline(time)
    return part if part.GetDataInformation().GetNumberOfPoints() > 0 else None


air, walls, screen, dust = map(block, ("internalMesh", "walls", "screen", "dust"))
if screen is None or walls is None:
    sys.exit("depositPicture: no patches 'screen' and 'walls' in " + file)

def box(part):
    """Lowest corner, highest corner, centre"""
    b = part.GetDataInformation().GetBounds()
    low, high = b[::2], b[1::2]
    return low, high, [(p + q) / 2 for p, q in zip(low, high)]


screenLow, screenHigh, screenCentre = box(screen)
ductLow, ductHigh, ductCentre = box(walls)

if dust is not None and "d" not in dust.PointData.keys():
    sys.exit("depositPicture: the particles at time %g have no field d" % time)

count = 0
window = [screenLow[0] + 5e-5, 0, 0]    # the upstream side of the wires
if dust is not None:
    data = servermanager.Fetch(dust)
    count = data.GetNumberOfPoints()
    low, high = data.GetPointData().GetArray("d").GetRange()
    low, high = math.floor(low * 1e6), max(math.ceil(high * 1e6), math.floor(low * 1e6) + 1)

    # The close-up shows the place with most particles at the screen: count them
    # in squares of a fifth of its side, then in each block of 5 x 5 squares
    slab = [screenLow[0] - 1e-4, screenHigh[0] + 1e-4]
    side = windowSize / 5
    squares = {}
    for i in range(count):
        x = data.GetPoint(i)
        if slab[0] < x[0] < slab[1]:
            key = tuple(int((x[k] - ductLow[k]) / side) for k in (1, 2))
            squares[key] = squares.get(key, 0) + 1

    def within(centre):
        return sum(
            squares.get((centre[0] + i, centre[1] + j), 0)
            for i in range(-2, 3) for j in range(-2, 3)
        )

    if squares:
        best = max(sorted(squares), key=within)
        for k in (1, 2):
            window[k] = ductLow[k] + (best[k - 1] + 0.5) * side
            window[k] = max(window[k], ductLow[k] + windowSize / 2)
            window[k] = min(window[k], ductHigh[k] - windowSize / 2)

    microns = Calculator(Input=dust, AttributeType="Point Data")
    microns.ResultArrayName = "diameter"
    microns.Function = "d*1e6"

    # Without what flies elsewhere and would be seen between the wires
    along = Calculator(Input=microns, AttributeType="Point Data")
    along.ResultArrayName, along.Function = "along", "coordsX"
    atScreen = Threshold(Input=along, Scalars=["POINTS", "along"])
    atScreen.LowerThreshold, atScreen.UpperThreshold = slab


# Views

size = [width, width * 5 // 6]
scale = width / 1800    # of what is given in pixels
layout = CreateLayout("deposit")
views = [CreateView("RenderView") for _ in range(3)]
AssignViewToLayout(views[0], layout, 0)
bottom = layout.SplitVertical(0, 0.36) + 1
right = layout.SplitHorizontal(bottom, 0.5) + 1
AssignViewToLayout(views[1], layout, bottom)
AssignViewToLayout(views[2], layout, right)
layout.SetSize(*size)

diameters = GetColorTransferFunction("diameter")
if count > 0:
    diameters.ApplyPreset("Plasma (matplotlib)", True)
    diameters.RescaleTransferFunction(low, high)

for view in views:
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1      # one scale in the whole view
    view.ViewTime = time


def plain(shown, colour):
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = colour
    return shown


def label(view, text, position, fontSize=22):
    shown = Show(Text(Text=text), view, "TextSourceRepresentation")
    shown.WindowLocation = "Any Location"
    shown.Position = position
    shown.FontSize = round(fontSize * scale)
    shown.Color = black


def look(view, focus, direction, up, height):
    """height: what the view shows from bottom to top, in metres"""
    view.CameraFocalPoint = focus
    view.CameraPosition = plus(focus, unit(direction), -0.05)
    view.CameraViewUp = up
    view.CameraParallelScale = height / 2


def scaleBar(view, length, text, focus, direction, up, height, aspect):
    """A line of true length in the lower left corner, in front of everything."""
    right = unit(cross(direction, up))
    top = unit(cross(right, direction))
    start = plus(focus, unit(direction), -0.02)
    start = plus(start, right, height * (0.04 - 0.5 * aspect))
    start = plus(start, top, height * (0.06 - 0.5))
    bar = Line(Point1=start, Point2=plus(start, right, length))
    shown = plain(Show(Tube(Input=bar, Radius=0.004 * height, NumberofSides=12), view), black)
    shown.Ambient, shown.Diffuse = 1, 0
    label(view, text, [0.04 / aspect, 0.075])


def spheres(view, source, resolution):
    glyph = Glyph(Input=source, GlyphType="Sphere")
    glyph.GlyphType.ThetaResolution = glyph.GlyphType.PhiResolution = resolution
    glyph.GlyphType.Radius = 0.5
    glyph.ScaleArray = ["POINTS", "d"]
    glyph.ScaleFactor = 1
    glyph.GlyphMode = "All Points"
    shown = Show(glyph, view)
    ColorBy(shown, ("POINTS", "diameter"))
    shown.Specular = 0.2
    return shown


def wires(view):
    plain(Show(screen, view), [0.75, 0.77, 0.79]).Ambient = 0.2


def colourBar(view, function, title, position, length):
    bar = GetScalarBar(function, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = black
    bar.TitleFontSize = bar.LabelFontSize = round(20 * scale)
    bar.ScalarBarThickness = round(18 * scale)
    bar.WindowLocation = "Any Location"
    bar.Position = position
    bar.ScalarBarLength = length
    bar.Orientation = "Horizontal"
    bar.AddRangeLabels = 0
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = "%.3g"
    bar.Visibility = 1


# Top: the duct, x to the right

aspect = size[0] / (0.36 * size[1])
direction, up = (0.2, -0.3, -1), [0, 1, 0]
height = 7.4e-3
focus = plus(ductCentre, [0, 0.2e-3, 0])
look(views[0], focus, direction, up, height)

edges = FeatureEdges(Input=ExtractSurface(Input=walls))
plain(Show(edges, views[0]), [0.45, 0.45, 0.45])
plain(Show(walls, views[0]), [0.6, 0.7, 0.8]).Opacity = 0.06

if air is not None and "U" in air.CellData.keys():
    plane = Slice(Input=air)
    plane.SliceType.Origin = ductCentre
    plane.SliceType.Normal = [0, 0, 1]
    speed = Calculator(Input=plane, AttributeType="Cell Data")
    speed.ResultArrayName, speed.Function = "speed", "mag(U)"
    shown = Show(speed, views[0])
    ColorBy(shown, ("CELLS", "speed"))
    shown.Ambient, shown.Diffuse = 1, 0
    shown.Opacity = 0.4
    speeds = GetColorTransferFunction("speed")
    speeds.ApplyPreset("Blues", True)
    speeds.InvertTransferFunction()
    speed.UpdatePipeline(time)
    speeds.RescaleTransferFunction(0, speed.CellData["speed"].GetRange()[1])
    colourBar(views[0], speeds, "Air speed [m/s]", [0.05, 0.80], 0.2)
wires(views[0])
if count > 0:
    shown = Show(microns, views[0])
    shown.Representation = "Points"
    shown.PointSize = 3 * scale
    ColorBy(shown, ("POINTS", "diameter"))
    colourBar(views[0], diameters, "Particle diameter [\u00b5m]", [0.72, 0.02], 0.2)
label(
    views[0],
    "t = %.4g ms, %d particles in the duct (dots). The air flows to the right." % (1e3 * time, count),
    [0.33, 0.9],
)
scaleBar(views[0], 2e-3, "2 mm", focus, direction, up, height, aspect)


# Lower left: the whole screen from upstream

aspect = (0.5 * size[0]) / (0.64 * size[1])
direction, up, height = (1, 0, 0), [0, 0, 1], 4.9e-3
focus = plus(screenCentre, [0, 0, -0.1e-3])
look(views[1], focus, direction, up, height)
wires(views[1])
if count > 0:
    # A sphere would be smaller than a pixel
    shown = Show(atScreen, views[1])
    shown.Representation = "Points"
    shown.PointSize = 4 * scale
    ColorBy(shown, ("POINTS", "diameter"))

frame = Show(
    Box(XLength=1e-6, YLength=windowSize, ZLength=windowSize,
        Center=[screenLow[0] - 1e-3, window[1], window[2]]),
    views[1],
)
frame.Representation = "Outline"
plain(frame, [0.8, 0, 0])
frame.LineWidth = 3 * scale
label(views[1], "The screen from upstream, dust as dots; red: close-up", [0.04, 0.945])
scaleBar(views[1], 1e-3, "1 mm", focus, direction, up, height, aspect)


# Lower right: the close-up, a little from the side to show heights

direction, up = (1, 0.35, -0.35), [0, 0, 1]
height = windowSize * 1.1
look(views[2], window, direction, up, height)
wires(views[2])
if count > 0:
    spheres(views[2], atScreen, 32)
label(views[2], "Close-up, true diameters", [0.04, 0.945])
scaleBar(views[2], 1e-4, "0.1 mm", window, direction, up, height, aspect)

SaveScreenshot(picture, layout, ImageResolution=size, CompressionLevel="9")
print("%s: %d particles at t = %g s" % (picture, count, time))
