package org.hificamsim.tracks.format;

/** Takes the samples of a file, one by one. */
public interface SampleSink {
  /** Called once, before the first sample: what its position is measured in. */
  void measuredIn(Unit unit);

  /** Takes a sample. */
  void accept(TrackSample sample);
}
