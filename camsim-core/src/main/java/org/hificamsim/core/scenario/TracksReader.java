package org.hificamsim.core.scenario;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.hificamsim.core.file.TextLines;

/**
 * Reads the element {@code tracks}: the targets of a file next to the scenario, or of the element's
 * own text, each as two events, one that adds it and one that removes it.
 */
final class TracksReader {
  static final Element<Track> ELEMENT =
      Element.<Track>of(
              "tracks",
              """
              Targets that come, move and go as they were recorded; once in a file (ours).
              file: path of the file of tracks, from the scenario's folder \
              | the tracks are the element's text
              """)
          .holds("#xs:string");
  static final Property<Track, String> FILE = ELEMENT.optional("file", Type.TEXT);

  private final Path scenario;
  private final Field field;
  private final double stepTime;
  private final Consumer<String> warnings;

  /**
   * @param scenario from whose folder paths are
   * @param stepTime seconds
   */
  TracksReader(Path scenario, Field field, double stepTime, Consumer<String> warnings) {
    this.scenario = scenario;
    this.field = field;
    this.stepTime = stepTime;
    this.warnings = warnings;
  }

  /** The events of all targets of an element. */
  List<ScenarioEvent> events(XmlElement element) {
    Attributes<Track> attributes = new Attributes<>(element, ELEMENT);
    attributes.warnOfUnknown(warnings);
    try (TextLines lines = attributes.has(FILE) ? open(element, attributes) : element.lines()) {
      return events(element, new TrackReader(lines, stepTime).tracks());
    }
  }

  private TextLines open(XmlElement element, Attributes<Track> attributes) {
    if (!element.text().isBlank()) {
      throw attributes.invalid(FILE, "none together with tracks that are written here");
    }
    try {
      return TextLines.open(scenario.resolveSibling(attributes.get(FILE)));
    } catch (InvalidPathException e) {
      throw attributes.invalid(FILE, "a path from the scenario's folder");
    }
  }

  private List<ScenarioEvent> events(XmlElement element, List<TrackReader.Tracked> tracks) {
    tracks.forEach(TracksReader::requireNear);
    StepPlaces.keep(tracks.stream().map(TrackReader.Tracked::track).toList());
    List<ScenarioEvent> events = new ArrayList<>();
    int missed = 0;
    int outside = 0;
    for (TrackReader.Tracked one : tracks) {
      missed += one.track().lastStep() < one.track().firstStep() ? 1 : 0;
      outside += staysIn(one.track()) ? 0 : 1;
      addEvents(one, events);
    }
    warn(element, missed, "no step meets: they are shorter than a step");
    warn(element, outside, "lead outside the field");
    return events;
  }

  private void warn(XmlElement element, int count, String what) {
    if (count > 0) {
      warnings.accept(element.place() + ": " + count + " of the tracks " + what);
    }
  }

  private boolean staysIn(Track track) {
    for (int i = 0; i < track.samples(); i++) {
      if (!field.contains(track.x(i), track.y(i))) {
        return false;
      }
    }
    return true;
  }

  private static void requireNear(TrackReader.Tracked one) {
    long last = Math.max(one.track().firstStep(), one.track().lastStep());
    if (last >= Integer.MAX_VALUE) {
      throw one.place()
          .error(
              "the target stays until step %s of %s s, expected one below %s: a longer step",
              last, one.track().stepTime(), Integer.MAX_VALUE);
    }
  }

  /** A target goes at the beginning of the step after its last; at that step it may come again. */
  private static void addEvents(TrackReader.Tracked one, List<ScenarioEvent> events) {
    Track track = one.track();
    if (track.lastStep() >= track.firstStep()) {
      events.add(new ScenarioEvent.AddTarget((int) track.firstStep(), target(one)));
      events.add(track.removal(one.features()));
    }
  }

  private static TargetSpec target(TrackReader.Tracked one) {
    Track track = one.track();
    TargetSpec target =
        new TargetSpec(one.features(), track.x(0), track.y(0))
            .with(TargetSpec.ORIGIN, TargetSpec.Origin.TRACK)
            .with(TargetSpec.HEADING, track.heading())
            .with(TargetSpec.SPEED, track.meanSpeed())
            .with(TargetSpec.MOVE, TargetSpec.TRACKS)
            .with(TargetSpec.TRACK, Optional.of(track));
    return one.extent().map(target::withExtent).orElseGet(() -> target.withSize(one.size()));
  }
}
