package org.hificamsim.runs;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.declaration.Property;

/**
 * An attribute of scenarios that keeps the value of a {@link Setting}.
 *
 * @param parser reads a value that a user asks for
 */
record ScenarioAttribute<T>(Property<Scenario, T> property, Function<String, T> parser) {
  /** Fails unless a text is a value. */
  void check(String value) {
    Objects.requireNonNull(parser.apply(value));
  }

  /** The scenario with this value in place of what its file says. */
  Scenario override(Scenario scenario, String value) {
    return scenario.with(property, parser.apply(value));
  }

  /** The value that a scenario writes into its file; empty if it omits it. */
  Optional<String> text(Scenario scenario) {
    return Optional.ofNullable(property.text(scenario));
  }
}
