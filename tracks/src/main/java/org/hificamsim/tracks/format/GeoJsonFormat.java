package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonToken;
import java.time.DateTimeException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * GeoJSON features: a {@code LineString} with {@code coordTimes} or {@code times} is a target's
 * track, a {@code Point} with {@code time} and {@code id} one of its samples. Longitude and
 * latitude (WGS84), or another unit where one is given.
 */
final class GeoJsonFormat implements TrackFormat {
  private static final Set<String> TIMES = Set.of("coordTimes", "times", "coordinateProperties");

  private JsonStream json;
  private String timeName;
  private String idName;

  // Of one feature.
  private final List<Positions.Position> points = new ArrayList<>();
  private final List<Double> times = new ArrayList<>();
  private String target;
  private int features;

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.unit().orElse(Unit.DEG));
    Map<String, String> columns = recording.columns();
    timeName = columns.getOrDefault("time", "time");
    idName = columns.getOrDefault("id", "id");
    try (JsonStream stream = JsonStream.open(recording.file())) {
      json = stream;
      json.next();
      requireStart(JsonToken.START_OBJECT, "a GeoJSON object");
      collection(samples);
    }
    return Clock.SECONDS;
  }

  private void requireStart(JsonToken token, String expected) {
    if (json.token() != token) {
      throw json.error("expected " + expected);
    }
  }

  private void collection(SampleSink samples) {
    while (json.nextProperty()) {
      boolean isFeatures = json.text().equals("features");
      json.next();
      if (isFeatures) {
        requireStart(JsonToken.START_ARRAY, "an array of features");
        while (json.next() == JsonToken.START_OBJECT) {
          feature(samples);
        }
      } else {
        json.skip();
      }
    }
  }

  private void feature(SampleSink samples) {
    Place place = json.place();
    points.clear();
    times.clear();
    target = null;
    features++;
    while (json.nextProperty()) {
      String name = json.text();
      json.next();
      member(name);
    }
    if (points.isEmpty()) {
      return;
    }
    if (times.size() != points.size()) {
      throw place.error(
          "the feature has %s positions and %s times, expected as many: a property %s or coordTimes"
              .formatted(points.size(), times.size(), timeName));
    }
    for (int i = 0; i < points.size(); i++) {
      Positions.Position point = points.get(i);
      String name = target == null ? "feature " + features : target;
      samples.accept(new Sample(point.place(), name, times.get(i), point.x(), point.y()));
    }
  }

  private void member(String name) {
    switch (name) {
      case "id" -> target = target == null ? json.text() : target;
      case "geometry" -> geometry();
      case "properties" -> properties();
      default -> json.skip();
    }
  }

  private void geometry() {
    if (json.token() != JsonToken.START_OBJECT) {
      return;
    }
    while (json.nextProperty()) {
      boolean coordinates = json.text().equals("coordinates");
      json.next();
      if (coordinates) {
        requireStart(JsonToken.START_ARRAY, "an array of coordinates");
        Positions.read(json).forEach(points::addAll);
      } else {
        json.skip();
      }
    }
  }

  private void properties() {
    if (json.token() != JsonToken.START_OBJECT) {
      return;
    }
    while (json.nextProperty()) {
      String name = json.text();
      json.next();
      property(name);
    }
  }

  private void property(String name) {
    if (name.equals(timeName)) {
      times.add(time());
    } else if (name.equals(idName)) {
      target = json.text();
    } else if (TIMES.contains(name) && json.token() == JsonToken.START_OBJECT) {
      properties(); // coordinateProperties holds times
    } else if (TIMES.contains(name)) {
      requireStart(JsonToken.START_ARRAY, "an array of times");
      while (json.next() != JsonToken.END_ARRAY) {
        times.add(time());
      }
    } else {
      json.skip();
    }
  }

  /** ISO 8601, or a number of seconds. */
  private double time() {
    if (json.token() != JsonToken.VALUE_STRING) {
      return json.number("time");
    }
    try {
      return Instants.seconds(json.text());
    } catch (DateTimeException e) {
      throw json.invalid("time", "as 2024-05-31T12:00:00Z, or a number of seconds");
    }
  }
}
