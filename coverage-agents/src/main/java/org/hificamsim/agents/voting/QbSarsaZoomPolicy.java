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
 * its own table holds best for that state. Where cameras differ in their views, state and answer
 * are translated ({@link ViewTranslation}). Where they differ in their number of levels alone, have
 * no lens and cannot turn, a neighbour picks among the levels that both have, and one that lacks
 * the level the camera is at abstains. All answers come from the tables as they stood before the
 * step's updates. Exploring starts from the vote's outcome, so it is asked for in either case; a
 * camera that is on its way to a view asks nobody.
 */
public final class QbSarsaZoomPolicy extends SarsaZoomPolicy {
  public static final String NAME = "qb-sarsa";

  private final CameraTask<int[]> electing = this::elect;
  private final VoteSettings settings;
  private NearestCameras nearest;
  private ViewTranslation translation;
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
    translation = new ViewTranslation(network);
  }

  /** All vote on the values as they stand, before any camera learns. */
  @Override
  protected void prepare(NetworkView network) {
    nearest.update(network);
    network.divide(elected, electing);
  }

  @Override
  protected int greedy(int camera, int state) {
    return elected[camera];
  }

  private void elect(NetworkView network, int[] elected, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (!network.moving(camera)) {
        elected[camera] = elect(network, camera);
      }
    }
  }

  private int elect(NetworkView network, int camera) {
    int own = q().best(camera, state(network, camera, camera, network.view(camera)));
    MajorityVote vote = votes[camera];
    vote.open();
    if (settings.ownVote() == VoteSettings.OwnVote.YES) {
      vote.vote(own);
    }
    int asked = nearest.count(camera);
    for (int i = 0; i < asked; i++) {
      ask(network, camera, nearest.neighbour(camera, i), vote);
    }
    messages[camera] += 2L * asked;
    return vote.winner(own);
  }

  private void ask(NetworkView network, int camera, int neighbour, MajorityVote vote) {
    int view = network.view(camera);
    if (!translation.byNumber(camera, neighbour)) {
      int theirs = translation.view(camera, neighbour, view);
      int answer = q().best(neighbour, state(network, camera, neighbour, theirs));
      vote.vote(translation.view(neighbour, camera, answer));
    } else if (q().knows(neighbour, view)) {
      int views = network.views(camera);
      vote.vote(q().answer(neighbour, view, percept(network, camera), views));
    }
  }

  /** The state that one camera would be in, in one of its views, with the percept of another. */
  private int state(NetworkView network, int perceives, int camera, int view) {
    return q().state(camera, view, percept(network, perceives));
  }
}
