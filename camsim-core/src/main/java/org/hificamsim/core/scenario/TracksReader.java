package org.hificamsim.core.scenario;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
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

  private TracksReader() {}

  /**
   * The events of all targets of an element.
   *
   * @param path of the scenario, from whose folder paths are
   */
  static List<ScenarioEvent> events(XmlElement element, Path path, Scenario scenario) {
    Attributes<Track> attributes = new Attributes<>(element, ELEMENT);
    attributes.warnOfUnknown();
    try (TextLines lines =
        attributes.has(FILE) ? open(element, attributes, path) : element.lines()) {
      List<TrackReader.Tracked> tracks = new TrackReader(lines, scenario.stepTime()).tracks();
      tracks.forEach(TracksReader::requireNear);
      warn(element, tracks, track -> !isMet(track), "no step meets: they are shorter than a step");
      warn(element, tracks, track -> !track.staysIn(scenario.field()), "lead outside the field");
      List<ScenarioEvent> events = new ArrayList<>();
      tracks.stream().filter(one -> isMet(one.track())).forEach(one -> addEvents(one, events));
      return events;
    }
  }

  private static TextLines open(XmlElement element, Attributes<Track> attributes, Path path) {
    if (!element.text().isBlank()) {
      throw attributes.invalid(FILE, "none together with tracks that are written here");
    }
    try {
      return TextLines.open(path.resolveSibling(attributes.get(FILE)));
    } catch (InvalidPathException e) {
      throw attributes.invalid(FILE, "a path from the scenario's folder");
    }
  }

  private static void warn(
      XmlElement element, List<TrackReader.Tracked> tracks, Predicate<Track> odd, String what) {
    long count = tracks.stream().map(TrackReader.Tracked::track).filter(odd).count();
    if (count > 0) {
      element.warn(count + " of the tracks " + what);
    }
  }

  private static boolean isMet(Track track) {
    return track.lastStep() >= track.firstStep();
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
    events.add(new ScenarioEvent.AddTarget((int) one.track().firstStep(), target(one)));
    events.add(one.track().removal(one.features()));
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
