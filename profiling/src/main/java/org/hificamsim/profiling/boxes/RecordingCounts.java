package org.hificamsim.profiling.boxes;

/**
 * The counts of one recording.
 *
 * @param boxes the number of labelled boxes that count
 * @param people the number of different people; the number of frames if labels have no ids
 * @param frames the number of frames
 * @param found the share of the boxes that was found
 * @param falseAlarms the number of detections that overlap with no label
 * @param outside the number of detections before the first labelled frame or after the last
 */
public record RecordingCounts(
    String recording,
    int boxes,
    int people,
    long frames,
    double found,
    int falseAlarms,
    int outside) {
  /** Returns the mean number of false alarms in a frame. */
  public double falseAlarmsPerFrame() {
    return (double) falseAlarms / frames;
  }
}
