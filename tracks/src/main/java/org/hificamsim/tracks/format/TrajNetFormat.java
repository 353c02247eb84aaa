package org.hificamsim.tracks.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * TrajNet++: an object in each line. A {@code track} has the frame f, the pedestrian p, and x and y
 * in metres; a {@code scene} has {@code fps}, the number of a pedestrian's samples per second,
 * whatever the number of frames between them. A rate that the user gives is in frames and takes
 * precedence.
 */
final class TrajNetFormat implements TrackFormat {
  private static final List<String> TRACK_KEYS = List.of("f", "p", "x", "y");

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
                samples.accept(sample(json));
              } else if (name.equals("scene")) {
                readScene(json);
              }
            });
      }
    }
    return recording.rate().isPresent() || Double.isNaN(fps)
        ? recording.frames()
        : new Clock(fps, true);
  }

  private static TrackSample sample(JsonStream json) {
    Place place = json.place();
    Map<String, Double> values = new HashMap<>();
    json.object(
        "a track",
        name -> {
          if (TRACK_KEYS.contains(name)) {
            values.put(name, "fp".contains(name) ? json.number(name) : json.coordinate(name));
          }
        });
    if (values.size() < TRACK_KEYS.size()) {
      throw place.error("the track lacks some of f, p, x and y, expected all");
    }
    String pedestrian = Long.toString(values.get("p").longValue());
    return new TrackSample(place, pedestrian, values.get("f"), values.get("x"), values.get("y"));
  }

  private void readScene(JsonStream json) {
    json.object(
        "a scene",
        name -> {
          if (name.equals("fps")) {
            readRate(json);
          }
        });
  }

  private void readRate(JsonStream json) {
    double before = fps;
    fps = json.number("fps");
    if (!(fps > 0) || (!Double.isNaN(before) && before != fps)) {
      throw json.invalid("fps", Double.isNaN(before) ? "a number above 0" : before + " as before");
    }
  }
}
