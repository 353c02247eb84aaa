package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;

/**
 * The labelled people of recordings, each with its height, hidden share, and whether it was found.
 *
 * @param boxes the boxes of people, ordered by recording and frame
 * @param recordings the counts of the recordings, in the given order
 */
public record MeasuredBoxes(List<PersonBox> boxes, List<RecordingCounts> recordings) {
  /** The least intersection over union of a person and a detection, unless users choose another. */
  public static final double USUAL_OVERLAP = 0.5;

  /**
   * Measures recordings.
   *
   * @param leastOverlap the least intersection over union of a person and a detection
   */
  public static MeasuredBoxes of(List<BoxRecording> recordings, double leastOverlap) {
    List<PersonBox> boxes = new ArrayList<>();
    List<RecordingCounts> counts = new ArrayList<>();
    for (BoxRecording recording : recordings) {
      if (counts.stream().anyMatch(other -> other.recording().equals(recording.name()))) {
        throw InputException.of(
            "two recordings are named '%s', expected files with different names", recording.name());
      }
      List<PersonBox> measured = new ArrayList<>();
      int falseAlarms = 0;
      for (Map.Entry<Long, FrameBoxes> frame : recording.frames().entrySet()) {
        FrameMatch match = FrameMatch.of(frame.getValue(), leastOverlap);
        add(recording, frame.getKey(), frame.getValue(), match, measured);
        falseAlarms += match.falseAlarms();
      }
      counts.add(count(recording, measured, falseAlarms));
      boxes.addAll(measured);
    }
    return new MeasuredBoxes(List.copyOf(boxes), List.copyOf(counts));
  }

  private static void add(
      BoxRecording recording,
      long number,
      FrameBoxes frame,
      FrameMatch match,
      List<PersonBox> boxes) {
    for (int label = 0; label < match.found().length; label++) {
      LabelledBox person = frame.labels().get(label);
      if (person.counted()) {
        String id = person.person() == null ? "frame " + number : person.person();
        boxes.add(
            new PersonBox(
                recording.name(),
                number,
                recording.name() + ":" + id,
                person.box(),
                HiddenParts.of(frame.labels(), label, recording.picture()),
                match.found()[label] ? 1 : 0));
      }
    }
  }

  private static RecordingCounts count(
      BoxRecording recording, List<PersonBox> boxes, int falseAlarms) {
    return new RecordingCounts(
        recording.name(),
        boxes.size(),
        (int) boxes.stream().map(PersonBox::person).distinct().count(),
        recording.frames().lastKey() - recording.frames().firstKey() + 1,
        boxes.stream().mapToInt(PersonBox::found).average().orElseThrow(),
        falseAlarms,
        recording.outside());
  }

  /** Returns the mean number of false alarms in a frame of all recordings. */
  public double falseAlarmsPerFrame() {
    double alarms = recordings.stream().mapToInt(RecordingCounts::falseAlarms).sum();
    return alarms / recordings.stream().mapToLong(RecordingCounts::frames).sum();
  }

  /** Returns the number of different people. */
  public int people() {
    return recordings.stream().mapToInt(RecordingCounts::people).sum();
  }
}
