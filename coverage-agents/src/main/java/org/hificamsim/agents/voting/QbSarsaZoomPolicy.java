package org.hificamsim.agents.voting;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.agents.temporal.TemporalDifferenceZoomPolicy;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Query-based SARSA (thesis 7.4.5): SARSA that exploits the majority vote of a camera and its k
 * nearest neighbours.
 *
 * <p>At each decision a camera sends its state to its neighbours; each answers with the action that
 * its own table holds best for that state. Where cameras differ in their views, state and answer
 * are translated ({@link ViewTranslation}). All answers come from the tables as they stood before
 * the step's updates. Exploring starts from the vote's outcome, so it is asked for in either case;
 * a camera that is on its way to a view asks nobody.
 *
 * <p>Over a channel that is not perfect a camera decides with the answers that it has: {@link
 * Inquiries}.
 */
public final class QbSarsaZoomPolicy extends TemporalDifferenceZoomPolicy {
  private static final int MAX_NEIGHBOURS = 10_000;
  private static final int MAX_TIMEOUT = 1_000_000;

  /** Whether a camera votes on its own next view; thesis 7.4.5 says that it does. */
  private enum OwnVote {
    YES,
    NO
  }

  private final int neighbours;
  private final OwnVote ownVote;
  private final MajorityVote.Draw ties;
  private final int timeout;
  private NearestCameras nearest;
  private ViewTranslation translation;
  private MajorityVote vote;
  private long directMessages;
  private int[] elected = {};
  private Inquiries inquiries; // null over a perfect channel
  private int bitsOfBoth; // of a query and its answer

  /** Reads the options of SARSA and those of the vote; thesis 7.4.5 has no k. */
  public QbSarsaZoomPolicy(Options options) {
    super("qb-sarsa", true, options);
    neighbours =
        options.integer("k", 4, 0, MAX_NEIGHBOURS, "number of nearest cameras that are asked");
    ownVote =
        options.choice("own-vote", OwnVote.YES, "whether the own best action counts: yes, no");
    ties =
        options.choice(
            "vote-ties",
            MajorityVote.Draw.OWN,
            "who wins a draw: own (else widest), widest, narrowest");
    timeout =
        options.integer(
            "timeout", 10, 0, MAX_TIMEOUT, "steps after the query in which an answer counts");
  }

  /** The number of messages sent so far: a query and an answer for each neighbour asked. */
  @Override
  public long messages() {
    return inquiries == null ? directMessages : inquiries.messages();
  }

  @Override
  public long bits() {
    return inquiries == null ? messages() / 2 * bitsOfBoth : inquiries.bits();
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    elected = new int[network.cameras()];
    directMessages = 0;
    int views = IntStream.range(0, elected.length).map(network::views).max().orElse(0);
    vote = new MajorityVote(ties, views);
    nearest = new NearestCameras(network, neighbours);
    translation = new ViewTranslation(network);
    int address = MessageBits.address(network.cameras());
    int query = address + MessageBits.of(q().states());
    int answer = address + MessageBits.of(views);
    bitsOfBoth = query + answer;
    inquiries =
        network.channel().isPerfect()
            ? null
            : new Inquiries(network, nearest, query, answer, timeout, q(), translation);
  }

  /** All vote on the values as they stand, before any camera learns. */
  @Override
  protected void prepare(NetworkView network) {
    nearest.update(network);
    if (inquiries != null) {
      inquiries.run(camera -> percept(network, camera));
    }
    for (int camera = 0; camera < elected.length; camera++) {
      if (!network.moving(camera)) {
        elected[camera] = elect(network, camera);
        directMessages += 2L * nearest.count(camera);
      }
    }
  }

  @Override
  protected int greedy(int camera, int state) {
    return elected[camera];
  }

  private int elect(NetworkView network, int camera) {
    int view = network.view(camera);
    int percept = percept(network, camera);
    int state = q().state(camera, view, percept);
    int own = q().best(camera, state);
    vote.open();
    if (ownVote == OwnVote.YES) {
      vote.vote(own);
    }
    int asked = nearest.count(camera);
    for (int i = 0; i < asked; i++) {
      int neighbour = nearest.neighbour(camera, i);
      int answer =
          inquiries != null
              ? inquiries.answer(camera, i, state)
              : translation.answer(q(), camera, neighbour, state, view, percept);
      if (answer != Inquiries.NONE) {
        vote.vote(answer);
      }
    }
    return vote.winner(own);
  }
}
