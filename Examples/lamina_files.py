# SPDX-License-Identifier: BSD-3-Clause
"""How VTK's XML files are written, so that the ParaView of this machine can read them.

ParaView 5.11 cannot read data that is appended to an XML file when it runs with a libexpat of 2.6 or later (or an older one with
its security repairs, as in Debian 12): its parser waits for the end of a tag that never comes.
"""
import functools

from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

EXPAT = ("this ParaView cannot read .vti, .vtp and .vtu files with appended data together with the libexpat of this machine; "
         "give the image as .mha, .nrrd or .nii.gz, or use a ParaView from paraview.org")


@functools.lru_cache(maxsize=None)
def appended_works():
    """Whether an image that is written with appended data comes back."""
    image = vtkImageData()
    image.SetDimensions(32, 32, 16)
    image.AllocateScalars(3, 1)
    image.GetPointData().GetScalars().Fill(1)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetCompressorTypeToNone()  # as many bytes as a real image: a few would pass
    writer.EncodeAppendedDataOff()
    writer.WriteToOutputStringOn()
    writer.Write()
    reader = vtkXMLImageDataReader()
    for source in (reader, reader.GetExecutive()):
        source.AddObserver("ErrorEvent", lambda *_: None)
    reader.ReadFromInputStringOn()
    reader.SetInputString(writer.GetOutputString())
    told = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    reader.Update()
    vtkLogger.SetStderrVerbosity(told)
    return reader.GetOutput().GetNumberOfPoints() == image.GetNumberOfPoints()


def prepare(writer):
    """Appended raw data are the smallest and fastest; inline binary data are read everywhere."""
    if appended_works():
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
    else:
        writer.SetDataModeToBinary()
