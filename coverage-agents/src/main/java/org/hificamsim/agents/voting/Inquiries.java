package org.hificamsim.agents.voting;

import java.util.function.IntUnaryOperator;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.policy.NetworkView;

/**
 * Queries and answers of QB-SARSA over a channel that is not perfect. A camera asks at each
 * decision, and decides with the last answer that it has from each neighbour: one to the state that
 * it is in, to a query that is not older than the time-out. A neighbour answers as soon as it is
 * asked, from its table as it then stands; also while it is on its way to a view.
 */
final class Inquiries {
  /** No vote: the neighbour has not answered. */
  static final int NONE = -1;

  /**
   * A query, or the answer to it.
   *
   * @param asked the step of the query
   * @param state of the asker then, as its view and percept make it
   * @param vote of an answer
   */
  private record Letter(boolean query, long asked, int state, int view, int percept, int vote) {}

  private record Answer(int neighbour, Letter letter) {}

  private final NetworkView network;
  private final NearestCameras nearest;
  private final int bitsOfQuery;
  private final int bitsOfAnswer;
  private final int timeout;
  private final ActionValues q;
  private final ViewTranslation translation;
  private final Post<Letter> post;
  private final Answer[][] answers; // by camera and neighbour, the last of each
  private long messages;
  private long bits;

  /**
   * @param timeout steps after the query in which its answer counts
   */
  Inquiries(
      NetworkView network,
      NearestCameras nearest,
      int bitsOfQuery,
      int bitsOfAnswer,
      int timeout,
      ActionValues q,
      ViewTranslation translation) {
    this.network = network;
    this.nearest = nearest;
    this.bitsOfQuery = bitsOfQuery;
    this.bitsOfAnswer = bitsOfAnswer;
    this.timeout = timeout;
    this.q = q;
    this.translation = translation;
    post = new Post<>(network, network.channel());
    answers = new Answer[network.cameras()][nearest.most()];
  }

  long messages() {
    return messages;
  }

  long bits() {
    return bits;
  }

  /** All cameras that decide ask their neighbours, and what arrives in this step is received. */
  void run(IntUnaryOperator percepts) {
    for (int camera = 0; camera < answers.length; camera++) {
      if (!network.moving(camera)) {
        int view = network.view(camera);
        int percept = percepts.applyAsInt(camera);
        int state = q.state(camera, view, percept);
        Letter query = new Letter(true, network.step(), state, view, percept, NONE);
        for (int i = 0; i < nearest.count(camera); i++) {
          send(camera, nearest.neighbour(camera, i), bitsOfQuery, query);
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

  private void receive(int from, int to, long sent, Letter letter) {
    if (letter.query) {
      int vote = translation.answer(q, from, to, letter.state, letter.view, letter.percept);
      Letter answer = new Letter(false, letter.asked, letter.state, 0, 0, vote);
      send(to, from, bitsOfAnswer, answer);
    } else {
      keep(from, to, letter);
    }
  }

  /** An answer that was overtaken by a later one is dropped. */
  private void keep(int from, int to, Letter letter) {
    for (int i = 0; i < nearest.count(to); i++) {
      Answer last = answers[to][i];
      boolean newer = last == null || last.neighbour != from || last.letter.asked <= letter.asked;
      if (nearest.neighbour(to, i) == from && newer) {
        answers[to][i] = new Answer(from, letter);
      }
    }
  }

  /** The vote of a camera's i-th neighbour for its state, or {@link #NONE}. */
  int answer(int camera, int i, int state) {
    Answer last = answers[camera][i];
    boolean counts =
        last != null
            && last.neighbour == nearest.neighbour(camera, i)
            && last.letter.state == state
            && network.step() - last.letter.asked <= timeout;
    return counts ? last.letter.vote : NONE;
  }
}
