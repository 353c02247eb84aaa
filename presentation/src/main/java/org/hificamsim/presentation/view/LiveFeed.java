package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.Place;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.report.ObjectiveWords;

/**
 * Holds what a session shows to pages: its simulations, their last steps, and its state. Each page
 * reads what is new to it, at its own pace.
 *
 * <p>The number of steps is limited. When the limit is reached, every other one of the older steps
 * is removed, so that curves keep their shape. The first and the last step always stay, and no move
 * is lost. A slow page gets fewer steps.
 */
final class LiveFeed {
  private static final int MAX_STEPS = 4000;
  private static final int MIN_STEPS = 50;
  private static final long MAX_NUMBERS = 1 << 21;

  /** The number of latest steps that are never removed. */
  private static final int LATEST = 100;

  private static final int STEPS_PER_EVENT = 200;
  private static final long HEARTBEAT = TimeUnit.SECONDS.toNanos(1);

  /** A comment, which pages ignore. Writing it fails if the page is closed, which tells us so. */
  private static final String COMMENT = ":\n\n";

  private static final String NO_HEAT = "[]";

  /** The message that describes one simulation before its steps. */
  record SideMessage(Setup setup, String estimated, ObjectiveWords objective) {}

  /**
   * The setups of all simulations.
   *
   * @param fresh whether pages are to forget the steps that were sent before
   */
  private record SetupMessage(boolean fresh, List<SideMessage> sides) {}

  private final int maxSteps;
  private List<SideMessage> sides = List.of();
  private List<LiveStep> steps = new ArrayList<>();
  private String state = "";
  private String heat = NO_HEAT;
  private int beginCount;
  private int choiceCount;

  /**
   * @param maxSteps the limit of steps, 2 or more
   */
  LiveFeed(int maxSteps) {
    this.maxSteps = maxSteps;
  }

  /** Returns a feed for a scenario. Large scenarios get fewer steps, so that memory is bounded. */
  static LiveFeed of(Setup setup) {
    long fit = MAX_NUMBERS / Math.max(1, setup.numbersPerFrame());
    return new LiveFeed((int) Math.max(MIN_STEPS, Math.min(MAX_STEPS, fit)));
  }

  /** Shows new simulations, and removes the steps of the old ones. */
  synchronized void begin(List<SideMessage> newSides) {
    sides = newSides;
    beginCount++;
    steps.clear();
    heat = NO_HEAT;
  }

  /** Shows a new choice of a simulation, and removes its estimates, which another policy made. */
  synchronized void choose(int side, List<SideMessage> newSides) {
    sides = newSides;
    choiceCount++;
    steps.replaceAll(step -> step.withoutEstimates(side));
  }

  synchronized void add(LiveStep step) {
    steps.add(step);
    if (steps.size() > maxSteps) {
      thin();
    }
  }

  private void thin() {
    int latest = steps.size() - Math.min(LATEST, maxSteps / 2);
    List<LiveStep> kept = new ArrayList<>();
    for (int i = 0; i < steps.size(); i++) {
      if (i % 2 != 0 && i < latest) {
        steps.set(i + 1, steps.get(i + 1).withMovesOf(steps.get(i)));
      } else {
        kept.add(steps.get(i));
      }
    }
    steps = kept;
  }

  synchronized void showState(String json) {
    state = json;
  }

  synchronized void showHeat(String json) {
    heat = json;
  }

  /** The steps that have not been removed, in order. */
  synchronized List<LiveStep> steps() {
    return List.copyOf(steps);
  }

  /** Reads the feed for one page, and knows what the page has got already. */
  final class Reader {
    private int knownBegins;
    private int knownChoices;
    private long lastStep;
    private String knownState;
    private String knownHeat;
    private long lastSent;

    /**
     * Returns what is new to the page, as server-sent events. There is at least a comment every
     * second.
     */
    String take() {
      StringBuilder news = new StringBuilder();
      synchronized (LiveFeed.this) {
        addSetup(news);
        addSteps(news);
        if (!state.equals(knownState)) {
          knownState = state;
          add(news, "state", state);
        }
        if (!heat.equals(knownHeat)) {
          knownHeat = heat;
          add(news, "heat", heat);
        }
      }
      if (news.isEmpty() && System.nanoTime() - lastSent > HEARTBEAT) {
        news.append(COMMENT);
      }
      lastSent = news.isEmpty() ? lastSent : System.nanoTime();
      return news.toString();
    }

    private void addSetup(StringBuilder news) {
      boolean fresh = knownBegins != beginCount;
      if (fresh || knownChoices != choiceCount) {
        add(news, "setup", ReplayJson.of(new SetupMessage(fresh, sides)));
        knownBegins = beginCount;
        knownChoices = choiceCount;
      }
      if (fresh) {
        lastStep = -1;
        knownState = "";
        knownHeat = NO_HEAT;
      }
    }

    private void addSteps(StringBuilder news) {
      List<LiveStep> unread = steps.stream().dropWhile(step -> step.number() <= lastStep).toList();
      for (int from = 0; from < unread.size(); from += STEPS_PER_EVENT) {
        int to = Math.min(from + STEPS_PER_EVENT, unread.size());
        add(news, "steps", ReplayJson.of(unread.subList(from, to)));
        lastStep = unread.get(to - 1).number();
      }
    }

    private static void add(StringBuilder news, String name, String json) {
      news.append("event: ").append(name).append("\ndata: ");
      news.append(Place.escaped(json, "\\\\")).append("\n\n");
    }
  }
}
