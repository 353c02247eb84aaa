package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** What of a scenario belongs to CamSim's network of cameras, which not every command simulates. */
public final class NetworkParts {
  private NetworkParts() {}

  /** The attributes and elements that the scenario uses; empty where it asks for no network. */
  public static List<String> of(Scenario scenario) {
    List<AgentSpec> agents = new ArrayList<>();
    scenario.cameras().forEach(camera -> agents.add(camera.agent()));
    for (ScenarioEvent event : scenario.events()) {
      if (event instanceof ScenarioEvent.AddCamera add) {
        agents.add(add.camera().agent());
      }
    }
    List<String> parts = new ArrayList<>();
    addIf(parts, agents, agent -> agent.algorithm().isPresent(), "ai_algorithm");
    addIf(parts, agents, agent -> agent.comm().isPresent(), "comm");
    addIf(parts, agents, agent -> agent.customComm().isPresent(), "customcom");
    addIf(parts, agents, agent -> agent.limit() != 0, "limit");
    addIf(parts, agents, agent -> agent.bandit().isPresent(), "bandit");
    if (scenario.visionGraph().isPresent()) {
      parts.add("visiongraph");
    }
    addIf(parts, scenario.events(), ScenarioEvent.FailRegistration.class::isInstance, "grc events");
    return parts;
  }

  private static <T> void addIf(
      List<String> parts, List<T> among, Predicate<T> condition, String part) {
    if (among.stream().anyMatch(condition)) {
      parts.add(part);
    }
  }
}
