package org.hificamsim.runs.heat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatMap.Place;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares maps of a field of 12 x 8 m, in cells of half a metre, with the simulation: targets
 * stand still in the centre of every free cell.
 */
class HeatRecorderTest {
  private static final int STEPS = 30;
  private static final int CELLS = 24;

  /** A scenario with cameras that turn, fail and are moved, and walls that hide or dim. */
  private static final String SITE =
      """
<root>
  <simulation min_x="0" max_x="12" min_y="0" max_y="8" order="coverage">
    <obstacles>
      <wall x1="4" y1="2" x2="4" y2="5"/>
      <wall x1="7" y1="1" x2="7" y2="6" transmittance="0.6"/>
      <polygon points="8.6,3.6 10.4,3.6 10.4,5.4 8.6,5.4"/>
    </obstacles>
    <cameras>
      <optics name="ptz" law="pinhole" pixels="640" hfov="20 40 60" pan="-40 0 40" pan_speed="20" zoom_time="2"/>
      <camera name="west" x="0.1" y="4.1" heading="90" viewing_angle="60" range="9" optics="ptz"/>
      <camera name="north" x="6.1" y="7.9" heading="180" viewing_angle="90" range="6"/>
      <camera name="east" x="11.9" y="0.1" heading="-45" viewing_angle="70" range="8"/>
    </cameras>
    <objects>%s</objects>
    <events>
      <event timestep="10" participant="camera" event="error" name="north" duration="-1"/>
      <event timestep="20" participant="camera" event="change" name="east" x="11" y="7" heading="225" viewing_angle="-1" range="-1"/>
    </events>
  </simulation>
</root>
""";

  @TempDir static Path folder;
  private final Catalogue catalogue = Catalogue.load();

  /** Sums up the coverage of the targets, of which each free cell has one. */
  private static final class Lattice implements StepListener {
    private final FieldCells cells;
    private final double[] meanK;
    private final double[] covered0;
    private final double[] coveredK;

    Lattice(FieldCells cells) {
      this.cells = cells;
      meanK = new double[cells.count()];
      covered0 = new double[cells.count()];
      coveredK = new double[cells.count()];
    }

    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      for (int target = 0; target < network.targets(); target++) {
        int cell = cells.cellAt(network.targetX(target), network.targetY(target));
        double mean = 0;
        double chanceOfNone = 1;
        double chanceOfOne = 0;
        for (int camera = 0; camera < network.cameras(); camera++) {
          int view = network.seeing(camera);
          boolean looks = network.online(camera) && view >= 0;
          double chance = looks ? network.chance(camera, view, target) : 0;
          mean += chance;
          chanceOfOne = chanceOfOne * (1 - chance) + chanceOfNone * chance;
          chanceOfNone *= 1 - chance;
        }
        meanK[cell] += mean / STEPS;
        covered0[cell] += chanceOfNone / STEPS;
        coveredK[cell] += (1 - chanceOfNone - chanceOfOne) / STEPS;
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "geometric",
        "dori-2014:level=observe",
        "hifi:orb-lin",
        "camsim-visibility",
        "hifi:orb-lin@chance"
      })
  void coverageOfCellEqualsThatOfTargetAtItsCentre(String model) throws IOException {
    FieldCells cells = new FieldCells(new Field(0, 12, 0, 8), 24, 16);
    Scenario scenario = scenario("lattice", lattice(cells));
    Lattice lattice = new Lattice(cells);
    HeatMap map = map(scenario, detection(model, scenario), 1, lattice);
    assertEquals(cells, map.cells());
    int sometimesCovered = 0;
    for (int cell = 0; cell < cells.count(); cell++) {
      Place place = map.places().get(cell);
      if (place.isFree()) {
        assertEquals(lattice.meanK[cell], place.meanK(), 1e-9, "cell " + cell);
        assertEquals(lattice.covered0[cell], place.covered0(), 1e-9, "cell " + cell);
        assertEquals(lattice.coveredK[cell], place.coveredK(), 1e-9, "cell " + cell);
        assertEquals(STEPS, place.visits());
        sometimesCovered += place.covered0() > 0.01 && place.covered0() < 0.99 ? 1 : 0;
      }
    }
    assertEquals(
        16, map.places().stream().filter(place -> !place.isFree()).count(), "in the polygon");
    assertTrue(sometimesCovered > 40, sometimesCovered + " cells are covered in some steps");
  }

  @Test
  void countsVisitsAndTheirCoverage() throws IOException {
    String objects =
        "<object features=\"1.0\" x=\"6.2\" y=\"7.2\" heading=\"0\" speed=\"0\"/>"
            + "<object features=\"2.0\" x=\"6.3\" y=\"7.1\" heading=\"0\" speed=\"0\"/>"
            + "<object features=\"3.0\" x=\"-3\" y=\"7.1\" heading=\"0\" speed=\"0\"/>";
    Scenario scenario = scenario("visits", objects);
    HeatMap map = map(scenario, detection("geometric", scenario), 2, null);
    Place under = map.places().get(map.cells().cellAt(6.25, 7.15));
    assertEquals(2 * 2 * STEPS, under.visits(), "two targets in two runs");
    assertEquals(under.meanK(), under.visitsMeanK(), 1e-12);
    assertEquals(under.covered0(), under.visitsCovered0(), 1e-12);
    assertTrue(under.covered0() > 0 && under.covered0() < 1, "north fails at step 10");
    long all = map.places().stream().mapToLong(Place::visits).sum();
    assertEquals(under.visits(), all, "a target outside the field is in no cell");
    assertTrue(Double.isNaN(map.places().get(0).visitsMeanK()));
  }

  @Test
  void sharesIgnoreCellsInObstacles() {
    FieldCells cells = new FieldCells(new Field(0, 4, 0, 1), 4, 1);
    HeatMap map =
        new HeatMap(
            cells,
            List.of(
                new Place(2, 0, 0, 1, 0, 0, 0),
                new Place(0.5, 0.5, 0.5, 0, 0, 0, 0),
                new Place(0, 1, 0, 0, 0, 0, 0),
                new Place(Double.NaN, Double.NaN, Double.NaN, Double.NaN, 0, 0, 0)));
    assertEquals(1.5 / 3, map.covered(), 1e-12);
    assertEquals(1.0 / 3, map.coveredK(), 1e-12);
    assertEquals(1.0 / 3, map.blind(), 1e-12);
  }

  @Test
  void cellsAreNearlySquareAndLimited() {
    FieldCells wide = FieldCells.of(new Field(-5, 15, 0, 7), 50);
    assertEquals(new FieldCells(new Field(-5, 15, 0, 7), 50, 18), wide);
    assertEquals(0.4, wide.width(), 1e-12);
    assertEquals(-4.8, wide.x(0), 1e-12);
    assertEquals(wide.count() - 1, wide.cellAt(15, 7), "the border belongs to the last cells");
    assertEquals(-1, wide.cellAt(15.01, 7));
    assertEquals(-1, wide.cellAt(Double.NaN, 7));
    assertEquals(1, FieldCells.of(new Field(3, 3, 2, 2), 50).count(), "a field that is a point");
    assertEquals(50, FieldCells.of(new Field(0, 9, 2, 2), 50).count(), "a field that is a line");
  }

  @Test
  void readsTableAndRejectsAnotherField() throws IOException {
    Scenario scenario = scenario("table", lattice(new FieldCells(new Field(0, 12, 0, 8), 6, 4)));
    HeatMap map = map(scenario, detection("geometric", scenario), 1, null);
    Path out = folder.resolve("written");
    try (OutputFolder files = new OutputFolder(out)) {
      HeatTable.write(files, map);
      files.commit(List.of());
    }
    HeatMap read = HeatTable.read(out, scenario.field());
    for (int cell = 0; cell < map.cells().count(); cell++) {
      assertEquals(map.places().get(cell).meanK(), read.places().get(cell).meanK(), 1e-6);
      assertEquals(map.places().get(cell).visits(), read.places().get(cell).visits());
    }
    InputException other =
        assertThrows(InputException.class, () -> HeatTable.read(out, new Field(0, 13, 0, 8)));
    assertTrue(
        other.getMessage().contains("heatmap.csv:2:5: x is 0.25, expected 0.27"),
        other.getMessage());
    Path table = out.resolve("heatmap.csv");
    Files.writeString(table, Files.readString(table).replaceFirst("(?s)\n[^\n]*\n$", "\n"));
    assertThrows(InputException.class, () -> HeatTable.read(out, scenario.field()));
  }

  private static String lattice(FieldCells cells) {
    StringBuilder objects = new StringBuilder();
    for (int cell = 0; cell < cells.count(); cell++) {
      double x = cells.x(cell);
      double y = cells.y(cell);
      if (Math.abs(x - 9.5) > 0.9 || Math.abs(y - 4.5) > 0.9) {
        objects.append(
            "<object features=\"%s.0\" x=\"%s\" y=\"%s\" heading=\"0\" speed=\"0\"/>"
                .formatted(cell, x, y));
      }
    }
    return objects.toString();
  }

  private Scenario scenario(String name, String objects) throws IOException {
    Path file = folder.resolve(name + ".xml");
    Files.writeString(file, SITE.formatted(objects));
    return ScenarioReader.read(file, catalogue.movements().names()::contains, line -> {});
  }

  private Detection detection(String model, Scenario scenario) {
    return DetectionSpec.parse(model, catalogue::detection).detection(Settings.NONE, scenario);
  }

  private HeatMap map(Scenario scenario, Detection detection, int repeats, StepListener other) {
    RunPlan plan =
        new RunPlan(scenario, detection, "epsilon-greedy:epsilon=0.5", STEPS, 7, repeats);
    HeatRecorder recorder =
        new HeatRecorder(new World(scenario, catalogue.movements(), 7), detection, CELLS);
    List<StepListener> listeners = other == null ? List.of(recorder) : List.of(recorder, other);
    new RunExecutor(catalogue).execute(plan, run -> listeners);
    assertEquals((long) STEPS * repeats, recorder.steps());
    return recorder.map();
  }
}
