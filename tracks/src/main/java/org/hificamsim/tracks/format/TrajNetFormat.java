package org.hificamsim.tracks.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * TrajNet++: objects, one a line, each a {@code track} with frame f, pedestrian p, x and y in
 * metres, or a {@code scene}, whose {@code fps} counts a pedestrian's samples, whatever the
 * distance of two frames. A rate that the user gives counts frames and takes precedence.
 */
final class TrajNetFormat implements TrackFormat {
  private static final List<String> NUMBERS = List.of("f", "p", "x", "y");

  private double fps = Double.NaN;

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.only(Unit.M));
    try (JsonStream json = JsonStream.open(recording.file())) {
      while (json.next() != null) {
        json.object(
            "an object with a track or a scene",
            name -> {
              if (name.equals("track")) {
                samples.accept(track(json));
              } else if (name.equals("scene")) {
                scene(json);
              }
            });
      }
    }
    return recording.rate().isPresent() || Double.isNaN(fps)
        ? recording.frames()
        : new Clock(fps, true);
  }

  private static Sample track(JsonStream json) {
    Place place = json.place();
    Map<String, Double> found = new HashMap<>();
    json.object(
        "a track",
        name -> {
          if (NUMBERS.contains(name)) {
            found.put(name, "fp".contains(name) ? json.number(name) : json.coordinate(name));
          }
        });
    if (found.size() < NUMBERS.size()) {
      throw place.error("a track without all of f, p, x and y, expected them");
    }
    String pedestrian = Long.toString(found.get("p").longValue());
    return new Sample(place, pedestrian, found.get("f"), found.get("x"), found.get("y"));
  }

  private void scene(JsonStream json) {
    json.object(
        "a scene",
        name -> {
          if (name.equals("fps")) {
            rate(json);
          }
        });
  }

  private void rate(JsonStream json) {
    double before = fps;
    fps = json.number("fps");
    if (!(fps > 0) || (!Double.isNaN(before) && before != fps)) {
      throw json.invalid("fps", Double.isNaN(before) ? "a number above 0" : before + " as before");
    }
  }
}
