package org.hificamsim.profiling.bench;

import java.util.concurrent.TimeUnit;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimDetections;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.model.LabDetections;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The cost of one evaluation of each step of the fidelity ladder, about 10 ns of which are the
 * benchmark's own. {@code ladder-nanoseconds.csv} records the fastest of five iterations on two
 * busy cores: compare the steps, not the nanoseconds with another machine's.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class LadderBenchmark {
  private static final int DISTANCES = 64;

  /** The step. */
  @Param({"geometric", "camsim-standard", "lin", "sr", "svr-rbf", "power", "pinhole"})
  public String model;

  private final ZoomLevel zoom = new ZoomLevel(5, 2.5, 7.5, Double.NaN, 2 * Math.PI);
  private DetectionModel detection;
  private int next;

  /** Looks the model up. */
  @Setup
  public void create() {
    Registry<DetectionModel> registry = new Registry<>("detection");
    CamSimDetections.register(registry);
    registry.register("geometric", "", GeometricDetection::new);
    LabDetections.register(registry);
    detection = registry.create(registry.knows(model) ? model : "lab:orb-" + model);
  }

  /** One evaluation, at one of {@value #DISTANCES} distances in turn. */
  @Benchmark
  public double confidence() {
    next = (next + 1) % DISTANCES;
    return detection.confidence(0.66, 0.1 + next * 0.07, 0, zoom);
  }
}
