package org.hificamsim.agents.voting;

import java.util.function.IntUnaryOperator;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.policy.NetworkView;

/**
 * The queries and answers of QB-SARSA over an imperfect channel. A camera sends a query at each
 * decision, and decides with the last answer that it has from each neighbour. An answer counts if
 * it is to the camera's present state, and if its query is not older than the time-out. A neighbour
 * answers a query at once from its present table, even while it moves.
 */
final class Inquiries {
  /** The vote of a neighbour that has not answered. */
  static final int NO_VOTE = -1;

  /**
   * A query, or the answer to it.
   *
   * @param askedAt the step of the query
   * @param state state of the asking camera, which follows from its view and percept
   * @param vote the vote of an answer; {@link #NO_VOTE} in a query
   */
  private record Letter(boolean query, long askedAt, int state, int view, int percept, int vote) {}

  private record Answer(int neighbour, Letter letter) {}

  private final NetworkView network;
  private final NearestCameras nearest;
  private final Lengths lengths;
  private final int timeout;
  private final ViewTranslation translation;
  private final Post<Letter> post;

  /** The last answer, by camera and neighbour. */
  private final Answer[][] lastAnswers;

  private long messages;
  private long bits;

  /** The lengths of a query and of an answer, in bits. */
  record Lengths(int query, int answer) {}

  /**
   * @param timeout number of steps after the query in which its answer counts
   */
  Inquiries(
      NetworkView network,
      NearestCameras nearest,
      ViewTranslation translation,
      Lengths lengths,
      int timeout) {
    this.network = network;
    this.nearest = nearest;
    this.translation = translation;
    this.lengths = lengths;
    this.timeout = timeout;
    post = new Post<>(network, network.channel());
    lastAnswers = new Answer[network.cameras()][nearest.maxNeighbours()];
  }

  /** The number of messages sent so far. */
  long messages() {
    return messages;
  }

  /** The length of all messages sent so far, in bits. */
  long bits() {
    return bits;
  }

  /**
   * Sends the queries of all cameras that decide in this step, and receives queries and answers.
   *
   * @param percepts the percepts by camera
   */
  void exchange(ActionValues q, IntUnaryOperator percepts) {
    for (int camera = 0; camera < lastAnswers.length; camera++) {
      if (!network.moving(camera)) {
        int view = network.view(camera);
        int percept = percepts.applyAsInt(camera);
        int state = q.state(camera, view, percept);
        Letter query = new Letter(true, network.step(), state, view, percept, NO_VOTE);
        for (int i = 0; i < nearest.count(camera); i++) {
          send(camera, nearest.neighbour(camera, i), lengths.query, query);
        }
      }
    }
    post.deliver(this::receive);
  }

  private void send(int from, int to, int length, Letter letter) {
    messages++;
    bits += length;
    post.send(from, to, length, letter);
  }

  private void receive(int sender, int receiver, long sentAt, Letter letter) {
    if (letter.query) {
      int vote = translation.answer(sender, receiver, letter.state, letter.view, letter.percept);
      Letter answer = new Letter(false, letter.askedAt, letter.state, 0, 0, vote);
      send(receiver, sender, lengths.answer, answer);
    } else {
      keep(sender, receiver, letter);
    }
  }

  /** Keeps an answer, unless an answer to a later query has arrived before it. */
  private void keep(int neighbour, int camera, Letter letter) {
    for (int i = 0; i < nearest.count(camera); i++) {
      Answer last = lastAnswers[camera][i];
      boolean newer =
          last == null || last.neighbour != neighbour || last.letter.askedAt <= letter.askedAt;
      if (nearest.neighbour(camera, i) == neighbour && newer) {
        lastAnswers[camera][i] = new Answer(neighbour, letter);
      }
    }
  }

  /** Returns the vote of a camera's i-th neighbour for the camera's state, or {@link #NO_VOTE}. */
  int vote(int camera, int i, int state) {
    Answer last = lastAnswers[camera][i];
    boolean counts =
        last != null
            && last.neighbour == nearest.neighbour(camera, i)
            && last.letter.state == state
            && network.step() - last.letter.askedAt <= timeout;
    return counts ? last.letter.vote : NO_VOTE;
  }
}
