package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonValue;
import java.util.Locale;

/** What is on the laboratory's objects, and behind them. */
public enum Texture {
  /** Photographs: what is on real surfaces. */
  PHOTOS {
    @Override
    Surfaces surfaces() {
      return new PhotoSurfaces();
    }
  },
  /** Painted shapes, words and grain: denser in features than most real surfaces. */
  PAINTED {
    @Override
    Surfaces surfaces() {
      return new PaintedSurfaces();
    }
  };

  /** New ones; the caller closes them. */
  abstract Surfaces surfaces();

  /** Its name in files and options. */
  @JsonValue
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
