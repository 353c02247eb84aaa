package org.hificamsim.agents.toy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;

/** Small worlds from scenario files, with lenses and walls, run by the engine. */
public final class RealWorld {
  /** A scenario file needs at least one target. */
  private static final String FAR_AWAY =
      "<object features=\"0\" x=\"-19\" y=\"-19\" heading=\"0\" speed=\"0\"/>";

  private RealWorld() {}

  /** Returns a run in which targets are detected wherever they are in view. */
  public static Simulation run(String parts, ZoomPolicy policy, long seed) {
    return run(parts, new GeometricDetection(), policy, seed);
  }

  /**
   * @param parts the elements of the simulation element; the field is 40 m x 40 m, centred on the
   *     origin
   */
  public static Simulation run(String parts, DetectionModel model, ZoomPolicy policy, long seed) {
    World world = new World(scenario(parts), Movements.registry(), seed);
    return new Simulation(world, Detection.of(model), policy, seed, List.of());
  }

  /** Returns a policy that always chooses these views, one for each camera. */
  public static ZoomPolicy always(int... views) {
    return new ZoomPolicy() {
      @Override
      public String name() {
        return "always";
      }

      @Override
      public void decide(NetworkView network, int[] chosen) {
        System.arraycopy(views, 0, chosen, 0, views.length);
      }
    };
  }

  private static Scenario scenario(String parts) {
    try {
      Path file = Files.createTempFile("world", ".xml");
      try {
        Files.writeString(file, text(parts));
        return ScenarioReader.read(file, Movements.registry().names()::contains, warning -> {});
      } finally {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String text(String parts) {
    return "<root><simulation min_x=\"-20\" max_x=\"20\" min_y=\"-20\" max_y=\"20\""
        + " order=\"coverage\" headings=\"degrees\">"
        + parts.replace('\'', '"')
        + (parts.contains("<object") ? "" : FAR_AWAY)
        + "</simulation></root>";
  }
}
