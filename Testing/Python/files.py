# SPDX-License-Identifier: BSD-3-Clause
"""Image files of every kind, written by hand, so that what is read is compared with what the formats say."""
import gzip
import os
import struct

import numpy as np


def sample():
    """6 x 5 x 4 voxels, all different: [k, j, i]."""
    return np.arange(120, dtype=np.int16).reshape(4, 5, 6) - 7


# A turned, anisotropic grid: columns are the steps of i, j, k in the world.
AXES = np.array([[0.0, -2.0, 0.0], [1.5, 0.0, 0.0], [0.0, 0.0, 3.0]])
ORIGIN = np.array([10.0, -20.0, 30.0])


def write(folder, name, *parts):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        for part in parts:
            file.write(part if isinstance(part, bytes) else part.encode())
    return path


def meta(folder, name, data=None, big=False, packed=False, detached=None, axes=AXES, extra="", sizes="6 5 4", kind="MET_SHORT"):
    data = sample() if data is None else data
    raw = data.astype((">" if big else "<") + "i2").tobytes() if isinstance(data, np.ndarray) else data
    if packed:
        import zlib
        raw = zlib.compress(raw)
    spacing = np.sqrt((axes ** 2).sum(axis=0))
    rows = " ".join(f"{x:.12g}" for x in (axes / spacing).T.ravel())
    header = (f"ObjectType = Image\nNDims = {len(sizes.split())}\nBinaryData = True\nBinaryDataByteOrderMSB = {big}\n"
              f"CompressedData = {packed}\nTransformMatrix = {rows}\nOffset = {' '.join(map(str, ORIGIN))}\n"
              f"ElementSpacing = {' '.join(map(str, spacing))}\nDimSize = {sizes}\n{extra}ElementType = {kind}\n"
              f"ElementDataFile = {detached or 'LOCAL'}\n")
    if len(sizes.split()) != 3:
        header = "\n".join(line for line in header.split("\n")
                           if not line.startswith(("Transform", "Offset", "ElementSpacing")))
    if detached:
        write(folder, detached, raw)
        return write(folder, name, header)
    return write(folder, name, header, raw)


def nrrd(folder, name, data=None, big=False, packed=False, detached=None, axes=AXES, sizes="6 5 4", dims=3, more=""):
    data = sample() if data is None else data
    raw = data.astype((">" if big else "<") + "i2").tobytes() if isinstance(data, np.ndarray) else data
    raw = gzip.compress(raw) if packed else raw
    vectors = " ".join("(" + ",".join(map(str, axes[:, a])) + ")" for a in range(3))
    vectors = ("none " * (dims - 3)) + vectors if dims > 3 else vectors
    header = (f"NRRD0004\n# made by hand\ntype: short\ndimension: {dims}\nspace: left-posterior-superior\nsizes: {sizes}\n"
              f"space directions: {vectors}\nendian: {'big' if big else 'little'}\n"
              f"encoding: {'gzip' if packed else 'raw'}\nspace origin: ({','.join(map(str, ORIGIN))})\n{more}")
    if dims < 3:
        header = "\n".join(line for line in header.split("\n") if not line.startswith("space"))
    if detached:
        write(folder, detached, raw)
        return write(folder, name, header + f"data file: {detached}\n")
    return write(folder, name, header + "\n", raw)


def nifti(folder, name, data=None, big=False, form="s", slope=0.0, sizes=(6, 5, 4), axes=AXES, code=4, magic=b"n+1\0"):
    o = ">" if big else "<"
    data = sample() if data is None else data
    raw = data.astype(o + "i2").tobytes() if isinstance(data, np.ndarray) else data
    head = bytearray(352)
    spacing = np.sqrt((axes ** 2).sum(axis=0))
    struct.pack_into(o + "i", head, 0, 348)
    struct.pack_into(o + "8h", head, 40, len(sizes), *(tuple(sizes) + (1,) * 7)[:7])
    struct.pack_into(o + "2h", head, 70, code, 16)
    struct.pack_into(o + "8f", head, 76, 1.0, *spacing, 0, 0, 0, 0)
    struct.pack_into(o + "3f", head, 108, 352.0, slope, 5.0)
    if form == "s":
        struct.pack_into(o + "2h", head, 252, 0, 1)
        struct.pack_into(o + "12f", head, 280, *np.column_stack([axes, ORIGIN]).ravel())
    elif form == "q":
        # A quarter turn about z: i goes to y, j to -x.
        struct.pack_into(o + "2h", head, 252, 1, 0)
        struct.pack_into(o + "6f", head, 256, 0, 0, np.sqrt(0.5), *ORIGIN)
    head[344:348] = magic
    raw = bytes(head) + raw
    return write(folder, name, gzip.compress(raw) if name.endswith(".gz") else raw)


def vti(folder, name, data=None, components=1):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
    data = sample() if data is None else data
    image = vtkImageData()
    image.SetDimensions(*data.shape[::-1])
    spacing = np.sqrt((AXES ** 2).sum(axis=0))
    image.SetSpacing(spacing)
    image.SetOrigin(ORIGIN)
    image.SetDirectionMatrix(*(AXES / spacing).ravel())
    values = np.repeat(data.reshape(-1, 1), components, axis=1) if components > 1 else data.ravel()
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName("whatever")
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(os.path.join(folder, name))
    writer.SetInputData(image)
    writer.Write()
    return os.path.join(folder, name)


def shortened(path, keep, name):
    """The first part of a file: `keep` of it, 0 to 1."""
    with open(path, "rb") as file:
        data = file.read()
    return write(os.path.dirname(path), name, data[:int(len(data) * keep)])
