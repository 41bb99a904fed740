# SPDX-License-Identifier: BSD-3-Clause
"""Read 3-D images into vtkImageData with their place in the world, and refuse broken files in one line.

    from lamina_images import read_image, ImageError
    image = read_image("scan.nii.gz")

Formats: .vti .mha .mhd .nrrd .nhdr .nii .nii.gz. VTK's own readers lose the orientation of all but .vti, pad truncated
files with zeros or never return from them; this module reads header and voxels itself, and compares the size of the
voxel data with the header before anything else.

The image keeps the world coordinates of its file: MetaImage and most NRRD files are LPS (x to the patient's left, y to
the back, z up), NIfTI is RAS (x to the right, y to the front). Nothing is flipped: two files of different kinds lie in
the same place only if a program has converted one of them.
"""
import bz2
import os
import re
import struct
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

EXTENSIONS = (".vti", ".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz")
MOST_VOXELS = 1 << 33


class ImageError(Exception):
    """What is wrong with a file and what to do, in one line."""


def read_image(path, allow_constant=False):
    """The image of `path` with its only scalar array active. `allow_constant`: for masks."""
    kind = extension_of(path)
    if not os.path.exists(path):
        raise ImageError(f"{path}: no such file")
    if not os.path.isfile(path):
        raise ImageError(f"{path}: not a file")
    if os.path.getsize(path) == 0:
        raise ImageError(f"{path}: the file is empty")
    try:
        if kind == ".vti":
            image = _read_vti(path)
        else:
            reader = {".mha": _read_meta, ".mhd": _read_meta, ".nrrd": _read_nrrd, ".nhdr": _read_nrrd}
            image = _make_image(path, *reader.get(kind, _read_nifti)(path))
    except OSError as error:
        raise ImageError(f"{path}: cannot be read: {error.strerror or error}") from None
    except MemoryError:
        raise ImageError(f"{path}: the image does not fit into memory; crop or coarsen it") from None
    _check_values(path, image, allow_constant)
    return image


def extension_of(path):
    lower = path.lower()
    for extension in sorted(EXTENSIONS, key=len, reverse=True):
        if lower.endswith(extension):
            return extension
    raise ImageError(f"{path}: not an image format known here; use one of {' '.join(EXTENSIONS)}")


def scalars_of(image):
    """The voxel values as a numpy array with k, j, i as its axes."""
    ni, nj, nk = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(nk, nj, ni)


# From header and voxels to vtkImageData -------------------------------------------------------------------------------

def _make_image(path, sizes, axes, origin, values, name="Intensity"):
    """axes: a column for each of i, j, k: the step from one voxel to the next in the world."""
    axes = np.asarray(axes, float)
    if not (np.isfinite(axes).all() and np.isfinite(origin).all()):
        raise ImageError(f"{path}: the header's orientation or origin is not a number")
    spacing = np.sqrt((axes * axes).sum(axis=0))
    if not (spacing > 0).all():
        raise ImageError(f"{path}: the header's voxel spacing is zero along an axis; correct the header")
    direction = axes / spacing
    skew = np.abs(direction.T @ direction - np.eye(3)).max()
    if skew > 2e-3:
        raise ImageError(f"{path}: the axes are sheared (not at right angles); resample the image to a rectangular grid")
    # Headers round their numbers: take the nearest exact rotation (or mirrored one).
    if skew > 1e-12:
        left, _, right = np.linalg.svd(direction)
        direction = left @ right
    direction[np.abs(direction) < 1e-9] = 0
    image = vtkImageData()
    image.SetDimensions(*[int(n) for n in sizes])
    image.SetSpacing(*spacing)
    image.SetOrigin(*[float(x) for x in origin])
    image.SetDirectionMatrix(*direction.ravel())
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    array.SetName(name)
    image.GetPointData().SetScalars(array)
    return image


def _check_sizes(path, sizes, components=1):
    """Three sizes of at least 2; further ones must be 1."""
    sizes = [int(n) for n in sizes]
    if components != 1:
        raise ImageError(f"{path}: the image has {components} components per voxel; extract one first")
    if any(n < 1 for n in sizes):
        raise ImageError(f"{path}: the header's sizes {sizes} are not positive")
    if len(sizes) > 3 and any(n != 1 for n in sizes[3:]):
        raise ImageError(f"{path}: the image has {len(sizes)} dimensions {sizes}; extract one volume first")
    sizes = sizes[:3]
    if len(sizes) < 3 or min(sizes) < 2:
        text = " x ".join(str(n) for n in sizes)
        raise ImageError(f"{path}: a 2-D image ({text} voxels); stack the slices into one 3-D image")
    count = sizes[0] * sizes[1] * sizes[2]
    if count > MOST_VOXELS:
        raise ImageError(f"{path}: the header asks for {count} voxels; crop or coarsen the image")
    return sizes


def _check_values(path, image, allow_constant):
    values = scalars_of(image)
    finite = values[np.isfinite(values)] if values.dtype.kind == "f" else values
    if finite.size == 0:
        raise ImageError(f"{path}: the image holds no finite value")
    if not allow_constant and finite.min() == finite.max() and finite.size == values.size:
        raise ImageError(f"{path}: the image is constant: every voxel is {finite.flat[0]}; nothing to tell apart")


def _inflate(path, packed, most):
    """Unpack zlib or gzip data of at most `most` bytes (and a little more, which is ignored)."""
    parts, got = [], 0
    try:
        while packed and got <= most:
            unpacker = zlib.decompressobj(47)
            while not unpacker.eof and got <= most:
                part = unpacker.decompress(packed, 1 << 24)
                packed = unpacker.unconsumed_tail
                parts.append(part)
                got += len(part)
                if not part and not packed and not unpacker.eof:
                    raise ImageError(f"{path}: truncated: the compressed data end early; copy the file again")
            packed = unpacker.unused_data.lstrip(b"\0")
    except zlib.error as error:
        raise ImageError(f"{path}: corrupted: the compressed data cannot be unpacked ({error}); copy the file again") from None
    return b"".join(parts)


def _take(path, data, dtype, sizes):
    """`data` as voxels; its size must be that of the header."""
    need = int(np.prod([int(n) for n in sizes])) * dtype.itemsize
    if len(data) < need:
        raise ImageError(f"{path}: truncated: the header promises {need} bytes of voxels, {len(data)} are there; "
                         "copy the file again")
    return np.frombuffer(data, dtype, need // dtype.itemsize).astype(dtype.newbyteorder("="), copy=False)


def _data_file(path, name):
    full = os.path.join(os.path.dirname(os.path.abspath(path)), name)
    if not os.path.isfile(full):
        raise ImageError(f"{path}: its data file {name} is missing; put it beside the header")
    return full


def _read_bytes(path, offset=0, most=None):
    with open(path, "rb") as file:
        file.seek(offset)
        return file.read() if most is None else file.read(most)


def _numbers(path, field, text, count=None):
    try:
        numbers = [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        raise ImageError(f"{path}: the header's {field} is not a list of numbers: {text}") from None
    if count is not None and len(numbers) != count:
        raise ImageError(f"{path}: the header's {field} has {len(numbers)} numbers, {count} are needed")
    return numbers


# MetaImage ------------------------------------------------------------------------------------------------------------

_META_TYPES = {
    "MET_CHAR": "i1", "MET_UCHAR": "u1", "MET_SHORT": "i2", "MET_USHORT": "u2", "MET_INT": "i4", "MET_UINT": "u4",
    "MET_LONG": "i4", "MET_ULONG": "u4", "MET_LONG_LONG": "i8", "MET_ULONG_LONG": "u8", "MET_FLOAT": "f4",
    "MET_DOUBLE": "f8"}


def _meta_header(path):
    head = _read_bytes(path, most=1 << 16)
    fields, at = {}, 0
    while True:
        end = head.find(b"\n", at)
        line = head[at:end if end >= 0 else len(head)].decode("latin-1")
        key, equals, value = line.partition("=")
        if not equals or not re.fullmatch(r"\s*\w+\s*", key):
            what = "not a MetaImage" if "NDims" not in fields else "the header ends without ElementDataFile"
            raise ImageError(f"{path}: {what}; is it truncated, or another format?")
        fields[key.strip()] = value.strip()
        at = end + 1
        if key.strip() == "ElementDataFile":
            return fields, at if end >= 0 else len(head)
        if end < 0:
            raise ImageError(f"{path}: truncated inside its header; copy the file again")


def _read_meta(path):
    fields, start = _meta_header(path)
    if fields.get("ObjectType", "Image") != "Image" or "DimSize" not in fields or "ElementType" not in fields:
        raise ImageError(f"{path}: a MetaImage header without DimSize or ElementType; not an image")
    if fields["ElementType"] not in _META_TYPES:
        raise ImageError(f"{path}: voxels of type {fields['ElementType']} are not supported")
    dims = int(_numbers(path, "NDims", fields.get("NDims", "3"), 1)[0])
    channels = int(_numbers(path, "ElementNumberOfChannels", fields.get("ElementNumberOfChannels", "1"), 1)[0])
    sizes = _check_sizes(path, _numbers(path, "DimSize", fields["DimSize"], dims), channels)

    def numbers(names, count, default):
        for name in names:
            if name in fields:
                return _numbers(path, name, fields[name], count)
        return default
    spacing = numbers(("ElementSpacing", "ElementSize"), dims, [1] * dims)[:3]
    origin = numbers(("Offset", "Position", "Origin"), dims, [0] * dims)[:3]
    matrix = numbers(("TransformMatrix", "Rotation", "Orientation"), dims * dims, np.eye(dims).ravel())
    # Row r of the matrix is the direction of axis r.
    axes = np.reshape(matrix, (dims, dims))[:3, :3].T * np.asarray(spacing)
    values = _meta_values(path, fields, start, sizes)
    return sizes, axes, origin, values


def _meta_values(path, fields, start, sizes):
    def true(*names):
        return any(fields.get(name, "").lower() in ("true", "1") for name in names)
    big = true("BinaryDataByteOrderMSB", "ElementByteOrderMSB")
    dtype = np.dtype((">" if big else "<") + _META_TYPES[fields["ElementType"]])
    name = fields["ElementDataFile"]
    if name == "LIST" or "%" in name:
        raise ImageError(f"{path}: voxels in a list of files are not supported; write one file")
    where, offset = (path, start) if name in ("LOCAL", "Local", "local") else (_data_file(path, name), 0)
    if fields.get("BinaryData", "True").lower() in ("false", "0"):
        return _text_values(path, _read_bytes(where, offset), dtype, sizes)
    need = int(np.prod(sizes)) * dtype.itemsize
    if true("CompressedData"):
        return _take(path, _inflate(path, _read_bytes(where, offset), need), dtype, sizes)
    skip = int(_numbers(path, "HeaderSize", fields.get("HeaderSize", "0"), 1)[0])
    if skip < 0:
        offset = max(os.path.getsize(where) - need, 0)
    return _take(path, _read_bytes(where, offset + max(skip, 0), need), dtype, sizes)


def _text_values(path, data, dtype, sizes):
    words = data.split()
    need = int(np.prod(sizes))
    if len(words) < need:
        raise ImageError(f"{path}: truncated: the header promises {need} voxels, {len(words)} are there")
    try:
        return np.array(words[:need], dtype=float).astype(dtype.newbyteorder("="))
    except ValueError:
        raise ImageError(f"{path}: the voxels are not numbers") from None


# NRRD -----------------------------------------------------------------------------------------------------------------

_NRRD_TYPES = {}
for _names, _type in (
        ("signed char|int8|int8_t", "i1"), ("uchar|unsigned char|uint8|uint8_t", "u1"),
        ("short|short int|signed short|signed short int|int16|int16_t", "i2"),
        ("ushort|unsigned short|unsigned short int|uint16|uint16_t", "u2"),
        ("int|signed int|int32|int32_t", "i4"), ("uint|unsigned int|uint32|uint32_t", "u4"),
        ("longlong|long long|long long int|signed long long|signed long long int|int64|int64_t", "i8"),
        ("ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t", "u8"),
        ("float", "f4"), ("double", "f8")):
    for _name in _names.split("|"):
        _NRRD_TYPES[_name] = _type


def _nrrd_header(path):
    head = _read_bytes(path, most=1 << 18)
    if not re.match(rb"NRRD000\d", head):
        raise ImageError(f"{path}: not an NRRD file (it does not begin with NRRD000)")
    blank = re.search(rb"\r?\n\r?\n", head)
    if not blank and not path.lower().endswith(".nhdr"):
        raise ImageError(f"{path}: truncated inside its header; copy the file again")
    text = head[:blank.start() if blank else len(head)].decode("latin-1")
    fields = {}
    for line in text.splitlines()[1:]:
        if line.startswith("#") or ":=" in line:
            continue
        key, colon, value = line.partition(":")
        if colon:
            fields[key.strip().lower()] = value.strip()
    for key in ("type", "dimension", "sizes", "encoding"):
        if key not in fields:
            raise ImageError(f"{path}: the NRRD header has no field \"{key}\"; is it truncated?")
    return fields, blank.end() if blank else len(head)


def _vectors(path, field, text):
    """The vectors of "(1,0,0) none (0,1,0)"; None for none."""
    vectors = []
    for word in re.findall(r"none|\([^)]*\)", text):
        vectors.append(None if word == "none" else _numbers(path, field, word.strip("()")))
    return vectors


def _nrrd_geometry(path, fields, dims):
    origin = [0.0] * 3
    if "space directions" in fields:
        axes = _vectors(path, "space directions", fields["space directions"])
        if any(axis is not None and len(axis) != 3 for axis in axes):
            raise ImageError(f"{path}: the NRRD space is not three-dimensional")
    else:
        steps = _numbers(path, "spacings", fields.get("spacings", " ".join(["1"] * dims)).replace("nan", "1"), dims)
        axes = [[step if a == b else 0.0 for b in range(3)] for a, step in enumerate(steps)]
        if "axis mins" in fields:
            mins = _numbers(path, "axis mins", fields["axis mins"].replace("nan", "0"), dims)
            origin = (mins + [0.0] * 3)[:3]
    if "space origin" in fields:
        found = _vectors(path, "space origin", fields["space origin"])
        origin = found[0] if found and found[0] is not None and len(found[0]) == 3 else origin
    return axes, origin


def _read_nrrd(path):
    fields, start = _nrrd_header(path)
    dims = int(_numbers(path, "dimension", fields["dimension"], 1)[0])
    sizes = [int(n) for n in _numbers(path, "sizes", fields["sizes"], dims)]
    axes, origin = _nrrd_geometry(path, fields, dims)
    if len(axes) != dims:
        raise ImageError(f"{path}: {len(axes)} space directions for {dims} dimensions")
    # An axis without a direction holds the components of a voxel.
    kinds = fields.get("kinds", "").split()
    inner = [a for a in range(dims) if axes[a] is None or
             (len(kinds) == dims and kinds[a] not in ("domain", "space", "???", "none", "time"))]
    components = int(np.prod([sizes[a] for a in inner], initial=1))
    space = [a for a in range(dims) if a not in inner]
    plain = _check_sizes(path, [sizes[a] for a in space], components)
    steps = np.array([axes[a] for a in space[:3]], float).T
    return plain, steps, origin, _nrrd_values(path, fields, start, plain)


def _nrrd_values(path, fields, start, sizes):
    if fields["type"].lower() not in _NRRD_TYPES:
        raise ImageError(f"{path}: voxels of type {fields['type']} are not supported")
    big = fields.get("endian", "little").lower() == "big"
    dtype = np.dtype((">" if big else "<") + _NRRD_TYPES[fields["type"].lower()])
    name = fields.get("data file", fields.get("datafile"))
    if name and (name.startswith("LIST") or "%" in name):
        raise ImageError(f"{path}: voxels in a list of files are not supported; write one file")
    if not name and path.lower().endswith(".nhdr"):
        raise ImageError(f"{path}: the header names no data file")
    data = _read_bytes(_data_file(path, name)) if name else _read_bytes(path, start)
    for _ in range(int(fields.get("line skip", fields.get("lineskip", 0)))):
        data = data[data.find(b"\n") + 1:]
    skip = int(fields.get("byte skip", fields.get("byteskip", 0)))
    need = int(np.prod(sizes)) * dtype.itemsize
    encoding = fields["encoding"].lower()
    if encoding in ("gz", "gzip"):
        data = _inflate(path, data, need + max(skip, 0))
    elif encoding in ("bz2", "bzip2"):
        try:
            data = bz2.decompress(data)
        except (OSError, ValueError):
            raise ImageError(f"{path}: corrupted or truncated: the compressed data cannot be unpacked") from None
    elif encoding in ("txt", "text", "ascii"):
        return _text_values(path, data, dtype, sizes)
    elif encoding != "raw":
        raise ImageError(f"{path}: the encoding {encoding} is not supported; use raw or gzip")
    data = data[len(data) - need:] if skip < 0 and len(data) >= need else data[max(skip, 0):]
    return _take(path, data, dtype, sizes)


# NIfTI ----------------------------------------------------------------------------------------------------------------

_NIFTI_TYPES = {2: "u1", 4: "i2", 8: "i4", 16: "f4", 64: "f8", 256: "i1", 512: "u2", 768: "u4", 1024: "i8", 1280: "u8"}
_NIFTI_HEADER = 348


def _read_nifti(path):
    packed = path.lower().endswith(".gz")
    raw = _read_bytes(path)
    if packed and raw[:2] != b"\x1f\x8b":
        raise ImageError(f"{path}: not a gzip file")
    head = _inflate(path, raw, _NIFTI_HEADER)[:_NIFTI_HEADER] if packed else raw[:_NIFTI_HEADER]
    if len(head) < _NIFTI_HEADER:
        raise ImageError(f"{path}: truncated inside its header, or not a NIfTI file")
    order = next((o for o in "<>" if struct.unpack(o + "i", head[:4])[0] == _NIFTI_HEADER), None)
    if order is None:
        if struct.unpack("<i", head[:4])[0] == 540 or struct.unpack(">i", head[:4])[0] == 540:
            raise ImageError(f"{path}: a NIfTI-2 file; convert it to NIfTI-1")
        raise ImageError(f"{path}: not a NIfTI file")
    if head[344:347] not in (b"n+1",):
        raise ImageError(f"{path}: a NIfTI header without its voxels in the same file; convert it to one .nii file")
    dims = struct.unpack(order + "8h", head[40:56])
    code, = struct.unpack(order + "h", head[70:72])
    if code not in _NIFTI_TYPES:
        many = {128: 3, 2304: 4, 32: 2, 1792: 2}.get(code)
        what = f"the image has {many} components per voxel" if many else f"voxels of NIfTI type {code} are not supported"
        raise ImageError(f"{path}: {what}; extract one first" if many else f"{path}: {what}")
    if not 1 <= dims[0] <= 7:
        raise ImageError(f"{path}: the header's number of dimensions is {dims[0]}; the file is corrupted")
    sizes = dims[1:dims[0] + 1]
    components = sizes[4] if len(sizes) > 4 else 1
    sizes = _check_sizes(path, sizes[:4], components)
    offset, slope, inter = struct.unpack(order + "3f", head[108:120])
    dtype = np.dtype(order + _NIFTI_TYPES[code])
    need = int(np.prod(sizes)) * dtype.itemsize
    data = _inflate(path, raw, int(offset) + need) if packed else raw
    values = _take(path, data[int(offset):], dtype, sizes)
    if np.isfinite(slope) and slope != 0 and (slope != 1 or inter != 0):
        values = values * np.float64(slope) + np.float64(inter)
    axes, origin = _nifti_geometry(path, head, order)
    return sizes, axes, origin, values


def _nifti_geometry(path, head, order):
    """The sform if there is one, else the qform, else the spacings alone."""
    pixdim = struct.unpack(order + "8f", head[76:108])
    qform, sform = struct.unpack(order + "2h", head[252:256])
    if sform > 0:
        rows = np.reshape(struct.unpack(order + "12f", head[280:328]), (3, 4))
        return rows[:, :3], rows[:, 3]
    steps = np.abs(pixdim[1:4])
    if qform <= 0:
        return np.diag(steps), np.zeros(3)
    b, c, d, x, y, z = struct.unpack(order + "6f", head[256:280])
    a = np.sqrt(max(0.0, 1.0 - b * b - c * c - d * d))
    rotation = np.array([
        [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c]])
    sign = -1.0 if pixdim[0] < 0 else 1.0
    return rotation * steps * np.array([1.0, 1.0, sign]), np.array([x, y, z])


# VTK's own ------------------------------------------------------------------------------------------------------------

def _read_vti(path):
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader
    head = _read_bytes(path, most=4096)
    if not re.match(rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)?<VTKFile", head, re.S):
        raise ImageError(f"{path}: not a VTK XML file")
    if not re.search(rb"<VTKFile[^>]*type=[\"']ImageData[\"']", head):
        raise ImageError(f"{path}: a VTK XML file that is not of type ImageData")
    if b"</VTKFile>" not in _read_bytes(path, max(os.path.getsize(path) - 4096, 0)):
        raise ImageError(f"{path}: truncated: the closing </VTKFile> is missing; copy the file again")
    reader = vtkXMLImageDataReader()
    errors = []
    for source in (reader, reader.GetExecutive()):
        source.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.SetFileName(path)
    reader.Update()
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    if errors or reader.GetErrorCode() or image.GetNumberOfPoints() == 0:
        from lamina_files import EXPAT, appended_works
        if b"<AppendedData" in _read_bytes(path) and not appended_works():
            raise ImageError(f"{path}: {EXPAT}")
        raise ImageError(f"{path}: damaged: VTK's reader could not read it; write or copy the file again")
    return _single_array(path, image)


def _single_array(path, image):
    points = image.GetPointData()
    arrays = [points.GetArray(a) for a in range(points.GetNumberOfArrays()) if points.GetArray(a)]
    active = points.GetScalars()
    if not arrays:
        cells = image.GetCellData().GetNumberOfArrays()
        raise ImageError(f"{path}: the image has no values on its points" +
                         ("; convert its cell data to point data" if cells else ""))
    if active is None and len(arrays) > 1:
        names = ", ".join(array.GetName() or "(no name)" for array in arrays)
        raise ImageError(f"{path}: the image has several arrays ({names}) and none is active; keep one")
    array = active or arrays[0]
    _check_sizes(path, image.GetDimensions(), array.GetNumberOfComponents())
    while points.GetNumberOfArrays():
        points.RemoveArray(0)
    points.SetScalars(array)
    # Count voxels from 0: a sub-extent's place goes into the origin.
    extent = image.GetExtent()
    origin = [0.0] * 3
    image.TransformContinuousIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin)
    sizes = image.GetDimensions()
    image.SetExtent(0, sizes[0] - 1, 0, sizes[1] - 1, 0, sizes[2] - 1)
    image.SetOrigin(origin)
    return image
