package org.hificamsim.tracks.format;

/** Receives the samples of a file, one by one. */
public interface SampleSink {
  /** Receives the unit of positions; called once, before the first sample. */
  void measuredIn(Unit unit);

  /** Receives a sample. */
  void accept(TrackSample sample);
}
