package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.Setup;

/** What the obstacles, shadows and zones in a picture mean: a line for each kind that it has. */
final class SiteLegend {
  private static final int GAP = 14;
  private static final int MARK = 16;

  /** A mark that is painted at a place, and what it means. */
  private record Entry(String label, BiConsumer<Graphics2D, Rectangle2D> mark) {}

  private final List<List<Entry>> lines = new ArrayList<>();

  SiteLegend(Setup setup, Look look) {
    List<Entry> site = new ArrayList<>();
    site(setup, site);
    List<Entry> zones = new ArrayList<>();
    if (look.zones().isPresent()) {
      zones(setup.cameras().get(look.zones().getAsInt()).name(), zones);
    }
    lines.addAll(List.of(site, zones));
    lines.removeIf(List::isEmpty);
  }

  private static void site(Setup setup, List<Entry> entries) {
    if (setup.obstacles().stream().anyMatch(Obstacle::solid)) {
      entries.add(new Entry("obstacle", (g, box) -> SitePainter.paint(g, box, 0)));
      entries.add(filled("hidden from all", SightPainter.SHADOW, SightPainter.SHADOW_STRENGTH));
    }
    setup.obstacles().stream()
        .filter(obstacle -> !obstacle.solid())
        .mapToDouble(Obstacle::transmittance)
        .sorted()
        .distinct()
        .limit(3)
        .forEach(t -> entries.add(through(t)));
    if (!setup.slow().isEmpty()) {
      entries.add(new Entry("moves, sees nothing", SiteLegend::blind));
    }
  }

  private static Entry through(double transmittance) {
    String share =
        String.valueOf(Math.round(1000 * transmittance) / 10.0).replaceFirst("\\.0$", "");
    String label = "lets %s %% through".formatted(share);
    return new Entry(label, (g, box) -> SitePainter.paint(g, box, transmittance));
  }

  private static void blind(Graphics2D graphics, Rectangle2D box) {
    graphics.setColor(SightPainter.RANGE);
    graphics.setStroke(SightPainter.blindStroke());
    graphics.draw(new Ellipse2D.Double(box.getX(), box.getY(), box.getWidth(), box.getHeight()));
  }

  private static void zones(String camera, List<Entry> entries) {
    entries.add(new Entry(camera + ", pixels per metre:", (g, box) -> {}));
    for (DensityZone zone : DensityZone.values()) {
      entries.add(filled(zone.label(), zone.color(), 1));
    }
  }

  private static Entry filled(String label, Color color, double strength) {
    return new Entry(
        label,
        (graphics, box) -> {
          graphics.setColor(Palette.pale(color, strength));
          graphics.fill(box);
        });
  }

  /** How many lines there are, from 0. */
  int lines() {
    return lines.size();
  }

  /**
   * Paints the lines.
   *
   * @param middle of the first one
   * @param height of each
   */
  void paint(Graphics2D graphics, int left, int middle, int height) {
    for (int i = 0; i < lines.size(); i++) {
      line(graphics, lines.get(i), left, middle + i * height);
    }
  }

  private static void line(Graphics2D graphics, List<Entry> entries, int left, int middle) {
    graphics.setFont(Fonts.TEXT);
    int x = left;
    for (Entry entry : entries) {
      boolean marked = !entry.label.endsWith(":");
      entry.mark.accept(graphics, new Rectangle2D.Double(x, middle - 6.0, 12, 12));
      x += marked ? MARK : 0;
      graphics.setColor(Palette.BLACK);
      graphics.drawString(entry.label, x, middle + 4);
      x += Fonts.width(entry.label, Fonts.TEXT) + GAP;
    }
  }
}
