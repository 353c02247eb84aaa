"""Makes the photographs of `profile lab --texture photos` from three packages of PyPI.

    pip download --no-deps scikit-image==0.18.3 scipy==1.5.4 scikit-learn==1.5.2
    (any platform's wheels), unzip them into one folder, then, with Pillow and numpy:
    python make_photos.py FOLDER OUT

Each is cut to the middle square, and not enlarged.
"""

import bz2
import pathlib
import pickle
import sys

import numpy
from PIL import Image

TARGETS = ["astronaut", "chelsea", "china", "coffee", "coins", "hubble_deep_field", "raccoon", "rocket"]
BACKGROUNDS = ["ascent", "brick", "camera", "flower", "grass", "gravel", "retina"]


def read(folder, name):
    if name == "raccoon":
        pixels = bz2.decompress((folder / "scipy/misc/face.dat").read_bytes())
        return Image.fromarray(numpy.frombuffer(pixels, dtype="uint8").reshape(768, 1024, 3))
    if name == "ascent":
        with open(folder / "scipy/misc/ascent.dat", "rb") as file:
            return Image.fromarray(numpy.array(pickle.load(file)).astype("uint8"))
    for place in ("skimage/data", "sklearn/datasets/images"):
        for file in sorted((folder / place).glob(name + ".*")):
            return Image.open(file).convert("RGB")
    raise FileNotFoundError(name)


def square(image, most):
    side = min(image.size)
    left, top = (image.width - side) // 2, (image.height - side) // 2
    image = image.crop((left, top, left + side, top + side))
    return image if side <= most else image.resize((most, most), Image.Resampling.LANCZOS)


def main(folder, out):
    for kind, names, most in (("targets", TARGETS, 768), ("backgrounds", BACKGROUNDS, 512)):
        (out / kind).mkdir(parents=True, exist_ok=True)
        for name in names:
            square(read(folder, name), most).convert("RGB").save(out / kind / f"{name}.jpg", quality=88)


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
