package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonToken;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * GeoJSON features: a {@code LineString} or {@code MultiLineString} with {@code coordTimes} or
 * {@code times} is the track of a target, which is absent between the parts; a {@code Point} with
 * {@code time} and {@code id} is one of its samples. Positions are longitude and latitude (WGS84)
 * unless a unit is given. Features without times, such as waypoints, are left out.
 */
final class GeoJsonFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "geojson",
          "`LineString` or `MultiLineString` with `coordTimes` or `times`, or `Point` with `time`"
              + " and `id`",
          "any",
          "WGS84, or `{unit}`",
          GeoJsonFormat::new);

  private static final Set<String> TIME_LISTS =
      Set.of("coordTimes", "times", "coordinateProperties");
  private static final Pattern TYPE =
      Pattern.compile("\"(features|geometry)\"\\s*:|\"type\"\\s*:\\s*\"Feature");

  private final Times clock = new Times();
  private JsonStream json;
  private String timeName;
  private String idName;
  private int featureCount;
  private boolean hasIds = true;

  // The current feature.
  private final List<List<Positions.Position>> parts = new ArrayList<>();
  private final List<Double> times = new ArrayList<>();
  private InputException wrongTime; // null if all times are right
  private String target;
  private Place place;

  @Override
  public boolean namesColumns() {
    return true;
  }

  @Override
  public Unit usualUnit() {
    return Unit.DEG;
  }

  @Override
  public boolean hasIds() {
    return hasIds;
  }

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    return FormatFit.of(
        start.isJson() && TYPE.matcher(start.text()).find(),
        "has features",
        "the file %s, GeoJSON has features".formatted(start.look()));
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.unit().orElse(Unit.DEG));
    timeName = recording.columns().getOrDefault("time", "time");
    idName = recording.columns().getOrDefault("id", "id");
    try (JsonStream stream = JsonStream.open(recording.file())) {
      json = stream;
      json.next();
      begin();
      json.object(
          "a GeoJSON object",
          name -> {
            if (name.equals("features")) {
              json.array("an array of features", () -> readFeature(samples));
            } else {
              readMember(name);
            }
          });
      end(samples); // the file may be one feature
    }
    return Clock.SECONDS;
  }

  private void readFeature(SampleSink samples) {
    begin();
    json.object("a feature", this::readMember);
    end(samples);
  }

  private void begin() {
    place = json.place();
    parts.clear();
    times.clear();
    wrongTime = null;
    target = null;
    featureCount++;
  }

  private void readMember(String name) {
    if (name.equals("id")) {
      target = target == null ? json.text() : target;
    } else if (name.equals("geometry") && json.isBegun()) {
      json.object("a geometry", this::readGeometry);
    } else if (name.equals("properties") && json.isBegun()) {
      json.object("properties", this::readProperty);
    }
  }

  private void readGeometry(String name) {
    if (name.equals("coordinates")) {
      parts.addAll(Positions.read(json));
    }
  }

  private void readProperty(String name) {
    if (name.equals(timeName)) {
      times.add(time());
    } else if (name.equals(idName)) {
      target = json.text();
    } else if (TIME_LISTS.contains(name) && json.token() == JsonToken.START_OBJECT) {
      json.object("properties", this::readProperty); // coordinateProperties contains times
    } else if (TIME_LISTS.contains(name)) {
      readTimes();
    }
  }

  /** Reads an array of times, or of such arrays. */
  private void readTimes() {
    json.array(
        "an array of times",
        () -> {
          if (json.token() == JsonToken.START_ARRAY) {
            readTimes();
          } else {
            times.add(time());
          }
        });
  }

  /** Reads a time; NaN if the value is none. */
  private double time() {
    double number = json.value();
    double seconds = clock.seconds(Double.isNaN(number) ? json.text() : Double.toString(number));
    if (Double.isNaN(seconds) && wrongTime == null) {
      wrongTime = json.invalid("time", clock.expected(json.text()));
    }
    return seconds;
  }

  private void end(SampleSink samples) {
    int positions = parts.stream().mapToInt(List::size).sum();
    if (positions == times.size()) {
      accept(samples);
    } else if (positions > 0) {
      boolean isWaypoint = positions == 1 && times.isEmpty();
      InputException reason = unequal(positions);
      samples.leaveOut(isWaypoint ? Omission.NO_TRACK : Omission.NO_TIME, () -> reason);
    }
    parts.clear();
    times.clear();
  }

  private InputException unequal(int positions) {
    return place.error(
        "the feature has %s positions and %s times, expected the same number: a property %s or"
            + " coordTimes",
        positions, times.size(), timeName);
  }

  private void accept(SampleSink samples) {
    hasIds &= target != null;
    String name = target == null ? "feature " + featureCount : target;
    int index = 0;
    for (List<Positions.Position> part : parts) {
      if (index > 0) {
        samples.pause(name);
      }
      for (Positions.Position position : part) {
        double time = times.get(index++);
        samples.reading(
            () ->
                samples.accept(
                    new TrackSample(
                        position.place(),
                        name,
                        OddRows.part(Omission.NO_TIME, () -> known(time)),
                        position.x(),
                        position.y())));
      }
    }
  }

  private double known(double time) {
    if (Double.isNaN(time)) {
      throw wrongTime;
    }
    return time;
  }
}
