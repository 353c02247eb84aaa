package org.hificamsim.bridge.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.bridge.agent.Bridge;
import org.hificamsim.bridge.agent.Trouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * The bridge at work: finds the run that a call from CamSim belongs to, and keeps CamSim from harm.
 * Whatever goes wrong here is told in one line, and from then on CamSim is on its own.
 *
 * <p>A run begins with the first step of a {@code SimCore} and ends with its {@code close_files()},
 * with the first step of another core in the same thread, or with the JVM. Runs in several threads
 * do not meet.
 */
public final class LiveBridge implements Bridge {
  private final Setup setup;
  private final boolean strict;
  private final List<Run> runs = new ArrayList<>();
  private final List<WeakReference<Object>> endedCores = new ArrayList<>();

  @SuppressWarnings("ThreadLocalUsage") // a JVM has one bridge
  private final ThreadLocal<Run> current = new ThreadLocal<>();

  private int begun;
  private volatile boolean off;

  /**
   * @param strict whether the JVM stops when something goes wrong
   */
  public LiveBridge(Setup setup, boolean strict) {
    this.setup = setup;
    this.strict = strict;
  }

  @Override
  public void stepBegins(Object core) {
    guarded(
        () -> {
          Run before = current.get();
          if (before != null && !before.isOf(core)) {
            end(before);
          }
          current.set(run(core));
          current.get().stepBegins();
        });
  }

  @Override
  public double look(Object camera, Object object) {
    Run run = current.get();
    if (off || run == null) {
      return Double.NaN;
    }
    try {
      return run.look(camera, object);
    } catch (Throwable e) {
      fail(e);
      return Double.NaN;
    }
  }

  @Override
  public void looked(Object camera, Object object, double confidence) {
    Run run = current.get();
    if (!off && run != null) {
      run.looked(camera, object, confidence);
    }
  }

  @Override
  public void stepEnds(Object core) {
    guarded(() -> current.get().stepEnds());
  }

  @Override
  public void runEnds(Object core) {
    guarded(
        () -> {
          end(run(core));
          current.remove();
        });
  }

  /** Puts the files of all runs into place; the JVM is about to end, and cannot be stopped. */
  public void close() {
    try {
      runs().forEach(this::end);
    } catch (RuntimeException e) {
      fail(e, false);
    }
  }

  /** Tells what went wrong, and leaves CamSim alone from now on. */
  public void fail(Throwable fault) {
    fail(fault, strict);
  }

  private void fail(Throwable fault, boolean stop) {
    synchronized (this) {
      if (off) {
        return;
      }
      off = true;
    }
    letGo();
    Trouble.tell(Place.printable(message(fault)), stop);
  }

  private static String message(Throwable fault) {
    return fault instanceof InputException || fault instanceof UncheckedIOException
        ? fault.getMessage()
        : fault.toString();
  }

  /** Gives back the cameras' ranges, and puts into place what has been written until now. */
  private void letGo() {
    for (Run run : runs()) {
      try {
        run.letGo();
        run.end();
      } catch (IOException | RuntimeException e) {
        // What went wrong first is told.
      }
    }
  }

  private void guarded(Runnable action) {
    if (off) {
      return;
    }
    try {
      action.run();
    } catch (Throwable e) {
      fail(e);
    }
  }

  private synchronized List<Run> runs() {
    return List.copyOf(runs);
  }

  private synchronized Run run(Object core) {
    return runs.stream().filter(run -> run.isOf(core)).findFirst().orElseGet(() -> begin(core));
  }

  /** A core that goes on after its end is steered still, but its files stay as they are. */
  private Run begin(Object core) {
    boolean again = endedCores.stream().anyMatch(ended -> ended.get() == core);
    try {
      Run run = new Run(again ? setup.with(Optional.empty()) : setup, begun++, core);
      runs.add(run);
      return run;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void end(Run run) {
    synchronized (this) {
      runs.remove(run);
      endedCores.removeIf(ended -> ended.get() == null);
      endedCores.add(new WeakReference<>(run.core()));
    }
    try {
      run.end();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
