package org.hificamsim.agents.voting;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.agents.temporal.SarsaZoomPolicy;
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
  private static final int MAX_NEIGHBOURS = 10_000;

  /** Whether a camera votes on its own next view; thesis 7.4.5 says that it does. */
  private enum OwnVote {
    YES,
    NO
  }

  private final CameraTask<int[]> electing = this::elect;
  private final int neighbours;
  private final OwnVote ownVote;
  private final MajorityVote.Draw ties;
  private NearestCameras nearest;
  private ViewTranslation translation;
  private MajorityVote[] votes = {}; // of a thread: those of the first camera of its share
  private long[] messages = {}; // of a thread, as the votes
  private int[] elected = {};

  @SuppressWarnings("UnusedVariable") // written so that the reads that it sums up are not left out
  private int fetched;

  /** Reads the options of SARSA and those of the vote; thesis 7.4.5 has no k. */
  public QbSarsaZoomPolicy(Options options) {
    super(options);
    neighbours =
        options.integer("k", 4, 0, MAX_NEIGHBOURS, "number of nearest cameras that are asked");
    ownVote =
        options.choice("own-vote", OwnVote.YES, "whether the own best action counts: yes, no");
    ties =
        options.choice(
            "vote-ties",
            MajorityVote.Draw.OWN,
            "who wins a draw: own (else widest), widest, narrowest");
  }

  @Override
  public String name() {
    return "qb-sarsa";
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
    int views = IntStream.range(0, votes.length).map(network::views).max().orElse(0);
    Arrays.setAll(votes, share -> new MajorityVote(ties, views));
    nearest = new NearestCameras(network, neighbours);
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

  /** In blocks, for speed alone: {@link #fetch}. */
  private void elect(NetworkView network, int[] elected, int from, int to) {
    for (int first = from; first < to; first += ActionValues.BLOCK) {
      int end = Math.min(to, first + ActionValues.BLOCK);
      if (q().exceedsCache()) {
        fetch(network, first, end);
      }
      for (int camera = first; camera < end; camera++) {
        if (!network.moving(camera)) {
          elected[camera] = elect(network, camera, votes[from]);
          messages[from] += 2L * nearest.count(camera);
        }
      }
    }
  }

  /**
   * Reads what the neighbours of some cameras are going to answer, so that it comes from memory at
   * once, where neighbour by neighbour each would wait (without it a step takes 1.3 times as long
   * with 100,000 cameras).
   */
  private void fetch(NetworkView network, int from, int to) {
    int sum = 0;
    for (int camera = from; camera < to; camera++) {
      int state = state(network, camera, camera, network.view(camera));
      for (int i = 0; i < nearest.count(camera); i++) {
        sum += q().best(nearest.neighbour(camera, i), state);
      }
    }
    fetched = sum;
  }

  private int elect(NetworkView network, int camera, MajorityVote vote) {
    int state = state(network, camera, camera, network.view(camera));
    int own = q().best(camera, state);
    vote.open();
    if (ownVote == OwnVote.YES) {
      vote.vote(own);
    }
    int asked = nearest.count(camera);
    for (int i = 0; i < asked; i++) {
      int neighbour = nearest.neighbour(camera, i);
      if (translation.isNeedless(camera, neighbour)) {
        vote.vote(q().best(neighbour, state));
      } else {
        ask(network, camera, neighbour, vote);
      }
    }
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
