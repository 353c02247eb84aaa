package org.hificamsim.cli;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.Estimate;
import org.hificamsim.tracks.mate.MateArena;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code hificamsim benchmark arena}: greedy cameras against greedy targets, as in MATE. */
@Command(
    name = "arena",
    description = "Plays MATE's arena: its greedy cameras against its greedy targets.")
final class ArenaCommand implements Callable<Integer> {
  private static final String SITE = "mate-4v8-9";

  @Option(names = "--episodes", paramLabel = "N")
  private int episodes;

  @Option(names = "--seed", paramLabel = "S")
  private int seed;

  @Mixin private Screen screen;

  @Override
  public Integer call() {
    Numbers.inRange("--episodes", episodes, 1, 1_000_000);
    Scenario site = ShippedScenarios.read(List.of(SITE), Catalogue.load()).get(SITE);
    MateArena[] played =
        LongStream.range(seed, (long) seed + episodes)
            .mapToObj(each -> MateArena.play(site, each))
            .toArray(MateArena[]::new);
    screen.say("coverage  %s", mean(played, MateArena::coverage, "%.3f"));
    screen.say("transport %s", mean(played, MateArena::transported, "%.3f"));
    screen.say("steps     %s", mean(played, MateArena::steps, "%.0f"));
    long steps = Arrays.stream(played).mapToLong(MateArena::steps).sum();
    ProcessHandle.current() // of all threads, from the start of Java on
        .info()
        .totalCpuDuration()
        .ifPresent(
            took ->
                screen.note(
                    "%.0f steps a second of processor time", 1e3 * steps / took.toMillis()));
    return 0;
  }

  private static String mean(MateArena[] played, ToDoubleFunction<MateArena> of, String form) {
    return Estimate.mean(Arrays.stream(played).mapToDouble(of).toArray()).text(form);
  }
}
