package org.hificamsim.tracks.format;

/** Receives the samples of a file, one by one, and what is odd about it. */
public interface SampleSink extends OddRows {
  /** Receives the unit of positions; called once, before the first sample. */
  void measuredIn(Unit unit);

  /** Receives a sample. */
  void accept(TrackSample sample);

  /** Makes a target absent from its last sample to its next one, however close these are. */
  void pause(String target);

  /** Receives a sign that the file is read in the wrong way, so that the samples are useless. */
  void doubt(Doubt sign);
}
