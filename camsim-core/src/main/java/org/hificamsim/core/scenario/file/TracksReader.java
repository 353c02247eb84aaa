package org.hificamsim.core.scenario.file;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.track.StepPlaces;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.scenario.xml.XmlElement;

/**
 * Reads the element {@code tracks}: the targets of a file next to the scenario, or of the element's
 * own text, each as two events, one that adds it and one that removes it.
 */
public final class TracksReader {
  public static final Element<Track> ELEMENT =
      Element.<Track>of(
              "tracks",
              """
              Targets that come, move and go as they were recorded; once in a file (ours).
              file: path of the file of tracks, from the scenario's folder \
              | the tracks are the element's text
              """)
          .holds("#xs:string");
  public static final Property<Track, String> FILE = ELEMENT.optional("file", Type.TEXT);

  private TracksReader() {}

  /**
   * The events of all targets of an element.
   *
   * @param path the path of the scenario, from whose folder the paths of tracks are resolved
   */
  public static List<ScenarioEvent> events(
      XmlElement element, Path path, double stepTime, Field field) {
    Attributes<Track> attributes = new Attributes<>(element, ELEMENT);
    attributes.warnOfUnknown();
    try (TextLines lines =
        attributes.has(FILE) ? open(element, attributes, path) : element.lines()) {
      List<TargetSpec> targets = new TrackReader(lines, stepTime).tracks();
      StepPlaces.precompute(targets.stream().map(target -> target.track().orElseThrow()).toList());
      warn(element, targets, track -> !isMet(track), "no step meets: they are shorter than a step");
      warn(element, targets, track -> !staysIn(track, field), "lead outside the field");
      return targets.stream().flatMap(TracksReader::events).toList();
    }
  }

  /** Returns the events that add a target at its first step and remove it after its last one. */
  private static Stream<ScenarioEvent> events(TargetSpec target) {
    Track track = target.track().orElseThrow();
    return isMet(track)
        ? Stream.of(
            new ScenarioEvent.AddTarget((int) track.firstStep(), target),
            removal(track, target.features()))
        : Stream.of();
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
      XmlElement element, List<TargetSpec> targets, Predicate<Track> odd, String problem) {
    long count = targets.stream().filter(target -> odd.test(target.track().orElseThrow())).count();
    if (count > 0) {
      element.warn(count + " of the tracks " + problem);
    }
  }

  /** Whether the target is in the field at all samples of its track. */
  private static boolean staysIn(Track track, Field field) {
    return IntStream.range(0, track.samples())
        .allMatch(sample -> field.contains(track.x(sample), track.y(sample)));
  }

  /** The event that removes the target at the beginning of the step after its last one. */
  public static ScenarioEvent.RemoveTarget removal(Track track, double features) {
    return new ScenarioEvent.RemoveTarget((int) track.lastStep() + 1, features);
  }

  private static boolean isMet(Track track) {
    return track.lastStep() >= track.firstStep();
  }
}
