package org.hificamsim.hifi;

/** A detection model that a file can hold: its numbers were fitted to data. */
public interface FittedDetection extends OpticalDetection {
  /** Returns this model under another name. */
  FittedDetection named(String newName);

  /** Returns the equation for readers. */
  String equation();
}
