#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renders VTK files (.vtu, .pvtu, .vtk or a .pvd series) to a PNG image, without a display.

    render.py [options] FILE... -o PICTURE.png

Debian packages: python3-vtk9, for --colors python3-pil, and xvfb if there is no display:
    xvfb-run -a /usr/bin/python3 scripts/render.py ...

Stress in the full model at the driver, seen through the chain's middle plane:
    render.py results/full/bodies.pvd --color von_mises --divide 1e6 --title "von Mises (MPa)" \\
        --range 0 100 --sequential --behind 0 --focus 0.004 0.024 0 --height 0.062 \\
        --view 0.1 0.15 1 --size 1120 700 --colors 96 -o doc/pictures/stress.png

Pressure without penalty, on a tooth and on a roller, after
    chaindrive run prm/paper/reduced-half.prm --output results/pressure \\
        --set "Time/End time in ms=9.1" --set "Output/Window start in ms=8" \\
        --set "Output/Field interval in ms=9" --set Mesh/Sprockets/Refinement=2
    render.py results/pressure/contacts.pvd --only interface 0 --color contact_pressure \\
        --divide 1e6 --title "pressure (MPa)" --sequential --range 0 400 \\
        --beside results/pressure/bodies.pvd --kinds 3 --no-edges --focus -0.0075 0.0335 0.0018 \\
        --height 0.016 --view -0.75 0.65 0.6 --size 1120 700 --colors 96 \\
        -o doc/pictures/pressure-tooth.png
    render.py results/pressure/bodies.pvd --only kind 0 1 --color contact_pressure --divide 1e6 \\
        --title "pressure (MPa)" --sequential --range 0 150 --focus -0.0065 0.0365 0.0018 \\
        --height 0.02 --view 0.1 -0.8 -0.6 --size 1120 700 --colors 96 \\
        -o doc/pictures/pressure-roller.png
"""
import argparse
import os
import xml.etree.ElementTree as xml

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.all import (vtkActor, vtkAppendFilter, vtkColorTransferFunction, vtkDataObject,
                            vtkDataSetMapper, vtkDataSetSurfaceFilter, vtkExtractGeometry,
                            vtkMapper, vtkPlane, vtkPNGWriter, vtkRenderer, vtkRenderWindow, vtkScalarBarActor,
                            vtkThreshold, vtkUnstructuredGridReader, vtkWarpVector,
                            vtkWindowToImageFilter, vtkXMLPUnstructuredGridReader,
                            vtkXMLUnstructuredGridReader)

# muted colours that tell neighbouring materials apart
PALETTE = [(0.80, 0.62, 0.36), (0.44, 0.60, 0.76), (0.78, 0.80, 0.84), (0.36, 0.48, 0.62),
           (0.70, 0.42, 0.36), (0.62, 0.66, 0.70), (0.42, 0.45, 0.48), (0.52, 0.66, 0.52)]

# from nothing, the grey of a rigid body, to much
SEQUENCE = [(0.80, 0.82, 0.84), (0.98, 0.90, 0.62), (0.96, 0.68, 0.35), (0.84, 0.33, 0.24),
            (0.45, 0.06, 0.20)]


def files_of(name, time):
    """The data files behind `name`: of a series, those of the time nearest to `time`."""
    if not name.endswith(".pvd"):
        return [name]
    sets = [(float(s.get("timestep", 0)), s.get("file")) for s in xml.parse(name).iter("DataSet")]
    last = max(t for t, _ in sets)
    nearest = min((t for t, _ in sets), key=lambda t: abs(t - (last if time is None else time)))
    return [os.path.join(os.path.dirname(name), f) for t, f in sets if t == nearest]


def read(name):
    reader = {".vtu": vtkXMLUnstructuredGridReader, ".pvtu": vtkXMLPUnstructuredGridReader,
              ".vtk": vtkUnstructuredGridReader}[os.path.splitext(name)[1]]()
    reader.SetFileName(name)
    if isinstance(reader, vtkUnstructuredGridReader):
        reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--time", type=float, help="time in a series; default: the last")
    parser.add_argument("--color", help="name of a cell or point array; default: one colour")
    parser.add_argument("--range", nargs=2, type=float, help="range of the colour scale")
    parser.add_argument("--divide", type=float, default=1., help="divide the values of the array by this")
    parser.add_argument("--title", help="title of the colour scale; default: the name of the array")
    parser.add_argument("--sequential", action="store_true", help="colours from grey to dark red")
    parser.add_argument("--behind", type=float, help="leave out cells with z above this value")
    parser.add_argument("--colors", type=int, help="write a small file with this number of colours")
    parser.add_argument("--discrete", action="store_true", help="one colour per integer value")
    parser.add_argument("--warp", help="name of a displacement array to add to the positions")
    parser.add_argument("--scale", type=float, default=1., help="scale of the displacement")
    parser.add_argument("--no-edges", action="store_true")
    parser.add_argument("--view", nargs=3, type=float, default=[0.6, -0.8, 1.2],
                        help="direction from the object to the camera")
    parser.add_argument("--up", nargs=3, type=float, default=[0, 1, 0])
    parser.add_argument("--focus", nargs=3, type=float, help="point at the centre of the image")
    parser.add_argument("--height", type=float, help="height of the visible part, in the units of the data")
    parser.add_argument("--only", nargs="+", metavar=("ARRAY", "NUMBER"),
                        help="leave out cells in which this array has none of these numbers")
    parser.add_argument("--beside", nargs="+", default=[], help="files to show in one colour as well")
    parser.add_argument("--kinds", nargs="+", type=int,
                        help="of these show bodies of these kinds alone (the cell array kind)")
    parser.add_argument("--size", nargs=2, type=int, default=[1600, 1000])
    arguments = parser.parse_args()

    def behind(source):
        """The part of `source` that is to be seen."""
        if arguments.behind is None:
            return source
        plane = vtkPlane()
        plane.SetOrigin(0, 0, arguments.behind + 1e-6)
        plane.SetNormal(0, 0, 1)
        part = vtkExtractGeometry()
        part.SetInputConnection(source.GetOutputPort())
        part.SetImplicitFunction(plane)
        return part

    def all_of(names):
        append = vtkAppendFilter()
        for name in names:
            for file in files_of(name, arguments.time):
                append.AddInputData(read(file))
        append.Update()
        return append

    def chosen(source, array, numbers):
        """The cells of `source` in which the array has one of these numbers."""
        parts = vtkAppendFilter()
        for number in numbers:
            part = vtkThreshold()
            part.SetInputConnection(source.GetOutputPort())
            part.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, array)
            part.SetLowerThreshold(number)
            part.SetUpperThreshold(number)
            parts.AddInputConnection(part.GetOutputPort())
        return parts

    def actor_of(mapper):
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(PALETTE[2])
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetDiffuse(0.75)
        actor.GetProperty().SetEdgeVisibility(not arguments.no_edges)
        actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.18)
        actor.GetProperty().SetLineWidth(1.)
        return actor

    source = all_of(arguments.files)
    if arguments.only:
        source = chosen(source, arguments.only[0], map(float, arguments.only[1:]))
    if arguments.warp:
        source.GetOutput().GetPointData().SetActiveVectors(arguments.warp)
        warp = vtkWarpVector()
        warp.SetInputConnection(source.GetOutputPort())
        warp.SetInputArrayToProcess(0, 0, 0, 0, arguments.warp)
        warp.SetScaleFactor(arguments.scale)
        source = warp
    source = behind(source)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(source.GetOutputPort())
    surface.Update()

    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor_of(mapper))
    if arguments.beside:
        rest = all_of(arguments.beside)
        if arguments.kinds:
            rest = chosen(rest, "kind", arguments.kinds)
        rest = behind(rest)
        hull = vtkDataSetSurfaceFilter()
        hull.SetInputConnection(rest.GetOutputPort())
        grey = vtkDataSetMapper()
        grey.SetInputConnection(hull.GetOutputPort())
        grey.ScalarVisibilityOff()
        # what lies on the bodies is to be seen
        vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-4., -4.)
        renderer.AddActor(actor_of(grey))
    renderers = [renderer]
    if arguments.color:
        data = surface.GetOutput()
        in_cells = data.GetCellData().HasArray(arguments.color)
        array = (data.GetCellData() if in_cells else data.GetPointData()).GetArray(arguments.color)
        if array is None:
            parser.error("there is no array named '%s'" % arguments.color)
        if arguments.divide != 1.:
            vtk_to_numpy(array)[:] /= arguments.divide
            array.Modified()
        low, high = arguments.range or array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
        colors = vtkColorTransferFunction()
        if arguments.discrete:
            for value in range(int(low), int(high) + 1):
                colors.AddRGBPoint(value, *PALETTE[value % len(PALETTE)])
        elif arguments.sequential:
            for i, color in enumerate(SEQUENCE):
                colors.AddRGBPoint(low + (high - low) * i / (len(SEQUENCE) - 1), *color)
        else:
            colors.SetColorSpaceToDiverging()
            colors.AddRGBPoint(low, 0.23, 0.30, 0.75)
            colors.AddRGBPoint(high, 0.71, 0.02, 0.15)
        if array.GetNumberOfComponents() > 1:
            colors.SetVectorModeToMagnitude()
        (mapper.SetScalarModeToUseCellFieldData if in_cells
         else mapper.SetScalarModeToUsePointFieldData)()
        mapper.SelectColorArray(arguments.color)
        mapper.SetLookupTable(colors)
        mapper.UseLookupTableScalarRangeOn()
        if not arguments.discrete:
            bar = vtkScalarBarActor()
            bar.SetLookupTable(colors)
            bar.SetTitle(arguments.title or arguments.color)
            bar.UnconstrainedFontSizeOn()
            for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
                text.SetColor(0, 0, 0)
                text.SetFontSize(arguments.size[1] // 45)
                text.ShadowOff()
                text.ItalicOff()
                text.BoldOff()
            bar.SetLabelFormat("%.4g")
            bar.SetPosition(0.1, 0.1)
            bar.SetWidth(0.85)
            renderer.SetViewport(0, 0, 0.88, 1)
            scale = vtkRenderer()  # beside the picture
            scale.SetBackground(1, 1, 1)
            scale.SetViewport(0.88, 0, 1, 1)
            scale.AddActor2D(bar)
            renderers.append(scale)
    else:
        mapper.ScalarVisibilityOff()

    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    focus = arguments.focus or surface.GetOutput().GetCenter()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*[f + v for f, v in zip(focus, arguments.view)])
    camera.SetViewUp(*arguments.up)
    renderer.ResetCamera()
    if arguments.focus or arguments.height:
        distance = camera.GetDistance()
        direction = camera.GetDirectionOfProjection()
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*[f - distance * d for f, d in zip(focus, direction)])
    if arguments.height:
        camera.SetParallelScale(0.5 * arguments.height)
    else:
        camera.Zoom(1.3)
    renderer.ResetCameraClippingRange()

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*arguments.size)
    for each in renderers:
        window.AddRenderer(each)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(arguments.output)
    writer.Write()
    if arguments.colors:
        from PIL import Image
        picture = Image.open(arguments.output).convert("RGB").quantize(
            arguments.colors, Image.Quantize.MAXCOVERAGE)  # keeps rare colours
        picture.save(arguments.output, optimize=True)


if __name__ == "__main__":
    main()
