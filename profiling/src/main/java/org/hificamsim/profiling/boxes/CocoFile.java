package org.hificamsim.profiling.boxes;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.core.JsonToken;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;
import org.hificamsim.profiling.boxes.CocoBox.Reader;
import org.hificamsim.profiling.check.Calibration.Size;

/**
 * COCO's format: labels are an object with {@code images}, {@code annotations} and {@code
 * categories}; results are a list of boxes with an {@code image_id}, a {@code category_id} and a
 * {@code score}, or an object like that of labels. The id of an image is its frame.
 */
final class CocoFile implements BoxFile {
  private static final Set<String> PEOPLE = Set.of("person", "pedestrian", "people");
  private static final String PERSON_ID = "1";
  private static final String EXPECTED =
      "an object with images, annotations and categories, or a list of results, as COCO has them";

  private final Path file;
  private final BoxRecording.Reading reading;
  private final Set<Long> images = new HashSet<>();
  private final Map<String, Long> categories = new LinkedHashMap<>();
  private final List<CocoBox> boxes = new ArrayList<>();
  private Optional<Size> picture = Optional.empty();
  private boolean isList;

  CocoFile(Path file, BoxRecording.Reading reading) {
    this.file = file;
    this.reading = reading;
  }

  @Override
  public void labels(LabelListener listener) {
    read();
    if (isList) {
      throw new Place(file.toString(), 1, 1)
          .error("the file is a list of results, expected labels with images and categories");
    }
    long type = type();
    SeenIds ids = new SeenIds();
    for (CocoBox box : boxes) {
      requireImage(box);
      boolean counted = box.category() == type && !box.crowd();
      if (box.person() != null && counted) {
        ids.add(box.place(), box.image(), box.person());
      }
      listener.label(box.image(), new LabelledBox(box.person(), box.box(), Double.NaN, counted));
    }
  }

  @Override
  public void detections(BoxFile labels, DetectedFrames detected) {
    read();
    CocoFile names = categories.isEmpty() && labels instanceof CocoFile named ? named : this;
    long type = names.categories.isEmpty() ? unnamedType() : names.type();
    for (CocoBox box : boxes) {
      names.requireImage(box);
      if (box.category() == type && box.score() >= reading.leastScore()) {
        detected.add(box.place(), box.image(), box.box());
      }
    }
  }

  private void requireImage(CocoBox box) {
    if (!images.isEmpty() && !images.contains(box.image())) {
      throw box.place().error("image_id is %s, expected an id of images", box.image());
    }
  }

  /** The id of the category that counts. */
  private long type() {
    if (reading.type().isPresent()) {
      return Optional.ofNullable(categories.get(reading.type().get())).orElseThrow(this::noType);
    }
    return categories.entrySet().stream()
        .filter(category -> categories.size() == 1 || PEOPLE.contains(category.getKey()))
        .map(Map.Entry::getValue)
        .findFirst()
        .orElseThrow(this::noType);
  }

  /** The id of the category that counts, where no file names categories. */
  private long unnamedType() {
    String id = reading.type().orElse(PERSON_ID);
    if (boxes.stream().noneMatch(box -> String.valueOf(box.category()).equals(id))) {
      throw InputException.of(
          "%s: no box has category_id %s, expected %s, since no file names the categories",
          file, id, setting("class", "ID"));
    }
    return Long.parseLong(id);
  }

  private InputException noType() {
    return InputException.of(
        "%s: the categories are %s, expected person among them, or %s",
        file,
        categories.isEmpty() ? "missing" : String.join(", ", categories.keySet()),
        setting("class", "NAME"));
  }

  private void read() {
    try (JsonStream json = JsonStream.open(file)) {
      JsonToken first = json.next();
      isList = first == JsonToken.START_ARRAY;
      if (isList) {
        json.array(EXPECTED, () -> boxes.add(new Reader(json).read()));
      } else if (first == JsonToken.START_OBJECT) {
        readObject(json);
      } else {
        throw new Place(file.toString(), 1, 1).error("this is no COCO file, expected " + EXPECTED);
      }
    }
  }

  private void readObject(JsonStream json) {
    Set<String> found = new HashSet<>();
    json.object(
        EXPECTED,
        name -> {
          found.add(name);
          switch (name) {
            case "images" -> json.array("a list of images", () -> readImage(json));
            case "annotations" ->
                json.array("a list of annotations", () -> boxes.add(new Reader(json).read()));
            case "categories" -> json.array("a list of categories", () -> readCategory(json));
            default -> {}
          }
        });
    for (String name : List.of("images", "annotations", "categories")) {
      if (!found.contains(name)) {
        throw new Place(file.toString(), 1, 1)
            .error("there is no '%s', expected %s", name, EXPECTED);
      }
    }
  }

  private void readImage(JsonStream json) {
    Map<String, Double> numbers = new LinkedHashMap<>();
    Place place = json.place();
    json.object(
        "an image",
        name -> {
          if (Set.of("id", "width", "height").contains(name)) {
            numbers.put(name, json.number(name));
          }
        });
    if (!numbers.containsKey("id")) {
      throw place.error("the image has no id, expected a number");
    }
    images.add(numbers.get("id").longValue());
    if (numbers.containsKey("width") && numbers.containsKey("height")) {
      picture = Optional.of(new Size(numbers.get("width"), numbers.get("height")));
    }
  }

  private void readCategory(JsonStream json) {
    Map<String, String> texts = new LinkedHashMap<>();
    Place place = json.place();
    json.object(
        "a category",
        name -> {
          if (name.equals("name")) {
            texts.put(name, json.text());
          } else if (name.equals("id")) {
            texts.put(name, String.valueOf((long) json.number(name)));
          }
        });
    if (texts.size() < 2) {
      throw place.error("the category has no id or no name, expected both");
    }
    categories.put(texts.get("name"), Long.parseLong(texts.get("id")));
  }

  @Override
  public Optional<Size> picture() {
    return reading.picture().or(() -> picture);
  }
}
