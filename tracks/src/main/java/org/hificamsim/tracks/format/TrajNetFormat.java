package org.hificamsim.tracks.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.data.JsonStream;

/**
 * TrajNet++: an object in each line. A {@code track} has the frame f, the pedestrian p, and x and y
 * in metres; a {@code scene} has {@code fps}, the number of a pedestrian's samples per second,
 * whatever the number of frames between them. A rate that the user gives is in frames and takes
 * precedence. Further predictions of the same way are left out. A pedestrian of another scene is
 * another one.
 */
final class TrajNetFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "trajnet",
          "TrajNet++: `{\"track\": {\"f\", \"p\", \"x\", \"y\"}}`, `{\"scene\": {..., \"fps\"}}`",
          "`fps` counts samples; `{rate}` counts frames",
          "m",
          TrajNetFormat::new);

  private static final List<String> TRACK_KEYS = List.of("f", "p", "x", "y");
  private static final String PREDICTION = "prediction_number";
  private static final String SCENE = "scene_id";
  private static final Pattern LINE = Pattern.compile("\\s*\\{\\s*\"(track|scene)\"\\s*:");

  private final Map<String, Double> firstScenes = new HashMap<>(); // by pedestrian
  private double fps = Double.NaN;

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    return FormatFit.of(
        LINE.matcher(start.text()).lookingAt(),
        "has lines of JSON with a track or a scene",
        "the file %s, TrajNet++ has lines {\"track\": {...}}".formatted(start.look()));
  }

  @Override
  public boolean reusesIds() {
    return true;
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.only(Unit.M));
    try (JsonStream json = JsonStream.open(recording.file())) {
      while (json.next() != null) {
        json.object(
            "an object with a track or a scene",
            name -> {
              if (name.equals("track")) {
                readTrack(json, samples);
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

  private void readTrack(JsonStream json, SampleSink samples) {
    Place place = json.place();
    Map<String, Double> values = new HashMap<>();
    json.object("a track", name -> values.put(name, json.value()));
    if (values.getOrDefault(PREDICTION, 0.0) > 0) {
      samples.leaveOut(Omission.MARKED, () -> place.error("a further prediction of the way"));
    } else {
      samples.reading(() -> samples.accept(sample(place, values)));
    }
  }

  private TrackSample sample(Place place, Map<String, Double> values) {
    double pedestrian = OddRows.part(Omission.NO_TARGET, () -> value(place, values, "p"));
    return new TrackSample(
        place,
        name(Long.toString((long) pedestrian), values.get(SCENE)),
        OddRows.part(Omission.NO_TIME, () -> value(place, values, "f")),
        OddRows.part(Omission.NO_PLACE, () -> coordinate(place, values, "x")),
        OddRows.part(Omission.NO_PLACE, () -> coordinate(place, values, "y")));
  }

  /** The name of a pedestrian, which has the scene from the second one on. */
  private String name(String pedestrian, Double scene) {
    if (scene == null || Double.isNaN(scene)) {
      return pedestrian;
    }
    double first = firstScenes.computeIfAbsent(pedestrian, key -> scene);
    return first == scene ? pedestrian : Texts.format("%s in scene %.0f", pedestrian, scene);
  }

  private static double value(Place place, Map<String, Double> values, String key) {
    double value = values.getOrDefault(key, Double.NaN);
    if (!Double.isFinite(value)) {
      throw place.error(
          "the track has no number %s, expected one each of %s",
          key, String.join(", ", TRACK_KEYS));
    }
    return value;
  }

  private static double coordinate(Place place, Map<String, Double> values, String key) {
    double value = value(place, values, key);
    if (Math.abs(value) > 1e9) {
      throw place.invalid(key, Double.toString(value), "a number from -1e9 to 1e9");
    }
    return value;
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
