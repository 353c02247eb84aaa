package org.hificamsim.agents.voting;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.agents.temporal.TemporalDifferenceZoomPolicy;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Query-based SARSA (thesis 7.4.5): SARSA that exploits the majority vote of a camera and its k
 * nearest neighbours.
 *
 * <p>At each decision a camera sends its state to its neighbours. Each answers with the best action
 * of its own table in that state; between cameras with different views, state and answer are
 * translated ({@link ViewTranslation}). All answers come from the tables before the step's updates.
 * Exploring also needs the outcome of the vote, so cameras always ask, except while they move.
 *
 * <p>Over an imperfect channel a camera decides with the answers that it has: {@link Inquiries}.
 */
public final class QbSarsaZoomPolicy extends TemporalDifferenceZoomPolicy {
  private static final int MAX_NEIGHBOURS = 10_000;
  private static final int MAX_TIMEOUT = 1_000_000;

  /** Whether a camera's own best view counts as a vote; thesis 7.4.5 says that it does. */
  private enum OwnVote {
    YES,
    NO
  }

  private final int neighbours;
  private final OwnVote ownVote;
  private final MajorityVote.DrawRule drawRule;
  private final int timeout;
  private NearestCameras nearest;
  private ViewTranslation translation;
  private MajorityVote vote;
  private long directMessages;
  private int[] electedViews = {};

  /** The queries on an imperfect channel; null over a perfect one. */
  private Inquiries inquiries;

  private Inquiries.Lengths lengths = new Inquiries.Lengths(0, 0);

  /** Reads the options of SARSA and of the vote; thesis 7.4.5 does not give k. */
  public QbSarsaZoomPolicy(Options options) {
    super("qb-sarsa", true, options);
    neighbours =
        options.integer("k", 4, 0, MAX_NEIGHBOURS, "number of nearest cameras that are asked");
    ownVote =
        options.choice("own-vote", OwnVote.YES, "whether the own best action counts: yes, no");
    drawRule =
        options.choice(
            "vote-ties",
            MajorityVote.DrawRule.OWN,
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
    return inquiries == null
        ? messages() / 2 * (lengths.query() + lengths.answer())
        : inquiries.bits();
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    electedViews = new int[network.cameras()];
    directMessages = 0;
    int views = IntStream.range(0, electedViews.length).map(network::views).max().orElse(0);
    vote = new MajorityVote(drawRule, views);
    nearest = new NearestCameras(network, neighbours);
    translation = new ViewTranslation(network, q());
    int address = MessageBits.address(network.cameras());
    lengths =
        new Inquiries.Lengths(
            address + MessageBits.of(q().states()), address + MessageBits.of(views));
    inquiries =
        network.channel().isPerfect()
            ? null
            : new Inquiries(network, nearest, translation, lengths, timeout);
  }

  /** Lets all cameras vote before any of them learns. */
  @Override
  protected void prepare(NetworkView network) {
    nearest.update(network);
    if (inquiries != null) {
      inquiries.exchange(q(), camera -> percept(network, camera));
    }
    for (int camera = 0; camera < electedViews.length; camera++) {
      if (!network.moving(camera)) {
        electedViews[camera] = elect(network, camera);
        directMessages += 2L * nearest.count(camera);
        countBits(network.radio(), camera);
      }
    }
  }

  /** Counts the queries of a camera and their answers, unless {@link Inquiries} posts them. */
  private void countBits(RadioLog radio, int camera) {
    for (int i = 0; inquiries == null && radio.counts() && i < nearest.count(camera); i++) {
      int neighbour = nearest.neighbour(camera, i);
      radio.send(camera, lengths.query());
      radio.receive(neighbour, lengths.query());
      radio.send(neighbour, lengths.answer());
      radio.receive(camera, lengths.answer());
    }
  }

  @Override
  protected int greedy(int camera, int state) {
    return electedViews[camera];
  }

  private int elect(NetworkView network, int camera) {
    int view = network.view(camera);
    int percept = percept(network, camera);
    int state = q().state(camera, view, percept);
    int own = q().best(camera, state);
    vote.clear();
    if (ownVote == OwnVote.YES) {
      vote.vote(own);
    }
    int asked = nearest.count(camera);
    for (int i = 0; i < asked; i++) {
      int neighbour = nearest.neighbour(camera, i);
      int answer =
          inquiries != null
              ? inquiries.vote(camera, i, state)
              : translation.answer(camera, neighbour, state, view, percept);
      if (answer != Inquiries.NO_VOTE) {
        vote.vote(answer);
      }
    }
    return vote.winner(own);
  }
}
