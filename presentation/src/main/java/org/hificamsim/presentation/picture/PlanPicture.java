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

/**
 * A picture of a plan: the field to scale, its cells by class, and the cameras with their views.
 */
public final class PlanPicture implements Paintable {
  private static final int SIGN_WIDTH = 22;
  private static final int LEGEND_ROW = 20;

  /** The colours of classes, as {@code scene.js} expects them. */
  record ColorClasses(int columns, int rows, List<List<Integer>> classes) {}

  private final RunFrames run;
  private final FieldScript.Cells cells;
  private final Legend legend;

  /**
   * The cells of a plan, each in one of some classes.
   *
   * @param values by cell, the number of its class, NaN for none
   * @param colors of the classes
   * @param labels of the classes
   */
  public record ClassifiedCells(
      FieldCells cells, double[] values, List<Color> colors, List<String> labels) {}

  /**
   * @param world before its first step, which is made here
   * @param staying a policy that keeps cameras in their first views
   */
  public PlanPicture(
      World world,
      Detection detection,
      ZoomPolicy staying,
      List<Setup.Floor> floor,
      ClassifiedCells classified) {
    Setup setup = Setup.of(world, detection, staying.name(), 0, floor);
    Snapshots snapshots = new Snapshots(setup, detection, staying);
    Simulation simulation = new Simulation(world, detection, staying, 0, List.of());
    simulation.step();
    this.run =
        new RunFrames(
            setup,
            new RecordedRun(
                0, 0, 1, 1, "", List.of(), List.of(snapshots.take(simulation.network()))));
    List<Color> colors = classified.colors();
    ColorClasses classes =
        new ColorClasses(
            classified.cells().columns(),
            classified.cells().rows(),
            colors.stream()
                .map(color -> List.of(color.getRed(), color.getGreen(), color.getBlue()))
                .toList());
    this.cells = new FieldScript.Cells(classes, classified.values().clone());
    List<LegendEntry> entries =
        IntStream.range(0, colors.size())
            .mapToObj(
                i ->
                    new LegendEntry(
                        classified.labels().get(i), onWhite(colors.get(i)), LegendEntry.Mark.BAR))
            .toList();
    this.legend = new Legend(List.of(entries), StepPicture.WIDTH, SIGN_WIDTH, LEGEND_ROW);
  }

  /** The colour of a cell, which is half transparent, as it looks on white. */
  private static Color onWhite(Color color) {
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
    run.script().paint(graphics, area(), run, 0, cells);
    legend.paint(graphics, StepPicture.MARGIN, (int) area().getMaxY());
  }
}
