package org.hificamsim.bridge.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.hificamsim.bridge.agent.Bridge;
import org.hificamsim.bridge.agent.FaultLine;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Io;

/**
 * Passes each call from CamSim to the run that it belongs to, and shields CamSim from failures. The
 * first failure is reported in one line; after it, CamSim runs on its own.
 *
 * <p>A run begins with the first step of a {@code SimCore} and ends with its {@code close_files()},
 * or with the JVM. Cores that step in turn or in several threads have separate runs.
 */
public final class LiveBridge implements Bridge {
  private final BridgeSettings settings;
  private final boolean strict;
  private final List<Run> runs = new ArrayList<>();
  private final List<EndedRun> endedRuns = new ArrayList<>();

  @SuppressWarnings("ThreadLocalUsage") // a JVM has one bridge
  private final ThreadLocal<Run> current = new ThreadLocal<>();

  private int runCount;
  private volatile boolean off;

  /** A core whose run has ended, and that run's number. */
  private record EndedRun(WeakReference<Object> core, int number) {}

  /**
   * @param strict whether the JVM stops at the first failure
   */
  public LiveBridge(BridgeSettings settings, boolean strict) {
    this.settings = settings;
    this.strict = strict;
  }

  @Override
  public void stepBegins(Object core) {
    guarded(
        () -> {
          current.set(run(core));
          current.get().stepBegins();
        });
  }

  @Override
  public double look(Object camera, Object object) {
    return guarded(Double.NaN, run -> run.look(camera, object));
  }

  @Override
  public void looked(Object camera, Object object, double confidence) {
    Run run = current.get();
    if (run != null) {
      guarded(() -> run.looked(camera, object, confidence));
    }
  }

  @Override
  public double coordinate(Object object, boolean isY, double camSimValue) {
    return guarded(camSimValue, run -> run.coordinate(object, isY, camSimValue));
  }

  @Override
  public void stepEnds(Object core) {
    guarded(() -> current.get().stepEnds());
  }

  @Override
  public void runEnds(Object core) {
    guarded(() -> findRun(core).ifPresent(this::endAndRelease));
  }

  /** Commits the files of all runs; called while the JVM shuts down. */
  public void close() {
    try {
      runs().forEach(this::end);
    } catch (RuntimeException e) {
      fail(e, false);
    }
  }

  /** Reports a failure, and turns the bridge off. */
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
    releaseCamSim();
    FaultLine.report(Place.printable(message(fault)), stop);
  }

  private static String message(Throwable fault) {
    return fault instanceof InputException || fault instanceof UncheckedIOException
        ? fault.getMessage()
        : fault.toString();
  }

  /** Restores the cameras, and commits what has been written so far. */
  private void releaseCamSim() {
    for (Run run : runs()) {
      try {
        run.releaseCamSim();
        run.end();
      } catch (IOException | RuntimeException e) {
        // Only the first failure is reported.
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

  /** Asks the current run; returns {@code fallback} if there is no run, or the run fails. */
  private double guarded(double fallback, ToDoubleFunction<Run> question) {
    Run run = current.get();
    if (off || run == null) {
      return fallback;
    }
    try {
      return question.applyAsDouble(run);
    } catch (Throwable e) {
      fail(e);
      return fallback;
    }
  }

  private synchronized List<Run> runs() {
    return List.copyOf(runs);
  }

  private synchronized Run run(Object core) {
    return findRun(core).orElseGet(() -> begin(core));
  }

  private synchronized Optional<Run> findRun(Object core) {
    return runs.stream().filter(run -> run.isOf(core)).findFirst();
  }

  /** Begins a run. A core that continues after its end is steered, but writes no more files. */
  private Run begin(Object core) {
    Optional<EndedRun> earlier =
        endedRuns.stream().filter(end -> end.core().refersTo(core)).findFirst();
    BridgeSettings runSettings = earlier.isPresent() ? settings.with(Optional.empty()) : settings;
    try {
      Run run =
          new Run(runSettings, earlier.map(EndedRun::number).orElseGet(() -> runCount++), core);
      runs.add(run);
      return run;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Ends a run and restores its cameras, since only this run knows their former aims. */
  private void endAndRelease(Run run) {
    current.remove();
    end(run);
    run.releaseCamSim();
  }

  private void end(Run run) {
    synchronized (this) {
      runs.remove(run);
      endedRuns.removeIf(end -> end.core().refersTo(null) || end.core().refersTo(run.core()));
      endedRuns.add(new EndedRun(new WeakReference<>(run.core()), run.number()));
    }
    Io.run(() -> run.end());
  }
}
