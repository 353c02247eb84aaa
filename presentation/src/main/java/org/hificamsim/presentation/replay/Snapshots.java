package org.hificamsim.presentation.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Takes frames of one run, at the end of any step, and notes the cameras that moved. */
public final class Snapshots {
  private final Setup setup;
  private final Poses made;
  private final ZoomPolicy policy;
  private final CameraPose[] poses;
  private String estimated;
  private int revision = Integer.MIN_VALUE;
  private boolean forgotten;

  /**
   * @param policy what decides in the run
   */
  public Snapshots(Setup setup, Detection detection, ZoomPolicy policy) {
    this.setup = setup;
    this.made = new Poses(detection, setup.targetSize(), setup.obstacles(), setup.field());
    this.policy = policy;
    this.poses = setup.cameras().stream().map(Setup.Camera::pose).toArray(CameraPose[]::new);
  }

  /** What the agents' estimates are ("mean reward", "Q"); empty where they have none. */
  public String estimated(NetworkView network) {
    if (estimated == null) {
      int most = IntStream.range(0, network.cameras()).map(network::views).max().orElse(0);
      estimated =
          network.cameras() == 0 ? "" : policy.estimates(0, new double[most], new double[most]);
    }
    return estimated;
  }

  /** The network as it is now. */
  public Frame take(OracleView network) {
    Frame frame =
        Frame.blank(setup, network.step(), !estimated(network).isEmpty(), believed(network));
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
      BeliefFrame belief = believes(network);
      System.arraycopy(belief.numbers(), 0, frame.belief(), 0, frame.belief().length);
    }
    return frame;
  }

  /** Whether cameras believe anything of where targets are. */
  public boolean believed(NetworkView network) {
    return policy.believe(0, new BeliefFrame(setup));
  }

  private BeliefFrame believes(NetworkView network) {
    BeliefFrame belief = new BeliefFrame(setup);
    IntStream.range(0, network.cameras())
        .filter(network::online)
        .findFirst()
        .ifPresent(camera -> policy.believe(camera, belief));
    return belief;
  }

  /** Has the next call of {@link #moves} say of every camera where it is. */
  public void forgetPoses() {
    forgotten = true;
  }

  /**
   * The cameras that stand, look or see otherwise than at the call before, or than at the start.
   */
  public List<Move> moves(NetworkView network) {
    if (network.revision() == revision && !forgotten) {
      return List.of();
    }
    revision = network.revision();
    List<Move> moves = new ArrayList<>();
    for (int camera = 0; camera < network.cameras(); camera++) {
      CameraPose before = poses[camera];
      CameraPose pose = network.online(camera) ? made.of(network, camera, before) : before;
      if (forgotten || !pose.equals(before)) {
        poses[camera] = pose;
        moves.add(new Move(network.step(), camera, pose));
      }
    }
    forgotten = false;
    return moves;
  }
}
