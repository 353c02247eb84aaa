package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.plot.Legend;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.replay.Snapshots;
import org.hificamsim.runs.cells.FieldCells;

/** A field to scale with its cells in classes, and the cameras with what they look at and names. */
public final class PlanPicture implements Paintable {
  private static final int SIGN = 22;
  private static final int ROW = 20;

  /** Cells in colours, as {@code scene.js} has them. */
  record Classes(int columns, int rows, List<List<Integer>> classes) {}

  private final RunFrames run;
  private final Classes classes;
  private final double[] values;
  private final Legend legend;

  /**
   * @param world that has not begun yet; it begins
   * @param stays what keeps cameras as they start
   * @param values by cell: the number of its class, NaN for none
   * @param signs the classes with their meanings
   */
  public PlanPicture(
      World world,
      Detection detection,
      ZoomPolicy stays,
      List<Setup.Floor> floor,
      FieldCells cells,
      double[] values,
      List<Color> colors,
      List<String> signs) {
    Setup setup = Setup.of(world, detection, stays.name(), 0, floor);
    Snapshots snapshots = new Snapshots(setup, detection, stays);
    Simulation simulation = new Simulation(world, detection, stays, 0, List.of());
    simulation.step();
    this.run =
        new RunFrames(
            setup,
            new RecordedRun(
                0, 0, 1, 1, "", List.of(), List.of(snapshots.take(simulation.network()))));
    this.classes =
        new Classes(
            cells.columns(),
            cells.rows(),
            colors.stream().map(c -> List.of(c.getRed(), c.getGreen(), c.getBlue())).toList());
    this.values = values.clone();
    List<LegendEntry> entries =
        IntStream.range(0, signs.size())
            .mapToObj(
                i -> new LegendEntry(signs.get(i), light(colors.get(i)), LegendEntry.Mark.BAR))
            .toList();
    this.legend = new Legend(List.of(entries), StepPicture.WIDTH, SIGN, ROW);
  }

  /** As it is seen on white. */
  private static Color light(Color color) {
    int[] parts = {color.getRed(), color.getGreen(), color.getBlue()};
    int[] light = IntStream.of(parts).map(part -> (int) (255 - 0.4 * (255 - part))).toArray();
    return new Color(light[0], light[1], light[2]);
  }

  @Override
  public int width() {
    return StepPicture.WIDTH;
  }

  @Override
  public int height() {
    return (int) area().getMaxY() + legend.height();
  }

  private Rectangle2D area() {
    Rectangle2D area = StepPicture.area(run);
    return new Rectangle2D.Double(0, 0, StepPicture.WIDTH, area.getHeight());
  }

  @Override
  public void paint(Graphics2D graphics) {
    run.script().paint(graphics, area(), run, 0, classes, values);
    legend.paint(graphics, StepPicture.MARGIN, (int) area().getMaxY());
  }
}
