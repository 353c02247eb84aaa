package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * A box of a COCO file.
 *
 * @param person the id of its track; null if it has none
 * @param score the detector's score in [0, 1]; 1 if the file has none
 * @param crowd whether the box is around several people
 */
record CocoBox(
    Place place, long image, long category, String person, Box box, double score, boolean crowd) {
  /** Reads one annotation or result. */
  static final class Reader {
    private final JsonStream json;
    private final Place place;
    private final List<Double> corners = new ArrayList<>();
    private long image = -1;
    private long category = -1;
    private String person;
    private double score = 1;
    private boolean crowd;

    Reader(JsonStream json) {
      this.json = json;
      this.place = json.place();
    }

    CocoBox read() {
      json.object("a box with image_id, category_id and bbox", this::property);
      require(image >= 0, "image_id");
      require(category >= 0, "category_id");
      require(!corners.isEmpty(), "bbox");
      Box box = BoxFile.box(place, corners.get(0), corners.get(1), corners.get(2), corners.get(3));
      return new CocoBox(place, image, category, person, box, score, crowd);
    }

    private void require(boolean has, String name) {
      if (!has) {
        throw place.error("the box has no %s, expected image_id, category_id and bbox", name);
      }
    }

    private void property(String name) {
      switch (name) {
        case "image_id" -> image = id(name);
        case "category_id" -> category = id(name);
        case "bbox" -> readCorners();
        case "score" -> score = BoxFile.score(json.place(), json.number(name));
        case "iscrowd" -> crowd = json.text().equals("1") || json.text().equals("true");
        case "track_id", "instance_id" -> person = json.text();
        case "attributes" -> readAttributes();
        default -> {}
      }
    }

    private void readAttributes() {
      if (json.isBegun()) {
        json.object("attributes", name -> person = name.equals("track_id") ? json.text() : person);
      }
    }

    private long id(String name) {
      double id = json.number(name);
      if (id != Math.rint(id) || id < 0) {
        throw json.invalid(name, "a whole number of 0 or more");
      }
      return (long) id;
    }

    private void readCorners() {
      Place list = json.place();
      json.array("a bbox of four numbers", () -> corners.add(json.coordinate("bbox")));
      if (corners.size() != 4) {
        throw list.error(
            "bbox has %s numbers, expected left, top, width and height", corners.size());
      }
    }
  }
}
