package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.json.JsonFile;
import org.hificamsim.hifi.json.JsonObject;

/** The boxes of a COCO annotation file, by picture and category. */
final class CocoPatches {
  private static final double MAX = 1e9;
  private static final int MAX_BYTES = 64 << 20;

  private record Box(String category, Patch patch) {}

  private final Map<String, List<Box>> boxes = new LinkedHashMap<>();

  private CocoPatches() {}

  /** Returns an instance without boxes. */
  static CocoPatches none() {
    return new CocoPatches();
  }

  /**
   * Reads {@code images}, {@code annotations} and {@code categories}; ignores other properties.
   *
   * @throws InputException with line and column, when the file is not in COCO's format
   */
  static CocoPatches read(Path file) {
    JsonObject json = JsonFile.read(file, "a COCO annotation file", MAX_BYTES);
    Map<Long, String> images = new LinkedHashMap<>();
    json.objects("images").forEach(image -> images.put(id(image, "id"), image.text("file_name")));
    Map<Long, String> categories = new LinkedHashMap<>();
    json.objects("categories")
        .forEach(category -> categories.put(id(category, "id"), category.text("name")));
    CocoPatches patches = new CocoPatches();
    for (JsonObject annotation : json.objects("annotations")) {
      String image = images.get(id(annotation, "image_id"));
      if (image == null) {
        throw annotation.error("image_id", "expected an id of images");
      }
      String category = categories.getOrDefault(id(annotation, "category_id"), "");
      Box box = new Box(category, patch(annotation.numbers("bbox", 4, 0, MAX)));
      patches.boxes.computeIfAbsent(image, name -> new ArrayList<>()).add(box);
    }
    return patches;
  }

  /** Returns the box of an object in a picture: the one of its category, or else the only one. */
  Optional<Patch> patch(String image, String object) {
    List<Box> inImage = boxes.getOrDefault(image, List.of());
    List<Box> ofCategory = inImage.stream().filter(box -> box.category().equals(object)).toList();
    List<Box> candidates = ofCategory.isEmpty() ? inImage : ofCategory;
    return candidates.size() == 1 ? Optional.of(candidates.get(0).patch()) : Optional.empty();
  }

  /** Rounds the edges of a box to whole pixels, so that none moves out of the picture. */
  private static Patch patch(double[] box) {
    int left = (int) Math.round(box[0]);
    int top = (int) Math.round(box[1]);
    int right = (int) Math.round(box[0] + box[2]);
    int bottom = (int) Math.round(box[1] + box[3]);
    return new Patch(left, top, right - left, bottom - top);
  }

  private static long id(JsonObject json, String key) {
    return (long) json.number(key, 0, 1e15);
  }
}
