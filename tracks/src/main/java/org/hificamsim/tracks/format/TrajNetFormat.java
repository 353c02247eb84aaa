package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonToken;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * TrajNet++: objects, one a line, each a {@code track} with frame f, pedestrian p, x and y in
 * metres, or a {@code scene}, whose {@code fps} counts a pedestrian's samples, whatever the
 * distance of two frames. A rate that is given beside the file counts frames and comes before it.
 */
final class TrajNetFormat implements TrackFormat {
  private double fps = Double.NaN;

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.only(Unit.M));
    try (JsonStream json = JsonStream.open(recording.file())) {
      while (json.next() != null) {
        object(json, samples);
      }
    }
    return clock(recording);
  }

  private Clock clock(Recording recording) {
    return recording.rate().isPresent() || Double.isNaN(fps)
        ? recording.frames()
        : new Clock(fps, true);
  }

  private void object(JsonStream json, SampleSink samples) {
    if (json.token() != JsonToken.START_OBJECT) {
      throw json.error("expected an object with a track or a scene");
    }
    while (json.nextProperty()) {
      String name = json.text();
      json.next();
      if (name.equals("track")) {
        samples.accept(track(json));
      } else if (name.equals("scene")) {
        scene(json);
      } else {
        json.skip();
      }
    }
  }

  private static Sample track(JsonStream json) {
    Place place = json.place();
    double frame = Double.NaN;
    double pedestrian = Double.NaN;
    double x = Double.NaN;
    double y = Double.NaN;
    requireObject(json, "track");
    while (json.nextProperty()) {
      String name = json.text();
      json.next();
      switch (name) {
        case "f" -> frame = json.number(name);
        case "p" -> pedestrian = json.number(name);
        case "x" -> x = json.coordinate(name);
        case "y" -> y = json.coordinate(name);
        default -> json.skip();
      }
    }
    if (Double.isNaN(frame + pedestrian + x + y)) {
      throw place.error("a track without all of f, p, x and y, expected them");
    }
    return new Sample(place, Long.toString((long) pedestrian), frame, x, y);
  }

  private static void requireObject(JsonStream json, String name) {
    if (json.token() != JsonToken.START_OBJECT) {
      throw json.invalid(name, "an object");
    }
  }

  private void scene(JsonStream json) {
    requireObject(json, "scene");
    while (json.nextProperty()) {
      String name = json.text();
      json.next();
      if (name.equals("fps")) {
        rate(json);
      } else {
        json.skip();
      }
    }
  }

  private void rate(JsonStream json) {
    double before = fps;
    fps = json.number("fps");
    if (!(fps > 0) || (!Double.isNaN(before) && before != fps)) {
      throw json.invalid("fps", Double.isNaN(before) ? "a number above 0" : before + " as before");
    }
  }
}
