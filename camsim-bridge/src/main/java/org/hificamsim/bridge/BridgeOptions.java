package org.hificamsim.bridge;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.bridge.run.BridgeSettings;
import org.hificamsim.bridge.run.ScenarioFile;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/** Parses the options after {@code -javaagent:hificamsim-bridge.jar=}. */
final class BridgeOptions {
  private static final String OWNER = "options";
  private static final double MAX_METRES = 1e6;
  private static final double FULL_TURN = 360;
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_NUMBERS = 1000;
  private static final int MAX_VIEWS = 10_000;

  private final Catalogue catalogue;
  private final Options given;

  /** The attributes of the scenario on the command line, which are defaults of some options. */
  private final Map<String, String> scenarioAttributes;

  private BridgeOptions(String text, Catalogue catalogue) {
    this.catalogue = catalogue;
    this.given = Options.parse(OWNER, text);
    this.scenarioAttributes =
        ScenarioFile.onCommandLine().map(ScenarioFile::attributes).orElse(Map.of());
  }

  /** The values of the option {@code strict}. */
  private enum Strict {
    FALSE,
    TRUE
  }

  /**
   * Parses the options.
   *
   * @throws InputException naming an option that is unknown, malformed or without effect
   */
  static BridgeSettings parse(String text, Catalogue catalogue) {
    return new BridgeOptions(text, catalogue).settings();
  }

  private BridgeSettings settings() {
    Optional<String> named = text("detection");
    Optional<String> model = named.or(() -> fromScenario("detection", true));
    boolean modelFromScenario = named.isEmpty() && model.isPresent();
    Optional<String> threshold =
        text("threshold").or(() -> fromScenario("threshold", modelFromScenario));
    Optional<String> detect = text("detect").or(() -> fromScenario("detect", model.isPresent()));
    Optional<String> size = text("size");
    Optional<String> policy = text("policy");
    Optional<String> zooms = text("zooms");
    Optional<String> hfov = text("hfov");
    Optional<String> law = text("law");
    Optional<String> pan = text("pan");
    Optional<String> pixels = text("pixels");
    Optional<String> givenObjective = text("objective");
    Optional<String> givenFollowing = text("following");
    Optional<String> seed = text("seed");
    Optional<String> tracks = text("tracks");
    Optional<String> out = text("out");
    boolean scores = policy.isPresent() || out.isPresent();
    Optional<String> objective = givenObjective.or(() -> fromScenario("objective", scores));
    Optional<String> following =
        givenFollowing.or(() -> fromScenario("following", out.isPresent()));
    given.choice("strict", Strict.FALSE, "");
    rejectUnknown();
    requireFor("threshold", threshold, model.isPresent(), "detection");
    requireFor("detect", detect, model.isPresent(), "detection");
    requireFor("size", size, model.isPresent(), "detection");
    Optional<Detection> detection = model.map(name -> detection(name, threshold, detect));
    boolean draws = policy.isPresent() || (detection.isPresent() && !detection.get().certain());
    requireFor("seed", seed, draws, "policy or detect");
    requireFor("objective", objective, scores, "policy or out");
    requireFor("following", following, out.isPresent(), "out");
    requireFor("zooms", zooms, model.isPresent() || policy.isPresent(), "policy or detection");
    requireFor("hfov", hfov, policy.isPresent(), "policy");
    requireFor("law", law, hfov.isPresent(), "hfov");
    requireFor("pan", pan, hfov.isPresent(), "hfov");
    requireFor("pixels", pixels, hfov.isPresent(), "hfov");
    if (hfov.isPresent() && zooms.isPresent()) {
      throw InputException.of(
          "hfov is '%s' and zooms '%s', expected one of them", hfov.get(), zooms.get());
    }
    return new BridgeSettings(
        detection,
        size.map(value -> number("size", value, Double.MIN_VALUE, MAX_METRES))
            .orElse(TargetSpec.DEFAULT_SIZE),
        policy.map(this::policy),
        zooms
            .map(text -> rising("zooms", text, Double.MIN_VALUE, MAX_METRES, "radii", "2.5;5;7.5"))
            .orElse(List.of()),
        hfov.map(angles -> optics(angles, law, pan, pixels)),
        objective.map(Objective::parse).orElseGet(Objective::kMin),
        seed.map(text -> integer("seed", text, Integer.MIN_VALUE, Integer.MAX_VALUE)).orElse(0),
        tracks.map(BridgeOptions::tracks),
        following
            .map(text -> Spelling.require(Following.class, "following", text))
            .orElse(Following.NONE),
        out.map(Path::of));
  }

  /** Returns an attribute of the scenario if it has an effect. */
  private Optional<String> fromScenario(String key, boolean hasEffect) {
    return hasEffect ? Optional.ofNullable(scenarioAttributes.get(key)) : Optional.empty();
  }

  private Optional<String> text(String key) {
    return Optional.ofNullable(given.text(key, null, ""));
  }

  /**
   * Rejects unknown options. The message has a hint, since users may separate the options of a
   * policy by commas.
   */
  private void rejectUnknown() {
    try {
      given.rejectUnknown();
    } catch (InputException e) {
      throw new InputException(e.getMessage() + ", with ';' between a policy's own", e);
    }
  }

  /** Rejects an option that has no effect without another. */
  private static void requireFor(
      String key, Optional<String> value, boolean present, String needed) {
    if (value.isPresent() && !present) {
      throw InputException.of("%s is '%s' without %s, expected both", key, value.get(), needed);
    }
  }

  private Detection detection(String name, Optional<String> threshold, Optional<String> detect) {
    Settings settings = Settings.NONE;
    if (threshold.isPresent()) {
      number("threshold", threshold.get(), 0, 1);
      settings = settings.with(Setting.THRESHOLD, threshold.get());
    }
    if (detect.isPresent()) {
      settings = settings.with(Setting.DETECT, detect.get().replace(';', ','));
    }
    return DetectionSpec.parse(name, catalogue::detection).detection(settings);
  }

  private static Map<String, List<Track>> tracks(String file) {
    Scenario scenario = ScenarioReader.read(Path.of(file), name -> true, warning -> {});
    if (scenario.hasHeights()) {
      throw InputException.of(
          "tracks is '%s', which has heights, expected a flat scenario: CamSim has none", file);
    }
    Map<String, List<Track>> tracks =
        scenario
            .events(ScenarioEvent.AddTarget.class)
            .map(ScenarioEvent.AddTarget::target)
            .filter(target -> target.track().isPresent())
            .collect(
                groupingBy(
                    TargetSpec::name, mapping(target -> target.track().orElseThrow(), toList())));
    if (tracks.isEmpty()) {
      throw InputException.of(
          "tracks is '%s', which has none, expected a scenario with <tracks>", file);
    }
    return tracks;
  }

  /** Parses a policy with its options, which semicolons separate since commas end our options. */
  private BridgeSettings.Policy policy(String text) {
    String spec = text.replace(';', ',');
    ZoomPolicy policy = catalogue.policies().create(spec);
    if (policy instanceof HindsightZoomPolicy) {
      throw InputException.of(
          "policy '%s' has to see the run before it begins, expected one that learns or"
              + " decides as the run goes",
          spec);
    }
    if (policy instanceof AimingZoomPolicy) {
      throw InputException.of(
          "policy '%s' turns cameras to any angle, expected one that chooses among views", spec);
    }
    return new BridgeSettings.Policy(spec, () -> catalogue.policies().create(spec));
  }

  /** Returns a lens for all cameras, whose reach is the range of each camera. */
  private static OpticsSpec optics(
      String angles, Optional<String> law, Optional<String> pan, Optional<String> pixels) {
    OpticsLaw opticsLaw = law.map(BridgeOptions::law).orElse(OpticsLaw.PINHOLE);
    OpticsSpec optics =
        new OpticsSpec("bridge")
            .with(OpticsSpec.LAW, opticsLaw)
            .with(OpticsSpec.PIXELS, pixels.map(text -> integer("pixels", text, 1, MAX_PIXELS)))
            .with(
                OpticsSpec.ANGLES_OF_VIEW,
                rising(
                    "hfov",
                    angles,
                    Double.MIN_VALUE,
                    Math.floor(opticsLaw.widest()),
                    "angles",
                    "8;15;25;40;58"))
            .with(
                OpticsSpec.PANS,
                pan.map(text -> rising("pan", text, -FULL_TURN, FULL_TURN, "angles", "-60;0;60"))
                    .orElse(List.of(0.0)));
    int views = optics.pans().size() * optics.anglesOfView().size();
    if (views > MAX_VIEWS) {
      throw InputException.of("pan and hfov make %s views, expected at most %s", views, MAX_VIEWS);
    }
    return optics;
  }

  private static OpticsLaw law(String law) {
    List<OpticsLaw> laws = Arrays.stream(OpticsLaw.values()).filter(OpticsLaw::hasAngles).toList();
    return Spelling.find(OpticsLaw.class, law)
        .filter(laws::contains)
        .orElseThrow(
            () ->
                InputException.of(
                    "options: law is '%s', expected one of %s",
                    law, laws.stream().map(Spelling::of).collect(Collectors.joining(", "))));
  }

  private static double number(String key, String text, double least, double most) {
    return Options.parse(OWNER, key + "=" + text).number(key, least, least, most, "");
  }

  private static int integer(String key, String text, int least, int most) {
    return Options.parse(OWNER, key + "=" + text).integer(key, least, least, most, "");
  }

  /**
   * Parses one or more rising numbers, separated by semicolons, commas or blanks.
   *
   * @param plural the name of the numbers, such as "radii"
   * @param example an example of such a list
   */
  private static List<Double> rising(
      String key, String text, double least, double most, String plural, String example) {
    List<Double> numbers = new ArrayList<>();
    for (String item : text.strip().split("[;,\\s]+")) {
      double number = number(key, item, least, most);
      if (!numbers.isEmpty() && number <= numbers.get(numbers.size() - 1)) {
        throw InputException.of(
            "%s has '%s' after %s, expected rising %s, each once, such as %s",
            key, item, numbers.get(numbers.size() - 1), plural, example);
      }
      numbers.add(number);
    }
    if (numbers.size() > MAX_NUMBERS) {
      throw InputException.of(
          "%s has %s %s, expected at most %s", key, numbers.size(), plural, MAX_NUMBERS);
    }
    return numbers;
  }
}
