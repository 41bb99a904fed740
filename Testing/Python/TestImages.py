# SPDX-License-Identifier: BSD-3-Clause
"""Reading images: voxels and places of every format, and one clear line for every broken file. Argument: Examples."""
import os
import sys
import tempfile

import numpy as np

sys.path[:0] = [sys.argv[1], os.path.dirname(os.path.abspath(__file__))]
import files  # noqa: E402
from lamina_images import ImageError, read_image, scalars_of  # noqa: E402

failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text)


def expect_place(image, what, axes=files.AXES, origin=files.ORIGIN):
    for index in ((0, 0, 0), (1, 0, 0), (0, 2, 0), (3, 1, 2)):
        world = [0.0] * 3
        image.TransformContinuousIndexToPhysicalPoint(*index, world)
        truth = axes @ np.array(index) + origin
        check(np.allclose(world, truth, atol=1e-5), f"{what}: voxel {index} is at {world}, not {truth}")


def expect_good(path, what=None, values=None):
    what = what or os.path.basename(path)
    try:
        image = read_image(path)
    except ImageError as error:
        check(False, f"{what}: {error}")
        return
    check(np.array_equal(scalars_of(image), files.sample() if values is None else values), f"{what}: other voxels")
    expect_place(image, what)


def expect_bad(path, *words):
    try:
        read_image(path)
        check(False, f"{os.path.basename(path)} was accepted; expected {words}")
    except ImageError as error:
        text = str(error)
        check(os.path.basename(path) in text, f"no file name in: {text}")
        check("\n" not in text, f"more than a line: {text}")
        for word in words:
            check(word in text, f"{os.path.basename(path)}: '{word}' is not in: {text}")


def good(folder):
    for big in (False, True):
        for packed in (False, True):
            tag = f"{'big' if big else 'little'}-{'packed' if packed else 'raw'}"
            expect_good(files.meta(folder, f"{tag}.mha", big=big, packed=packed))
            expect_good(files.meta(folder, f"{tag}.mhd", big=big, packed=packed, detached=f"{tag}.meta"))
            expect_good(files.nrrd(folder, f"{tag}.nrrd", big=big, packed=packed))
            expect_good(files.nrrd(folder, f"{tag}.nhdr", big=big, packed=packed, detached=f"{tag}.data"))
        expect_good(files.nifti(folder, f"{big}.nii", big=big))
        expect_good(files.nifti(folder, f"{big}.nii.gz", big=big))
    expect_good(files.nifti(folder, "qform.nii", form="q"))
    expect_good(files.nifti(folder, "slope.nii", slope=2.0), values=files.sample() * 2.0 + 5.0)
    expect_good(files.vti(folder, "good.vti"))
    expect_good(files.nrrd(folder, "component.nrrd", dims=4, sizes="1 6 5 4"))
    expect_good(files.nrrd(folder, "skip.nrrd", data=b"xxxx" + files.sample().astype("<i2").tobytes(), more="byte skip: 4\n"))
    mirrored = files.AXES * [1, 1, -1]
    image = read_image(files.meta(folder, "mirrored.mha", axes=mirrored))
    expect_place(image, "mirrored", axes=mirrored)
    upper = files.meta(folder, "UPPER.MHA")
    expect_good(upper)


def bad(folder):
    expect_bad(os.path.join(folder, "missing.mha"), "no such file")
    expect_bad(files.write(folder, "photo.png", b"\x89PNG"), "not an image format known here")
    expect_bad(files.write(folder, "none.nrrd"), "empty")
    for name in ("text.mha", "text.mhd"):
        expect_bad(files.write(folder, name, "hello\nworld\n"), "not a MetaImage")
    expect_bad(files.write(folder, "text.nrrd", "hello"), "not an NRRD")
    expect_bad(files.write(folder, "text.nhdr", "hello"), "not an NRRD")
    expect_bad(files.write(folder, "text.nii", "hello" * 100), "not a NIfTI")
    expect_bad(files.write(folder, "text.nii.gz", "hello"), "not a gzip")
    expect_bad(files.write(folder, "text.vti", "hello"), "not a VTK XML")
    expect_bad(files.write(folder, "other.vti", '<VTKFile type="PolyData"></VTKFile>'), "not of type ImageData")
    for keep in (0.3, 0.6, 0.97):
        for make, name in ((files.meta, "t.mha"), (files.nrrd, "t.nrrd"), (files.nifti, "t.nii"),
                           (files.nifti, "t.nii.gz"), (files.vti, "t.vti")):
            cut = files.shortened(make(folder, name), keep, f"cut{int(100 * keep)}-{name}")
            expect_bad(cut)
        for make, name in ((files.meta, "p.mha"), (files.nrrd, "p.nrrd")):
            expect_bad(files.shortened(make(folder, name, packed=True), keep, f"cut{int(100 * keep)}-{name}"))
    for make, name in ((files.meta, "d.mhd"), (files.nrrd, "d.nhdr")):
        path = make(folder, name, detached="d.raw")
        files.shortened(os.path.join(folder, "d.raw"), 0.5, "d.raw")
        expect_bad(path, "truncated")
        os.remove(os.path.join(folder, "d.raw"))
        expect_bad(path, "d.raw is missing")
    path = files.nifti(folder, "damaged.nii.gz")
    with open(path, "r+b") as file:
        file.seek(60)
        file.write(b"\xff" * 12)
    expect_bad(path)
    sheared = files.AXES + np.array([[0, 0, 0.4], [0, 0, 0], [0, 0, 0]])
    for make, name in ((files.nrrd, "sheared.nrrd"), (files.nifti, "sheared.nii"), (files.meta, "sheared.mha")):
        expect_bad(make(folder, name, axes=sheared), "sheared")
    flat = files.sample()[:1]
    expect_bad(files.meta(folder, "flat.mha", data=flat, sizes="6 5 1"), "2-D")
    expect_bad(files.meta(folder, "flat2.mha", data=flat, sizes="6 5"), "2-D")
    expect_bad(files.nrrd(folder, "flat.nrrd", data=flat, sizes="6 5", dims=2), "2-D")
    expect_bad(files.nifti(folder, "flat.nii", data=flat, sizes=(6, 5, 1)), "2-D")
    expect_bad(files.vti(folder, "flat.vti", data=flat), "2-D")
    many = files.sample().astype("<i2").tobytes() * 3
    expect_bad(files.meta(folder, "rgb.mha", data=many, extra="ElementNumberOfChannels = 3\n"), "3 components")
    expect_bad(files.nrrd(folder, "rgb.nrrd", data=many, dims=4, sizes="3 6 5 4"), "3 components")
    expect_bad(files.nifti(folder, "rgb.nii", data=many, code=128), "3 components")
    expect_bad(files.vti(folder, "rgb.vti", components=3), "3 components")
    expect_bad(files.meta(folder, "same.mha", data=files.sample() * 0 + 3), "constant: every voxel is 3")
    check(read_image(files.meta(folder, "same2.mha", data=files.sample() * 0 + 1), allow_constant=True) is not None, "mask")
    expect_bad(files.nifti(folder, "pair.nii", magic=b"ni1\0"), "without its voxels")
    expect_bad(files.meta(folder, "huge.mha", sizes="6000 50000 40000"), "voxels")


def main():
    with tempfile.TemporaryDirectory() as folder:
        good(folder)
        bad(folder)
    sys.stdout.flush()
    if failures:
        sys.exit(f"{len(failures)} failures")
    print("all images as expected")


if __name__ == "__main__":
    main()
