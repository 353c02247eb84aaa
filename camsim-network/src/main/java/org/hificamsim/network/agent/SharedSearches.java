package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.BitSet;

/**
 * What every camera of a network looks for, written down once for all: a message that reaches all
 * cameras leaves them of one mind about its target, and need not be brought to each. A camera's own
 * {@link Searches} know better where it has heard something else since.
 *
 * <p>Time is counted in changes, of which no two happen at once.
 */
public final class SharedSearches {
  private static final int UNKNOWN = -1;

  private final int[] searcher;
  private final long[] since;
  private final long[] changed;
  private final int[] apart; // cameras that have heard something else since
  private final BitSet listening = new BitSet();
  private boolean reachingAll;
  private int revision = UNKNOWN;
  private long now;

  /** All look for nothing. */
  public SharedSearches(int targets) {
    searcher = new int[targets];
    Arrays.fill(searcher, Searches.NONE);
    since = new long[targets];
    changed = new long[targets];
    apart = new int[targets];
  }

  /**
   * Finds out who is online, until this is asked again, and whether a message to all neighbours
   * reaches all of them. Where a bandit zooms it goes to each, since what each sees is counted.
   *
   * @param newRevision of the cameras; with the last one nothing is done, unless an agent has said
   *     that it is out of date
   */
  public void refresh(Agent[] agents, int count, int newRevision) {
    if (newRevision == revision) {
      return;
    }
    revision = newRevision;
    listening.clear();
    reachingAll = true;
    for (int camera = 0; camera < count; camera++) {
      agents[camera].searches.listen(agents[camera].isOnline());
      if (agents[camera].isOnline()) {
        listening.set(camera);
        reachingAll &= agents[camera].isInReachOf(count - 1);
      }
    }
  }

  /** An agent has other neighbours, or another schedule. */
  void outdate() {
    revision = UNKNOWN;
  }

  /** The cameras that hear a message to everyone, and who sends it; for reading only. */
  BitSet listening() {
    return listening;
  }

  boolean reachingAll() {
    return reachingAll;
  }

  /**
   * Takes a message to everyone.
   *
   * @param value with a search the time at which it began
   * @return false where the cameras would not be of one mind thereby: it has to go to each
   */
  public boolean hear(MessageKind kind, Agent from, int target, double value) {
    return kind == MessageKind.START_SEARCH
        ? start(target, from.searches, (long) value)
        : stop(target, from.searches);
  }

  /** All look for what the sender looks for since {@code time}, of whom only it knew by now. */
  boolean start(int target, Searches sender, long time) {
    long first = searcher[target] == Searches.NONE ? time : since[target];
    boolean alone = apart[target] == 1 && sender.isApart(target);
    if (!alone || sender.since(target) != first) {
      return false;
    }
    agree(target, sender.camera(), first);
    return true;
  }

  /** Nobody looks for a target any more, as the sender does not. */
  boolean stop(int target, Searches sender) {
    if (sender.contains(target)) {
      return false;
    }
    agree(target, Searches.NONE, 0);
    return true;
  }

  private void agree(int target, int forCamera, long first) {
    searcher[target] = forCamera;
    since[target] = first;
    changed[target] = tick();
    apart[target] = 0;
  }

  long tick() {
    return ++now;
  }

  /** A camera that had heard something else is asked no longer. */
  void forget(int target) {
    apart[target]--;
  }

  /** A camera that was of one mind with the others about a target no longer is. */
  void leave(int target) {
    apart[target]++;
  }

  int searcher(int target) {
    return searcher[target];
  }

  long since(int target) {
    return since[target];
  }

  long changed(int target) {
    return changed[target];
  }
}
