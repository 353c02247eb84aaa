package org.hificamsim.presentation.picture;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Setup;

/** Paints the field at one step: fields of view, detected ranges, trails, cameras, targets. */
final class FieldPainter {
  /** {@link SightPainter#RANGE} as it looks where two cameras detect. */
  static final Color DETECTED = new Color(0xC1DDEC);

  static final Color INK = new Color(0x1D2733);
  static final Color FAINT = new Color(0x6B7785);
  static final Color GRID = new Color(0xE4E8ED);
  private static final Color CAMERA = new Color(0x2B3A4A);

  /** How many frames a trail is long. */
  private static final int TRAIL = 40;

  private static final double CAMERA_RADIUS = 4.5;
  private static final double TARGET_RADIUS = 8;
  private static final double TICK_SPACING = 70;

  private final Graphics2D graphics;
  private final RunFrames run;
  private final int index;
  private final Frame frame;
  private final List<CameraPose> poses;
  private final FieldMap map;
  private final PaintedPart painted;

  /**
   * @param area the part of the picture that shows the field
   */
  FieldPainter(Graphics2D graphics, RunFrames run, int index, Rectangle2D area) {
    this.graphics = graphics;
    this.run = run;
    this.index = index;
    this.frame = run.frame(index);
    this.poses = run.poses(index);
    this.map = FieldMap.fit(run.setup().field(), area);
    this.painted = PaintedPart.of(area);
  }

  void paint() {
    SitePainter site = new SitePainter(graphics, map);
    site.floor(run, run.look().floor());
    grid();
    run.look().zones().ifPresent(this::zones);
    views();
    site.obstacles(run.setup());
    tracks();
    for (int target = 0; target < frame.x().length; target++) {
      trail(target);
    }
    cameras();
    for (int target = 0; target < frame.x().length; target++) {
      if (frame.present()[target]) {
        target(target);
      }
    }
  }

  /** The field without what belongs to one step: a heat map, obstacles, tracks and cameras. */
  void paintMap(HeatLayer heat) {
    SitePainter site = new SitePainter(graphics, map);
    site.floor(run, run.look().floor());
    grid();
    heat.paint(graphics, map);
    site.obstacles(run.setup());
    tracks();
    cameras();
  }

  private void tracks() {
    if (run.look().tracks()) {
      new TrackPainter(graphics, map, run).paint();
    }
  }

  private void cameras() {
    for (int camera = 0; camera < poses.size(); camera++) {
      int view = frame.seen(camera) < 0 ? frame.level()[camera] : frame.seen(camera);
      camera(poses.get(camera), view, frame.online()[camera]);
    }
  }

  private void zones(int camera) {
    CameraPose pose = poses.get(camera);
    int view = frame.seen(camera);
    if (frame.online()[camera] && view >= 0 && pose.density(view) > 0) {
      DensityZone.paint(graphics, map, pose, view);
    }
  }

  private void views() {
    SightPainter sight = new SightPainter(graphics, map);
    for (int camera = 0; camera < poses.size(); camera++) {
      if (frame.online()[camera] && frame.seen(camera) >= 0) {
        sight.view(poses.get(camera), frame.seen(camera));
      } else if (frame.online()[camera]) {
        sight.blind(poses.get(camera), frame.level()[camera]);
      }
    }
    sight.shadows();
  }

  private void grid() {
    Field field = run.setup().field();
    Rectangle2D border = map.rectangle(field);
    double gap = niceGap(TICK_SPACING / map.scale());
    graphics.setFont(Fonts.TICKS);
    graphics.setStroke(new BasicStroke(0.8f));
    for (long i = (long) Math.ceil(field.minX() / gap); i * gap <= field.maxX() + 1e-9; i++) {
      double x = map.x(i * gap);
      line(GRID, new Line2D.Double(x, border.getMinY(), x, border.getMaxY()));
      String text = metres(i * gap);
      text(text, x - Fonts.width(text, Fonts.TICKS) / 2.0, border.getMaxY() + 13);
    }
    for (long i = (long) Math.ceil(field.minY() / gap); i * gap <= field.maxY() + 1e-9; i++) {
      double y = map.y(i * gap);
      line(GRID, new Line2D.Double(border.getMinX(), y, border.getMaxX(), y));
      String text = metres(i * gap);
      text(text, border.getMinX() - 5 - Fonts.width(text, Fonts.TICKS), y + 4);
    }
    line(FAINT, border);
    text("m", border.getMaxX() + 12, border.getMaxY() + 13);
  }

  private void trail(int target) {
    int first = Math.max(1, index - TRAIL + 1);
    Composite before = graphics.getComposite();
    for (int i = first; i <= index; i++) {
      Frame from = run.frame(i - 1);
      Frame to = run.frame(i);
      if (from.present()[target] && to.present()[target]) {
        CoverClass cover = CoverClass.of(to.coverage()[target]);
        float strength = 0.15f + 0.75f * (i - first + 1) / (index - first + 1);
        graphics.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, strength));
        graphics.setStroke(
            new BasicStroke(cover.trail(), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        painted.within(moved(from, to, target)).ifPresent(line -> line(cover.color(), line));
      }
    }
    graphics.setComposite(before);
  }

  private Line2D moved(Frame from, Frame to, int target) {
    return new Line2D.Double(
        map.x(from.x()[target]),
        map.y(from.y()[target]),
        map.x(to.x()[target]),
        map.y(to.y()[target]));
  }

  /** A square with a line along its view; hollow and crossed out while it is not online. */
  private void camera(CameraPose pose, int view, boolean online) {
    double r = CAMERA_RADIUS;
    double x = map.x(pose.x());
    double y = map.y(pose.y());
    Rectangle2D box = new Rectangle2D.Double(x - r, y - r, 2 * r, 2 * r);
    graphics.setColor(online ? CAMERA : Color.WHITE);
    graphics.fill(box);
    graphics.setStroke(new BasicStroke(1.5f));
    line(CAMERA, box);
    double heading = pose.heading(view);
    if (pose.viewingAngle(view) < 2 * Math.PI) {
      double length = 2.4 * r;
      line(
          CAMERA,
          new Line2D.Double(x, y, x + length * Math.sin(heading), y - length * Math.cos(heading)));
    }
    if (!online) {
      line(CAMERA, new Line2D.Double(x - r, y - r, x + r, y + r));
    }
  }

  private void target(int target) {
    int k = frame.coverage()[target];
    CoverClass cover = CoverClass.of(k);
    double x = map.x(frame.x()[target]);
    double y = map.y(frame.y()[target]);
    Setup setup = run.setup();
    double least = TARGET_RADIUS * run.prominence(target);
    double r = Math.max(least, map.scale() * setup.width(target) / 2);
    Shape shape = cover.at(x, y, r);
    graphics.setColor(cover.color());
    graphics.fill(shape);
    graphics.setStroke(new BasicStroke(1.2f));
    line(INK, shape);
    if (k > 0) {
      graphics.setFont(Fonts.PANEL.deriveFont((float) (1.15 * r)));
      String text = Integer.toString(k);
      graphics.setColor(Color.BLACK);
      double width = Fonts.width(text, graphics.getFont());
      double drop = r * (cover == CoverClass.ONE ? 0.55 : 0.42);
      graphics.drawString(text, (float) (x - width / 2), (float) (y + drop));
    }
  }

  private void line(Color color, Shape shape) {
    graphics.setColor(color);
    graphics.draw(shape);
  }

  private void text(String text, double x, double y) {
    graphics.setColor(FAINT);
    graphics.drawString(text, (float) x, (float) y);
  }

  /** 1, 2 or 5 times a power of ten, at least this much. */
  static double niceGap(double least) {
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    for (int factor : new int[] {1, 2, 5}) {
      if (factor * power >= least) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  private static String metres(double number) {
    String text = String.format(Locale.ROOT, "%.3f", number);
    return text.replaceFirst("\\.?0+$", "").replaceFirst("^-0$", "0");
  }
}
