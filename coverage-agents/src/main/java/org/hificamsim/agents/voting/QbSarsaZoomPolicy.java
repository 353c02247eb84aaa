package org.hificamsim.agents.voting;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.temporal.SarsaZoomPolicy;
import org.hificamsim.agents.temporal.TemporalDifferenceSettings;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Query-based SARSA (thesis 7.4.5): SARSA that exploits the majority vote of a camera and its k
 * nearest neighbours.
 *
 * <p>At each decision a camera sends its state to its neighbours; each answers with the action that
 * its own table holds best for that state. Where cameras differ in their number of views, a
 * neighbour picks among the views that both have, and one that lacks the view the camera is at
 * abstains. All answers come from the tables as they stood before the step's updates. Exploring
 * starts from the vote's outcome, so it is asked for in either case.
 */
public final class QbSarsaZoomPolicy extends SarsaZoomPolicy {
  public static final String NAME = "qb-sarsa";

  private final CameraTask<int[]> electing = this::elect;
  private final VoteSettings settings;
  private NearestCameras nearest;
  private MajorityVote[] votes = {};
  private int[] elected = {};
  private long[] messages = {};

  public QbSarsaZoomPolicy(
      TemporalDifferenceSettings learning, EpsilonGreedyChoice choice, VoteSettings settings) {
    super(learning, choice);
    this.settings = settings;
  }

  /** The policy with its options: those of SARSA and those of the vote. */
  public static QbSarsaZoomPolicy from(Options options) {
    return new QbSarsaZoomPolicy(
        TemporalDifferenceSettings.from(options),
        EpsilonGreedyChoice.from(options),
        VoteSettings.from(options));
  }

  @Override
  public String name() {
    return NAME;
  }

  /** The number of messages sent so far: a query and an answer for each neighbour asked. */
  @Override
  public long messages() {
    return Arrays.stream(messages).sum();
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    elected = new int[network.cameras()];
    messages = new long[network.cameras()];
    votes = new MajorityVote[network.cameras()];
    Arrays.setAll(votes, camera -> new MajorityVote(settings.ties(), network.views(camera)));
    nearest = new NearestCameras(network, settings.neighbours());
  }

  /** All vote on the values as they stand, before any camera learns. */
  @Override
  public void decide(NetworkView network, int[] views) {
    nearest.update(network);
    network.divide(elected, electing);
    super.decide(network, views);
  }

  @Override
  protected int greedy(int camera, int state) {
    return elected[camera];
  }

  private void elect(NetworkView network, int[] elected, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      elected[camera] = elect(network, camera);
    }
  }

  private int elect(NetworkView network, int camera) {
    int view = network.view(camera);
    int detected = network.detected(camera);
    int own = q().best(camera, q().state(network, camera));
    MajorityVote vote = votes[camera];
    vote.open();
    if (settings.ownVote() == VoteSettings.OwnVote.YES) {
      vote.vote(own);
    }
    int asked = nearest.count(camera);
    for (int i = 0; i < asked; i++) {
      int neighbour = nearest.neighbour(camera, i);
      if (q().knows(neighbour, view)) {
        vote.vote(q().answer(neighbour, view, detected, network.views(camera)));
      }
    }
    messages[camera] += 2L * asked;
    return vote.winner(own);
  }
}
