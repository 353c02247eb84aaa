"""Puts all photos of one object of a laboratory on one sheet, as Figure 3.6: photos.py LAB SHEET.jpg [OBJECT]; pip install pillow. A row for each distance, a column for each focal length."""

import csv
import pathlib
import sys

from PIL import Image

WIDTH, HEIGHT = 120, 80

lab, sheet = pathlib.Path(sys.argv[1]), sys.argv[2]
with open(lab / "dataset.csv", newline="") as file:
    photos = list(csv.DictReader(file))
wanted = sys.argv[3] if len(sys.argv) > 3 else photos[0]["object"]
places = {
    (float(photo["distance_m"]), float(photo["focal_length_m"])): lab / photo["image"]
    for photo in photos
    if photo["object"] == wanted
}
distances, focal_lengths = (sorted({place[i] for place in places}) for i in (0, 1))
picture = Image.new("RGB", (WIDTH * len(focal_lengths), HEIGHT * len(distances)), "white")
for (distance, focal_length), photo in places.items():
    with Image.open(photo) as one:
        corner = (WIDTH * focal_lengths.index(focal_length), HEIGHT * distances.index(distance))
        picture.paste(one.convert("RGB").resize((WIDTH - 2, HEIGHT - 2)), corner)
picture.save(sheet, quality=55)
print(f"{sheet}: {len(places)} photos of {wanted}")
