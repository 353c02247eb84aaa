package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.bridge.run.BridgeSettings;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class BridgeOptionsTest {
  @Test
  void settingsHaveValuesOfOptions() {
    BridgeSettings settings =
        parse(
            "detection=hifi:orb-lin,policy=sarsa:gamma=0.9;epsilon=0.1,threshold=0.0441,size=1.5,"
                + "seed=-3,zooms=2.5;5;7.5,out=results/one,strict=true");
    assertEquals("hifi:orb-lin", settings.detection().orElseThrow().model().name());
    assertEquals(0.0441, settings.detection().orElseThrow().threshold());
    assertEquals("sarsa:gamma=0.9,epsilon=0.1", settings.policy().orElseThrow().spec());
    assertEquals("sarsa", settings.policy().orElseThrow().maker().get().name());
    assertEquals(1.5, settings.size());
    assertEquals(-3, settings.seed());
    assertEquals(List.of(2.5, 5.0, 7.5), settings.zooms());
    assertEquals(Optional.of(Path.of("results/one")), settings.out());
  }

  @Test
  void thresholdOfDetectionOverridesOption() {
    BridgeSettings settings = parse("detection=hifi:orb-lin@0.06,threshold=0.0441");
    assertEquals(0.06, settings.detection().orElseThrow().threshold());
    assertEquals("hifi:orb-lin@0.06", settings.detection().orElseThrow().name());
  }

  @Test
  void defaultsAreModelThresholdAndLargestLabTarget() {
    BridgeSettings settings = parse("detection=hifi:orb-lin");
    double ofModel = OwnSimulation.detection("hifi:orb-lin").threshold();
    assertEquals(ofModel, settings.detection().orElseThrow().threshold());
    assertEquals(0.66, settings.size());
    assertEquals(0, settings.seed());
    assertEquals(Optional.empty(), settings.policy());
    assertEquals(Optional.empty(), settings.out());
  }

  @ParameterizedTest
  @ValueSource(strings = {"zooms=2.5;5;7.5", "zooms=2.5 5 7.5", "zooms=2.5,5,7.5"})
  void radiiMayBeSeparatedBySemicolonsBlanksOrCommas(String zooms) {
    assertEquals(List.of(2.5, 5.0, 7.5), parse("policy=random," + zooms).zooms());
  }

  @Test
  void opticsHaveAnglesLawAndPixelsOfOptions() {
    OpticsSpec optics =
        parse("policy=random,hfov=8;25;58,law=constant-area,pan=-60;0;60,pixels=640")
            .optics()
            .orElseThrow();
    assertEquals(OpticsLaw.CONSTANT_AREA, optics.law());
    assertEquals(List.of(8.0, 25.0, 58.0), optics.anglesOfView());
    assertEquals(List.of(-60.0, 0.0, 60.0), optics.pans());
    assertEquals(Optional.of(640), optics.pixels());
    assertEquals(OptionalDouble.empty(), optics.reach());
    assertFalse(optics.takesTime());
  }

  @Test
  void opticsDefaultToFixedLens() {
    OpticsSpec optics = parse("policy=random,hfov=58").optics().orElseThrow();
    assertEquals(OpticsLaw.PINHOLE, optics.law());
    assertEquals(List.of(0.0), optics.pans());
    assertEquals(Optional.empty(), optics.pixels());
    assertEquals(Optional.empty(), parse("policy=random").optics());
  }

  @Test
  void camSimStaysUnchangedWithoutDetectionPolicyAndOut() {
    assertFalse(parse("strict=true").needsWeaving());
    assertTrue(parse("out=results").needsWeaving());
  }

  @ParameterizedTest
  @MethodSource
  void messageStatesProblemAndExpectation(String options, String problem) {
    InputException thrown = assertThrows(InputException.class, () -> parse(options));
    assertTrue(thrown.getMessage().startsWith(problem), thrown.getMessage());
  }

  static Stream<Arguments> messageStatesProblemAndExpectation() {
    return Stream.of(
        arguments(
            "detection=hifi:orb-line",
            "unknown detection 'hifi:orb-line', expected one of hifi:orb-lin, "),
        arguments("detection=none.json", "none.json: no such file, expected a model in JSON"),
        arguments(
            "policy=sarsa:gama=0.9", "policy sarsa: unknown option 'gama=0.9', expected one of"),
        arguments(
            "policy=best-fixed",
            "policy 'best-fixed' has to see the run before it begins, expected one that"),
        arguments(
            "detektion=geometric",
            "options: unknown option 'detektion=geometric', expected one of detection, threshold"),
        arguments(
            "detection=geometric,threshold=2",
            "options: threshold is '2', expected a number from 0.0 to 1.0"),
        arguments("threshold=0.5", "threshold is '0.5' without detection, expected both"),
        arguments(
            "policy=random,zooms=5;3", "zooms has '3' after 5.0, expected rising radii, each once"),
        arguments(
            "policy=random,zooms=0;3",
            "options: zooms is '0', expected a number above 0 and at most 1000000"),
        arguments(
            "policy=sarsa:gamma=0.9,epsilon=0.1",
            "options: unknown option 'epsilon=0.1', expected one of detection, threshold, detect,"
                + " size, policy, zooms, hfov, law, pan, pixels, objective, following, seed,"
                + " tracks, out, strict, with ';' between a policy's own"),
        arguments("hfov=8;25", "hfov is '8;25' without policy, expected both"),
        arguments("policy=random,law=pinhole", "law is 'pinhole' without hfov, expected both"),
        arguments("policy=random,pan=0;60", "pan is '0;60' without hfov, expected both"),
        arguments("policy=random,pixels=640", "pixels is '640' without hfov, expected both"),
        arguments(
            "policy=random,hfov=8;25,zooms=3;5",
            "hfov is '8;25' and zooms '3;5', expected one of them"),
        arguments(
            "policy=random,hfov=25;8",
            "hfov has '8' after 25.0, expected rising angles, each once, such as 8;15;25;40;58"),
        arguments(
            "policy=random,hfov=0",
            "options: hfov is '0', expected a number above 0 and at most 179"),
        arguments(
            "policy=random,hfov=200",
            "options: hfov is '200', expected a number above 0 and at most 179"),
        arguments(
            "policy=random,hfov=400,law=constant-area",
            "options: hfov is '400', expected a number above 0 and at most 180"),
        arguments(
            "policy=random,hfov=25,law=round",
            "options: law is 'round', expected one of constant-area, pinhole"),
        arguments(
            "policy=random,hfov=25,pan=0;-60",
            "pan has '-60' after 0.0, expected rising angles, each once, such as -60;0;60"),
        arguments(
            "policy=random,hfov=25,pan=0;400",
            "options: pan is '400', expected a number from -360.0 to 360.0"),
        arguments(
            "policy=random,hfov=25,pixels=0",
            "options: pixels is '0', expected a whole number from 1 to 100000"),
        arguments(
            "policy=random,hfov=" + rising(1, 101) + ",pan=" + rising(0, 100),
            "pan and hfov make 10201 views, expected at most 10000"),
        arguments("seed=4,out=results", "seed is '4' without policy or detect, expected both"),
        arguments(
            "policy=random,seed=1.5", "options: seed is '1.5', expected a whole number from -2147"),
        arguments(
            "strict=perhaps,policy=random",
            "options: strict is 'perhaps', expected one of false, true"),
        arguments(
            "policy=random,policy=zoom-in",
            "options: option 'policy=zoom-in', expected key=value with each key once"));
  }

  private static String rising(int first, int last) {
    return IntStream.rangeClosed(first, last)
        .mapToObj(String::valueOf)
        .collect(Collectors.joining(";"));
  }

  private static BridgeSettings parse(String options) {
    return BridgeOptions.parse(options, OwnSimulation.CATALOGUE);
  }
}
