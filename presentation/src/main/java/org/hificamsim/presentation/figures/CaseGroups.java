package org.hificamsim.presentation.figures;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.runs.compare.CaseResult;

/** Results by the name of something, in the order of their first appearance. */
final class CaseGroups {
  private CaseGroups() {}

  static Map<String, List<CaseResult>> byScenario(List<CaseResult> cases) {
    return by(cases, one -> one.plan().scenario().name());
  }

  static Map<String, List<CaseResult>> byDetection(List<CaseResult> cases) {
    return by(cases, one -> one.plan().detection().name());
  }

  static Map<String, List<CaseResult>> byPolicy(List<CaseResult> cases) {
    return by(cases, one -> one.plan().policy());
  }

  private static Map<String, List<CaseResult>> by(
      List<CaseResult> cases, Function<CaseResult, String> name) {
    return cases.stream()
        .collect(Collectors.groupingBy(name, LinkedHashMap::new, Collectors.toList()));
  }
}
