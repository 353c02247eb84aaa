package org.hificamsim.presentation.odd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.runs.RunPlan;

/**
 * A plan in the seven elements of the ODD protocol (Grimm et al., The ODD Protocol for Describing
 * Agent-Based and Other Simulation Models: A Second Update, 2020), as Markdown. What no file says,
 * such as why the study was made, is a line that asks its author to write it.
 */
public final class OddProtocol {
  private final RunPlan plan;
  private final Catalogue catalogue;
  private final Scenario scenario;

  private OddProtocol(RunPlan plan, Catalogue catalogue) {
    this.plan = plan;
    this.catalogue = catalogue;
    this.scenario = plan.scenario();
  }

  /** The text. */
  public static String of(RunPlan plan, Catalogue catalogue) {
    OddProtocol odd = new OddProtocol(plan, catalogue);
    return String.join(
        "\n",
        "# ODD protocol: " + plan.scenario().name() + "\n",
        odd.purpose(),
        odd.entities(),
        odd.schedule(),
        odd.concepts(),
        odd.initialization(),
        odd.input(),
        odd.submodels());
  }

  private String purpose() {
    return """
## 1 Purpose and patterns

The model asks how well a network of smart cameras keeps every moving target covered when each camera chooses its zoom: here under the policy `%s`
and the detection model `%s`. It is judged by k_min, the least number of cameras that detect a target, in each step and summed over the run.

%s
"""
        .formatted(
            plan.policy(),
            plan.detection().name(),
            author(
                "the study's question, and the patterns that the model has to show to be of use for"
                    + " it"));
  }

  private String entities() {
    return """
## 2 Entities, state variables, and scales

| entity | how many | state variables |
|---|---|---|
| camera | %s at first | position (m), heading (degrees, 0 is +y), opening angle (degrees), zoom level, online or not; what its policy has learned |
| target | %s at first | position (m), heading, speed (m a step), size (m), movement |
| field | 1 | %s m by %s m (x from %s to %s, y from %s to %s), where targets move |

%s
Time: %s steps a run. A step has no length in seconds; speeds are metres a step. Space is continuous.
"""
        .formatted(
            scenario.cameras().size(),
            scenario.targets().size(),
            plain(scenario.field().width()),
            plain(scenario.field().height()),
            plain(scenario.field().minX()),
            plain(scenario.field().maxX()),
            plain(scenario.field().minY()),
            plain(scenario.field().maxY()),
            zooms(),
            plan.steps());
  }

  private String zooms() {
    if (scenario.zooms().isEmpty()) {
      return "Each camera has one zoom level: its own range.\n";
    }
    String radii =
        scenario.zooms().stream().map(OddProtocol::plain).collect(Collectors.joining(", "));
    return "Zoom levels of every camera, by radius of the field of view (m): " + radii + ".\n";
  }

  private String schedule() {
    List<String> processes = new ArrayList<>();
    processes.add("The events of the step happen, in the order of the file.");
    processes.add(
        "All cameras choose their zoom level from one picture of the network (submodel *policy*);"
            + " then all levels change at once.");
    processes.add("Each camera looks: which targets it detects (submodel *detection*).");
    processes.add("The cameras learn from what they detect, if the policy learns.");
    processes.add("k_min and the coverage are measured.");
    processes.add(
        scenario.order() == StepOrder.CAMSIM ? 1 : processes.size(),
        "Every target moves (submodel *movement*), in the order of the file.");
    String list =
        IntStream.range(0, processes.size())
            .mapToObj(i -> (i + 1) + ". " + processes.get(i) + "\n")
            .collect(Collectors.joining());
    return """
           ## 3 Process overview and scheduling

           In each step, in this order (`order="%s"`):

           %s"""
        .formatted(Spelling.of(scenario.order()), list);
  }

  private String concepts() {
    return """
## 4 Design concepts

- **Basic principles**: coverage by k cameras, and detection by what a target fills of the image, g(f(size, distance, zoom)). %s
- **Emergence**: k_min over time comes from all cameras' choices and the targets' paths together.
- **Adaptation**: cameras change their zoom level by the policy: %s.
- **Objectives**: what the policy counts as a reward; see its submodel.
- **Learning**: as the policy does; others do not learn.
- **Prediction**: none.
- **Sensing**: a camera knows its own levels and the targets that it detects now. Policies such as `optimal` know everything; they are yardsticks.
- **Interaction**: cameras that see the same target raise its k together; policies that vote send messages, all others none.
- **Stochasticity**: random draws of movements and of policies, from generators of their own, both seeded with the run's seed: the same targets under every policy. %s
- **Collectives**: none.
- **Observation**: all of every step is measured: `steps.csv`, `summary.json`; `docs/data.md` explains the columns.
"""
        .formatted(
            author("which theory the study rests on"),
            summary(catalogue.policies(), plan.policy()),
            "Runs: "
                + plan.repeats()
                + ", seeds "
                + plan.seed()
                + " to "
                + plan.seed(plan.repeats() - 1)
                + ".");
  }

  private String initialization() {
    return """
## 5 Initialization

The same in every run but for what is drawn at random. Every camera starts at its widest level.

%s
%s
%s
"""
        .formatted(
            OddTables.cameras(scenario),
            OddTables.targets(scenario),
            author("why these positions and numbers"));
  }

  private String input() {
    return "## 6 Input data\n\n"
        + (scenario.events().isEmpty()
            ? "None: nothing comes from outside once a run has begun.\n"
            : "The scenario's events:\n\n" + OddTables.events(scenario));
  }

  private static String rule(Detection detection) {
    return detection.certain()
        ? "where the model's confidence is " + plain(detection.threshold()) + " or more"
        : "by chance, half of the time where the model's confidence is "
            + plain(detection.threshold())
            + " (`--detect "
            + detection.rule().text()
            + "`, `docs/detection.md`)";
  }

  private String submodels() {
    return """
## 7 Submodels

**Detection** `%s`: %s A target within a camera's reach and angle is detected %s.

**Policy** `%s`: %s.%s

**Movement**: %s (`docs/scenario-format.md` says how each goes on at the field's border).

%s
"""
        .formatted(
            plan.detection().name(),
            detection(),
            rule(plan.detection()),
            plan.policy(),
            summary(catalogue.policies(), plan.policy()),
            options(),
            scenario.targets().stream()
                .map(target -> "`" + target.movement().shortName() + "`")
                .distinct()
                .collect(Collectors.joining(", ")),
            author(
                "how the parameters were chosen, beyond what the scenario and the defaults say"));
  }

  private String detection() {
    if (plan.detection().model() instanceof HiFiDetection fitted) {
      return "a fitted model g(f(q, d, z)), from " + fitted.provenance().source() + ".";
    }
    return catalogue.detections().knows(plan.detection().model().name())
        ? summary(catalogue.detections(), plan.detection().model().name()) + "."
        : "";
  }

  private String options() {
    List<Options.Declared> declared = catalogue.policies().options(name(plan.policy()));
    return declared.isEmpty()
        ? ""
        : " Its options, where the name above does not say otherwise:\n\n"
            + OddTables.options(declared).stripTrailing();
  }

  private static <T> String summary(Registry<T> registry, String spec) {
    String name = registry.names().contains(spec) ? spec : name(spec);
    return registry.entries().stream()
        .filter(entry -> entry.name().equals(name))
        .map(Registry.Entry::summary)
        .findFirst()
        .orElse(name);
  }

  /** A policy's name without its options. */
  private static String name(String policy) {
    return policy.replaceFirst(":.*", "");
  }

  private static String author(String what) {
    return "*To be written by the author: " + what + ".*";
  }

  /** Whole numbers without a fraction. */
  static String plain(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.valueOf(value);
  }
}
