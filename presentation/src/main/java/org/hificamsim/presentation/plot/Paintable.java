package org.hificamsim.presentation.plot;

import java.awt.Graphics2D;

/** Something that can be painted at any size, measured in points, as papers are. */
public interface Paintable {
  /** Width, points. */
  int width();

  /** Height, points. */
  int height();

  /** Paints on a ground that is white already. */
  void paint(Graphics2D graphics);
}
