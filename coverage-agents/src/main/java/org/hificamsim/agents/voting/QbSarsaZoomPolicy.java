package org.hificamsim.agents.voting;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.temporal.SarsaZoomPolicy;
import org.hificamsim.agents.temporal.TemporalDifferenceSettings;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Query-based SARSA (section 7.4.5): SARSA that exploits the majority vote of a camera and its k
 * nearest neighbours.
 *
 * <p>At each decision a camera sends its state to its neighbours; each answers with the action that
 * its own table holds best for that state. Where cameras differ in their number of levels, a
 * neighbour picks among the levels that both have, and one that lacks the level the camera is at
 * abstains. All answers come from the tables as they stood before the step's updates. Exploring
 * starts from the vote's outcome, so it is asked for in either case.
 */
public final class QbSarsaZoomPolicy extends SarsaZoomPolicy {
  public static final String NAME = "qb-sarsa";

  private final VoteSettings settings;
  private NearestCameras nearest;
  private MajorityVote vote;
  private int revision;
  private long messages;

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
    return messages;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    int mostLevels = 1;
    for (int camera = 0; camera < network.cameras(); camera++) {
      mostLevels = Math.max(mostLevels, network.levels(camera));
    }
    vote = new MajorityVote(settings.ties(), mostLevels);
    nearest = new NearestCameras(network, settings.neighbours());
    nearest.find(network);
    revision = network.revision();
  }

  @Override
  protected int exploit(NetworkView network, int camera, int row) {
    if (network.revision() != revision) {
      nearest.find(network);
      revision = network.revision();
    }
    int own = super.exploit(network, camera, row);
    vote.open();
    if (settings.ownVote() == VoteSettings.OwnVote.YES) {
      vote.vote(own);
    }
    for (int i = 0; i < nearest.count(camera); i++) {
      ask(network, camera, nearest.neighbour(camera, i));
    }
    return vote.winner(own);
  }

  private void ask(NetworkView network, int camera, int neighbour) {
    messages += 2;
    int level = network.level(camera);
    if (values().knows(neighbour, level)) {
      int row = values().row(neighbour, level, network.detected(camera));
      int shared = Math.min(network.levels(camera), network.levels(neighbour));
      vote.vote(values().best(row, shared));
    }
  }
}
