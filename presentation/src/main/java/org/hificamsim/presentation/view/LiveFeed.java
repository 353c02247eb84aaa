package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.Place;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.report.ObjectiveWords;

/**
 * What a session shows: its simulations, their last steps, and how it goes on. Each page reads what
 * is new to it, in its own time.
 *
 * <p>There are as many steps as there is room for: when it is full, every other one but the latest
 * is left out, so that the shape of a curve stays; the first and the last are always there, and no
 * move is lost. A page that is slow gets fewer steps.
 */
final class LiveFeed {
  private static final int MAX_STEPS = 4000;
  private static final int MIN_STEPS = 50;
  private static final long MAX_NUMBERS = 1 << 21;
  private static final int LATEST = 100; // none of which is left out
  private static final int STEPS_PER_EVENT = 200;
  private static final long HEARTBEAT = TimeUnit.SECONDS.toNanos(1);

  /** A comment, which pages ignore: writing it shows whether anybody is there. */
  private static final String NOTHING = ":\n\n";

  private static final String NO_HEAT = "[]";

  /** One simulation. */
  record SideMessage(Setup setup, String estimated, ObjectiveWords objective) {}

  /**
   * What runs.
   *
   * @param fresh whether the steps sent before are to be forgotten
   */
  private record SetupMessage(boolean fresh, List<SideMessage> sides) {}

  private final int most;
  private List<SideMessage> sides = List.of();
  private List<LiveStep> steps = new ArrayList<>();
  private String state = "";
  private String heat = NO_HEAT;
  private int beginnings;
  private int choices;

  /**
   * @param most steps, 2 or more
   */
  LiveFeed(int most) {
    this.most = most;
  }

  /** A feed with room for the steps of a scenario, so that a large one needs no more memory. */
  static LiveFeed of(Setup setup) {
    long fit = MAX_NUMBERS / Math.max(1, setup.numbersPerFrame());
    return new LiveFeed((int) Math.max(MIN_STEPS, Math.min(MAX_STEPS, fit)));
  }

  /** Shows other simulations: the steps so far are forgotten. */
  synchronized void begin(List<SideMessage> newSides) {
    sides = newSides;
    beginnings++;
    steps.clear();
    heat = NO_HEAT;
  }

  /** Has a simulation go on under another choice: its estimates so far were another policy's. */
  synchronized void choose(int side, List<SideMessage> newSides) {
    sides = newSides;
    choices++;
    steps.replaceAll(step -> step.withoutEstimates(side));
  }

  synchronized void add(LiveStep step) {
    steps.add(step);
    if (steps.size() > most) {
      thin();
    }
  }

  private void thin() {
    int latest = steps.size() - Math.min(LATEST, most / 2);
    List<LiveStep> kept = new ArrayList<>();
    for (int i = 0; i < steps.size(); i++) {
      if (i % 2 != 0 && i < latest) {
        steps.set(i + 1, steps.get(i + 1).after(steps.get(i)));
      } else {
        kept.add(steps.get(i));
      }
    }
    steps = kept;
  }

  synchronized void state(String json) {
    state = json;
  }

  synchronized void heat(String json) {
    heat = json;
  }

  /** The steps, in order. */
  synchronized List<LiveStep> steps() {
    return List.copyOf(steps);
  }

  /** How far one page has read. */
  final class Reader {
    private int begun;
    private int chosen;
    private long step;
    private String knownState;
    private String knownHeat;
    private long sent;

    /** Server-sent events with what is new to the page; at least a comment every second. */
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
      if (news.isEmpty() && System.nanoTime() - sent > HEARTBEAT) {
        news.append(NOTHING);
      }
      sent = news.isEmpty() ? sent : System.nanoTime();
      return news.toString();
    }

    private void addSetup(StringBuilder news) {
      boolean fresh = begun != beginnings;
      if (fresh || chosen != choices) {
        add(news, "setup", ReplayJson.of(new SetupMessage(fresh, sides)));
        begun = beginnings;
        chosen = choices;
      }
      if (fresh) {
        step = -1;
        knownState = "";
        knownHeat = NO_HEAT;
      }
    }

    private void addSteps(StringBuilder news) {
      List<LiveStep> unread = steps.stream().dropWhile(one -> one.number() <= step).toList();
      for (int from = 0; from < unread.size(); from += STEPS_PER_EVENT) {
        int to = Math.min(from + STEPS_PER_EVENT, unread.size());
        add(news, "steps", ReplayJson.of(unread.subList(from, to)));
        step = unread.get(to - 1).number();
      }
    }

    private static void add(StringBuilder news, String name, String json) {
      news.append("event: ").append(name).append("\ndata: ");
      news.append(Place.escaped(json, "\\\\")).append("\n\n");
    }
  }
}
