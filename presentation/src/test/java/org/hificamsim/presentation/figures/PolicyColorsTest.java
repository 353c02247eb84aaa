package org.hificamsim.presentation.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.hificamsim.presentation.plot.LineLook;
import org.hificamsim.presentation.plot.Palette;
import org.junit.jupiter.api.Test;

class PolicyColorsTest {
  @Test
  void twelvePoliciesHaveColoursOfTheirOwn() {
    List<String> policies =
        IntStream.range(0, 12).mapToObj(i -> i == 5 ? "sarsa" : "policy-" + i).toList();
    PolicyColors colors = new PolicyColors(policies);
    assertEquals(12, Set.copyOf(policies.stream().map(colors::of).toList()).size());
    assertEquals(Palette.VERMILION, colors.of("sarsa"));
  }

  @Test
  void morePoliciesDifferInColourOrMark() {
    List<String> policies = IntStream.range(0, 24).mapToObj(i -> "policy-" + i).toList();
    PolicyColors colors = new PolicyColors(policies);
    Set<List<Object>> looks = new HashSet<>();
    for (String policy : policies) {
      LineLook look = colors.look(policy);
      looks.add(List.of(look.color(), look.mark()));
    }
    assertEquals(24, looks.size());
  }

  @Test
  void allColoursCanBeSeenOnWhite() {
    Palette.LINES.forEach(
        color ->
            assertTrue(
                0.2126 * color.getRed() + 0.7152 * color.getGreen() + 0.0722 * color.getBlue()
                    < 175));
  }

  @Test
  void pagesHaveWordsOfNamesInTheirData() {
    String data = "{\"chosen\": \"sarsa | ucb1:c=2\", \"note\": \"a=b c\", \"k\": 1}";
    assertEquals("{\"ucb1:c=2\":\"ucb1, c 2\"}", SpokenNames.json(data));
  }

  @Test
  void spellsNamesInWords() {
    assertEquals("ORB pinhole law", SpokenNames.of("hifi:orb-pinhole"));
    assertEquals("ORB linear, chapter 5, by chance", SpokenNames.of("hifi:orb-lin-gt@chance"));
    assertEquals("CamSim range, 0.45", SpokenNames.of("camsim-range@0.45"));
    assertEquals("epsilon-greedy, epsilon 0.3", SpokenNames.of("epsilon-greedy:epsilon=0.3"));
  }
}
