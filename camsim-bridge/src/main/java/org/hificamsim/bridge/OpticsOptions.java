package org.hificamsim.bridge;

import static org.hificamsim.bridge.NumberOption.requireFor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.Moving;
import org.hificamsim.core.scenario.OpticsLaw;
import org.hificamsim.core.scenario.OpticsSpec;

/** The options that give every camera a lens, and let it turn. */
final class OpticsOptions {
  private static final String NAME = "bridge";
  private static final double FULL_TURN = 360;
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_VIEWS = 10_000;

  private final Optional<String> hfov;
  private final Optional<String> law;
  private final Optional<String> pan;
  private final Optional<String> pixels;

  /** Declares them. */
  OpticsOptions(Options given) {
    hfov = Optional.ofNullable(given.text("hfov", null, "horizontal angles of view, degrees"));
    law = Optional.ofNullable(given.text("law", null, "what ties angle and reach"));
    pan = Optional.ofNullable(given.text("pan", null, "pan angles, degrees"));
    pixels = Optional.ofNullable(given.text("pixels", null, "width of the picture"));
  }

  /**
   * The optics that are asked for, each camera's own range being their reach.
   *
   * @param steered whether a policy chooses among views
   * @throws InputException naming what is wrong
   */
  Optional<OpticsSpec> optics(boolean steered, Optional<String> zooms) {
    requireFor("hfov", hfov, steered, "policy");
    requireFor("law", law, hfov.isPresent(), "hfov");
    requireFor("pan", pan, hfov.isPresent(), "hfov");
    requireFor("pixels", pixels, hfov.isPresent(), "hfov");
    if (hfov.isPresent() && zooms.isPresent()) {
      throw new InputException(
          "hfov is '%s' beside zooms '%s', expected one of them"
              .formatted(hfov.get(), zooms.get()));
    }
    return hfov.map(this::optics).map(OpticsOptions::checked);
  }

  private OpticsSpec optics(String angles) {
    OpticsLaw used = law.map(OpticsOptions::lens).orElse(OpticsLaw.PINHOLE);
    return new OpticsSpec(
        NAME,
        used,
        pixels
            .map(text -> OptionalInt.of(NumberOption.integer("pixels", text, 1, MAX_PIXELS)))
            .orElseGet(OptionalInt::empty),
        NumberOption.rising(
            "hfov", angles, Double.MIN_VALUE, Math.floor(used.widest()), "angles", "8;15;25;40;58"),
        OptionalDouble.empty(),
        pan.map(OpticsOptions::pans).orElse(List.of(0.0)),
        OptionalDouble.empty(),
        0,
        Moving.BLIND);
  }

  private static OpticsLaw lens(String law) {
    return Spelling.find(OpticsLaw.class, law)
        .filter(OpticsLaw::hasAngles)
        .orElseThrow(
            () ->
                new InputException(
                    "options: law is '%s', expected one of %s".formatted(law, lenses())));
  }

  private static String lenses() {
    return Stream.of(OpticsLaw.values())
        .filter(OpticsLaw::hasAngles)
        .map(Spelling::of)
        .collect(Collectors.joining(", "));
  }

  private static List<Double> pans(String text) {
    return NumberOption.rising("pan", text, -FULL_TURN, FULL_TURN, "angles", "-60;0;60");
  }

  private static OpticsSpec checked(OpticsSpec optics) {
    int views = optics.pans().size() * optics.anglesOfView().size();
    if (views > MAX_VIEWS) {
      throw new InputException(
          "pan and hfov make %s views, expected at most %s".formatted(views, MAX_VIEWS));
    }
    return optics;
  }
}
