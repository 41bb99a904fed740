#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""Write the heart phantom: pvpython heart_phantom.py OUTPUT.vti [--resolution N] [--labels] [--open]"""
import argparse
import os
import sys

from vtkmodules.vtkIOXML import vtkXMLImageDataWriter


def main():
    parser = argparse.ArgumentParser(description="Write the heart phantom as an image.")
    parser.add_argument("output")
    parser.add_argument("--resolution", type=int, default=120)
    parser.add_argument("--labels", action="store_true", help="the true materials instead of grey values")
    parser.add_argument("--open", action="store_true", help="great vessels leave through the image's border")
    options = parser.parse_args()
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    from lamina_files import prepare
    from lamina_pipeline import Failed, Pipeline, load_plugin, simple
    pipeline = Pipeline()
    try:
        load_plugin()
        pipeline.begin("Heart Phantom")
        source = simple.HeartPhantom(Resolution=options.resolution, OpenVessels=int(options.open))
        image, labels = pipeline.update(source, (0, 1))
        pipeline.end(voxels=image.GetNumberOfPoints())
    except Failed as error:
        sys.exit(f"heart_phantom: error: {error}")
    writer = vtkXMLImageDataWriter()
    prepare(writer)
    writer.SetFileName(options.output + ".part")
    writer.SetInputData(labels if options.labels else image)
    if not writer.Write() or writer.GetErrorCode():
        sys.exit(f"heart_phantom: error: {options.output} cannot be written")
    os.replace(options.output + ".part", options.output)


if __name__ == "__main__":
    main()
