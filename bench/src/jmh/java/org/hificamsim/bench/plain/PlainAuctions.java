package org.hificamsim.bench.plain;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * CamSim's step (behaviour 7) as a loop over objects, which move, observe, advertise, look and
 * settle. It takes scenarios of cameras below a range of 20 and straight movement, without events,
 * links or limits. It does not compute overlaps, which never change while cameras stay.
 */
public final class PlainAuctions {
  /** The figures of a step in CamSim's table, apart from those that never change. */
  public record Figures(
      double utility, long communication, double confidence, double proportion, long handovers) {}

  private final Field field;
  private final List<TradingCamera> cameras = new ArrayList<>();
  private final List<Target> targets = new ArrayList<>();
  private final Random turns;

  /** Starts a run. */
  public PlainAuctions(Scenario scenario, long seed) {
    field = scenario.field();
    turns = new Random(seed);
    for (TargetSpec target : scenario.targets()) {
      double heading = Math.toRadians(target.heading());
      targets.add(new Target(target.x(), target.y(), heading, target.speed(), target.size()));
    }
    for (CameraSpec camera : scenario.cameras()) {
      cameras.add(new TradingCamera(camera));
    }
    cameras.forEach(camera -> camera.meet(cameras, targets));
  }

  /** Runs one step. */
  public Figures step() {
    targets.forEach(target -> target.move(field, turns));
    cameras.forEach(camera -> camera.observe(targets));
    cameras.forEach(TradingCamera::advertise);
    cameras.forEach(TradingCamera::look);
    long sent = 0;
    double confidence = 0;
    int tracked = 0;
    for (TradingCamera camera : cameras) {
      camera.settle();
      sent += camera.sent();
      confidence += camera.relativeConfidence();
      tracked += camera.tracked();
    }
    double utility = 0;
    long handovers = 0;
    for (TradingCamera camera : cameras) {
      utility += camera.utility();
      handovers += camera.handovers();
    }
    return new Figures(utility, sent, confidence, (double) tracked / targets.size(), handovers);
  }
}
