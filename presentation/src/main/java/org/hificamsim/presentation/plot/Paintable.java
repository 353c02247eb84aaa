package org.hificamsim.presentation.plot;

import java.awt.Graphics2D;

/** A picture that can be painted at any size; lengths are in points. */
public interface Paintable {
  /** Returns the width, in points. */
  int width();

  /** Returns the height, in points. */
  int height();

  /** Paints the picture on a white ground. */
  void paint(Graphics2D graphics);
}
