package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonToken;
import java.time.DateTimeException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * GeoJSON features: a {@code LineString} with {@code coordTimes} or {@code times} is the track of a
 * target, a {@code Point} with {@code time} and {@code id} one of its samples. Positions are
 * longitude and latitude (WGS84) unless a unit is given.
 */
final class GeoJsonFormat implements TrackFormat {
  private static final Set<String> TIME_LISTS =
      Set.of("coordTimes", "times", "coordinateProperties");

  private JsonStream json;
  private String timeName;
  private String idName;

  // The current feature.
  private final List<Positions.Position> points = new ArrayList<>();
  private final List<Double> times = new ArrayList<>();
  private String target;
  private int featureCount;

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.unit().orElse(Unit.DEG));
    timeName = recording.columns().getOrDefault("time", "time");
    idName = recording.columns().getOrDefault("id", "id");
    try (JsonStream stream = JsonStream.open(recording.file())) {
      json = stream;
      json.next();
      json.object(
          "a GeoJSON object",
          name -> {
            if (name.equals("features")) {
              json.array("an array of features", () -> feature(samples));
            }
          });
    }
    return Clock.SECONDS;
  }

  private void feature(SampleSink samples) {
    Place place = json.place();
    points.clear();
    times.clear();
    target = null;
    featureCount++;
    json.object("a feature", this::member);
    if (points.isEmpty()) {
      return;
    }
    if (times.size() != points.size()) {
      throw place.error(
          "the feature has %s positions and %s times, expected the same number: a property %s or"
              + " coordTimes",
          points.size(), times.size(), timeName);
    }
    for (int i = 0; i < points.size(); i++) {
      Positions.Position point = points.get(i);
      String name = target == null ? "feature " + featureCount : target;
      samples.accept(new TrackSample(point.place(), name, times.get(i), point.x(), point.y()));
    }
  }

  private void member(String name) {
    if (name.equals("id")) {
      target = target == null ? json.text() : target;
    } else if (name.equals("geometry") && json.isBegun()) {
      json.object("a geometry", this::coordinates);
    } else if (name.equals("properties") && json.isBegun()) {
      json.object("properties", this::property);
    }
  }

  private void coordinates(String name) {
    if (name.equals("coordinates")) {
      Positions.read(json).forEach(points::addAll);
    }
  }

  private void property(String name) {
    if (name.equals(timeName)) {
      times.add(time());
    } else if (name.equals(idName)) {
      target = json.text();
    } else if (TIME_LISTS.contains(name) && json.token() == JsonToken.START_OBJECT) {
      json.object("properties", this::property); // coordinateProperties contains times
    } else if (TIME_LISTS.contains(name)) {
      json.array("an array of times", () -> times.add(time()));
    }
  }

  /** Reads a time in ISO 8601, or a number of seconds. */
  private double time() {
    if (json.token() != JsonToken.VALUE_STRING) {
      return json.number("time");
    }
    try {
      return Clock.sinceEpoch(json.text());
    } catch (DateTimeException e) {
      throw json.invalid("time", "a time such as 2024-05-31T12:00:00Z, or a number of seconds");
    }
  }
}
