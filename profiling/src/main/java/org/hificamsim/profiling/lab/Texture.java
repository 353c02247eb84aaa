package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonValue;
import org.hificamsim.core.Spelling;

/** What is on the laboratory's objects, and behind them. */
public enum Texture {
  /** Photographs: what is on real surfaces. */
  PHOTOS,
  /** Painted shapes, words and grain: denser in features than most real surfaces. */
  PAINTED;

  /** New ones; the caller closes them. */
  Surfaces surfaces() {
    return this == PHOTOS ? new PhotoSurfaces() : new Surfaces.Painted();
  }

  /** Its name in files and options. */
  @JsonValue
  public String word() {
    return Spelling.of(this);
  }
}
