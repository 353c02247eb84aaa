package org.hificamsim.presentation.replay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Holders;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Takes frames of one run after its steps, and finds the cameras whose poses have changed. */
public final class Snapshots {
  private final Setup setup;
  private final Poses poseMaker;
  private final ZoomPolicy policy;
  private final CameraPose[] poses;
  private final Holders holders = new Holders();
  private String estimated;
  private int knownRevision = Integer.MIN_VALUE;
  private boolean posesForgotten;

  /**
   * @param policy the policy that decides in the run
   */
  public Snapshots(Setup setup, Detection detection, ZoomPolicy policy) {
    this.setup = setup;
    this.poseMaker = new Poses(detection, setup.targetSize(), setup.obstacles(), setup.field());
    this.policy = policy;
    this.poses = setup.cameras().stream().map(Setup.Camera::pose).toArray(CameraPose[]::new);
  }

  /** Returns the name of what agents estimate, such as "mean reward" or "Q"; empty without one. */
  public String estimated(NetworkView network) {
    if (estimated == null) {
      int maxViews = IntStream.range(0, network.cameras()).map(network::views).max().orElse(0);
      estimated =
          network.cameras() == 0
              ? ""
              : policy.estimates(0, new double[maxViews], new double[maxViews]);
    }
    return estimated;
  }

  /** Takes a frame of the current state. */
  public Frame take(OracleView network) {
    Frame frame =
        Frame.blank(setup, network.step(), !estimated(network).isEmpty(), hasBelief(network));
    for (int camera = 0; camera < network.cameras(); camera++) {
      frame.online()[camera] = network.online(camera);
      frame.level()[camera] = network.view(camera);
      frame.detected()[camera] = network.detected(camera);
    }
    for (int camera = 0; camera < frame.seeing().length; camera++) {
      frame.seeing()[camera] = network.seeing(camera);
    }
    for (int target = 0; target < network.targets(); target++) {
      frame.present()[target] = network.present(target);
      frame.x()[target] = network.targetX(target);
      frame.y()[target] = network.targetY(target);
      frame.coverage()[target] = network.coverage(target);
    }
    for (int camera = 0; camera < frame.estimates().length; camera++) {
      policy.estimates(camera, frame.estimates()[camera], frame.counts()[camera]);
    }
    if (frame.belief().length > 0) {
      BeliefFrame belief = belief(network);
      System.arraycopy(belief.numbers(), 0, frame.belief(), 0, frame.belief().length);
    }
    if (frame.holders().length > 0) {
      takeHolders(network, frame);
    }
    return frame;
  }

  private void takeHolders(OracleView network, Frame frame) {
    holders.update(network);
    Arrays.setAll(frame.holders(), holders::holder);
  }

  /** Whether cameras have a belief of where targets are. */
  public boolean hasBelief(NetworkView network) {
    return policy.believe(0, new BeliefFrame(setup));
  }

  private BeliefFrame belief(NetworkView network) {
    BeliefFrame belief = new BeliefFrame(setup);
    IntStream.range(0, network.cameras())
        .filter(network::online)
        .findFirst()
        .ifPresent(camera -> policy.believe(camera, belief));
    return belief;
  }

  /** Lets the next call of {@link #moves} return the poses of all cameras. */
  public void forgetPoses() {
    posesForgotten = true;
  }

  /** Returns the cameras whose poses have changed since the last call, or since the start. */
  public List<Move> moves(NetworkView network) {
    if (network.revision() == knownRevision && !posesForgotten) {
      return List.of();
    }
    knownRevision = network.revision();
    List<Move> moves = new ArrayList<>();
    for (int camera = 0; camera < network.cameras(); camera++) {
      CameraPose before = poses[camera];
      CameraPose pose = network.online(camera) ? poseMaker.of(network, camera, before) : before;
      if (posesForgotten || !pose.equals(before)) {
        poses[camera] = pose;
        moves.add(new Move(network.step(), camera, pose));
      }
    }
    posesForgotten = false;
    return moves;
  }
}
