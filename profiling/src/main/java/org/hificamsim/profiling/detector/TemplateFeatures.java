package org.hificamsim.profiling.detector;

/** The features of each object's template. */
public interface TemplateFeatures {
  /** Those that a feature detector, by its name, finds in an object's template. */
  Features of(String object, String detector);
}
