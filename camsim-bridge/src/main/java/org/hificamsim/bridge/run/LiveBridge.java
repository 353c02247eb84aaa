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
 * The bridge at work: finds the run that a call from CamSim belongs to, and keeps CamSim from harm.
 * A failure is reported in one line, and from then on CamSim runs on its own.
 *
 * <p>A run begins with the first step of a {@code SimCore} and ends with its {@code close_files()},
 * or with the JVM. Cores that step in turn, or in several threads, do not meet.
 */
public final class LiveBridge implements Bridge {
  private final BridgeSettings settings;
  private final boolean strict;
  private final List<Run> runs = new ArrayList<>();
  private final List<Ended> ended = new ArrayList<>();

  @SuppressWarnings("ThreadLocalUsage") // a JVM has one bridge
  private final ThreadLocal<Run> current = new ThreadLocal<>();

  private int begun;
  private volatile boolean off;

  /** A core whose run has ended, and that run's number. */
  private record Ended(WeakReference<Object> core, int number) {}

  /**
   * @param strict whether the JVM stops when something goes wrong
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
  public double place(Object object, boolean upwards, double own) {
    return guarded(own, run -> run.place(object, upwards, own));
  }

  @Override
  public void stepEnds(Object core) {
    guarded(() -> current.get().stepEnds());
  }

  @Override
  public void runEnds(Object core) {
    guarded(() -> live(core).ifPresent(this::endAndLetGo));
  }

  /** Puts the files of all runs into place; the JVM is about to end, and cannot be stopped. */
  public void close() {
    try {
      runs().forEach(this::end);
    } catch (RuntimeException e) {
      fail(e, false);
    }
  }

  /** Reports what failed, and leaves CamSim alone from now on. */
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
    FaultLine.tell(Place.printable(message(fault)), stop);
  }

  private static String message(Throwable fault) {
    return fault instanceof InputException || fault instanceof UncheckedIOException
        ? fault.getMessage()
        : fault.toString();
  }

  /** Gives cameras back what they had, and puts into place what has been written until now. */
  private void letGo() {
    for (Run run : runs()) {
      try {
        run.letGo();
        run.end();
      } catch (IOException | RuntimeException e) {
        // What failed first is reported.
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

  /** What the run that is under way says; {@code otherwise} where there is none, or it fails. */
  private double guarded(double otherwise, ToDoubleFunction<Run> question) {
    Run run = current.get();
    if (off || run == null) {
      return otherwise;
    }
    try {
      return question.applyAsDouble(run);
    } catch (Throwable e) {
      fail(e);
      return otherwise;
    }
  }

  private synchronized List<Run> runs() {
    return List.copyOf(runs);
  }

  private synchronized Run run(Object core) {
    return live(core).orElseGet(() -> begin(core));
  }

  private synchronized Optional<Run> live(Object core) {
    return runs.stream().filter(run -> run.isOf(core)).findFirst();
  }

  /** A core that goes on after its end is steered still, but its files stay as they are. */
  private Run begin(Object core) {
    Optional<Ended> earlier = ended.stream().filter(end -> end.core().refersTo(core)).findFirst();
    BridgeSettings its = earlier.isPresent() ? settings.with(Optional.empty()) : settings;
    try {
      Run run = new Run(its, earlier.map(Ended::number).orElseGet(() -> begun++), core);
      runs.add(run);
      return run;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What cameras had before is known to the run alone: another one has to find them as before. */
  private void endAndLetGo(Run run) {
    current.remove();
    end(run);
    run.letGo();
  }

  private void end(Run run) {
    synchronized (this) {
      runs.remove(run);
      ended.removeIf(end -> end.core().refersTo(null) || end.core().refersTo(run.core()));
      ended.add(new Ended(new WeakReference<>(run.core()), run.number()));
    }
    Io.run(() -> run.end());
  }
}
